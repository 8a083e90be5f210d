#pragma once

#include <filesystem>
#include <vector>

#include "app/pictures/shot_selector.h"
#include "app/scene/reader.h"

namespace assembly {
struct BuiltScene;
}

/// @file
/// The scene and the states of a logged run, as a run of the scene draws them.

namespace app {

/// Reads the scene of a logged run again.
/// @param run     Folder of the run, or its trajectory.
/// @param scene   Present path of the scene; empty: that of the run, from its summary.
/// @throws InputError
scene::Scene logged_scene(const std::filesystem::path& run, const std::filesystem::path& scene,
                          const std::vector<scene::Override>& overrides,
                          scene::MeshFormats formats);

/// Selects the logged states that a run of the scene would have drawn.
/// @param run     Folder of the run, or its trajectory.
/// @param scene   It has a render block.
/// @param built   Built from it; it must outlive what is returned.
/// @param fps     States per second of a video, interpolated between rows; 0: those of frames
/// alone.
/// @throws InputError if the log is damaged or is that of other bodies
ShotSelector logged_shots(const std::filesystem::path& run, const scene::Scene& scene,
                          const assembly::BuiltScene& built, int fps);

}  // namespace app

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/render/image.h"

/// @file
/// The pictures that are kept: of scenes at a time of their golden trajectories, so that a change
/// of the motion does not show in them. They hold no text: fonts are the system's.

namespace golden {

struct KeptPicture {
  std::string scene;                   ///< Name of a file in `scenes/`, without `.yaml`.
  double time = 0;                     ///< Of a row of its golden trajectory [s].
  std::vector<std::string> sets = {};  ///< KEY.PATH=VALUE, replaced in the scene.
};

/// Between them they have a drop's impact, waves, many bodies, joints, a shore and every kind of
/// line.
const std::vector<KeptPicture>& kept_pictures();

/// Where a picture is kept.
std::filesystem::path kept_file(const KeptPicture& picture);

/// Draws it anew. @throws render::Error, scene::InputError, std::invalid_argument
render::Image draw(const KeptPicture& picture);

}  // namespace golden

#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "app/report/logged_run.h"
#include "app/report/shapes.h"

/// @file
/// What the page of a report shows, as the JSON that its script reads (web/data.js). Arrays of
/// numbers are packed (packing.h). SI units; angles in degrees.

namespace app {

/// What keeps a page small, whatever the run: about 30 MB at most in all.
struct PageLimits {
  std::size_t poses = 1'000'000;   ///< Numbers in all poses, kPoseNumbers a body a time.
  std::size_t series = 1'500'000;  ///< Numbers that vary, in all plotted columns of all bodies.
  Eigen::Index faces = 100'000;    ///< Triangles of all meshes.
  Eigen::Index heights = 500'000;  ///< Of a height field.
  std::size_t frames = 4'000'000;  ///< Bytes of all pictures.
};

/// The whole of it.
nlohmann::ordered_json page_data(const LoggedRun& run, const PageLimits& limits = {});

/// Its parts. What there is to say of bodies, shapes, water and ground:
nlohmann::ordered_json page_bodies(const LoggedRun& run, const Shapes& shapes);
nlohmann::ordered_json page_shapes(const Shapes& shapes);
nlohmann::ordered_json page_water(const engine::SimulationSpec& spec, const PageLimits& limits);
nlohmann::ordered_json page_ground(const engine::Ground& ground, const PageLimits& limits);

/// Poses for the replay, relative to `origin`.
nlohmann::ordered_json page_poses(const LoggedRun& run, const Eigen::Vector3d& origin,
                                  const PageLimits& limits);

/// Columns for the plots.
nlohmann::ordered_json page_series(const LoggedRun& run, const PageLimits& limits);

/// Pictures of the first camera with their times; null if there are none.
nlohmann::ordered_json page_frames(const LoggedRun& run, const PageLimits& limits);

}  // namespace app

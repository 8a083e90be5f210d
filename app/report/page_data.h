#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "app/report/logged_run.h"
#include "app/report/shapes.h"

/// @file
/// Data of a report's page, as the JSON that its script reads (web/data.js). Arrays of numbers are
/// packed (packing.h). SI units; angles in degrees.

namespace app {

/// Limits on the size of a page, which keep it below about 30 MB for every run.
struct PageLimits {
  std::size_t poses = 1'000'000;   ///< Numbers in all poses, kPoseNumbers per body and time.
  std::size_t series = 1'500'000;  ///< Numbers in the varying plotted columns of all bodies.
  Eigen::Index faces = 100'000;    ///< Triangles of all meshes.
  Eigen::Index heights = 500'000;  ///< Heights of a height field.
  std::size_t rigging = 500'000;   ///< Numbers of lines and machines over time.
  std::size_t spectra = 500'000;   ///< Numbers in all spectra and responses.
  std::size_t frames = 4'000'000;  ///< Bytes of all pictures.
};

/// Returns all data of a page.
nlohmann::ordered_json page_data(const LoggedRun& run, const PageLimits& limits = {});

/// Returns the origin of the replay's single-precision coordinates: the first body's start, at the
/// water level [m, W].
Eigen::Vector3d replay_origin(const LoggedRun& run);

/// Returns what a replay draws, which is part of a page's data: bodies, shapes, water, ground,
/// camera, poses and rigging, relative to `origin` [m, W].
nlohmann::ordered_json replay_data(const LoggedRun& run, const Eigen::Vector3d& origin,
                                   const PageLimits& limits);

/// Parts of the data: bodies, shapes, water and ground.
nlohmann::ordered_json page_bodies(const LoggedRun& run, const Shapes& shapes);
nlohmann::ordered_json page_shapes(const Shapes& shapes);
nlohmann::ordered_json page_water(const engine::SimulationSpec& spec, const PageLimits& limits);
/// The pressure scale of the pictures, and what the replay needs to find pressures; null for a dry
/// scene.
nlohmann::ordered_json page_pressure(const LoggedRun& run);
nlohmann::ordered_json page_ground(const engine::Ground& ground, const PageLimits& limits);

/// Returns the poses for the replay, relative to `origin` [m, W].
nlohmann::ordered_json page_poses(const LoggedRun& run, const Eigen::Vector3d& origin,
                                  const PageLimits& limits);

/// Returns lines, anchors and machines for the replay; null if there are none.
nlohmann::ordered_json page_rigging(const LoggedRun& run, const Eigen::Vector3d& origin,
                                    const PageLimits& limits);

/// Returns the columns for the plots.
nlohmann::ordered_json page_series(const LoggedRun& run, const PageLimits& limits);

/// Returns what `plimsoll analyse` finds of the run (analysis/run_analysis.h); null of a run too
/// short for a spectrum.
///
///     wave     to which responses are, in words
///     signals  [{of, signal, unit, statistics, spectrum, decay, response}], of the last three
///              those that the signal has
///
/// The first six signals of a body are its motions. A spectrum or response has a value at each
/// multiple of `step` [Hz] from 0, up to where nearly nothing is left of it.
nlohmann::ordered_json page_analysis(const LoggedRun& run, const PageLimits& limits);

/// Returns the pictures of the first camera with their times; null if there are none.
nlohmann::ordered_json page_frames(const LoggedRun& run, const PageLimits& limits);

}  // namespace app

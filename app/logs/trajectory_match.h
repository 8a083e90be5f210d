#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "app/logs/trajectory.h"
#include "engine/base/spec.h"

/// @file
/// Comparison of a logged trajectory with its scene.

namespace app {

/// Checks that the trajectory and the scene have the same bodies.
/// @param file   File of the trajectory, named in faults.
/// @throws InputError with every body that only one of the two has.
void check_same_bodies(const Trajectory& trajectory, const engine::SimulationSpec& spec,
                       const std::filesystem::path& file);

/// Returns the number of rows that every body has. It is less than that of the longest track if the
/// log was cut off.
/// @throws InputError if rows of two bodies have different times.
std::size_t common_rows(const Trajectory& trajectory, const std::filesystem::path& file);

/// Returns the states of all bodies, in the order of the scene, at a row that they all have.
std::vector<hydro::BodyState> states_at(const Trajectory& trajectory,
                                        const engine::SimulationSpec& spec, std::size_t row);

}  // namespace app

#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "app/logs/trajectory.h"
#include "engine/spec.h"

/// @file
/// A trajectory that was read back, held against the scene that it is said to be of.

namespace app {

/// @param file   Of the trajectory, named in faults.
/// @throws InputError with every body that only one of the two has.
void check_same_bodies(const Trajectory& trajectory, const engine::SimulationSpec& spec,
                       const std::filesystem::path& file);

/// The rows that every body has: fewer than the longest track's if the log was cut off.
/// @throws InputError if rows of two bodies are not of the same time.
std::size_t common_rows(const Trajectory& trajectory, const std::filesystem::path& file);

/// Of all bodies of a scene, in its order, at a row that they all have.
std::vector<hydro::BodyState> states_at(const Trajectory& trajectory,
                                        const engine::SimulationSpec& spec, std::size_t row);

}  // namespace app

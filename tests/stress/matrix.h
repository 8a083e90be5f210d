#pragma once

#include <vector>

#include "tests/stress/run_name.h"

/// @file
/// Runs of the stress test. The lists are the same on every machine.

namespace stress {

/// Returns all runs, each once: variations of each single parameter about a few base runs; Latin
/// hypercubes over all parameters, inside the operating envelope and beyond it; long runs of bodies
/// with much added mass; teapots of 80,000 triangles.
std::vector<RunName> whole_matrix();

/// Returns about 200 of the runs, from all parts, for every build: none that takes minutes.
std::vector<RunName> subset();

/// Returns random runs of free bodies, in still water and in waves, at any step: four of five
/// inside the operating envelope but for the added mass of light ones, the fifth of 0.1 mm to 1 km,
/// 0.001 to 40 times as dense as the water, at up to 300 m/s and 300 rad/s. Equal seeds give equal
/// runs.
std::vector<RunName> random_runs(std::size_t count, unsigned seed);

}  // namespace stress

#pragma once

#include <vector>

#include "tests/stress/run_name.h"

/// @file
/// Runs of the stress test. The lists are the same on every machine.

namespace stress {

/// Returns all runs, each once: variations of each single parameter about a few base runs; a Latin
/// hypercube over all parameters; long runs of bodies with much added mass; teapots of 80,000
/// triangles.
std::vector<RunName> whole_matrix();

/// Returns about 200 of the runs, from all parts, for every build: none that takes minutes.
std::vector<RunName> subset();

/// Returns random runs of free bodies between the values of the matrix: of 0.1 mm to 60 m, 0.002 to
/// 40 times as dense as the water, with spins to 30 rad/s and speeds to 100 m/s, in still water and
/// in waves, at any step. Equal seeds give equal runs.
std::vector<RunName> random_runs(std::size_t count, unsigned seed);

}  // namespace stress

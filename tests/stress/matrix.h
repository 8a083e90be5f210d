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

/// Returns about 200 of the runs, from all parts, for every build.
std::vector<RunName> subset();

}  // namespace stress

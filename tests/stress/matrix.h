#pragma once

#include <vector>

#include "tests/stress/run_name.h"

/// @file
/// Which runs the stress test consists of. The lists are the same on every machine.

namespace stress {

/// All runs, each once: around each of a few bases every value of every parameter by itself; a
/// Latin hypercube over all parameters; long runs of bodies with much added mass; teapots of 80,000
/// triangles.
std::vector<RunName> whole_matrix();

/// About 200 of them, from all parts, for every build.
std::vector<RunName> subset();

}  // namespace stress

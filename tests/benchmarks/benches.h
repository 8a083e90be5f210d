#pragma once

/// @file
/// The groups of benchmarks; each function registers those of one file.

namespace bench {

void register_hydro();

}  // namespace bench

#pragma once

#include <array>

#include "hydro/loads/kernel/load_inputs.h"
#include "hydro/loads/kernel/panels.h"
#include "hydro/loads/kernel/tree.h"

/// @file
/// The walk through a hull's tree that adds up its loads, by the best vector unit that the
/// processor has. It has two parts, so that several threads can share the second. What the first
/// adds and which branches it leaves depend on the hull and the water alone.

namespace hydro::kernel {

/// The branches that the second part has to look into. Each is one piece of work.
struct Chunks {
  std::array<int, kMostChunks> node;
  int count = 0;
};

/// Adds the loads on branches that can be taken whole near the root, and lists the others.
Chunks sum_top(const Panels& panels, const Tree& tree, const LoadInputs& in, Sums& sums);

/// Adds the loads on one branch.
void sum_branch(const Panels& panels, const Tree& tree, const LoadInputs& in, int node, Sums& sums);

}  // namespace hydro::kernel

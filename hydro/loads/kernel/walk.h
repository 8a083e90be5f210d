#pragma once

#include "hydro/loads/kernel/load_inputs.h"
#include "hydro/loads/kernel/panels.h"
#include "hydro/loads/kernel/tree.h"

namespace hydro::kernel {

/// The loads on all faces of a hull, by the best vector unit that the processor has.
///
/// A walk through the tree adds them up. For a large hull it takes branches near the root whole
/// where that can be done, and cuts the others into pieces of work, which several threads share.
/// The pieces depend on the hull and the water alone, and are added in their order, so the sums do
/// not depend on the threads.
Sums sum_hull(const Panels& panels, const Tree& tree, const LoadInputs& in);

}  // namespace hydro::kernel

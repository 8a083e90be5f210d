#pragma once

#include "hydro/loads/kernel/load_inputs.h"
#include "hydro/loads/kernel/panels.h"
#include "hydro/loads/kernel/tree.h"

namespace hydro::kernel {

/// A wind by the power law of air.h, in body axes.
struct PowerLaw {
  double velocity[3] = {};  ///< At the wind's own height [m/s].
  double exponent = 0;      ///< α [-].
  double per_height = 0;    ///< One over the wind's own height [1/m].
};

/// The pressure drag of the air on the faces above the surface, in the rows kPressureDrag of the
/// sums, by the best vector unit that the processor has. Above the surface are the faces' parts of
/// negative depth, cut as the water's are.
///
/// Over a triangle the factor (z/h)^α of the wind is taken as linear. With ε = z/z_c − 1, z_c the
/// height of its centre, e the corners' ε, p = Σ e² and q = e_1 e_2 e_3, the means over it are
///
///     ⟨ε²⟩ = p/12          ⟨ε³⟩ = q/10          ⟨ε⁴⟩ = p²/60                                (1)
///
/// and the factor is (z_c/h)^α (⟨f⟩ + ε ⟨ε f⟩/⟨ε²⟩), f the Taylor series of (1 + ε)^α to the fourth
/// order. For α = 0.11 the mean of its square is within 5e-4 of that of the power law if the lowest
/// corner has a quarter of the height of the highest, and within 0.3 % if it is on the water.
///
/// @param in    Its `above` is set and its motion is that relative to the wind, with lift 0; by the
///              power law it is the motion of the hull.
/// @param law   It is null where the wind is uniform: then there is no error but round-off.
Sums sum_wind(const Panels& panels, const Tree& tree, const LoadInputs& in, const PowerLaw* law);

}  // namespace hydro::kernel

#pragma once

#include "hydro/added_mass/potentials.h"
#include "hydro/added_mass/surface_cut.h"
#include "hydro/loads/kernel/load_inputs.h"

/// @file
/// The integral ∫ ψ_m N_n dS over the wetted faces of a hull, by the walk through the tree and in
/// the vector lanes that the loads have.
///
/// The integral over the wet part of a face follows from the part's area and its first and second
/// moments, which are the same for all six potentials:
///
///     ∫ ψ {1, x, y} dA = ψ_c ∫ {1, x, y} dA + ψ_x ∫ x {1, x, y} dA + ψ_y ∫ y {1, x, y} dA    (1)

namespace hydro::kernel {

/// Rows of the sums: ∫ ψ_m N_n dS with a minus, row by row; ∫ ψ_m u̇·n dS; those of a cut.
enum : int { kShare = 0, kLoad = 36, kCut = 42, kShareSums = kCut + kCutSums };

/// The wetted part of a hull.
struct WettedShare {
  Matrix6d share = Matrix6d::Zero();  ///< ∫ ψ_m N_n dS.
  SurfaceCut cut;                     ///< By flat water; empty in waves.
};

/// The motion in `in` does not count.
WettedShare wetted_share(const Panels& panels, const Tree& tree, const Potentials& potentials,
                         const LoadInputs& in);

/// The integrals under Airy waves.
struct WaveShare {
  Matrix6d share = Matrix6d::Zero();  ///< ∫ ψ_m N_n dS.
  Vector6d load = Vector6d::Zero();   ///< ∫ ψ_m u̇·n dS, u̇ in body axes.
};

/// Both over the wetted part of a hull. Over whole branches u̇ is taken as constant or quadratic
/// where that misses less than g times `in.wave_error` over the largest potential.
WaveShare wave_share(const Panels& panels, const Tree& tree, const Potentials& potentials,
                     const LoadInputs& in);

}  // namespace hydro::kernel

#pragma once

#include <complex>

#include "hydro/added_mass/patch_integrals.h"

/// @file
/// The boundary integral equation (1) of radiation_solve.h on the patches of a wetted hull.

namespace hydro {

/// A point of a patch at which the smooth part of G is taken.
struct PatchNode {
  Eigen::Vector3d at;
  Eigen::Matrix3d flux;  ///< ∫ L f_b n dS, one column per function b, with L the node's weight.
  MotionRow source;      ///< ∫ L N dS
};

/// The wetted hull in H, and what of (1) does not depend on the frequency.
struct RadiationEquations {
  using SixColumns = Eigen::Matrix<double, Eigen::Dynamic, 6>;

  WaterPlane plane;
  /// Depth of the water [m]; may be infinite.
  double depth = std::numeric_limits<double>::infinity();
  /// Factor of 1/r': 1, or −1 in the limit of high frequency.
  double image = 1;
  std::vector<Patch> patches;
  std::vector<PatchMoments> moments;
  std::vector<PatchNode> nodes;        ///< Three a patch.
  std::vector<Eigen::Vector3d> inner;  ///< Points of the waterplane inside the hull.
  double inner_weight = 0;             ///< Weight of their equations.
  double sloshing = 0;                 ///< A lower bound of ω²/g of sloshing [1/m].
  Eigen::MatrixXd
      rankine;  ///< Coefficients of ½ψ, 1/r, 1/r' and 1/r''; rows of patches, then inner points.
  Eigen::MatrixXd rising;  ///< (1/4π) ∫ f_b n_z/r' dS
  SixColumns side;         ///< (1/4π) ∫ N (1/r + 1/r' + 1/r'') dS

  Eigen::Index unknowns() const { return 3 * static_cast<Eigen::Index>(patches.size()); }
  /// Lowest wetted point's depth below the surface [m].
  double draught() const;
  /// Largest horizontal distance of two nodes or inner points, or more [m].
  double reach() const;
};

/// Whether waves form on the surface.
enum class SurfaceWaves { yes, no };

/// @param mesh_H   Closed.  @param plane   Plane of the water's surface, with up = z.
/// @param waves    no: the limit of high frequency, with zero potential on the surface.
/// @return no patches for a dry body
RadiationEquations make_radiation_equations(const TriMesh& mesh_H, const WaterPlane& plane,
                                            double depth, int patches, SurfaceWaves waves);

/// The potentials of the six motions: three coefficients for each patch (surface_patches.h).
/// @param deep_wave_number   ω²/g [rad/m]; of no effect in the limit of high frequency.
Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 6> solve_potentials(
    const RadiationEquations& equations, double deep_wave_number);

/// ∫ ψ_m N_n dS
Eigen::Matrix<std::complex<double>, 6, 6> load_of(
    const RadiationEquations& equations,
    const Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 6>& potentials);

}  // namespace hydro

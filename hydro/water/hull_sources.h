#pragma once

#include <Eigen/Core>
#include <memory>

#include "hydro/mesh/mesh.h"
#include "hydro/radiation/floating_body.h"
#include "hydro/sea.h"
#include "hydro/water/periodic_waves.h"

/// @file
/// A floating hull and the water that PeriodicWaves simulates: the sources by which the hull moves
/// the water, and the load of the water on the hull.
///
/// The velocity potential about the hull, ∇Φ the water's velocity, is that of the hull's sources,
/// φ_b, and that of the simulated waves, φ_w. About the mean pose, on the mean wetted surface,
///
///     φ_b = −Σ_j V_j' G_j,        (½ − a⁻¹Kᵀa) σ = (u − ∇φ_w)·n,        V_j' = a_j σ_j,       (1)
///     K_ij = ∫_j ∂G/∂n dS at i,   G = (1/r + 1/r')/4π − P,                                   (2)
///     P = Σ_k F² C(k, z) e^{kz'} e^{ik·(x − x')} g/(ω² L²) + c,                              (3)
///
/// with the patches' areas a. Waves that the grid holds meet the condition φ_b = 0 on the surface,
/// whose image has the other sign, −1/r'; waves too short for it are faster than any motion of the
/// hull, and meet ∂φ_b/∂z = 0. P with the grid's filter F tells the two apart; c makes it 1/2πr'
/// for sources that are closer than the square is wide. The transpose of K gives each source's
/// whole flux to the water outside, so that (1) has the added mass of the direct method
///
///     (½ − K) ψ = ∫ N G dS,        A∞ = ∫ ψ_m N_n dS,        N = (n, r × n).                 (4)
///
/// By Green's identity on the water outside, the load of the waves is, with η's harmonic
/// continuation below the surface,
///
///     F_m = −ρg ∫ (η N_m + ψ_m ∂η/∂n) dS,                                                    (5)
///
/// which needs neither pressures nor the change of the sources. The given sea has its own load by
/// hydrostatics and Froude and Krylov; what the hull scatters of it at once is ρ ∫ ψ_m (u̇·n) dS,
/// and the rest comes by (1) and (5).
///
/// A motion ξ gives the volumes M⁻ᵀ ∫ N·ξ dS to the sources, M = ½ − K. They raise the water by a
/// field whose load is −ρg C ξ: for a time that is short for waves the water is a spring.
///
/// Each patch has one source, at its centre. Cells of a quarter of the hull's breadth are small
/// enough, and so are 250 patches.

namespace hydro {

/// The hull in the frame H of radiation_data.h, for water of density 1.
struct HullSources {
  using SixColumns = Eigen::Matrix<double, Eigen::Dynamic, 6>;
  using SixRows = Eigen::Matrix<double, 6, Eigen::Dynamic>;

  MeanPose pose;
  LinearWater water;
  double volume = 0;  ///< Displaced in the mean pose [m^3].
  /// Places of the patches: x, y from H's origin, z from the still surface [m].
  Eigen::Matrix3Xd places = {};
  Eigen::Matrix3Xd fluxes = {};  ///< ∫ n dS [m^2].
  SixColumns motions = {};       ///< ∫ N dS
  SixColumns potentials = {};    ///< ψ
  Eigen::MatrixXd volumes = {};  ///< M⁻ᵀ: volumes of the sources by the flow through the patches.
  Matrix6d added_mass = {};      ///< A∞
  Matrix6d spring = {};          ///< C [m^2]
  Matrix6d thin_spring = {};     ///< The same of the sources (6) [m^2].
  SixRows reply = {};            ///< The same, g left out, by the flow through the patches [1/m].
  double waterplane = 0;         ///< Area of the waterplane [m^2].
  /// Points of the waterplane a cell from its edge, from H's origin.
  Eigen::Matrix2Xd inside = {};

  /// True unless the hull lies wholly below the surface.
  bool pierces_surface() const { return waterplane > 1e-6 * length() * length(); }
  /// Longer horizontal side of the box about the places [m].
  double length() const;
  /// Radius of the circle of the waterplane's area [m].
  double radius() const;
  /// (5) over −ρg of a field of the elevation η and its gradient at the places.
  Vector6d load_of(const Eigen::VectorXd& raise, const Eigen::Matrix3Xd& slope) const;
};

/// @param mesh_B   Closed; its origin is the centre of mass.
/// @param square   Square of the waves; its number of cells does not matter.
/// @throws std::invalid_argument if the body is dry in the pose or reaches the bottom.
HullSources make_hull_sources(const TriMesh& mesh_B, const MeanPose& pose,
                              const PeriodicSquare& square, int patches = 250);

/// The hull with A∞ and without memory; in place of the diffraction is the load of what the held
/// hull scatters at once.
/// @param mesh_B   As for make_hull_sources().
std::shared_ptr<const FloatingBody> floating_hull(const HullSources& hull, const TriMesh& mesh_B,
                                                  const Sea& sea);

}  // namespace hydro

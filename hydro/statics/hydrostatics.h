#pragma once

#include <Eigen/Core>

#include "hydro/mesh/mesh.h"

/// @file
/// Hydrostatics of a closed body in still water: displaced volume, centre of buoyancy, waterplane.
///
/// Let d >= 0 be the depth below the water surface, linear on each wet triangle of area vector a =
/// A n. The vertical fields d ẑ, x d ẑ, y d ẑ and d²/2 ẑ vanish on the surface, so the divergence
/// theorem leaves integrals over the wet triangles alone, with closed forms [EM73]:
///
///     V        = −∫ d n_z dS     = −Σ a_z S / 3,                 S = d_0 + d_1 + d_2        (1)
///     ∫ x dV   = −∫ x d n_z dS   = −Σ (a_z / 12) Σ_i (S + d_i) x_i,   ∫ y dV alike          (2)
///     ∫ −d dV  = ∫ d²/2 n_z dS   = Σ (a_z / 12) (Σ_i d_i² + Σ_{i<j} d_i d_j)                (3)
///
/// The waterplane is the region enclosed by the waterline, the edges of the wet triangles at d = 0.
/// By Green's theorem, with c = p × q for an edge from p to q that has the waterplane on its left,
///
///     area = Σ c / 2,    ∫ r dA = Σ c (p + q) / 6,                                           (4)
///     ∫ r rᵀ dA = Σ (c / 24) (p pᵀ + q qᵀ + (p + q)(p + q)ᵀ)                                 (5)
///
/// No chain of edges is built, so the region may be of any shape, with islands and holes. All
/// results are exact to round-off. A face that lies in the surface is dry.
///
/// Frame    G: origin at the centre of mass, W axes. `height` [m] is the height of the centre of
///          mass above the water.
/// Units    SI; no density and no gravity: forces and stiffness are per ρ g.
///
/// [EM73] Eisenberg, Malvern. On finite element integration in natural co-ordinates.
///        Int. J. Numer. Methods Eng. 7 (1973) 574-575.

namespace hydro {

/// The section of a body in the surface of the water.
struct Waterplane {
  double area = 0;                                     ///< [m^2]
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  ///< Centre of flotation, in G [m].
  /// ∫ (r − c)(r − c)ᵀ dA about the centroid [m^4]: element (0, 0) is for pitch, (1, 1) for roll.
  Eigen::Matrix2d second_moment = Eigen::Matrix2d::Zero();
};

/// The geometry of the wet part of a body.
struct Hydrostatics {
  double volume = 0;  ///< Displaced volume [m^3].
  /// In G [m]; zero if nothing is wet.
  Eigen::Vector3d centre_of_buoyancy = Eigen::Vector3d::Zero();
  double wetted_surface = 0;  ///< [m^2]
  Waterplane waterplane;      ///< Section in the surface.
};

/// Evaluates the wet part of a body in still water.
/// @param mesh_G   Closed and outward.
/// @param height   Height of the centre of mass above the water [m].
Hydrostatics hydrostatics(const TriMesh& mesh_G, double height);

/// The displaced volume under a surface that need not be level.
struct WetVolume {
  double volume = 0;                                 ///< [m^3]; all fields are 0 if nothing is wet.
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< Centroid, x and y in G [m].
  double depth = 0;                                  ///< Mean depth below the surface [m].
};

/// Evaluates (1) to (3), which require ∂d/∂z = −1.
/// @param mesh_G   Closed and outward.
/// @param depths   Depths of the vertices, linear over faces [m].
WetVolume wet_volume(const TriMesh& mesh_G, const Eigen::RowVectorXd& depths);

/// Second derivatives of the potential energy with respect to heave, roll and pitch about the
/// centre of mass, per ρ g: [m^2], [m^3], [m^4]. With the volume V, the centre of buoyancy B,
/// integrals over the waterplane and x, y in G,
///
///     | ∫ dA    ∫ y dA             −∫ x dA           |
///     |         V z_B + ∫ y² dA    −∫ x y dA         |  symmetric [N77, ch. 4].              (6)
///     |                            V z_B + ∫ x² dA   |
///
/// In any pose the matrix is minus the derivative of force and moment with respect to heave and
/// small rotations about W axes.
///
/// [N77] Newman. Marine Hydrodynamics. MIT Press (1977), sec. 6.16.
Eigen::Matrix3d restoring_stiffness(const Hydrostatics& h);

/// (6) with heave eliminated, per volume [m]: the metacentric heights GM of roll and pitch and
/// their coupling, z_B + (1/V) ∫ (r − c)(r − c)ᵀ dA in the axes of roll and pitch.
Eigen::Matrix2d metacentric_heights(const Hydrostatics& h);

}  // namespace hydro

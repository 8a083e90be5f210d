#pragma once

#include <Eigen/Core>

#include "hydro/mesh/mesh.h"

/// @file
/// What still water cuts off a closed body: displaced volume, centre of buoyancy, waterplane.
///
/// With the depth d >= 0 below the water surface, linear on each wet triangle of area vector
/// a = A n, the divergence theorem for the vertical fields that vanish on the surface, d ẑ, x d ẑ,
/// y d ẑ and d²/2 ẑ, leaves integrals over the wet triangles alone, and [EM73] their closed forms:
///
///     V        = −∫ d n_z dS     = −Σ a_z S / 3,                 S = d_0 + d_1 + d_2        (1)
///     ∫ x dV   = −∫ x d n_z dS   = −Σ (a_z / 12) Σ_i (S + d_i) x_i,   ∫ y dV alike          (2)
///     ∫ −d dV  = ∫ d²/2 n_z dS   = Σ (a_z / 12) (Σ_i d_i² + Σ_{i<j} d_i d_j)                (3)
///
/// The waterplane is the region that the waterline, the edges of the wet triangles at d = 0, runs
/// around. By Green's theorem, with c = p × q for an edge from p to q, the waterplane on its left:
///
///     area = Σ c / 2,    ∫ r dA = Σ c (p + q) / 6,                                           (4)
///     ∫ r rᵀ dA = Σ (c / 24) (p pᵀ + q qᵀ + (p + q)(p + q)ᵀ)                                 (5)
///
/// No chain of edges is built, so the region may be of any shape, with islands and holes. All are
/// exact to round-off. A face that lies in the surface is dry.
///
/// Frame    G: origin at the centre of mass, W axes. `height` is that of the centre of mass above
///          the water [m].
/// Units    SI; no density and no gravity: forces and stiffness are per ρ g.
///
/// [EM73] Eisenberg, Malvern. On finite element integration in natural co-ordinates.
///        Int. J. Numer. Methods Eng. 7 (1973) 574-575.

namespace hydro {

struct Waterplane {
  double area = 0;                                     ///< [m^2]
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  ///< Centre of flotation, in G [m].
  /// ∫ (r − c)(r − c)ᵀ dA about the centroid [m^4]: (0, 0) is that of pitch, (1, 1) of roll.
  Eigen::Matrix2d second_moment = Eigen::Matrix2d::Zero();
};

struct Hydrostatics {
  double volume = 0;  ///< Displaced [m^3].
  Eigen::Vector3d centre_of_buoyancy =
      Eigen::Vector3d::Zero();  ///< In G [m]; zero if nothing is wet.
  double wetted_surface = 0;    ///< [m^2]
  Waterplane waterplane;
};

/// @param mesh_G   Closed and outward.
Hydrostatics hydrostatics(const TriMesh& mesh_G, double height);

/// What lies under a surface that need not be level.
struct WetVolume {
  double volume = 0;                                 ///< [m^3]; 0 if nothing is wet, as the others.
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< x and y in G [m].
  double depth = 0;                                  ///< Mean, below the surface over it [m].
};

/// By (1) to (3), which ask for depths that fall by 1 with z alone.
/// @param mesh_G   Closed and outward. @param depths   Of its vertices, linear over faces [m].
WetVolume wet_volume(const TriMesh& mesh_G, const Eigen::RowVectorXd& depths);

/// Second derivatives of the potential energy by heave, roll and pitch about the centre of mass,
/// per ρ g: [m^2], [m^3], [m^4]. With V the volume, B the centre of buoyancy, all integrals over
/// the waterplane and x, y in G,
///
///     | ∫ dA    ∫ y dA             −∫ x dA           |
///     |         V z_B + ∫ y² dA    −∫ x y dA         |  symmetric [N77, ch. 4].              (6)
///     |                            V z_B + ∫ x² dA   |
///
/// These are minus the derivatives of force and moment by small turns about W axes, in any pose.
///
/// [N77] Newman. Marine Hydrodynamics. MIT Press (1977), sec. 6.16.
Eigen::Matrix3d restoring_stiffness(const Hydrostatics& h);

/// (6) with heave eliminated, per volume [m]: the metacentric heights GM of roll and pitch and what
/// couples them, z_B + (1/V) ∫ (r − c)(r − c)ᵀ dA turned to the axes of roll and pitch.
Eigen::Matrix2d metacentric_heights(const Hydrostatics& h);

/// Height of the centre of mass at which the body displaces `volume` as it is turned.
///
/// Displacement falls with height, by the waterplane area (dV/dh = −area), so there is one height;
/// where there is an interval of them (a gap between parts one above the other) it is one of these.
/// Newton's method within a bracket that always shrinks; to round-off, 2e-15 of the volume.
/// @throws std::invalid_argument unless volume is positive and less than the whole body's.
double floating_height(const TriMesh& mesh_G, double volume);

}  // namespace hydro

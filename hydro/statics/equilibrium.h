#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/statics/hydrostatics.h"

/// @file
/// How a body floats at rest: the attitude of least potential energy, and what rights it at others.
///
/// At a given attitude the height is that of flotation (`floating_height`). The potential energy of
/// body and water over weight is then the height of the centre of mass G above the centre of
/// buoyancy B, a function of the attitude alone. For turns θ about the horizontal W axes, with B in
/// G and the metacentric heights M of hydrostatics.h (heave eliminated),
///
///     e = −z_B,    ∂e/∂θ = (−y_B, x_B),    ∂²e/∂θ∂θ = M.                                     (1)
///
/// It does not depend on turns about the vertical. It has a continuous gradient; M jumps where a
/// face of the body comes to lie in the surface.
///
/// Frames   B: origin at the centre of mass.   G: the same origin, W axes.
/// Units    SI. `volume` is what the body displaces, its mass over the density of water [m^3].
/// Errors   std::invalid_argument unless volume is positive and less than the body's.

namespace hydro {

/// A body that displaces its mass at some attitude. A value.
struct Flotation {
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< R_WB
  double height = 0;          ///< Of the centre of mass above the water [m].
  double draught = 0;         ///< Of the lowest point [m].
  Hydrostatics hydrostatics;  ///< In G.

  /// (1): the arms of the moment about the centre of mass, over weight [m]; zero at equilibrium.
  Eigen::Vector2d gradient() const;
};

/// The body as it is turned, at the height where it displaces `volume`.
Flotation afloat(const TriMesh& mesh_B, double volume, const Eigen::Quaterniond& orientation);

/// Whether small turns are resisted.
enum class Stability {
  stable,   ///< Both principal metacentric heights are positive.
  neutral,  ///< One is zero to 1e-9 of the body's radius, none negative.
  unstable
};
Stability stability(const TriMesh& mesh_B, const Flotation& flotation);

/// A least potential energy, found downhill from `start` by steps of at most 0.2 rad: a
/// trust-region Newton method on (1). Steps are turns about horizontal axes. From a saddle or a
/// maximum it leaves along the least stable direction, to the side that `trust_region_step` names.
/// Where a search has ended, eight attitudes 1e-3 rad around are tried: a saddle that (1) shows
/// from one side only, or not at all, is left too. The remaining arm of the moment is round-off,
/// a few 1e-15 of the body's radius.
Flotation equilibrium(const TriMesh& mesh_B, double volume, const Eigen::Quaterniond& start);

/// A point of the curve of righting arms.
struct RightingArm {
  double heel = 0;     ///< [rad]
  double trim = 0;     ///< [rad]
  double draught = 0;  ///< [m]
  double lever = 0;    ///< GZ, positive if it turns the body back from a positive heel [m].
};

/// The righting arm at each heel, with height and trim at rest: R_WB = Ry(trim)·Rx(heel), so heel
/// turns about the body's x axis and a positive trim puts its +x end down. Each search for the trim
/// starts at the last one, the first at 0.
///
/// GZ is the horizontal distance from B to G across the body's x axis, −y_B. The work of righting
/// the body is weight times ∫ GZ cos(trim) dheel.
std::vector<RightingArm> righting_arms(const TriMesh& mesh_B, double volume,
                                       const std::vector<double>& heels);

/// Roll, pitch and yaw of R = Rz(yaw)·Ry(pitch)·Rx(roll) [rad], pitch within ±π/2.
Eigen::Vector3d euler_angles(const Eigen::Quaterniond& orientation);

/// The orientation turned about the vertical until the horizontal part of the body's x axis points
/// along `heading`, counter-clockwise from +x [rad]; as it is if that axis is vertical to 1e-9.
Eigen::Quaterniond with_heading(const Eigen::Quaterniond& orientation, double heading);

}  // namespace hydro

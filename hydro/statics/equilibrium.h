#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "hydro/loads/loads.h"
#include "hydro/mesh/mesh.h"
#include "hydro/statics/hydrostatics.h"
#include "hydro/statics/immersed_mesh.h"

/// @file
/// The attitude at which a body floats at rest, and its righting arms at other attitudes.
///
/// At a given attitude the body is at its floating height (immersed_mesh.h). The potential energy
/// of body and water, over the weight, is then the height of the centre of mass G above the centre
/// of buoyancy B, a function of the attitude alone. For rotations θ about the horizontal W axes,
/// with B expressed in G and the metacentric heights M of hydrostatics.h (heave eliminated),
///
///     e = −z_B,    ∂e/∂θ = (−y_B, x_B),    ∂²e/∂θ∂θ = M.                                     (1)
///
/// The energy e does not depend on rotations about the vertical. Its gradient is continuous; M
/// jumps where a face of the body lies in the surface.
///
/// Water in tanks weighs on the body: `volume` then includes it, and with its volume v, its
/// centroid C and M_v of its free surface by the same formulas, (1) holds with B − Σ (v/V) C in
/// place of B and M − Σ (v/V) M_v in place of M: its centre is that of the water as it lies, and
/// its surface takes from the stability.
///
/// Frames   B: origin at the centre of mass.   G: the same origin, W axes.
/// Units    SI. `volume` is the displacement: the mass over the density of water [m^3].
/// Errors   std::invalid_argument unless volume is positive and less than the body's.

namespace hydro {

/// Water that is enclosed in a body, in a pocket of hydro/interior.
struct Tank {
  Hull hull;          ///< The surface of the pocket; its normals point into the water.
  double volume = 0;  ///< [m^3], > 0.
};

/// A body that displaces its mass, and that of the water in it, at some attitude.
struct Flotation {
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< R_WB
  double height = 0;                ///< Height of the centre of mass above the water [m].
  double draught = 0;               ///< Depth of the lowest point [m].
  Hydrostatics hydrostatics;        ///< Hydrostatics in G.
  std::vector<Hydrostatics> tanks;  ///< Hydrostatics of the water in each tank, in G.

  /// B − Σ (v/V) C [m]
  Eigen::Vector3d effective_centre() const;
  /// M − Σ (v/V) M_v [m]
  Eigen::Matrix2d effective_metacentric_heights() const;

  /// Gradient in (1): the moment arms about the centre of mass [m]; zero at equilibrium.
  Eigen::Vector2d gradient() const;
};

/// Returns the body at the given orientation and the height where it displaces `volume`.
/// @param volume   The mass of the body and of the water in its tanks, over the density of water
///     [m^3].
/// @param guess    The height where that is looked for first [m].
Flotation afloat(const ImmersedMesh& mesh, double volume, const Eigen::Quaterniond& orientation,
                 const std::vector<Tank>& tanks = {}, std::optional<double> guess = std::nullopt);

/// Stability of a floating body against small rotations.
enum class Stability {
  stable,   ///< Both principal metacentric heights are positive.
  neutral,  ///< One is zero within 1e-9 of the body's radius, none is negative.
  unstable
};
/// Judges a flotation by its metacentric heights.
Stability stability(const ImmersedMesh& mesh, const Flotation& flotation);

/// Finds a local minimum of the potential energy downhill from `start`, by a trust-region Newton
/// method on (1) with rotations of at most 0.2 rad about horizontal axes. From a saddle or a
/// maximum the search leaves along the least stable direction, on the side chosen by
/// `trust_region_step`. Where a search ends, eight attitudes 1e-3 rad around are tried, so it also
/// leaves a saddle that (1) shows from one side only or not at all. The remaining moment arm is
/// round-off, a few 1e-15 of the body's radius.
Flotation equilibrium(const ImmersedMesh& mesh, double volume, const Eigen::Quaterniond& start,
                      const std::vector<Tank>& tanks = {});

/// A point of the curve of righting arms.
struct RightingArm {
  double heel = 0;     ///< [rad]
  double trim = 0;     ///< [rad]
  double draught = 0;  ///< [m]
  double lever = 0;    ///< GZ, positive if it restores the body from a positive heel [m].
};

/// Returns the righting arm at each heel, with height and trim in equilibrium: R_WB =
/// Ry(trim)·Rx(heel), so heel is a rotation about the body's x axis and a positive trim lowers its
/// +x end. Each search for the trim starts at the previous trim, the first at 0.
///
/// GZ is the horizontal distance from B to G across the body's x axis, −y_B, G that of body and
/// water in its tanks. The work of righting
/// the body is weight times ∫ GZ cos(trim) dheel.
std::vector<RightingArm> righting_arms(const ImmersedMesh& mesh, double volume,
                                       const std::vector<double>& heels,
                                       const std::vector<Tank>& tanks = {});

/// Roll, pitch and yaw of R = Rz(yaw)·Ry(pitch)·Rx(roll) [rad], pitch within ±π/2.
Eigen::Vector3d euler_angles(const Eigen::Quaterniond& orientation);

/// Returns the orientation rotated about the vertical until the horizontal part of the body's x
/// axis points along `heading`, counter-clockwise from +x [rad]; unchanged if that axis is vertical
/// within 1e-9.
Eigen::Quaterniond with_heading(const Eigen::Quaterniond& orientation, double heading);

}  // namespace hydro

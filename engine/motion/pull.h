#pragma once

#include "engine/base/spatial_vector.h"

/// @file
/// A force that pulls a point of a body to a place, as a hand does.
///
/// With p the point, v_p its velocity and M_p = (J S⁻¹ Jᵀ)⁻¹, J = (1, −[r]×), the body's mass
/// there,
///
///     F = M_p (ω² (to − p) − 2 ω v_p).                                                   (E17)
///
/// Without other loads p'' = ω² (to − p) − 2 ω p', but for terms of the rotation: whatever the
/// point, it approaches its place as fast as it can without overshoot,
/// p − to = (p₀ − to) (1 + ω t) e^(−ωt) from rest. The mass leaves out joints, locks and contacts,
/// under which the point is slower.

namespace engine {

/// The pull of (E17) on a body.
struct Pull {
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();  ///< The point p, in B [m].
  Eigen::Vector3d to_W = Eigen::Vector3d::Zero();  ///< Its place [m].
  double rate = 10;                                ///< ω [1/s], > 0.
};

/// The load (E17) on a body: moment about the centre of mass, in W. @param inertia_W   S
hydro::Wrench wrench(const Pull& pull, const Matrix6d& inertia_W, const hydro::BodyState& state);

}  // namespace engine

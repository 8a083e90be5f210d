#pragma once

#include "engine/spatial_vector.h"

/// @file
/// A hand that draws a body by one of its points.
///
/// With p the point, v_p its velocity and M_p = (J S⁻¹ Jᵀ)⁻¹, J = (1, −[r]×), the mass that the
/// body has there,
///
///     F = M_p (ω² (to − p) − 2 ω v_p).                                                    (E17)
///
/// Without other loads p'' = ω² (to − p) − 2 ω p' but for what turning does: wherever the body is
/// taken hold of, the point comes to its place as fast as it can without swinging past it,
/// p − to = (p₀ − to) (1 + ω t) e^(−ωt) from rest. The mass is that of the body without its joints,
/// locks and contacts, so that under those it comes slower.

namespace engine {

struct Pull {
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();  ///< Where it takes hold, in B [m].
  Eigen::Vector3d to_W = Eigen::Vector3d::Zero();  ///< Where that point is drawn to [m].
  double rate = 10;                                ///< ω [1/s], > 0.
};

/// Its load on a body: moment about the centre of mass, in W.
/// @param inertia_W   S, of the body with the water that moves with it.
hydro::Wrench wrench(const Pull& pull, const Matrix6d& inertia_W, const hydro::BodyState& state);

}  // namespace engine

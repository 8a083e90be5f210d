#pragma once

#include "hydro/loads/loads.h"

/// @file
/// The load of the air on the dry part of a hull.
///
/// It is pressure drag as in the water, with the density of the air, the coefficients C_p of the
/// body, K = 1 for all bodies (bluntness.h: what stands above the water is mostly blunt) and the
/// velocity v = v_0 + ω × r − U(z) relative to the wind,
///
///     F = −½ρ ∫_dry C_p v_n |v_n| n dS,                                                      (1)
///
/// summed by the kernel of the water's loads (kernel/wind_walk.h): triangles are cut at the
/// waterline as in the water, and each piece again at v_n = 0. Friction is left out: that of a
/// smooth plate in air, about 0.003, is less than 1 % of C_p. So are lift, the weight of the
/// displaced air and its added mass, each about 1/800 of the water's.
///
/// The height z of the wind's profile is that above the water at the instant, right below or above
/// the point: it is linear over the dry pieces and zero on their waterline.

namespace hydro {

/// The load of the air of `sea` on the dry part of a hull, (1): the moment is about the centre of
/// mass, in W. Without air it is zero.
///
/// In uniform wind over flat water it is exact to round-off. By the power law it is
/// within 0.3 % on a wall of two triangles that rises from the water, for all exponents, and within
/// 0.05 % on a floating sphere of 320 triangles. In waves faces that the waterline
/// may cross are split until it is near its chord (refine.h).
/// A calibration of the drag scales it as for a body that moves in the direction of the wind.
Wrench wind_load(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                 const Coefficients& coefficients);

}  // namespace hydro

#pragma once

#include "engine/spec.h"

/// @file
/// Drag that one explicit step would overshoot.
///
/// Drag D = −½ J ν, J = −∂D/∂ν its resistance, changes by a large part of itself within a step h if
/// the body is light for its size or the step is long. Its stiffness
///
///     a = h D·M⁻¹D / (−D·ν)                                                               (1)
///
/// is the share of the motion relative to the water that an explicit step would take away: above 1
/// it turns the motion around, above 2 it adds energy, and the body is thrown out of the water. So
/// where a > kStiffDrag the drag is taken linearly implicit in the velocity: the step's change of
/// velocity solves
///
///     (M + h J) Δν = h F,   which the load  F − J Δν  brings about,                       (2)
///
/// with F the sum of all loads. J is symmetric and positive semi-definite, so that drag never turns
/// the motion it acts on, and a steady motion is the one that balances the loads.

namespace engine {

/// At this share an explicit step takes away half as much again as quadratic drag does within the
/// step, an implicit one a quarter too little. Below it the explicit step is left as it is.
inline constexpr double kStiffDrag = 0.5;

/// Equation (1); 0 without drag. Locked degrees of freedom take no part.
double drag_stiffness(const BodySpec& body, const hydro::BodyState& state,
                      const Eigen::Vector3d& current, const hydro::Wrench& drag, double step);

/// −J Δν of equation (2): what to add to the load of a step.
///
/// @param load   F: all loads on the body, its weight included; moment about the centre of mass.
hydro::Wrench implicit_part(const BodySpec& body, const hydro::Hull& hull,
                            const hydro::BodyState& state, const hydro::Sea& sea, double time,
                            const hydro::Wrench& load, double step);

}  // namespace engine

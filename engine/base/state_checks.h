#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/spec.h"

/// @file
/// Sentences that say which part of a state or a load is invalid.

namespace engine {

/// "the position's z is inf" or nothing if the state is finite and within kLargestState.
std::optional<std::string> state_fault(const hydro::BodyState& state);

/// "the angular velocity's x is 1e+40, beyond all bounds" or nothing if the body, free and without
/// added mass, would stay within bounds over a step [s] under the load. ODE needs that.
std::optional<std::string> motion_fault(const BodySpec& body, const hydro::BodyState& state,
                                        const hydro::Wrench& load, double step);

/// The loads on a body by origin: moments about the centre of mass, in W.
struct BodyLoads {
  std::vector<hydro::Wrench> applied;  ///< In the order of `BodySpec::loads`; last, the pull.
  hydro::Loads water;
  hydro::Wrench weight;    ///< Weight of the body's own mass.
  hydro::Wrench lines;     ///< Load of lines and drives of joints that are no rows (rig.h).
  hydro::Wrench machines;  ///< Load of propellers and foils.

  hydro::Wrench total() const;
};

/// "the pressure drag's force y is nan", of loads that are not all finite.
std::string load_fault(const BodyLoads& loads);

/// "the largest load is buoyancy, force z = 9810 N", or that there is none.
std::string largest_load(const BodyLoads& loads);

}  // namespace engine

#pragma once

#include <string>
#include <vector>

#include "engine/motion/body.h"
#include "tests/stress/scenario.h"

/// @file
/// Lines and motors of the scenarios.

namespace stress {

/// Values of `with` that name a rig.
const std::vector<std::string>& rigged();
bool is_rigged(const std::string& with);

/// Adds the rig to a scenario that has its bodies and joints.
///
/// rope: a rope of 1e4 times the weight over the size in stiffness ties two copies; leash: one of
/// 1e5 ties a body to the world; spring: a spring of 30 between two copies; moored: a catenary from
/// the body to an anchor below it; driven: a hinge to the world with a motor, stops and friction.
void rig(const std::string& with, Scenario& scenario);

/// True if the energy of the rig is not known, or it has a motor.
bool gives_energy(const std::string& with);

/// ½ k e² of springs and stretched ropes, e their stretch: the most that they can give [J].
double stretch_energy(const engine::SimulationSpec& spec,
                      const std::vector<engine::Motion>& motions);

}  // namespace stress

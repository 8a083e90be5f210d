#pragma once

#include "engine/spec.h"
#include "tests/stress/run_name.h"

/// @file
/// From a run's name to what is simulated.

namespace stress {

struct Scenario {
  engine::SimulationSpec spec;
  long steps = 0;
  double size = 0;                                 ///< Of one body [m].
  double volume = 0;                               ///< Of one body [m^3].
  Eigen::Vector3d push = Eigen::Vector3d::Zero();  ///< Constant force on the first body, W [N].
  /// Still water, no lift, and nothing fixed that the water streams past: energy cannot grow.
  bool passive = false;
};

/// @throws std::invalid_argument for a value that is not known.
Scenario make_scenario(const RunName& run);

}  // namespace stress

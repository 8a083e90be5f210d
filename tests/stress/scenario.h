#pragma once

#include "engine/base/spec.h"
#include "tests/stress/run_name.h"

/// @file
/// Conversion of a run's name to a simulation.

namespace stress {

struct Scenario {
  engine::SimulationSpec spec;
  long steps = 0;
  double size = 0;                                 ///< Size of one body [m].
  double volume = 0;                               ///< Volume of one body [m^3].
  Eigen::Vector3d push = Eigen::Vector3d::Zero();  ///< Constant force on the first body, W [N].
  bool inside = false;  ///< True: the operating envelope has it (app/assembly/envelope.h).
  /// True: energy cannot grow, since the water is still, there is no lift and nothing fixed stands
  /// in a current.
  bool passive = false;
};

/// @throws std::invalid_argument for an unknown value.
Scenario make_scenario(const RunName& run);

}  // namespace stress

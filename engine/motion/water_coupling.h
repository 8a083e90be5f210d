#pragma once

#include <string>
#include <vector>

#include "engine/motion/moving_body.h"
#include "hydro/water/simulated_water.h"

/// @file
/// The simulated water of a scene beside its bodies.
///
/// A step of the water takes as many whole steps of the simulation as its grid allows, one at
/// least. At its start the water tells each hull the load of the waves; the hull moves under it and
/// the spring of wave_memory.h; at the end the water takes the hull's way.

namespace engine {

/// The surface or hull of each body that moves the water.
std::vector<hydro::WaterBody> bodies_in_water(const SimulationSpec& spec);

class WaterCoupling {
 public:
  /// @param spec   Has a grid; it must outlive this.
  explicit WaterCoupling(const SimulationSpec& spec);

  /// Called before the step of this number, from 0.
  /// @param seconds   The wall time is added to it [s].
  void begin_step(long number, std::vector<MovingBody>& bodies, double& seconds);
  /// Called after it.
  void end_step(long number, const std::vector<MovingBody>& bodies, double& seconds);

  const hydro::SimulatedWater& water() const { return water_; }
  std::string state() const { return water_.state(); }
  /// @throws std::invalid_argument if the state is that of other water.
  void restore(const std::string& state) { water_.restore(state); }

 private:
  const SimulationSpec& spec_;
  hydro::SimulatedWater water_;
  long steps_;  ///< Steps of the simulation in one of the water.
};

}  // namespace engine

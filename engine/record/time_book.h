#pragma once

#include <vector>

#include "engine/base/timings.h"
#include "engine/motion/moving_body.h"

namespace engine {

/// Adds up the wall times of the stages of steps.
class TimeBook {
 public:
  /// Books a step.
  /// @param threads     Number that the simulation may use.
  /// @param wall        Wall time of the step [s].
  /// @param collision   The part of it that finds contacts [s].
  void add(const std::vector<MovingBody>& bodies, int threads, double wall, double collision);

  /// Time of simulated water [s], for the caller to add to.
  double& water() { return timings_.water; }

  const Timings& timings() const { return timings_; }

 private:
  /// Wall times that all bodies have booked [s].
  struct BodySeconds {
    double loads = 0, sea = 0, constraints = 0;
  };

  Timings timings_;
  BodySeconds so_far_;  ///< After the last step.
};

}  // namespace engine

#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/counts.h"
#include "engine/base/state_checks.h"
#include "engine/machines/machines.h"
#include "engine/motion/body.h"
#include "engine/motion/pull.h"

/// @file
/// A body in a simulation: its constants, its motion, inputs from outside, and its loads.

namespace engine {

/// Loads of a program on a body, beside those of the scene.
struct Inputs {
  std::optional<Pull> pull;        ///< Until the program ends it.
  std::vector<AppliedLoad> loads;  ///< For the next step only.
};

/// The last loads. They follow from the motion and are no part of it.
struct LoadCache {
  BodyLoads loads;
  /// State that the water's loads are those of; none where they follow from more than that.
  std::optional<hydro::BodyState> water_state;
  std::shared_ptr<const CarriedWater> carried_water;  ///< The water in its pockets for that state.
  Vector6d wake = Vector6d::Zero();                   ///< Wake of the motion for that state.
  WaveMemoryRule memory_rule;                         ///< Rule of the last substep.
  double seconds = 0;             ///< Wall time of loads and added mass so far [s].
  double sea_seconds = 0;         ///< Time spent on the motion of waves about it [s].
  double constraint_seconds = 0;  ///< Time spent on islands of which it is the first body [s].
};

struct MovingBody {
  BodyId id = 0;
  Body body;
  Motion motion;
  Inputs inputs;
  hydro::Wrench rig_load = {};            ///< Load of lines and drives in this substep (rig.h).
  const Machines* machines = nullptr;     ///< Null: it has none.
  const SetPoints* set_points = nullptr;  ///< Set points that its applied loads follow.
  LoadCache cache;
  Counts counts;
};

/// True for a body that can move; false for kWorld.
inline bool can_move(const std::vector<MovingBody>& bodies, BodyId id) {
  return id != kWorld && bodies[id].body.movable;
}

/// Difference by which a motion does not fit a body; null if it fits.
const char* misfit(const MovingBody& moving, const Motion& motion);

/// The loads of the water, and of the air, on a body in a state that may be wet or feels the air.
/// @param motion   Tells the water in its pockets and its wake.
hydro::Loads water_loads(const Body& body, const Motion& motion, const hydro::BodyState& state,
                         double time);

/// The sum of all loads on the body in a state, its weight included; the cache keeps them.
/// @throws MotionFault if they are not finite.
/// @param motion   Tells the water in the pockets and the wake.
hydro::Wrench find_loads(MovingBody& moving, const Motion& motion, const hydro::BodyState& state,
                         double time);
inline hydro::Wrench find_loads(MovingBody& moving, const hydro::BodyState& state, double time) {
  return find_loads(moving, moving.motion, state, time);
}

/// Makes the cache that of a body whose water_state is this one.
void restore_cache(MovingBody& moving, const std::optional<hydro::BodyState>& water_state);

/// The loads of the scene, of the bed's suction and of the program on the body in a state.
std::vector<hydro::Wrench> applied_loads(const MovingBody& moving, const hydro::BodyState& state,
                                         double time);

/// Flows of the body's pumps without a lift, at a time [m^3/s].
std::vector<double> pump_rates(const MovingBody& moving, double time);

/// A load or a state of a body is not finite, or beyond all bounds.
class MotionFault : public std::runtime_error {
 public:
  MotionFault(const Body& body, const std::string& what)
      : std::runtime_error(what), body_(body.spec->name) {}
  const std::string& body() const { return body_; }

 private:
  std::string body_;
};

/// @throws MotionFault if the state is out of bounds, naming the largest load.
void check_state(const MovingBody& moving, const hydro::BodyState& state);

}  // namespace engine

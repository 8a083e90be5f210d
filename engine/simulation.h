#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/counts.h"
#include "engine/base/rig_readings.h"
#include "engine/base/spec.h"
#include "engine/base/step_stopped.h"
#include "engine/base/timings.h"
#include "engine/hollows/interior_water.h"
#include "engine/motion/pull.h"
#include "engine/record/body_forces.h"
#include "engine/record/constraint_errors.h"
#include "engine/simulation_state.h"

/// @file
/// The simulation: bodies in the sea, moved step by step.

namespace hydro {
class SimulatedWater;
}

namespace engine {

/// The simulation cannot go on: a state or load is not finite, or the mechanics engine refuses it.
class SimulationError : public std::runtime_error {
 public:
  /// Makes an error at a time.
  /// @param time   Time of the simulation [s].  @param body   Its name; empty: no single one.
  SimulationError(double time, std::string body, const std::string& what);
  double time() const { return time_; }              ///< [s]
  const std::string& body() const { return body_; }  ///< Empty if no single body is to blame.

 private:
  double time_;
  std::string body_;
};

/// The parts of a step that the scene does not need, and that are never computed.
struct Skips {
  bool collision = false;  ///< Nothing in the scene can collide.
  bool water = false;      ///< There is no water, or no body that it acts on.
};

/// The axes of a load.
enum class Frame {
  world,  ///< The axes of W.
  body,   ///< The axes of the body's mesh; the load turns with the body.
};

/// Bodies in the sea, moved step by step. Owns the mechanics engine.
class Simulation {
 public:
  /// Makes a simulation at time 0.
  /// @throws std::invalid_argument for a step, body or joint that makes no sense (body_check.h),
  ///         SimulationError if the engine refuses the description.
  explicit Simulation(SimulationSpec spec);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// The specification.
  const SimulationSpec& spec() const;
  double time() const;  ///< Time since the start, steps()·step [s].
  /// Steps taken since the start.
  long steps() const;
  /// Pose and velocity of each body, in the order of the specification.
  const std::vector<hydro::BodyState>& states() const;
  /// The loads on each body in its present state, and the works so far.
  /// @throws std::logic_error unless the specification asks for a record of work.
  std::vector<BodyForces> forces() const;
  /// The works of forces(), per body; empty unless the specification asks for a record of work.
  std::vector<Works> works() const;
  /// The pockets of each body and their water, in the present state.
  std::vector<InteriorState> interiors() const;
  /// Lines, joints, machines and set points in the present state.
  RigReadings rig() const;
  /// The simulated water; null without it.
  const hydro::SimulatedWater* water() const;
  /// Wall times of the steps so far.
  const Timings& timings() const;
  /// The parts of a step that are never computed.
  Skips skips() const;
  std::vector<Counts> counts() const;  ///< Counts of steps and loads, per body.
  /// The largest overlaps and errors of joints so far.
  const ConstraintErrors& constraint_errors() const;

  /// Adds a load that acts in the next step only. Calls add up.
  /// @param wrench   Force [N] at the point, and torque [N m] beside it, in the axes of `frame`.
  /// @param at_B     Point where the force acts, in B [m]: by default the centre of mass.
  /// @throws std::invalid_argument for a load that is not finite, or an unknown body.
  void apply(BodyId body, const hydro::Wrench& wrench, Frame frame = Frame::world,
             const Eigen::Vector3d& at_B = Eigen::Vector3d::Zero());

  /// Sets a set point from now on, in the unit of its name, until this is called again; a control
  /// of the scene that drives it no longer does. @throws std::invalid_argument for an unknown name
  /// or a value that is not finite.
  void set(const std::string& set_point, double value);
  /// The same by index, in the unit of its name. @throws std::invalid_argument for a value that is
  /// not finite.
  void set(SetPointId set_point, double value);
  /// Gives the set point back to the scene's control, or to its initial value.
  void release(const std::string& set_point);
  /// The same by index.
  void release(SetPointId set_point);
  /// The value that set() gave; none since it was released.
  std::optional<double> set_value(SetPointId set_point) const;

  /// Pulls the body by one of its points in all steps to come; none lets it go. A body has at most
  /// one pull, at a rate of at most kFastestPull a step; one that cannot move stays.
  void pull(BodyId body, const std::optional<Pull>& pull);

  /// Puts a body in another state, as far as its locks and a joint to the world allow. Its history
  /// and its record of work start anew. @throws std::invalid_argument for an impossible state.
  void set_motion(BodyId body, const hydro::BodyState& state);

  /// Everything that changes, for restore() in this simulation or another of the same
  /// specification. A run continued from a restored state gives the same bytes as one that was
  /// never interrupted. @throws SimulationError after a step that failed.
  SimulationState state() const;
  /// Returns to a state that state() gave.
  /// @throws std::invalid_argument if the state is that of other bodies.
  void restore(const SimulationState& state);
  /// Returns to time 0.
  void reset();

  /// From now on steps ask `stop` some times for each body, from any thread, whether to go on; an
  /// empty one lets them. A step that is not to go on throws StepStopped.
  void stop_if(StopCheck stop);

  /// Advances by one step. The state before it is kept if it throws; until restore() every later
  /// step then throws too. @throws SimulationError, StepStopped
  void step();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace engine

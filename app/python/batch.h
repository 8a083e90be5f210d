#pragma once

#include <tbb/task_arena.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/held/held_simulation.h"
#include "app/held/motions.h"
#include "app/held/observer.h"

namespace python {

/// A simulation of a batch, to be made.
struct BatchMember {
  const scene::Scene* scene = nullptr;  ///< It is read while the simulation is made.
  engine::SimulationSpec spec;
  app::SensorSpec sensors;
};

/// Simulations of scenes with the same bodies and set points, stepped together on several threads.
/// Each goes on exactly as it would alone.
class Batch {
 public:
  /// Makes a simulation of each member; they should share hulls (engine/motion/hulls.h).
  /// @param observed   Names of observables, which are read of each simulation (observer.h).
  /// @throws std::invalid_argument if there is none, or if their bodies or set points have other
  ///     names or numbers than the first's
  /// @throws UnknownName for an observable that there is not
  Batch(std::vector<BatchMember> members, int threads, std::vector<std::string> observed = {});

  std::size_t size() const { return simulations_.size(); }
  std::size_t bodies() const { return spec().bodies.size(); }
  const engine::SimulationSpec& spec() const { return simulations_.front()->engine().spec(); }
  app::HeldSimulation& at(std::size_t simulation) { return *simulations_.at(simulation); }
  app::MotionArrays& motions() { return motions_; }

  /// Numbers of the observed names of each simulation, in the units of their names.
  std::vector<double>& observations() { return observations_; }
  const std::vector<std::string>& observed() const { return observed_; }

  /// Loads that act in every step, three numbers a body of each simulation: forces [N] at the
  /// centres of mass, and torques [N m], in W.
  std::vector<double>& forces() { return forces_; }
  std::vector<double>& torques() { return torques_; }
  /// Values of the set points of each simulation, in the units of their names; NaN leaves a set
  /// point to the scene.
  std::vector<double>& controls() { return controls_; }

  /// Takes `count` steps of every simulation that has not failed.
  /// @param which   Simulations that are stepped; empty: all.
  /// @throws std::invalid_argument, before any is taken, for a load or set value that is infinite
  void step(long count, const std::vector<std::size_t>& which = {});

  /// Brings a simulation back to time 0, without loads and set values, even after a failure.
  void reset(std::size_t simulation);
  /// Puts other simulations in the places of some, at time 0.
  /// @throws as the constructor, and keeps those that there are
  void replace(const std::vector<std::size_t>& which, std::vector<BatchMember> members);
  /// Puts a body of a simulation in another state of motion.
  void set_motion(std::size_t simulation, engine::BodyId body, const hydro::BodyState& state);
  /// HeldSimulation::save of a simulation under its present loads and set values.
  std::string save(std::size_t simulation);
  /// Restores a simulation, its loads and set values from what save() gave, for any of them.
  /// @throws std::invalid_argument if it is the state of another scene, or holds a load elsewhere
  ///     than at a centre of mass in W
  void load(std::size_t simulation, std::string_view bytes);

  /// Why each simulation stands still; empty: it does not.
  const std::vector<std::string>& errors() const { return errors_; }

 private:
  /// A simulation that is not shown in the arrays yet.
  struct Made {
    std::unique_ptr<app::HeldSimulation> simulation;
    app::Observer observer;
  };
  Made make(std::size_t place, BatchMember member);
  void accept(std::size_t place, Made made);
  void observe(std::size_t simulation);
  void clear_inputs(std::size_t simulation);
  void take_steps(std::size_t simulation, long count);
  void hand_over_inputs(std::size_t simulation);

  app::MotionArrays motions_;
  std::vector<std::unique_ptr<app::HeldSimulation>> simulations_;
  std::vector<std::string> observed_;
  std::vector<app::Observer> observers_;  ///< One for each simulation.
  std::vector<double> forces_, torques_, controls_, observations_;
  std::vector<std::string> errors_;
  tbb::task_arena& threads_;
};

}  // namespace python

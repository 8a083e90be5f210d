#pragma once

#include <tbb/task_arena.h>

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "app/python/held_simulation.h"
#include "app/python/motions.h"

namespace python {

/// Simulations of scenes with the same bodies and set points, stepped together on several threads.
/// Each goes on exactly as it would alone.
class Batch {
 public:
  /// Makes a simulation of each specification; they should share hulls (engine/motion/hulls.h).
  /// @throws std::invalid_argument if there is none, or if their bodies or set points have other
  ///     names or numbers than the first's
  Batch(std::vector<engine::SimulationSpec> specs, int threads);

  std::size_t size() const { return simulations_.size(); }
  std::size_t bodies() const { return spec().bodies.size(); }
  const engine::SimulationSpec& spec() const { return simulations_.front().engine().spec(); }
  HeldSimulation& at(std::size_t simulation) { return simulations_.at(simulation); }
  MotionArrays& motions() { return motions_; }

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
  /// HeldSimulation::save of a simulation under its present loads and set values.
  std::string save(std::size_t simulation);
  /// Restores a simulation, its loads and set values from what save() gave, for any of them.
  /// @throws std::invalid_argument if it is the state of another scene, or holds a load elsewhere
  ///     than at a centre of mass in W
  void load(std::size_t simulation, std::string_view bytes);

  /// Why each simulation stands still; empty: it does not.
  const std::vector<std::string>& errors() const { return errors_; }

 private:
  void take_steps(std::size_t simulation, long count);
  void hand_over_inputs(std::size_t simulation);

  MotionArrays motions_;
  std::deque<HeldSimulation> simulations_;
  std::vector<double> forces_, torques_, controls_;
  std::vector<std::string> errors_;
  tbb::task_arena& threads_;
};

}  // namespace python

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/spec.h"

/// @file
/// The set points of a simulation and the controls that drive them.
///
/// At the start of a step each set point gets its values for the whole step. A table or formula is
/// taken at the start, the middle and the end of the step, and is a parabola between them; a table
/// of steps, a controller and another program hold one value. So loads that follow a smooth set
/// point are of the order of the stepping, and no function is called by several threads.

namespace engine {

/// A set point over one step, in the unit of its name.
struct StepValue {
  double start = 0, middle = 0, end = 0;

  /// @param part   Part of the step, 0 … 1.
  double at(double fraction) const {
    return start +
           fraction * (4 * middle - 3 * start - end + 2 * fraction * (start - 2 * middle + end));
  }
  /// Derivative by `fraction`.
  double slope(double fraction) const {
    return 4 * middle - 3 * start - end + 4 * fraction * (start - 2 * middle + end);
  }
};

/// The changing side of a set point: a part of the state of a simulation.
struct SetPointState {
  StepValue value;
  std::optional<double> outside;   ///< Set by another program.
  double integral = 0;             ///< ∫e dt of a PID, in the unit of its measured name times s.
  std::optional<double> measured;  ///< Last measurement of the control, in SI units.
  bool beyond = false;             ///< A relay gives its second value.
};

class SetPoints {
 public:
  /// Finds what a control measures, in SI units; an angle may differ from it by full turns.
  using Measure = std::function<double(const Measurement&)>;

  /// @param spec   It must outlive this.
  explicit SetPoints(const SimulationSpec& spec);

  /// Gives every set point its values for the step of length h [s] that begins at `time` [s].
  void begin_step(double time, double h, const Measure& measure);

  /// A set point at a time within the step that was begun last, and its derivative, in SI units.
  double value(SetPointId id, double time) const;
  double rate(SetPointId id, double time) const;
  /// At the end of the last step, or at the start, in SI units.
  double latest(SetPointId id) const { return states_[id].value.end * unit(id); }
  /// Mean over the last step of the values, each kept within ±most, in SI units.
  double mean_within(SetPointId id, double limit) const;
  /// The latest values in the units of the names.
  std::vector<double> readings() const;

  /// @throws std::invalid_argument for an unknown name.
  SetPointId find(const std::string& name) const;
  void set(SetPointId id, std::optional<double> value) { states_[id].outside = value; }

  const std::vector<SetPointState>& states() const { return states_; }
  void restore(const std::vector<SetPointState>& states) { states_ = states; }
  /// Sets the step that value() and rate() are of.
  void set_time(double start, double h) {
    start_ = start;
    h_ = h;
  }

 private:
  double unit(SetPointId id) const { return spec_->set_points[id].unit; }
  double fraction(double time) const;
  StepValue controlled(const ControlSpec& control, SetPointState& state, double time, double h,
                       const Measure& measure) const;

  const SimulationSpec* spec_;
  std::vector<SetPointState> states_;
  std::vector<std::optional<std::size_t>> control_of_;  ///< Per set point.
  double start_ = 0;                                    ///< Start of the last step [s].
  double h_ = 1;                                        ///< Its length [s].
};

}  // namespace engine

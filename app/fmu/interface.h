#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/held/held_simulation.h"
#include "app/held/observer.h"
#include "app/scene/scene.h"

/// @file
/// The variables of a unit: what an importer sets and what it reads.

namespace fmu {

/// The name by which an importer speaks of a variable in its calls.
using ValueReference = std::uint32_t;

/// The value reference of the time [s]; those of inputs and then of outputs follow it.
inline constexpr ValueReference kTime = 0;

/// A variable of a unit. Its value is a number in its units.
struct Variable {
  std::string name;              ///< `rudders[rudder].angle_deg`
  std::string units;             ///< `deg`
  std::string description = {};  ///< A phrase for the importer's user, or none.
  double start = 0;              ///< Initial value of an input.
};

/// The variables of a scene, of which the same scene always has the same.
///
/// Inputs are the set points of the scene under their own names, and `BODY.force_x` … `.torque_z`:
/// the force at the centre of mass [N] and the torque [N m] that act on a body, in W, of each body
/// that can move. A set point that a control of the scene drives starts at NaN, which leaves it to
/// that control; a number takes it over, and NaN gives it back.
///
/// Outputs are all observables (held/observer.h). One whose name an input has stands as
/// NAME.reading.
class Interface {
 public:
  Interface(const scene::Scene& scene, const app::HeldSimulation& simulation);

  const std::vector<Variable>& inputs() const { return inputs_; }
  const std::vector<Variable>& outputs() const { return outputs_; }

  ValueReference first_input() const { return kTime + 1; }
  ValueReference first_output() const {
    return first_input() + static_cast<ValueReference>(inputs_.size());
  }

  /// Gives an input to the simulation.
  /// @param values   Values of all inputs, the new one among them.
  /// @throws std::invalid_argument, naming the input, unless its value is finite or releases a set
  ///     point; the simulation is then as before.
  void apply(std::size_t input, std::span<const double> values,
             app::HeldSimulation& simulation) const;

  /// Returns the values of all outputs in the present state.
  std::vector<double> read(const app::HeldSimulation& simulation) const;

 private:
  void add_set_points(const scene::Scene& scene, const engine::SimulationSpec& spec);
  void add_loads(const engine::SimulationSpec& spec);
  void add_outputs(const scene::Scene& scene, const app::HeldSimulation& simulation);

  std::vector<Variable> inputs_, outputs_;
  std::size_t set_points_ = 0;           ///< Number of set points, the first of the inputs.
  std::vector<engine::BodyId> movable_;  ///< Bodies with loads, in the order of the inputs.
  app::Observer observer_;
};

}  // namespace fmu

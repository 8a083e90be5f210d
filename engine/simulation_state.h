#pragma once

#include <memory>
#include <string>
#include <string_view>

/// @file
/// The state of a simulation as a value.

namespace engine {

/// Everything that changes in a simulation, at one instant: poses, velocities, added mass,
/// histories, contacts, energy ranges, records of work, inputs and counts. A value: copies are
/// independent of the simulation, and cheap.
class SimulationState {
 public:
  struct Data;
  /// For the engine itself: a program gets states from Simulation::state() and from_bytes().
  explicit SimulationState(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  /// Steps taken since the start.
  long steps() const;

  /// The state as bytes, exact to the last bit, for machines of the same byte order.
  std::string to_bytes() const;
  /// The state whose bytes to_bytes() gave.
  /// @throws std::invalid_argument if the bytes are not those of a state of this version.
  static SimulationState from_bytes(std::string_view bytes);

  /// For the engine itself.
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace engine

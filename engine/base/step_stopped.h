#pragma once

#include <exception>
#include <functional>

/// @file
/// Steps that a program stops.

namespace engine {

/// True once a step is not to go on. Any thread may ask.
using StopCheck = std::function<bool()>;

/// A step did not go on because a program asked for that (Simulation::stop_if()).
class StepStopped : public std::exception {
 public:
  /// The message.
  const char* what() const noexcept override { return "the step was stopped"; }
};

/// Returns unless a step is not to go on.
/// @throws StepStopped if a step is not to go on. @param stop   Empty: it always is.
inline void ask(const StopCheck& stop) {
  if (stop && stop()) throw StepStopped();
}

}  // namespace engine

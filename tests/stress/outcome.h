#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "tests/stress/run_name.h"
#include "tests/stress/watch.h"

namespace stress {

/// Outcome of a run.
struct Outcome {
  std::string fault;     ///< Reason and time of the failure; empty if there was none.
  long steps = 0;        ///< Steps done.
  bool inside = false;   ///< True: it lies inside the operating envelope.
  bool judged = false;   ///< True: its energy was judged.
  bool stopped = false;  ///< True: outside the envelope, the engine said why it cannot go on.
  double rise = 0;       ///< Watch::worst_rise.
  long substeps = 0;     ///< Largest number in a step.
  long sweeps = 0;       ///< Largest number in a step.
  long unconverged = 0;  ///< Substeps whose constraints did not reach their tolerance.
  long clamped = 0;      ///< Substeps slowed by the energy limiter.
  double seconds = 0;    ///< Processor time [s], for information.
  /// Of the last states, to see whether two builds move bodies alike; 0 before the first step.
  std::uint64_t digest = 0;
};

/// Called after every step; may be empty.
using Listener = std::function<void(const engine::Simulation&, const Watch&)>;

/// Simulates a run to its end or to its first fault. Outside the envelope a SimulationError that
/// names the body is no fault but a stop.
Outcome run_through(const RunName& run, const Listener& listener = {});
Outcome run_through(const Scenario& scenario, const Listener& listener = {});

/// Converts an outcome to one line of comma-separated values and back. Commas in a fault become
/// semicolons.
std::string to_csv(const Outcome& outcome);
Outcome outcome_from_csv(const std::string& line);
inline constexpr const char* kOutcomeColumns =
    "steps,inside,judged,stopped,rise,substeps,sweeps,unconverged,clamped,seconds,digest,fault";

}  // namespace stress

#pragma once

#include <functional>
#include <string>

#include "tests/stress/run_name.h"
#include "tests/stress/watch.h"

namespace stress {

/// What came of a run.
struct Outcome {
  std::string fault;     ///< Why it failed and when; empty if it did not.
  long steps = 0;        ///< Done.
  bool judged = false;   ///< Its energy was.
  double rise = 0;       ///< Watch::worst_rise.
  long substeps = 0;     ///< Most of a step.
  long solutions = 0;    ///< Most of a step.
  long unconverged = 0;  ///< Substeps whose constraints did not reach their tolerance.
  long clamped = 0;      ///< Substeps slowed so that the water gave no energy.
  double seconds = 0;    ///< Of processor time; for information.
};

/// Told after every step; may be empty.
using Listener = std::function<void(const engine::Simulation&, const Watch&)>;

/// Simulates a run to its end or to its first fault.
Outcome run_through(const RunName& run, const Listener& listener = {});

/// The outcome as one line of comma-separated values, and back. A fault's commas become semicolons.
std::string to_csv(const Outcome& outcome);
Outcome outcome_from_csv(const std::string& line);
inline constexpr const char* kOutcomeColumns =
    "steps,judged,rise,substeps,solutions,unconverged,clamped,seconds,fault";

}  // namespace stress

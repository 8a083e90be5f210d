#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/spec.h"

/// @file
/// The operating envelope: the descriptions for which the engine answers in full.
///
/// Inside it no run of the stress test may gain energy, leave, stall or stop (tests/stress).
/// Outside it a run has finite states or stops with the body, the time and the reason, and its work
/// is bounded. The bounds are on what a scene says, not on what comes of it; app/README.md lists
/// them. A body without freedom is not judged, nor the mass of a dry one, nor the step where
/// nothing moves.

namespace assembly {

/// Returns what of bodies and step lies outside the envelope, each with value and bound: `body 'a':
/// size 0.002 m, expected at least 0.005 m`. Waves that break are left to sea_warnings.h.
std::vector<std::string> outside_envelope(const engine::SimulationSpec& spec);

/// Returns outside_envelope in one line, which counts what is too much for a line; none inside it.
std::optional<std::string> envelope_warning(const engine::SimulationSpec& spec);

/// True if bodies, step and sea lie inside the envelope.
bool inside_envelope(const engine::SimulationSpec& spec);

}  // namespace assembly

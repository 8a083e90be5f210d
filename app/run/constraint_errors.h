#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/counts.h"
#include "engine/base/spec.h"
#include "engine/record/body_forces.h"
#include "engine/record/constraint_errors.h"

/// @file
/// Errors of a run's constraints: the depth of overlaps, the gaps of joints, and the work that the
/// energy limiter has taken from bodies.

namespace app {

/// Part of a body's size, of the work on it or of its substeps, from which on an error is a warning
/// [-]; as much of a turn in radians moves the far side of a body by that part.
inline constexpr double kNotableError = 0.01;

/// Errors of the constraints of a run at its end, and what tells of them.
struct RunErrors {
  engine::ConstraintErrors constraints;
  std::vector<engine::Works> works;    ///< Per body; empty without a record of work.
  std::vector<engine::Counts> counts;  ///< Per body.
};

/// Returns the entry `overlaps` of summary.json: the number of `pairs` that have touched and the
/// `largest` overlaps over the size of the smaller body, the first ten and all notable ones. The
/// size of a body is the longest edge of the box around its mesh.
nlohmann::ordered_json overlaps_summary(const engine::SimulationSpec& spec,
                                        const engine::ConstraintErrors& errors);

/// Returns the entry `joints`: of each joint its largest errors and their times.
nlohmann::ordered_json joints_summary(const engine::SimulationSpec& spec,
                                      const engine::ConstraintErrors& errors);

/// Returns a warning of forces that missed their tolerance (constraint_warning()), and one each of
/// overlaps, joints and the energy limiter, if any is notable.
std::vector<std::string> error_warnings(const engine::SimulationSpec& spec,
                                        const RunErrors& errors);

/// Returns lines with the largest overlaps, errors of joints and what the energy limiter slowed.
std::vector<std::string> error_lines(const engine::SimulationSpec& spec, const RunErrors& errors);

}  // namespace app

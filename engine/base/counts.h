#pragma once

/// @file
/// Counts of steps and loads.

namespace engine {

/// Counts of a body's steps and load evaluations so far.
struct Counts {
  long free = 0;         ///< Steps, or parts of them, without constraints that are solved.
  long constrained = 0;  ///< Substeps under joints or contacts.
  long substeps = 0;     ///< All substeps.
  long implicit = 0;     ///< Substeps whose loads were taken implicitly.
  long iterations = 0;   ///< Sweeps of the constraint solver.
  long unconverged = 0;  ///< Substeps in which those did not reach their tolerance.
  long clamped = 0;      ///< Substeps that the energy limiter has slowed.
  long dry = 0;          ///< Load evaluations above the highest water.
  long resting = 0;      ///< Load evaluations with body and water as in the last one.
};

}  // namespace engine

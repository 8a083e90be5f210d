#pragma once

namespace engine {

/// Counts of a body's steps and load evaluations so far.
struct Counts {
  long free = 0;  ///< Steps, or parts of them, that it moved by itself or on a reduced joint.
  long constrained = 0;  ///< Substeps that it moved under joints or contacts.
  long substeps = 0;     ///< All substeps.
  long implicit = 0;     ///< Substeps whose loads were taken implicitly.
  long iterations = 0;   ///< Constraint solves; without added mass, one per substep.
  long unconverged = 0;  ///< Substeps in which those did not reach their tolerance.
  long clamped = 0;      ///< Substeps slowed so that still water gives no energy.
  long dry = 0;          ///< Load evaluations above the highest water.
  long resting = 0;      ///< Load evaluations that found both body and water as they were.
};

}  // namespace engine

#pragma once

#include "engine/motion/body.h"

/// @file
/// Lengths of substeps that keep the error of a motion below a tolerance.
///
/// A substep is taken as a whole and as two halves, whose difference is at least three times the
/// error of the halves. The error of a substep is of the third order in its length h, and its share
/// of a second's error of the second.

namespace engine {

/// Estimated error of a motion over a time h [s], over the error that the tolerance allows: up to 1
/// it is accepted.
/// @param whole       The motion by one substep.
/// @param halves      The motion by two.
/// @param tolerance   Largest error of the pose in a second, over the body's radius and in rad; >
/// 0.
double estimated_error(const Body& body, const Motion& whole, const Motion& halves, double h,
                       double tolerance);

/// Length of the next substep that is likely to be accepted, after one of length h with this error.
double length_for_error(double h, double error);

}  // namespace engine

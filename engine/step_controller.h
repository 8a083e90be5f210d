#pragma once

#include "engine/body.h"

/// @file
/// The lengths of pieces that keep the error of a motion below a tolerance.
///
/// A piece is done as a whole and as two halves, whose difference is three times the error of the
/// halves or more. The error of a piece of length h is of the third order in h, a second's share of
/// it of the second.

namespace engine {

/// The estimated error of `halves`, a part of a motion of length h, over what the tolerance allows
/// it: it stands up to 1.
/// @param whole       The same part done as one piece.
/// @param tolerance   Largest error of the pose in a second, as a part of the body's radius and in
///                    rad; > 0.
double estimated_error(const Body& body, const Motion& whole, const Motion& halves, double h,
                       double tolerance);

/// The length that after a piece of length h and this error is likely to stand.
double length_for_error(double h, double error);

}  // namespace engine

#pragma once

#include <string>
#include <vector>

#include "app/databases/body_data.h"
#include "hydro/spatial.h"

namespace databases {

/// Bounds above which a check is noted, and refused, relative to the largest of its kind [-].
struct Bounds {
  double noted, refused;
};

/// Part of the frequencies that may be bad, away from the ends (bad_ends.h), and be left out: panel
/// methods have no unique solution at those of sloshing inside the hull [-].
inline constexpr double kMostDropped = 0.2;

/// `2.1, 2.14, 5`; of many the first and the last. @param frequencies   [rad/s], not empty
std::string in_words(const std::vector<double>& frequencies);

/// Adds a check and its note.
void add_check(const std::string& name, double value, const Bounds& bounds, BodyData& found);

/// A matrix with moments and turns in the units of forces and motions. @param lever   [m]
hydro::Matrix6d weighted(const hydro::Matrix6d& matrix, double lever);

}  // namespace databases

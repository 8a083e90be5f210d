#pragma once

#include <string>

#include "app/databases/body_data.h"
#include "hydro/spatial.h"

namespace databases {

/// Bounds above which a check is noted, and refused, relative to the largest of its kind [-].
struct Bounds {
  double noted, refused;
};

/// Adds a check and its note.
void add_check(const std::string& name, double value, const Bounds& bounds, BodyData& found);

/// A matrix with moments and turns in the units of forces and motions. @param lever   [m]
hydro::Matrix6d weighted(const hydro::Matrix6d& matrix, double lever);

}  // namespace databases

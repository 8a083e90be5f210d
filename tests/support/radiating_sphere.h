#pragma once

#include <cmath>

#include "hydro/radiation/radiation_data.h"

/// @file
/// Linear radiation of a sphere that floats half submerged. Test programs only.

namespace support {

/// The data of a sphere of the given radius [m], whose centre of mass is its centre, by
/// tools/validation/potential_flow.py: hemisphere(1, 14, 14), about its centre, in deep water of
/// density 1. Frequencies near the irregular one of kR = 2.56 are left out. The added mass for high
/// frequency is of the same panels. There is no load of waves.
inline hydro::RadiationData radiating_sphere(double radius) {
  struct Row {
    double frequency, heave_mass, heave_damping, surge_mass, surge_damping;
  };
  constexpr Row kRows[] = {
      {0.442869, 1.815737, 0.041687, 1.059364, 0.000009},
      {0.700237, 1.840023, 0.152435, 1.072674, 0.000209},
      {0.990285, 1.811415, 0.377733, 1.097997, 0.002278},
      {1.291174, 1.715307, 0.696050, 1.139578, 0.013876},
      {1.627205, 1.551017, 1.078313, 1.207676, 0.065121},
      {1.980571, 1.354748, 1.418783, 1.297387, 0.231712},
      {2.364274, 1.157843, 1.646530, 1.377070, 0.669384},
      {2.800950, 0.986429, 1.707141, 1.348069, 1.557920},
      {3.284405, 0.870787, 1.579245, 1.113819, 2.621188},
      {3.835359, 0.816056, 1.299279, 0.774402, 3.222767},
      {4.428691, 0.813275, 0.966273, 0.525040, 3.176116},
      {6.023670, 0.894906, 0.347549, 0.326184, 2.141618},
  };
  hydro::RadiationData data;
  data.volume = 2 * M_PI / 3 * std::pow(radius, 3);
  const auto diagonal = [](double horizontal, double vertical) {
    const hydro::Vector6d values(horizontal, horizontal, vertical, 0, 0, 0);
    return hydro::Matrix6d(values.asDiagonal());
  };
  const double volume = std::pow(radius, 3), rate = 1 / std::sqrt(radius);
  for (const Row& row : kRows) {
    data.frequencies.push_back(rate * row.frequency);
    data.added_mass.push_back(volume * diagonal(row.surge_mass, row.heave_mass));
    data.damping.push_back(volume * rate * diagonal(row.surge_damping, row.heave_damping));
  }
  data.infinite_added_mass = volume * diagonal(0.580172, 1.049240);
  return data;
}

}  // namespace support

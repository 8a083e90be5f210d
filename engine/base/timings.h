#pragma once

/// @file
/// Wall times of the stages of steps.

namespace engine {

/// Wall time spent so far, by stage [s]. Added mass counts as water. Time that several bodies or
/// islands take at once is divided by the number of threads that share it.
struct Timings {
  double collision = 0;    ///< Search for contacts.
  double hydro = 0;        ///< Loads of water and air.
  double engine = 0;       ///< The rest of the steps.
  double sea = 0;          ///< The part of `engine` that finds the motion of waves about bodies.
  double water = 0;        ///< Simulated water, beside the three.
  double constraints = 0;  ///< The part of `engine` that solves for joints, contacts and lines.
};

}  // namespace engine

#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "app/logs/trajectory.h"

/// @file
/// How far two trajectories differ, body by body, and whether that is within tolerance.
///
/// Where the logs have other times than each other, the one with more rows of a body is taken
/// between them: the place by Hermite's cubic through the places and velocities around the time,
/// the attitude likewise by the turn from the earlier one, velocities on the line. That is wrong by
/// some a'' h⁴/384, with a'' the second derivative of the acceleration and h the log's interval.

namespace app {

/// A quantity that is compared.
struct ComparedQuantity {
  const char* name;
  const char* unit;
  double (*difference)(const hydro::BodyState&, const hydro::BodyState&);
};
/// position, orientation_deg, linear_velocity, angular_velocity.
extern const std::array<ComparedQuantity, 4> kComparedQuantities;

/// Largest differences that are none.
struct Tolerances {
  static constexpr double kDefault = 1e-9;
  static constexpr double kNotJudged = std::numeric_limits<double>::infinity();

  std::map<std::string, double> all;                            ///< By quantity.
  std::map<std::string, std::map<std::string, double>> bodies;  ///< By body and quantity.

  /// kDefault if none is given at all; kNotJudged for a quantity that is not among those that are.
  double of(const std::string& body, const std::string& quantity) const;
};

/// Reads `QUANTITY: NUMBER` lines and `bodies: {NAME: {QUANTITY: NUMBER}}` from YAML.
/// @throws InputError with all faults
Tolerances read_tolerances(const std::filesystem::path& file);

/// How far one quantity of a body differs.
struct Difference {
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  double tolerance = 0;
  double largest = 0;
  double when_largest = 0;       ///< [s]
  double first_beyond = kNever;  ///< [s]

  bool judged() const { return tolerance != Tolerances::kNotJudged; }
  bool within() const { return first_beyond == kNever; }
};

struct BodyComparison {
  enum class In { both, only_a, only_b };
  std::string name;
  In in = In::both;
  std::vector<double> times;     ///< At which it was compared [s].
  std::size_t interpolated = 0;  ///< Of them, where one log had no row.
  std::size_t only_a = 0;        ///< Rows before the other log begins or after it ends.
  std::size_t only_b = 0;
  std::array<Difference, 4> differences;               ///< As kComparedQuantities.
  std::array<std::vector<double>, 4> difference_over;  ///< The same at each time.

  bool same() const;
};

struct Comparison {
  std::vector<BodyComparison> bodies;  ///< In the order of the first, then those only in the other.
  bool same() const;
};

Comparison compare_trajectories(const Trajectory& a, const Trajectory& b,
                                const Tolerances& tolerances);

/// The state at a time within a track's.
hydro::BodyState state_at(const BodyTrack& track, double time);

}  // namespace app

#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "app/logs/trajectory.h"

/// @file
/// Differences of two trajectories, body by body, and their verdict.
///
/// Where the logs have different times, the one with more rows of a body is interpolated: the
/// position by Hermite's cubic through positions and velocities, the attitude likewise by its
/// rotation from the earlier one, velocities linearly. The error of the position is about a''
/// h⁴/384, with a'' the second derivative of the acceleration and h the log's interval.

namespace app {

/// A quantity that is compared.
struct ComparedQuantity {
  const char* name;
  const char* unit;
  double (*difference)(const hydro::BodyState&, const hydro::BodyState&);
};
/// position, orientation_deg, linear_velocity, angular_velocity.
extern const std::array<ComparedQuantity, 4> kComparedQuantities;

/// Largest differences that count as equal.
struct Tolerances {
  static constexpr double kDefault = 1e-9;
  static constexpr double kNotJudged = std::numeric_limits<double>::infinity();

  std::map<std::string, double> all;                            ///< Key: quantity.
  std::map<std::string, std::map<std::string, double>> bodies;  ///< Keys: body, quantity.

  /// Returns the tolerance of a quantity: kDefault if no tolerance is given at all, kNotJudged if
  /// only other quantities have one.
  double of(const std::string& body, const std::string& quantity) const;
};

/// Reads `QUANTITY: NUMBER` lines and `bodies: {NAME: {QUANTITY: NUMBER}}` from YAML.
/// @throws InputError with all faults
Tolerances read_tolerances(const std::filesystem::path& file);

/// The difference in one quantity of a body.
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
  std::vector<double> times;     ///< Times of the comparison [s].
  std::size_t interpolated = 0;  ///< Number of times at which one log had no row.
  std::size_t only_a = 0;        ///< Rows before the other log begins or after it ends.
  std::size_t only_b = 0;
  std::array<Difference, 4> differences;               ///< In the order of kComparedQuantities.
  std::array<std::vector<double>, 4> difference_over;  ///< The differences at each time.

  bool same() const;
};

struct Comparison {
  std::vector<BodyComparison> bodies;  ///< The first log's, then the others.
  bool same() const;
};

Comparison compare_trajectories(const Trajectory& a, const Trajectory& b,
                                const Tolerances& tolerances);

/// Returns the state at a time within the track.
hydro::BodyState state_at(const BodyTrack& track, double time);

}  // namespace app

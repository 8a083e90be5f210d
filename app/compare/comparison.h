#pragma once

#include <limits>
#include <string>
#include <vector>

#include "app/compare/compared_run.h"
#include "app/compare/quantities.h"
#include "app/compare/tolerances.h"
#include "app/logs/trajectory.h"

/// @file
/// Differences of two runs, body by body and table by table, and their verdict.
///
/// Where the logs have different times, the one with more rows of a body is interpolated: the
/// position by Hermite's cubic through positions and velocities, the attitude likewise by its
/// rotation from the earlier one, velocities and the numbers of tables linearly. The error of the
/// position is about a'' h⁴/384, with a'' the second derivative of the acceleration and h the log's
/// interval.

namespace app {

/// The difference in one quantity of a body or of another name. A number that only one log has is
/// an infinite difference.
struct Difference {
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  std::string quantity;  ///< `position`, `forces.buoyancy`
  std::string unit;
  double peak_limit = Tolerance::kNone;  ///< The largest difference that is allowed.
  double rms_limit = Tolerance::kNone;   ///< The largest root mean square that is allowed.
  double size = 0;  ///< Largest size of the quantity in A; of places and attitudes, from the start.
  double largest = 0;
  double when_largest = 0;       ///< [s]
  double rms = 0;                ///< Over all times.
  double first_beyond = kNever;  ///< Time from which on it is beyond `peak_limit` [s].

  bool judged() const { return peak_limit != Tolerance::kNone || rms_limit != Tolerance::kNone; }
  bool within_rms() const { return !(rms > rms_limit); }
  bool within() const { return first_beyond == kNever && within_rms(); }
};

/// Where a name or a table is.
enum class In { both, only_a, only_b };

/// The comparison of one body, or of one name of a table.
struct BodyComparison {
  std::string name;
  In in = In::both;
  bool judged = true;            ///< False: no quantity has a tolerance, so all of it may differ.
  std::vector<double> times;     ///< Times of the comparison [s].
  std::size_t interpolated = 0;  ///< Number of times at which one log had no row.
  std::size_t only_a = 0;        ///< Rows before the other log begins or after it ends.
  std::size_t only_b = 0;
  std::vector<Difference> differences;               ///< In the order of the quantities.
  std::vector<std::vector<double>> difference_over;  ///< At each time; empty for tables.

  bool same() const;
};

/// The comparison of a table.
struct TableComparison {
  std::string name;  ///< `forces`
  In in = In::both;
  bool judged = true;
  std::vector<BodyComparison> names;  ///< The first log's, then the others.

  bool same() const;
};

struct Comparison {
  std::vector<BodyComparison> bodies;   ///< The first log's, then the others.
  std::vector<TableComparison> tables;  ///< Tables that either run has.

  bool same() const;
};

Comparison compare_trajectories(const Trajectory& a, const Trajectory& b,
                                const Tolerances& tolerances);

/// Compares trajectories and tables. A table or a name of it that only one run has is a difference
/// if any of its quantities has a tolerance.
Comparison compare_runs(const ComparedRun& a, const ComparedRun& b, const Tolerances& tolerances);

/// Returns the state at a time within the track.
hydro::BodyState state_at(const BodyTrack& track, double time);

}  // namespace app

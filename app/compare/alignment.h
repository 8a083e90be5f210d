#pragma once

#include <cstddef>
#include <optional>
#include <vector>

/// @file
/// The times at which two logs are compared.

namespace app {

/// A time of the comparison and the rows that the logs have there.
struct Meeting {
  double time = 0;                   ///< [s]
  std::optional<std::size_t> row_a;  ///< None: A is interpolated.
  std::optional<std::size_t> row_b;
};

struct Alignment {
  std::vector<Meeting> meetings;
  std::size_t interpolated = 0;  ///< Number of times at which one log has no row.
  std::size_t only_a = 0;        ///< Rows before the other log begins or after it ends.
  std::size_t only_b = 0;

  std::vector<double> times() const;
};

/// Returns the times of the log with fewer rows in the span of both, as far as the other reaches.
/// @param a   Ascending times, at least one.
Alignment aligned(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the row at a time; none if there is none to within round-off.
std::optional<std::size_t> row_at(const std::vector<double>& times, double time);

}  // namespace app

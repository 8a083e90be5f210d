#pragma once

#include <cstddef>
#include <vector>

/// @file
/// Reduction of a log's rows, for a page of bounded size.

namespace app {

/// Reduction of rows 0 … rows − 1. It keeps the first and the last row and, for each bucket of rows
/// between them, the smallest and the largest value of each column, so that no peak is lost.
class Thinning {
 public:
  /// @param most   Largest number of rows to keep, >= 4.
  Thinning(std::size_t rows, std::size_t most);

  bool thins() const { return buckets_ > 0; }

  /// Returns the times of the kept rows, for a bucket those of its first and its middle row.
  std::vector<double> times(const std::vector<double>& all) const;

  /// Returns the kept values of a column, for a bucket its smallest and its largest in order of
  /// time.
  std::vector<double> values(const std::vector<double>& all) const;

 private:
  /// Returns the first row of a bucket; the index after the last bucket yields the last row.
  std::size_t start(std::size_t bucket) const;

  std::size_t rows_;
  std::size_t buckets_ = 0;  ///< 0: every row is kept.
};

/// Returns at most `most` (>= 2) of rows 0 … rows − 1, evenly spaced, with the first and the last.
std::vector<std::size_t> spread_rows(std::size_t rows, std::size_t most);

}  // namespace app

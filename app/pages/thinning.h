#pragma once

#include <cstddef>
#include <vector>

/// @file
/// Fewer rows of a log, for a page of a bounded size.

namespace app {

/// How rows 0 … rows − 1 are made fewer: the first and the last are kept, and of each bucket of
/// rows between them the least and the largest value of each column, so that no peak is lost.
class Thinning {
 public:
  /// @param most   Rows to keep at most, >= 4.
  Thinning(std::size_t rows, std::size_t most);

  bool thins() const { return buckets_ > 0; }

  /// Times of the kept rows: of a bucket its first and its middle one.
  std::vector<double> times(const std::vector<double>& all) const;

  /// The kept values of a column: of a bucket its least and its largest, in the order in which they
  /// come.
  std::vector<double> values(const std::vector<double>& all) const;

 private:
  /// The first row of a bucket; of the bucket after the last one the last row.
  std::size_t start(std::size_t bucket) const;

  std::size_t rows_;
  std::size_t buckets_ = 0;  ///< 0: every row is kept.
};

/// At most `most` (>= 2) of rows 0 … rows − 1, evenly spread, the first and the last among them.
std::vector<std::size_t> spread_rows(std::size_t rows, std::size_t most);

}  // namespace app

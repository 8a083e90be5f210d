#include "app/compare/alignment.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kSameTime = 1e-9;  ///< Round-off of logged times, relative, or [s] below 1 s.

bool same_time(double a, double b) {
  return std::abs(a - b) <= kSameTime * std::max(1.0, std::abs(a));
}

/// Counts the rows outside the times of another log.
std::size_t rows_beyond(const std::vector<double>& times, const std::vector<double>& other) {
  return static_cast<std::size_t>(std::ranges::count_if(times, [&](double time) {
    const bool before = time < other.front() && !same_time(time, other.front());
    const bool after = time > other.back() && !same_time(time, other.back());
    return before || after;
  }));
}

}  // namespace

std::vector<double> Alignment::times() const {
  std::vector<double> times;
  for (const Meeting& meeting : meetings) times.push_back(meeting.time);
  return times;
}

std::optional<std::size_t> row_at(const std::vector<double>& times, double time) {
  const auto next = std::ranges::lower_bound(times, time);
  const auto row = static_cast<std::size_t>(next - times.begin());
  if (next != times.end() && same_time(*next, time)) return row;
  if (next != times.begin() && same_time(*(next - 1), time)) return row - 1;
  return std::nullopt;
}

Alignment aligned(const std::vector<double>& a, const std::vector<double>& b) {
  Alignment alignment{.meetings = {}, .only_a = rows_beyond(a, b), .only_b = rows_beyond(b, a)};
  const bool a_is_coarser = a.size() - alignment.only_a <= b.size() - alignment.only_b;
  const std::vector<double>& coarser = a_is_coarser ? a : b;
  const std::vector<double>& finer = a_is_coarser ? b : a;
  for (std::size_t i = 0; i < coarser.size(); ++i) {
    const double time = coarser[i];
    const std::optional<std::size_t> met = row_at(finer, time);
    if (!met && (time < finer.front() || time > finer.back())) continue;
    alignment.interpolated += !met;
    Meeting meeting{.time = time, .row_a = i, .row_b = met};
    if (!a_is_coarser) std::swap(meeting.row_a, meeting.row_b);
    alignment.meetings.push_back(meeting);
  }
  return alignment;
}

}  // namespace app

#include "app/compare/comparison.h"

#include <algorithm>
#include <cmath>

#include "app/compare/alignment.h"
#include "app/logs/interpolation.h"

namespace app {
namespace {

using hydro::BodyState;

/// The difference of one quantity at each time.
struct Course {
  std::vector<double> differences;
  double size = 0;  ///< Largest size in A.
};

Difference judged(const Course& course, const std::vector<double>& times,
                  const Tolerance& tolerance) {
  Difference d{.quantity = "",
               .unit = "",
               .peak_limit = tolerance.peak_limit(course.size),
               .rms_limit = tolerance.rms,
               .size = course.size};
  double squares = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double difference = course.differences[i];
    squares += difference * difference;
    if (difference > d.largest) {
      d.largest = difference;
      d.when_largest = times[i];
    }
    if (difference > d.peak_limit) d.first_beyond = std::min(d.first_beyond, times[i]);
  }
  if (!times.empty()) d.rms = std::sqrt(squares / static_cast<double>(times.size()));
  return d;
}

BodyComparison begun(const std::string& name, const Alignment& alignment) {
  return {.name = name,
          .times = alignment.times(),
          .interpolated = alignment.interpolated,
          .only_a = alignment.only_a,
          .only_b = alignment.only_b};
}

std::vector<BodyState> states_at(const BodyTrack& track, const Alignment& alignment,
                                 std::optional<std::size_t> Meeting::*row) {
  std::vector<BodyState> states;
  for (const Meeting& meeting : alignment.meetings)
    states.push_back(meeting.*row ? track.states[*(meeting.*row)] : state_at(track, meeting.time));
  return states;
}

BodyComparison compare_body(const std::string& name, const BodyTrack& a, const BodyTrack& b,
                            const Tolerances& tolerances) {
  const Alignment alignment = aligned(a.times, b.times);
  BodyComparison body = begun(name, alignment);
  const std::vector<BodyState> states_a = states_at(a, alignment, &Meeting::row_a);
  const std::vector<BodyState> states_b = states_at(b, alignment, &Meeting::row_b);
  for (const ComparedQuantity& quantity : kComparedQuantities) {
    Course course;
    for (std::size_t i = 0; i < states_a.size(); ++i) {
      const BodyState& from = quantity.from_start ? states_a.front() : BodyState{};
      course.differences.push_back(quantity.difference(states_a[i], states_b[i]));
      course.size = std::max(course.size, quantity.difference(states_a[i], from));
    }
    Difference& d = body.differences.emplace_back(
        judged(course, body.times, tolerances.of(name, quantity.name)));
    d.quantity = quantity.name;
    d.unit = quantity.unit;
    body.difference_over.push_back(std::move(course.differences));
  }
  return body;
}

/// Returns the numbers of a column at the compared times, interpolated linearly between rows.
std::vector<double> numbers_at(const TableTrack& track, std::size_t column,
                               const Alignment& alignment,
                               std::optional<std::size_t> Meeting::*row) {
  const std::vector<double>& all = track.columns[column];
  std::vector<double> numbers;
  for (const Meeting& meeting : alignment.meetings) {
    if (meeting.*row) {
      numbers.push_back(all[*(meeting.*row)]);
      continue;
    }
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(track.times, meeting.time) -
                                               track.times.begin());
    const double s =
        (meeting.time - track.times[next - 1]) / (track.times[next] - track.times[next - 1]);
    numbers.push_back((1 - s) * all[next - 1] + s * all[next]);
  }
  return numbers;
}

/// Returns how far two numbers are apart; a number that only one has is infinitely far from none.
double apart(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return 0;
  if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<double>::infinity();
  return b - a;
}

/// Adds the squares of a column's differences to those of the other columns of its series.
void add_squares(const std::vector<double>& a, const std::vector<double>& b, bool from_start,
                 std::vector<double>& differences, std::vector<double>& sizes) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double apart_now = apart(a[i], b[i]);
    const double size = from_start ? apart(a.front(), a[i]) : a[i];
    differences[i] += apart_now * apart_now;
    if (std::isfinite(size)) sizes[i] += size * size;
  }
}

BodyComparison compare_name(const std::string& name, const ComparedTable& table,
                            const TableTrack& a, const TableTrack& b,
                            const Tolerances& tolerances) {
  const Alignment alignment = aligned(a.times, b.times);
  BodyComparison body = begun(name, alignment);
  const std::size_t rows = alignment.meetings.size();
  std::size_t column = 0;
  for (const TableSeries& series : table.layout.series) {
    const bool is_place = series.columns.size() > 1 && series.units == "m";
    std::vector<double> differences(rows), sizes(rows);
    for (std::size_t i = 0; i < series.columns.size(); ++i, ++column)
      add_squares(numbers_at(a, column, alignment, &Meeting::row_a),
                  numbers_at(b, column, alignment, &Meeting::row_b), is_place, differences, sizes);
    Course course;
    for (std::size_t i = 0; i < rows; ++i) {
      course.differences.push_back(std::sqrt(differences[i]));
      course.size = std::max(course.size, std::sqrt(sizes[i]));
    }
    const std::string quantity = quantity_name(table, series);
    Difference& d =
        body.differences.emplace_back(judged(course, body.times, tolerances.of(name, quantity)));
    d.quantity = quantity;
    d.unit = series.units;
  }
  return body;
}

/// True if any quantity of a table has a tolerance for a name.
bool judges(const Tolerances& tolerances, const std::string& name, const ComparedTable& table) {
  return std::ranges::any_of(table.layout.series, [&](const TableSeries& series) {
    return tolerances.of(name, quantity_name(table, series)).judges();
  });
}

TableComparison compare_table(const ComparedTable& table, const TableRows& a, const TableRows& b,
                              const Tolerances& tolerances) {
  TableComparison comparison{.name = table.name};
  for (const std::string& name : a.names) {
    const bool in_both = b.tracks.contains(name);
    comparison.names.push_back(
        in_both ? compare_name(name, table, a.tracks.at(name), b.tracks.at(name), tolerances)
                : BodyComparison{.name = name, .in = In::only_a});
  }
  for (const std::string& name : b.names)
    if (!a.tracks.contains(name)) comparison.names.push_back({.name = name, .in = In::only_b});
  for (BodyComparison& name : comparison.names) name.judged = judges(tolerances, name.name, table);
  return comparison;
}

/// Compares a table that only one run has.
TableComparison table_of_one(const ComparedTable& table, const TableRows& rows, In in,
                             const Tolerances& tolerances) {
  const bool judged = std::ranges::any_of(
      rows.names, [&](const std::string& name) { return judges(tolerances, name, table); });
  return {.name = table.name, .in = in, .judged = judged, .names = {}};
}

}  // namespace

bool BodyComparison::same() const {
  if (!judged) return true;
  return in == In::both && only_a + only_b == 0 && !times.empty() &&
         std::ranges::all_of(differences, &Difference::within);
}

bool TableComparison::same() const {
  return (in == In::both || !judged) && std::ranges::all_of(names, &BodyComparison::same);
}

bool Comparison::same() const {
  return std::ranges::all_of(bodies, &BodyComparison::same) &&
         std::ranges::all_of(tables, &TableComparison::same);
}

Comparison compare_trajectories(const Trajectory& a, const Trajectory& b,
                                const Tolerances& tolerances) {
  Comparison comparison;
  for (const std::string& name : a.names) {
    if (b.tracks.contains(name))
      comparison.bodies.push_back(
          compare_body(name, a.tracks.at(name), b.tracks.at(name), tolerances));
    else
      comparison.bodies.push_back({.name = name, .in = In::only_a});
  }
  for (const std::string& name : b.names)
    if (!a.tracks.contains(name)) comparison.bodies.push_back({.name = name, .in = In::only_b});
  return comparison;
}

Comparison compare_runs(const ComparedRun& a, const ComparedRun& b, const Tolerances& tolerances) {
  Comparison comparison = compare_trajectories(a.trajectory, b.trajectory, tolerances);
  for (const ComparedTable& table : compared_tables()) {
    const auto of_a = a.tables.find(table.name);
    const auto of_b = b.tables.find(table.name);
    if (of_a != a.tables.end() && of_b != b.tables.end())
      comparison.tables.push_back(compare_table(table, of_a->second, of_b->second, tolerances));
    else if (of_a != a.tables.end())
      comparison.tables.push_back(table_of_one(table, of_a->second, In::only_a, tolerances));
    else if (of_b != b.tables.end())
      comparison.tables.push_back(table_of_one(table, of_b->second, In::only_b, tolerances));
  }
  return comparison;
}

BodyState state_at(const BodyTrack& track, double time) {
  if (const auto row = row_at(track.times, time)) return track.states[*row];
  const auto next =
      static_cast<std::size_t>(std::ranges::lower_bound(track.times, time) - track.times.begin());
  if (next == 0) return track.states.front();
  if (next == track.times.size()) return track.states.back();
  const double h = track.times[next] - track.times[next - 1];
  return between(track.states[next - 1], track.states[next], h, (time - track.times[next - 1]) / h);
}

}  // namespace app

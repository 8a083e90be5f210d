#include "app/assembly/elevation_file.h"

#include <fmt/format.h>

#include <cmath>

#include "app/assembly/column_file.h"
#include "app/scene/diagnostics.h"

namespace assembly {
namespace {

const char* const kElevationUsage = "expected the columns time [s] and elevation [m]";

/// Largest distance of a time from its place in equal intervals, in intervals: times are often
/// written with few digits.
constexpr double kUnevenness = 0.25;

constexpr double kGap = 1.5;  ///< Least length of a gap, in intervals.

/// Returns the interval of the times, which must be the same everywhere [s].
double interval_of(const std::filesystem::path& file, const ColumnFile& table,
                   const std::vector<double>& times) {
  const double interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double step = times[i] - times[i - 1];
    if (step <= 0)
      table.refuse(file, i,
                   fmt::format("found the time {:g} s after {:g} s, expected ascending ones",
                               times[i], times[i - 1]));
    if (step > kGap * interval)
      table.refuse(file, i,
                   fmt::format("found the time {:g} s after {:g} s, a gap: the mean interval is "
                               "{:.4g} s, and the elevations must be at equal ones",
                               times[i], times[i - 1], interval));
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double expected = times.front() + static_cast<double>(i) * interval;
    if (std::abs(times[i] - expected) > kUnevenness * interval)
      table.refuse(file, i,
                   fmt::format("found the time {:g} s, expected {:g} s: the elevations must be at "
                               "equal intervals, here of {:.4g} s",
                               times[i], expected, interval));
  }
  return interval;
}

}  // namespace

hydro::ElevationRecord read_elevation(const std::filesystem::path& file) {
  const ColumnFile table = read_columns(file, {"time", "elevation"}, kElevationUsage);
  const std::vector<double>* times = table.find("time");
  const std::vector<double>* elevations = table.find("elevation");
  if (times == nullptr || elevations == nullptr) throw scene::InputError(file, kElevationUsage);
  if (table.rows() < hydro::kFewestElevations)
    throw scene::InputError(file, fmt::format("found {} rows, expected at least {}", table.rows(),
                                              hydro::kFewestElevations));
  return {.start = times->front(),
          .interval = interval_of(file, table, *times),
          .elevations = *elevations};
}

}  // namespace assembly

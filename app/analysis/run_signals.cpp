#include "app/analysis/run_signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/analysis/signal_statistics.h"
#include "app/assembly/build_sea.h"
#include "app/logs/motion_columns.h"
#include "app/logs/read_log.h"
#include "app/logs/run_files.h"
#include "app/logs/run_source.h"
#include "app/logs/table_layouts.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

namespace fs = std::filesystem;

struct Motion {
  const char* name;
  const char* unit;
};
constexpr auto kMotionNames = std::to_array<Motion>({{"surge", "m"},
                                                     {"sway", "m"},
                                                     {"heave", "m"},
                                                     {"roll", "deg"},
                                                     {"pitch", "deg"},
                                                     {"yaw", "deg"}});
static_assert(kMotionNames.size() == kMotionsOfBody);

/// Keeps the rows in the window of the options that have a number.
Signal windowed(Signal signal, const AnalyseOptions& options) {
  Signal kept{signal.of, signal.name, signal.unit, {}, {}};
  for (std::size_t i = 0; i < signal.times.size(); ++i) {
    const double t = signal.times[i];
    if (t < options.from.value_or(t) || t > options.to.value_or(t)) continue;
    if (std::isnan(signal.values[i])) continue;
    kept.times.push_back(t);
    kept.values.push_back(signal.values[i]);
  }
  return kept;
}

void add_motions(const Trajectory& trajectory, const AnalyseOptions& options, RunSignals& signals) {
  for (const std::string& body : trajectory.names) {
    const BodyTrack& track = trajectory.tracks.at(body);
    const std::vector<std::vector<double>> columns = motion_of(track);
    for (std::size_t k = 0; k < kMotionsOfBody; ++k)
      signals.motions.push_back(windowed(
          {body, kMotionNames[k].name, kMotionNames[k].unit, track.times, columns[k]}, options));
  }
  for (const Signal& motion : signals.motions)
    if (motion.times.size() < 2)
      throw scene::InputError(options.run,
                              fmt::format("has {} of body {} in that time, expected two or more",
                                          motion.times.empty() ? "no rows" : "one row", motion.of));
}

void add_column(const fs::path& trajectory, const TableLayout& layout, const std::string& column,
                const std::string& unit, const AnalyseOptions& options, RunSignals& signals) {
  const auto table = read_table(trajectory, layout);
  if (!table) return;
  for (const std::string& name : table->names) {
    const TableTrack& track = table->tracks.at(name);
    Signal signal =
        windowed({name, column, unit, track.times, track.columns[layout.column(column)]}, options);
    if (signal.times.size() >= 2) signals.others.push_back(std::move(signal));
  }
}

/// Returns the sea of the scene that was run; none unless its waves are irregular.
std::optional<hydro::Sea> irregular_sea_of(const fs::path& summary) {
  const auto source = source_in(read_summary(summary), summary);
  if (!source) return std::nullopt;
  const scene::Scene scene = read_again(*source, source->file);
  if (!scene.water) return std::nullopt;
  assembly::BuildLog log{.scene = scene, .faults = {}, .notes = {}};
  std::optional<assembly::IrregularSea> irregular;
  hydro::Sea sea = assembly::build_sea(*scene.water, scene.gravity, irregular, log);
  log.faults.throw_if_any();
  return irregular ? std::optional(std::move(sea)) : std::nullopt;
}

}  // namespace

RunSignals signals_of(const Trajectory& trajectory, const fs::path& log,
                      const AnalyseOptions& options) {
  RunSignals signals;
  add_motions(trajectory, options, signals);
  add_column(log, probes_layout(), "elevation", "m", options, signals);
  add_column(log, lines_layout(), "tension", "N", options, signals);
  return signals;
}

RunSignals read_signals(const AnalyseOptions& options) {
  const fs::path file = trajectory_of(options.run);
  RunSignals signals = signals_of(read_trajectory(file), file, options);
  if (fs::is_directory(options.run) && options.wave.empty())
    signals.sea = irregular_sea_of(options.run / kSummaryFile);
  return signals;
}

Signal wave_at(const hydro::Sea& sea, const Signal& surge, const Signal& sway) {
  const LineFit x = fitted_line(surge.times, surge.values);
  const LineFit y = fitted_line(sway.times, sway.values);
  Signal wave{surge.of, "wave", "m", surge.times, {}};
  for (const double t : wave.times)
    wave.values.push_back(hydro::surface_elevation(sea, x.at(t), y.at(t), t));
  return wave;
}

Samples even_samples(const Signal& signal) {
  constexpr double kEven = 1e-3;  // of an interval
  const std::size_t rows = signal.times.size();
  const double interval =
      (signal.times.back() - signal.times.front()) / static_cast<double>(rows - 1);
  Samples samples{.rate = 1 / interval, .values = {}};
  std::size_t next = 1;
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = signal.times.front() + static_cast<double>(i) * interval;
    if (std::abs(signal.times[i] - t) < kEven * interval) {
      samples.values.push_back(signal.values[i]);
      continue;
    }
    while (next + 1 < rows && signal.times[next] < t) ++next;
    const double s = (t - signal.times[next - 1]) / (signal.times[next] - signal.times[next - 1]);
    samples.values.push_back((1 - s) * signal.values[next - 1] + s * signal.values[next]);
  }
  return samples;
}

}  // namespace app

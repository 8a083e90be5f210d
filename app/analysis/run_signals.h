#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/analysis/analyse_options.h"
#include "app/logs/trajectory.h"
#include "hydro/sea.h"

namespace app {

/// A quantity of a run over time.
struct Signal {
  std::string of;    ///< Name of the body, probe or line.
  std::string name;  ///< `heave`, `elevation`, `tension`
  std::string unit;
  std::vector<double> times;  ///< [s]
  std::vector<double> values;
};

/// The signals of a run that are analysed: six motions of each body, elevations at probes and
/// tensions of lines, and what its scene tells of the waves.
struct RunSignals {
  std::vector<Signal> motions;  ///< Six of each body: surge, sway, heave, roll, pitch, yaw.
  std::vector<Signal> others;
  std::optional<hydro::Sea> sea;  ///< None unless the scene has irregular waves.
};

inline constexpr std::size_t kMotionsOfBody = 6;

/// Reads a run and keeps the rows from `options.from` to `options.to`.
/// @throws InputError if the run cannot be read, or has less than two rows there
RunSignals read_signals(const AnalyseOptions& options);

/// Returns the signals of a run whose trajectory has been read, without its sea.
/// @param log   File of the trajectory, beside which or in which tables are.
RunSignals signals_of(const Trajectory& trajectory, const std::filesystem::path& log,
                      const AnalyseOptions& options);

/// Returns the wave at the mean path of a body, a straight line, at the times of its motion.
/// @param surge   Followed by sway.
Signal wave_at(const hydro::Sea& sea, const Signal& surge, const Signal& sway);

/// A signal at even intervals.
struct Samples {
  double rate = 0;  ///< [Hz]
  std::vector<double> values;
};

/// Returns the values of a signal at the mean interval of its rows, interpolated linearly where
/// these are not even. @param signal   It has at least two rows.
Samples even_samples(const Signal& signal);

}  // namespace app

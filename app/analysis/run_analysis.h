#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/analysis/decay_fit.h"
#include "app/analysis/power_spectrum.h"
#include "app/analysis/run_signals.h"
#include "app/analysis/signal_statistics.h"

namespace app {

/// Findings about a signal.
struct SignalAnalysis {
  Signal signal;
  SignalStatistics statistics;
  std::optional<PowerSpectrum> spectrum;     ///< None of a signal that is constant or short.
  std::optional<DecayFit> decay;             ///< None unless it decays freely.
  std::optional<TransferFunction> response;  ///< To the wave; none without one.
};

struct RunAnalysis {
  std::string run;
  std::string wave;  ///< To which responses are, in words: `the wave at gauge`; empty: to none.
  std::vector<SignalAnalysis> signals;
};

/// Samples that a spectrum needs at least.
inline constexpr std::size_t kLeastSamples = 16;

/// Finds statistics, spectra, decays and responses of all signals of a run.
/// @throws InputError if the options name a probe or a length of segments that the run lacks
RunAnalysis analysis_of(const RunSignals& signals, const AnalyseOptions& options);

}  // namespace app

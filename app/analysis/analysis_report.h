#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/analysis/decay_fit.h"
#include "app/analysis/power_spectrum.h"
#include "app/analysis/run_signals.h"
#include "app/analysis/signal_statistics.h"

namespace app {

/// What was found of a signal.
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

/// Returns tables of statistics, of decays and of responses.
std::string text_of(const RunAnalysis& analysis);

/// Returns all numbers, spectra and responses at every frequency.
nlohmann::ordered_json json_of(const RunAnalysis& analysis);

}  // namespace app

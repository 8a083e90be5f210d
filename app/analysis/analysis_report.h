#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/analysis/run_analysis.h"

namespace app {

/// Returns tables of statistics, of decays and of responses.
std::string text_of(const RunAnalysis& analysis);

/// Returns all numbers, spectra and responses at every frequency.
nlohmann::ordered_json json_of(const RunAnalysis& analysis);

/// Returns the numbers of one signal, of a fit with its cycles.
nlohmann::ordered_json json_of(const SignalStatistics& statistics);
nlohmann::ordered_json json_of(const DecayFit& decay);

}  // namespace app

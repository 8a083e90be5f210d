#include "app/analysis/run_analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/base/words.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// Returns the samples in a segment of a spectrum; 0 if the signal is too short for one.
std::size_t segment_of(const Samples& samples, const std::optional<double>& seconds) {
  const std::size_t count = samples.values.size();
  if (count < kLeastSamples) return 0;
  if (!seconds) return usual_segment(count);
  const double wanted = *seconds * samples.rate;
  if (!(wanted >= 8 && wanted <= static_cast<double>(count)))
    throw scene::InputError(
        "--segment",
        fmt::format("found {:g} s, expected {:.4g} to {:.4g} s: 8 rows to all of them", *seconds,
                    8 / samples.rate, static_cast<double>(count) / samples.rate));
  return static_cast<std::size_t>(wanted);
}

/// True if a signal is constant but for round-off.
bool is_constant(const SignalStatistics& s) {
  constexpr double kRoundOff = 1e-12;
  return s.deviation <= kRoundOff * std::max({1.0, std::abs(s.min), std::abs(s.max)});
}

/// @param wave   At the times of the signal; null if there is none.
SignalAnalysis analysed(const Signal& signal, const Signal* wave,
                        const std::optional<double>& seconds) {
  SignalAnalysis a{.signal = signal, .statistics = statistics_of(signal.times, signal.values)};
  if (is_constant(a.statistics)) return a;
  const Samples samples = even_samples(signal);
  const std::size_t segment = segment_of(samples, seconds);
  if (segment > 0) a.spectrum = power_spectrum(samples.values, samples.rate, segment);
  if (segment > 0 && wave != nullptr)
    a.response =
        transfer_function(even_samples(*wave).values, samples.values, samples.rate, segment);
  else if (wave == nullptr)
    a.decay = fitted_decay(signal.times, signal.values);
  return a;
}

/// Returns the elevation at the probe that the user names. @throws InputError if there is none
Signal wave_at_probe(const RunSignals& signals, const std::string& probe) {
  std::vector<std::string> probes;
  for (const Signal& signal : signals.others) {
    if (signal.name != "elevation") continue;
    if (signal.of == probe) return signal;
    probes.push_back(signal.of);
  }
  std::string hint = did_you_mean(probe, probes);
  if (hint.empty())
    hint = probes.empty() ? "; the run has no probes with an elevation (log: {probes: […]})"
                          : "; there are " + enumerate(probes, "and");
  throw scene::InputError("--wave", fmt::format("there is no probe {}{}", probe, hint));
}

/// Returns the wave to which the motions of a body are a response; none if there is none.
std::optional<Signal> wave_for(const RunSignals& signals, std::size_t body,
                               const std::optional<Signal>& at_probe, const std::string& probe) {
  const Signal& surge = signals.motions[kMotionsOfBody * body];
  if (signals.sea) return wave_at(*signals.sea, surge, signals.motions[kMotionsOfBody * body + 1]);
  if (at_probe && at_probe->times != surge.times)
    throw scene::InputError(
        "--wave", fmt::format("probe {} and body {} have rows of other times, expected the same",
                              probe, surge.of));
  return at_probe;
}

}  // namespace

RunAnalysis analysis_of(const RunSignals& signals, const AnalyseOptions& options) {
  std::optional<Signal> at_probe;
  if (!options.wave.empty()) at_probe = wave_at_probe(signals, options.wave);
  RunAnalysis analysis{.run = options.run.string(), .wave = {}, .signals = {}};
  if (signals.sea) analysis.wave = "the wave at its mean place";
  if (at_probe) analysis.wave = "the wave at " + options.wave;
  for (std::size_t i = 0; i < signals.motions.size(); ++i) {
    const auto wave = wave_for(signals, i / kMotionsOfBody, at_probe, options.wave);
    analysis.signals.push_back(
        analysed(signals.motions[i], wave ? &*wave : nullptr, options.segment));
  }
  for (const Signal& signal : signals.others)
    analysis.signals.push_back(analysed(signal, nullptr, options.segment));
  return analysis;
}

}  // namespace app

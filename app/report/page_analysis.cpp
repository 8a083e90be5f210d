#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/analysis/analysis_report.h"
#include "app/analysis/run_analysis.h"
#include "app/logs/run_files.h"
#include "app/pages/packing.h"
#include "app/report/page_data.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// Largest number of columns that a signal has: its spectrum, and four of a response.
constexpr std::size_t kColumns = 5;

/// Returns how many values of a density are shown: up to the last one that is not small beside the
/// largest, and a quarter more.
std::size_t shown_of(const std::vector<double>& density, std::size_t most) {
  constexpr double kSmall = 1e-3;  // of the largest
  const double least = kSmall * *std::ranges::max_element(density);
  std::size_t end = density.size();
  while (end > 1 && density[end - 1] < least) --end;
  return std::min({end + end / 4 + 2, density.size(), most});
}

/// Packs the first values of a column.
template <class Value>
std::string packed_first(const std::vector<Value>& values, std::size_t count,
                         double (*number)(const Value&)) {
  std::vector<float> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(static_cast<float>(number(values[i])));
  return packed<float>(numbers);
}

double itself(const double& value) { return value; }
double size_of(const std::complex<double>& value) { return std::abs(value); }
double degrees_of(const std::complex<double>& value) {
  return std::arg(value) * 180 / std::numbers::pi;
}

Json page_spectrum(const PowerSpectrum& s, std::size_t most) {
  return {{"segments", s.segments},
          {"significant_height", 4 * std::sqrt(s.moment(0))},
          {"peak_period", s.peak() > 0 ? Json(1 / s.peak()) : Json(nullptr)},
          {"step", s.frequencies[1]},
          {"density", packed_first(s.density, shown_of(s.density, most), itself)}};
}

Json page_response(const TransferFunction& r, std::size_t most) {
  const std::size_t count = shown_of(r.input, most);
  return {{"segments", r.segments},
          {"step", r.frequencies[1]},
          {"amplitude", packed_first(r.response, count, size_of)},
          {"phase_deg", packed_first(r.response, count, degrees_of)},
          {"coherence", packed_first(r.coherence, count, itself)},
          {"wave", packed_first(r.input, count, itself)}};
}

}  // namespace

Json page_analysis(const LoggedRun& run, const PageLimits& limits) {
  if (run.rows < kLeastSamples || run.trajectory.tracks.empty()) return nullptr;
  const AnalyseOptions options{.run = run.path, .from = {}, .to = {}, .segment = {}, .wave = {}};
  RunSignals signals = signals_of(run.trajectory, trajectory_of(run.path), options);
  if (run.built.irregular_sea) signals.sea = run.built.spec.sea;
  const RunAnalysis analysis = analysis_of(signals, options);
  const std::size_t most =
      std::max<std::size_t>(limits.spectra / (kColumns * analysis.signals.size()), kLeastSamples);
  Json all = Json::array();
  for (const SignalAnalysis& a : analysis.signals) {
    Json& one = all.emplace_back(
        Json{{"of", a.signal.of}, {"signal", a.signal.name}, {"unit", a.signal.unit}});
    one["statistics"] = json_of(a.statistics);
    if (a.spectrum) one["spectrum"] = page_spectrum(*a.spectrum, most);
    if (a.decay) one["decay"] = json_of(*a.decay);
    if (a.response) one["response"] = page_response(*a.response, most);
  }
  return {{"wave", analysis.wave}, {"signals", all}};
}

}  // namespace app

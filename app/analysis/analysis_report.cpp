#include "app/analysis/analysis_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/base/console.h"
#include "app/base/table.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kWithWaves = 0.05;  ///< Least density shown, over the wave's largest [-].
constexpr std::size_t kMostRows = 16;
constexpr double kDegree = std::numbers::pi / 180;

std::string four(double number) { return fmt::format("{:.4g}", number); }

/// As `four`, but 0 for what is round-off beside the largest value.
std::string beside(double number, double largest) {
  constexpr double kRoundOff = 1e-9;
  return four(std::abs(number) <= kRoundOff * largest ? 0 : number);
}

void add_lines(const std::vector<Cells>& rows, std::string& text) {
  for (const std::string& line : aligned_lines(rows)) text += line + "\n";
}

Cells statistics_row(const SignalAnalysis& a) {
  const SignalStatistics& s = a.statistics;
  const double most = std::max(std::abs(s.min), std::abs(s.max));
  Cells cells = {a.signal.of + " " + a.signal.name,
                 a.signal.unit,
                 beside(s.mean, most),
                 beside(s.deviation, most),
                 beside(s.min, most),
                 four(s.at_min),
                 beside(s.max, most),
                 four(s.at_max),
                 beside(s.drift, most)};
  const bool cycles = s.crossings && a.spectrum;
  cells.push_back(cycles ? fmt::format("{}", s.crossings->count) : "-");
  cells.push_back(cycles ? four(s.crossings->period) : "-");
  cells.push_back(cycles ? four(s.crossings->significant) : "-");
  cells.push_back(a.spectrum ? four(4 * std::sqrt(a.spectrum->moment(0))) : "-");
  cells.push_back(a.spectrum && a.spectrum->peak() > 0 ? four(1 / a.spectrum->peak()) : "-");
  return cells;
}

void add_statistics(const RunAnalysis& analysis, std::string& text) {
  std::vector<Cells> rows = {{"signal", "unit", "mean", "std", "min", "at s", "max", "at s",
                              "drift /s", "cycles", "T_z s", "H_1/3", "H_m0", "T_p s"}};
  for (const SignalAnalysis& a : analysis.signals) rows.push_back(statistics_row(a));
  add_lines(rows, text);
}

void add_decay(const SignalAnalysis& a, std::string& text) {
  const DecayFit& d = *a.decay;
  text += fmt::format(
      "\ndecay of {} {} to {:.4g} {}: period {:.4g} s, linear damping {:.3g} % of the critical "
      "(p1 {:.3g} 1/s), quadratic p2 {:.3g} 1/{}\n",
      a.signal.of, a.signal.name, d.equilibrium, a.signal.unit, d.period, 100 * d.damping_ratio,
      d.linear, d.quadratic, a.signal.unit);
  std::vector<Cells> rows = {{"from s", "period s", "amplitude " + a.signal.unit, "decrement"}};
  for (std::size_t i = 0; i < d.cycles.size() && rows.size() <= kMostRows; i += 2)
    rows.push_back({four(d.cycles[i].start), four(d.cycles[i].period), four(d.cycles[i].amplitude),
                    four(d.cycles[i].decrement)});
  add_lines(rows, text);
  if (d.cycles.size() > 2 * kMostRows)
    text += fmt::format("  and {} later, which --json lists\n",
                        counted((d.cycles.size() + 1) / 2 - kMostRows, "cycle", "cycles"));
}

/// Returns the rows of a response at which the wave has energy.
std::vector<std::size_t> rows_with_waves(const TransferFunction& response) {
  const double most = *std::ranges::max_element(response.input);
  std::vector<std::size_t> rows;
  for (std::size_t k = 1; k < response.input.size(); ++k)
    if (response.input[k] >= kWithWaves * most) rows.push_back(k);
  return rows;
}

/// Adds a table of the responses of one body, all of which are over the same frequencies.
void add_responses(const std::vector<const SignalAnalysis*>& motions, const std::string& wave,
                   std::string& text) {
  const TransferFunction& first = *motions.front()->response;
  text += fmt::format("\n{}: response to {}, with phase lead in degrees and coherence, from {}\n",
                      motions.front()->signal.of, wave,
                      counted(static_cast<std::size_t>(first.segments), "segment", "segments"));
  std::vector<Cells> rows = {{"period s"}};
  for (const SignalAnalysis* a : motions)
    for (const std::string& head :
         {a->signal.name + " " + a->signal.unit + "/m", std::string("lead"), std::string("coh")})
      rows.front().push_back(head);
  const std::vector<std::size_t> with_waves = rows_with_waves(first);
  const std::size_t stride = (with_waves.size() + kMostRows - 1) / kMostRows;
  for (std::size_t i = 0; i < with_waves.size(); i += stride) {
    const std::size_t k = with_waves[i];
    Cells& row = rows.emplace_back(Cells{four(1 / first.frequencies[k])});
    for (const SignalAnalysis* a : motions) {
      row.push_back(fmt::format("{:.3f}", std::abs(a->response->response[k])));
      row.push_back(fmt::format("{:.0f}", std::arg(a->response->response[k]) / kDegree));
      row.push_back(fmt::format("{:.2f}", a->response->coherence[k]));
    }
  }
  add_lines(rows, text);
}

/// Returns the signals with a response, those of each body together.
std::vector<std::vector<const SignalAnalysis*>> with_response(const RunAnalysis& analysis) {
  std::vector<std::vector<const SignalAnalysis*>> bodies;
  for (const SignalAnalysis& a : analysis.signals) {
    if (!a.response) continue;
    if (bodies.empty() || bodies.back().front()->signal.of != a.signal.of) bodies.emplace_back();
    bodies.back().push_back(&a);
  }
  return bodies;
}

Json json_of(const PowerSpectrum& s) {
  return {{"segments", s.segments},
          {"variance", s.moment(0)},
          {"significant_height", 4 * std::sqrt(s.moment(0))},
          {"peak_period", s.peak() > 0 ? Json(1 / s.peak()) : Json(nullptr)},
          {"frequency_hz", s.frequencies},
          {"density", s.density}};
}

Json json_of(const TransferFunction& r) {
  std::vector<double> sizes, phases;
  for (const std::complex<double>& response : r.response) {
    sizes.push_back(std::abs(response));
    phases.push_back(std::arg(response) / kDegree);
  }
  return {{"segments", r.segments}, {"frequency_hz", r.frequencies}, {"amplitude", sizes},
          {"phase_deg", phases},    {"coherence", r.coherence},      {"wave_density", r.input}};
}

}  // namespace

std::string text_of(const RunAnalysis& analysis) {
  const Signal& first = analysis.signals.front().signal;
  std::string text = fmt::format("{}: {} from {:g} to {:g} s\n", analysis.run,
                                 counted(first.times.size(), "row", "rows"), first.times.front(),
                                 first.times.back());
  add_statistics(analysis, text);
  for (const SignalAnalysis& a : analysis.signals)
    if (a.decay) add_decay(a, text);
  for (const auto& motions : with_response(analysis)) add_responses(motions, analysis.wave, text);
  return text;
}

Json json_of(const SignalStatistics& s) {
  Json json = {{"mean", s.mean},     {"std", s.deviation}, {"drift", s.drift},  {"min", s.min},
               {"at_min", s.at_min}, {"max", s.max},       {"at_max", s.at_max}};
  if (s.crossings)
    json["cycles"] = {{"count", s.crossings->count},
                      {"mean_period", s.crossings->period},
                      {"significant_height", s.crossings->significant},
                      {"largest_height", s.crossings->largest}};
  return json;
}

Json json_of(const DecayFit& d) {
  Json cycles = Json::array();
  for (const DecayCycle& c : d.cycles)
    cycles.push_back({{"start", c.start},
                      {"period", c.period},
                      {"amplitude", c.amplitude},
                      {"decrement", c.decrement}});
  return {{"period", d.period},       {"equilibrium", d.equilibrium},
          {"decrement", d.decrement}, {"damping_ratio", d.damping_ratio},
          {"linear", d.linear},       {"quadratic", d.quadratic},
          {"cycles", cycles}};
}

Json json_of(const RunAnalysis& analysis) {
  Json signals = Json::array();
  for (const SignalAnalysis& a : analysis.signals) {
    Json& one = signals.emplace_back(
        Json{{"of", a.signal.of}, {"signal", a.signal.name}, {"unit", a.signal.unit}});
    one["rows"] = a.signal.times.size();
    one["from"] = a.signal.times.front();
    one["to"] = a.signal.times.back();
    one["statistics"] = json_of(a.statistics);
    if (a.spectrum) one["spectrum"] = json_of(*a.spectrum);
    if (a.decay) one["decay"] = json_of(*a.decay);
    if (a.response) one["response"] = json_of(*a.response);
  }
  Json json = {{"run", analysis.run}};
  if (!analysis.wave.empty()) json["wave"] = analysis.wave;
  json["signals"] = signals;
  return json;
}

}  // namespace app

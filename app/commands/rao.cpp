#include "app/commands/rao.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/assembly/build.h"
#include "app/assembly/build_radiation.h"
#include "app/base/atomic_file.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/quoting.h"
#include "app/base/table.h"
#include "app/base/terminal_reporter.h"
#include "app/commands/linear_motions.h"
#include "app/commands/measured_motions.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;
using std::numbers::pi;

constexpr const char* kAxes[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
constexpr double kDegrees = 180 / pi;

/// Amplitudes below this are of no phase, and none is printed for them [m/m, deg/m].
constexpr double kNoMotion = 1e-9;

/// Amplitude that a table shows at least [m/m, deg/m].
constexpr double kSmallest = 5e-5;

/// Change of a response in a run above which it is told [-].
constexpr double kSteady = 0.02;

/// A wave and the motions of one body in it.
struct Response {
  RegularWave wave;
  hydro::Vector6d amplitude;  ///< [m/m, deg/m]
  hydro::Vector6d lead;       ///< Phase by which it leads the crest, within ±180; 0 at rest [deg].
  std::string source = "linear";  ///< Or `run`.
};

struct BodyResponses {
  LinearMotions body;
  std::vector<Response> responses;  ///< By heading, then by period; that of a run after the other.
};

Response response_of(const RegularWave& wave, const hydro::Vector6cd& motion) {
  Response found{wave, motion.cwiseAbs(), hydro::Vector6d::Zero()};
  found.amplitude.tail<3>() *= kDegrees;
  for (Eigen::Index i = 0; i < 6; ++i) {
    if (found.amplitude[i] < kNoMotion) found.amplitude[i] = 0;
    // The motion |ξ| cos(ωt − arg ξ) leads the crest by −arg ξ.
    else
      found.lead[i] = -std::arg(motion[i]) * kDegrees + 0.0;
  }
  return found;
}

std::vector<BodyResponses> responses_of(const RaoCommand& o, Reporter& reporter) {
  const scene::Scene scene = scene::read(o.scene, o.overrides, o.formats);
  const assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  if (!built.spec.sea) throw scene::InputError(o.scene.string(), "has no water");
  const hydro::Sea& sea = *built.spec.sea;
  std::vector<std::vector<RegularWave>> trains;
  for (const double heading : o.headings) {
    trains.emplace_back();
    for (const double period : o.periods)
      trains.back().push_back(regular_wave(sea, period, heading / kDegrees));
  }
  assembly::RadiationStore store(o.store ? assembly::cache_folder() : std::nullopt);
  std::vector<BodyResponses> all;
  for (LinearMotions& body : linear_motions(o.scene, built, o.body, store, reporter)) {
    all.push_back({std::move(body), {}});
    for (const std::vector<RegularWave>& waves : trains) {
      const hydro::Loads6cd motions = all.back().body.in(waves);
      for (std::size_t w = 0; w < waves.size(); ++w)
        all.back().responses.push_back(
            response_of(waves[w], motions.col(static_cast<Eigen::Index>(w))));
    }
  }
  return all;
}

/// Measures the responses to the waves of all bodies, behind those of linear theory.
void add_runs(const RaoCommand& o, std::vector<BodyResponses>& all, Reporter& reporter) {
  const scene::Scene scene = scene::read(o.scene, o.overrides, o.formats);
  assembly::AddedMassStore store(o.store ? assembly::cache_folder() : std::nullopt);
  std::vector<LinearMotions> bodies;
  for (const BodyResponses& each : all) bodies.push_back(each.body);
  std::vector<std::vector<Response>> rows(all.size());
  const std::size_t waves = all.front().responses.size();
  for (std::size_t w = 0; w < waves; ++w) {
    const RegularWave wave = all.front().responses[w].wave;
    reporter.working_on(fmt::format("run {} of {}: {:g} s from {:g} deg", w + 1, waves, wave.period,
                                    wave.heading * kDegrees));
    const auto found = measured_motions(scene, wave, o.slope, bodies, store, reporter);
    for (std::size_t i = 0; i < all.size(); ++i) {
      rows[i].push_back(all[i].responses[w]);
      rows[i].push_back(response_of(wave, found[i].first));
      rows[i].back().source = "run";
      if (found[i].change > kSteady)
        reporter.warning(fmt::format(
            "{} in waves of {:g} s: the response still changes by {:.2g} of the largest in ten "
            "periods",
            bodies[i].name, wave.period, found[i].change));
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].responses = std::move(rows[i]);
}

std::vector<std::string> assumed(const hydro::Sea& sea) {
  std::vector<std::string> all =
      assembly::assumptions({.gravity = sea.gravity, .depth = sea.depth}, false);
  all.emplace_back("no drag, wind, machines or controls");
  return all;
}

const char* unit_suffix(std::size_t motion) { return motion < 3 ? "" : "_deg"; }

std::string csv_of(const std::vector<BodyResponses>& all) {
  std::string text = "body,heading_deg,period,omega,wavelength";
  for (std::size_t i = 0; i < 6; ++i)
    text += fmt::format(",{0}{1},{0}_phase_deg", kAxes[i], unit_suffix(i));
  text += ",source\n";
  for (const BodyResponses& each : all)
    for (const Response& r : each.responses) {
      text += fmt::format("{},{},{},{},{}", csv_field(each.body.name), r.wave.heading * kDegrees,
                          r.wave.period, r.wave.frequency, 2 * pi / r.wave.wave_number);
      for (Eigen::Index i = 0; i < 6; ++i) text += fmt::format(",{},{}", r.amplitude[i], r.lead[i]);
      text += "," + r.source + "\n";
    }
  return text;
}

Json to_json(const BodyResponses& each) {
  Json rows = Json::array();
  for (const Response& r : each.responses) {
    Json row = {{"heading_deg", r.wave.heading * kDegrees},
                {"period", r.wave.period},
                {"omega", r.wave.frequency},
                {"wavelength", 2 * pi / r.wave.wave_number}};
    for (std::size_t i = 0; i < 6; ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      row[kAxes[i] + std::string(unit_suffix(i))] = r.amplitude[at];
      row[kAxes[i] + std::string("_phase_deg")] = r.lead[at];
    }
    row["source"] = r.source;
    rows.push_back(std::move(row));
  }
  return {{"assumed", assumed(each.body.sea)},
          {"left_out", each.body.left_out},
          {"responses", std::move(rows)}};
}

std::string table_of(const BodyResponses& each) {
  std::string text = fmt::format(
      "{}: amplitude over that of the wave, and phase by which it leads the crest\n"
      "  assumed: {}\n",
      each.body.name, fmt::join(assumed(each.body.sea), ", "));
  if (!each.body.left_out.empty())
    text += fmt::format("  left out: {}\n", fmt::join(each.body.left_out, ", "));
  const bool runs = std::ranges::any_of(
      each.responses, [](const Response& response) { return response.source == "run"; });
  std::vector<Cells> rows = {{"heading", "period", "length"}, {"deg", "s", "m"}};
  if (runs) {
    rows[0].emplace_back("by");
    rows[1].emplace_back("");
  }
  for (std::size_t i = 0; i < 6; ++i) {
    rows[0].insert(rows[0].end(), {kAxes[i], "phase"});
    rows[1].insert(rows[1].end(), {i < 3 ? "m/m" : "deg/m", "deg"});
  }
  for (const Response& r : each.responses) {
    Cells row = {fmt::format("{:g}", r.wave.heading * kDegrees), fmt::format("{:g}", r.wave.period),
                 fmt::format("{:.4g}", 2 * pi / r.wave.wave_number)};
    if (runs) row.push_back(r.source);
    for (Eigen::Index i = 0; i < 6; ++i) {
      row.push_back(fmt::format("{:.4f}", r.amplitude[i]));
      row.push_back(r.amplitude[i] >= kSmallest ? fmt::format("{:.0f}", std::round(r.lead[i]) + 0.0)
                                                : "");
    }
    rows.push_back(std::move(row));
  }
  for (const std::string& line : aligned_lines(rows)) text += line + "\n";
  return text;
}

void check(const RaoCommand& o) {
  if (!(o.periods.front() > 0))
    throw scene::InputError(
        "--periods", fmt::format("found {:g}, expected positive numbers [s]", o.periods.front()));
  if (!(o.slope > 0 && o.slope < 0.4))
    throw scene::InputError(
        "--slope", fmt::format("found {:g}, expected a slope above 0 and below 0.4", o.slope));
  if (!o.out.empty() && o.out.extension() != ".csv")
    throw scene::InputError("--out", fmt::format("found {}, expected a file .csv", o.out.string()));
}

}  // namespace

int rao(const RaoCommand& command) {
  check(command);
  TerminalReporter reporter(false);
  std::vector<BodyResponses> all = responses_of(command, reporter);
  if (command.runs && !all.empty()) add_runs(command, all, reporter);
  if (!command.out.empty()) write_whole(command.out, csv_of(all));
  if (command.json) {
    Json bodies = Json::object();
    for (const BodyResponses& each : all) bodies[each.body.name] = to_json(each);
    fmt::print("{}\n",
               Json{{"bodies", bodies}}.dump(2, ' ', false, Json::error_handler_t::replace));
  } else if (command.csv) {
    fmt::print("{}", csv_of(all));
  } else {
    for (const BodyResponses& each : all) fmt::print("{}", table_of(each));
  }
  flush_output();
  return kDone;
}

}  // namespace app

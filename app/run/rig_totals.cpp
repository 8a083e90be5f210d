#include "app/run/rig_totals.h"

#include <algorithm>
#include <numbers>

#include "app/logs/rig_log.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

}  // namespace

void RigTotals::Line::add(double time, const engine::LineReading& reading) {
  if (reading.tension > most) {
    most = reading.tension;
    at = time;
  }
  if (reading.broken && !broken) broken = time;
}

void RigTotals::add(double time, const engine::RigReadings& readings) {
  ++readings_;
  lines_.resize(readings.lines.size() + readings.moordyn.size());
  std::size_t next = 0;
  for (const engine::LineReading& reading : readings.lines) lines_[next++].add(time, reading);
  for (const engine::LineReading& reading : readings.moordyn) lines_[next++].add(time, reading);
  propellers_.resize(readings.propellers.size());
  for (std::size_t i = 0; i < propellers_.size(); ++i) {
    const engine::PropellerReading& reading = readings.propellers[i];
    propellers_[i].power += 2 * std::numbers::pi * reading.speed * reading.torque;
    propellers_[i].thrust += reading.thrust;
  }
}

Json RigTotals::state() const {
  Json lines = Json::array(), propellers = Json::array();
  for (const Line& line : lines_) lines.push_back({line.most, line.at, or_null(line.broken)});
  for (const Propeller& propeller : propellers_)
    propellers.push_back({propeller.power, propeller.thrust});
  return {{"readings", readings_}, {"lines", lines}, {"propellers", propellers}};
}

void RigTotals::restore(const Json& state) {
  readings_ = state.at("readings").get<long>();
  lines_.clear();
  for (const Json& line : state.at("lines")) {
    lines_.push_back(
        {.most = line.at(0).get<double>(), .at = line.at(1).get<double>(), .broken = {}});
    if (!line.at(2).is_null()) lines_.back().broken = line.at(2).get<double>();
  }
  propellers_.clear();
  for (const Json& propeller : state.at("propellers"))
    propellers_.push_back({propeller.at(0).get<double>(), propeller.at(1).get<double>()});
}

Json RigTotals::lines(const engine::SimulationSpec& spec) const {
  Json all = Json::object();
  const std::vector<std::string> names = line_names(spec);
  for (std::size_t i = 0; i < lines_.size(); ++i)
    all[names[i]] = {{"tension_max", lines_[i].most},
                     {"at", lines_[i].at},
                     {"broken_at", or_null(lines_[i].broken)}};
  return all;
}

Json RigTotals::machines(const engine::SimulationSpec& spec) const {
  Json all = Json::object();
  const auto count = static_cast<double>(std::max(readings_, 1L));
  for (std::size_t i = 0; i < propellers_.size(); ++i)
    all[log_name(spec.propellers[i])] = {{"power_mean", propellers_[i].power / count},
                                         {"thrust_mean", propellers_[i].thrust / count}};
  return all;
}

}  // namespace app

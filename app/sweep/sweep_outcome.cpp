#include "app/sweep/sweep_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "app/base/atomic_file.h"
#include "app/base/child_process.h"
#include "app/base/exit_code.h"
#include "app/base/quoting.h"
#include "app/logs/read_log.h"
#include "app/logs/run_files.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Returns the angle of the body's z axis to the vertical [deg].
double tilt_deg(const hydro::BodyState& state) {
  const Eigen::Vector3d axis = state.orientation * Eigen::Vector3d::UnitZ();
  // The arc tangent is used, since the arc cosine loses its digits where the body is upright.
  return std::atan2(std::hypot(axis.x(), axis.y()), axis.z()) * 180 / std::numbers::pi;
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

Json parsed(const fs::path& file) { return Json::parse(text_of(file), nullptr, false); }

/// Returns the first line that reports an error.
std::string first_complaint(const fs::path& messages) {
  std::istringstream stream(text_of(messages));
  const std::string mark = "error: ";
  std::string first;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(mark)) return line.substr(mark.size());
    if (first.empty() && line.find(": note: ") == std::string::npos) first = line;
  }
  return first;
}

std::string joined_warnings(const Json& summary) {
  std::string text;
  for (const Json& warning : summary.value("warnings", Json::array()))
    text += (text.empty() ? "" : "; ") + warning.get<std::string>();
  return text;
}

std::string message_of(const Json& summary, const fs::path& messages, int code) {
  if (code > EndedProcess::kSignalBase)
    return fmt::format("the run was ended by signal {}", code - EndedProcess::kSignalBase);
  if (code == kDone) return summary.is_object() ? joined_warnings(summary) : "";
  if (summary.is_object() && summary.contains("error")) return summary["error"];
  return first_complaint(messages);
}

std::vector<BodyOutcome> read_bodies(const fs::path& trajectory) {
  std::vector<BodyOutcome> bodies;
  try {
    const Trajectory read = read_trajectory(trajectory);
    for (const std::string& name : read.names)
      bodies.push_back(body_outcome(name, read.tracks.at(name)));
  } catch (const std::runtime_error&) {
    // The run ended before its first row; its message gives the reason.
  }
  return bodies;
}

std::vector<NamedNumber> joints_in(const Json& summary) {
  std::vector<NamedNumber> numbers;
  if (!summary.is_object() || !summary.contains("joints")) return numbers;
  for (const auto& [name, joint] : summary["joints"].items())
    for (const std::string_view column : kJointColumns)
      if (const auto found = joint.find(column); found != joint.end())
        numbers.push_back({fmt::format("joints.{}.{}", name, column), found->get<double>()});
  return numbers;
}

/// Returns a text as a cell of a CSV file, on one line.
std::string cell(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return csv_field(text);
}

std::string header_of(const std::vector<SweepParameter>& parameters,
                      const std::vector<std::string>& bodies,
                      const std::vector<std::string>& joint_columns) {
  std::string header = "run";
  for (const SweepParameter& parameter : parameters) header += ',' + cell(parameter.key_path);
  header += ",exit_code,simulated_seconds,wall_seconds";
  for (const std::string& body : bodies)
    for (const std::string_view column : kBodyColumns)
      header += ',' + cell(fmt::format("{}.{}", body, column));
  header += ",message";
  for (const std::string& column : joint_columns) header += ',' + cell(column);
  return header + '\n';
}

std::string row_of(std::size_t index, const SweepPoint& point,
                   const std::vector<std::string>& bodies,
                   const std::vector<std::string>& joint_columns, const RunOutcome& outcome) {
  std::string row = run_name(index);
  for (const std::string& value : point) row += ',' + cell(value);
  row += fmt::format(",{},{},{:.3f}", outcome.code,
                     outcome.simulated ? fmt::format("{}", *outcome.simulated) : "", outcome.wall);
  for (const std::string& body : bodies) {
    const auto found = std::find_if(outcome.bodies.begin(), outcome.bodies.end(),
                                    [&](const BodyOutcome& one) { return one.name == body; });
    if (found == outcome.bodies.end())
      row += std::string(kBodyColumns.size(), ',');
    else
      for (const double value : found->values) row += fmt::format(",{}", value);
  }
  row += ',' + cell(outcome.message);
  for (const std::string& column : joint_columns) {
    const auto found = std::ranges::find(outcome.joints, column, &NamedNumber::column);
    row += found == outcome.joints.end() ? "," : fmt::format(",{}", found->value);
  }
  return row + '\n';
}

}  // namespace

BodyOutcome body_outcome(const std::string& name, const BodyTrack& track) {
  const hydro::BodyState& last = track.states.back();
  double z_min = last.position.z(), z_max = z_min;
  double speed = 0, angular_speed = 0, acceleration = 0, tilt = 0;
  for (std::size_t i = 0; i < track.states.size(); ++i) {
    const hydro::BodyState& state = track.states[i];
    z_min = std::min(z_min, state.position.z());
    z_max = std::max(z_max, state.position.z());
    speed = std::max(speed, state.linear_velocity.norm());
    angular_speed = std::max(angular_speed, state.angular_velocity.norm());
    tilt = std::max(tilt, tilt_deg(state));
    if (i == 0) continue;
    const Eigen::Vector3d change = state.linear_velocity - track.states[i - 1].linear_velocity;
    acceleration = std::max(acceleration, change.norm() / (track.times[i] - track.times[i - 1]));
  }
  BodyOutcome outcome{.name = name};
  const std::array extremes = {z_min,        z_max,          speed, angular_speed,
                               acceleration, tilt_deg(last), tilt};
  std::ranges::copy(extremes, std::ranges::copy(row_of(last), outcome.values.begin()).out);
  return outcome;
}

RunOutcome collect_outcome(const fs::path& folder, const fs::path& messages, int code,
                           double wall) {
  RunOutcome outcome = {
      .code = code, .simulated = {}, .wall = wall, .message = {}, .bodies = {}, .joints = {}};
  const Json summary = parsed(folder / kSummaryFile);
  outcome.message = message_of(summary, messages, code);
  if (summary.is_object()) outcome.simulated = summary.value("simulated_seconds", 0.0);
  outcome.bodies = read_bodies(folder / kTrajectoryLog);
  outcome.joints = joints_in(summary);
  return outcome;
}

void write_outcome(const RunOutcome& outcome, const fs::path& file) {
  Json json = {{"exit_code", outcome.code},
               {"simulated_seconds", outcome.simulated ? Json(*outcome.simulated) : Json(nullptr)},
               {"wall_seconds", outcome.wall},
               {"message", outcome.message},
               {"bodies", Json::array()},
               {"joints", Json::object()}};
  for (const BodyOutcome& body : outcome.bodies)
    json["bodies"].push_back({{"name", body.name}, {"values", body.values}});
  for (const NamedNumber& number : outcome.joints) json["joints"][number.column] = number.value;
  write_whole(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

std::optional<RunOutcome> read_outcome(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  try {
    const Json json = Json::parse(text_of(file));
    RunOutcome outcome = {.code = json.at("exit_code"),
                          .simulated = {},
                          .wall = json.at("wall_seconds"),
                          .message = json.at("message"),
                          .bodies = {},
                          .joints = {}};
    if (!json.at("simulated_seconds").is_null()) outcome.simulated = json.at("simulated_seconds");
    for (const Json& body : json.at("bodies"))
      outcome.bodies.push_back({body.at("name"), body.at("values")});
    const Json joints = json.value("joints", Json::object());
    for (const auto& [column, value] : joints.items()) outcome.joints.push_back({column, value});
    return outcome;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string table_of(const std::vector<SweepParameter>& parameters,
                     const std::vector<SweepPoint>& points, const std::vector<std::string>& bodies,
                     const std::vector<std::optional<RunOutcome>>& outcomes) {
  std::vector<std::string> joint_columns;
  for (const auto& outcome : outcomes)
    for (const NamedNumber& number : outcome ? outcome->joints : std::vector<NamedNumber>{})
      if (std::ranges::find(joint_columns, number.column) == joint_columns.end())
        joint_columns.push_back(number.column);
  std::string table = header_of(parameters, bodies, joint_columns);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (outcomes[i]) table += row_of(i, points[i], bodies, joint_columns, *outcomes[i]);
  return table;
}

std::string run_name(std::size_t index) { return fmt::format("{:04}", index); }

}  // namespace app

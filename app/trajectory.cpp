#include "app/trajectory.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

#include "app/faults.h"

namespace app {
namespace {

constexpr std::string_view kHeader = "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";
constexpr std::size_t kFields = 15;
constexpr double kUnitTolerance = 0.01;  ///< Of quaternions that others wrote with few digits.

std::array<double, 13> numbers(const hydro::BodyState& s) {
  const Eigen::Vector3d& p = s.position;
  const Eigen::Quaterniond& q = s.orientation;
  const Eigen::Vector3d& v = s.linear_velocity;
  const Eigen::Vector3d& w = s.angular_velocity;
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(),
          v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
}

hydro::BodyState state(const std::array<double, 13>& n) {
  return {.position = {n[0], n[1], n[2]},
          .orientation = Eigen::Quaterniond(n[3], n[4], n[5], n[6]),
          .linear_velocity = {n[7], n[8], n[9]},
          .angular_velocity = {n[10], n[11], n[12]}};
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

[[noreturn]] void refuse(const std::filesystem::path& file, int line, const std::string& message) {
  throw InputError({{.place = {.file = file, .line = line, .column = 1}, .message = message}});
}

double number_in_log(std::string_view text, const std::filesystem::path& file, int line) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    refuse(file, line, fmt::format("found \"{}\", expected a finite number", text));
  return value;
}

/// One row; a body's times must ascend.
void read_row(std::string_view text, const std::filesystem::path& file, int line,
              Trajectory& trajectory) {
  const std::vector<std::string_view> fields = split(text);
  if (fields.size() != kFields)
    refuse(file, line, fmt::format("found {} fields, expected {}", fields.size(), kFields));
  const double time = number_in_log(fields[0], file, line);
  std::array<double, 13> values;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = number_in_log(fields[i + 2], file, line);
  const std::string name(fields[1]);
  const auto [entry, is_new] = trajectory.tracks.try_emplace(name);
  BodyTrack& track = entry->second;
  if (is_new) trajectory.names.push_back(name);
  if (!track.times.empty() && time <= track.times.back())
    refuse(
        file, line,
        fmt::format("time {} of body {} does not come after {}", time, name, track.times.back()));
  track.times.push_back(time);
  track.states.push_back(state(values));
  const double norm = track.states.back().orientation.norm();
  if (!(std::abs(norm - 1) < kUnitTolerance))
    refuse(file, line, fmt::format("the quaternion has length {:g}, expected 1", norm));
}

}  // namespace

TrajectoryWriter::TrajectoryWriter(const std::filesystem::path& file,
                                   std::vector<std::string> names)
    : names_(std::move(names)), file_(file, kHeader) {}

void TrajectoryWriter::add(double time, const std::vector<hydro::BodyState>& states) {
  fmt::memory_buffer rows;
  for (std::size_t i = 0; i < states.size(); ++i) {
    fmt::format_to(std::back_inserter(rows), "{},{}", time, names_[i]);
    for (const double n : numbers(states[i])) fmt::format_to(std::back_inserter(rows), ",{}", n);
    rows.push_back('\n');
  }
  file_.add(rows);
}

Trajectory read_trajectory(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw InputError(file, "cannot be read; expected a trajectory that plimsoll run has written");
  Trajectory trajectory;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const bool cut_off = stream.eof();  // the last line has no end: its writer was stopped
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (number == 1) {
      if (line != kHeader) refuse(file, 1, fmt::format("expected the header {}", kHeader));
      continue;
    }
    if (cut_off) break;
    read_row(line, file, number, trajectory);
  }
  if (trajectory.names.empty()) throw InputError(file, "has no rows");
  return trajectory;
}

}  // namespace app

#include "app/logs/trajectory_csv.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <utility>

#include "app/logs/log_rows.h"

namespace app {
namespace {

constexpr std::string_view kHeader = "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";

/// Reads one row; a body's times must ascend.
void read_row(std::string_view text, const std::filesystem::path& file, int line,
              Trajectory& trajectory) {
  StateRow values;
  const LogRow row = read_log_row(text, file, line, values);
  const std::string name(row.body);
  const auto [entry, is_new] = trajectory.tracks.try_emplace(name);
  if (is_new) trajectory.names.push_back(name);
  const std::string fault = add_row(name, row.time, values, entry->second);
  if (!fault.empty()) refuse_row(file, line, fault);
}

}  // namespace

TrajectoryWriter::TrajectoryWriter(const std::filesystem::path& file,
                                   std::vector<std::string> names,
                                   const std::optional<FilePosition>& kept)
    : names_(std::move(names)), file_(file, kHeader, kept) {}

void TrajectoryWriter::add(double time, const std::vector<hydro::BodyState>& states) {
  const std::string at = fmt::format("{},", time);
  rows_.clear();
  const auto to = std::back_inserter(rows_);
  for (std::size_t i = 0; i < states.size(); ++i) {
    rows_.append(at);
    rows_.append(names_[i]);
    for (const double n : row_of(states[i])) fmt::format_to(to, FMT_COMPILE(",{}"), n);
    rows_.push_back('\n');
  }
  file_.add(rows_);
}

Trajectory read_trajectory_csv(const std::filesystem::path& file) {
  Trajectory trajectory;
  const auto read = [&](std::string_view row, int line) { read_row(row, file, line, trajectory); };
  read_rows(file, kHeader, "a trajectory", read);
  return trajectory;
}

}  // namespace app

#include "app/pictures/rig_history.h"

#include <algorithm>
#include <cmath>

#include "app/logs/read_log.h"
#include "app/logs/rig_log.h"

namespace app {
namespace {

constexpr double kOneDegree = M_PI / 180;

/// Rows of one name, and the one that counts at a time.
class Rows {
 public:
  Rows(const std::optional<TableRows>& table, const std::string& name) {
    if (!table) return;
    const auto found = table->tracks.find(name);
    if (found == table->tracks.end()) return;
    layout_ = &table->layout;
    track_ = &found->second;
  }

  /// Index of the last row at or before a time; none if there is no such row.
  std::optional<std::size_t> row_at(double time) const {
    if (!track_) return std::nullopt;
    const auto after = std::upper_bound(track_->times.begin(), track_->times.end(), time);
    if (after == track_->times.begin()) return std::nullopt;
    return static_cast<std::size_t>(after - track_->times.begin()) - 1;
  }

  std::size_t size() const { return track_ ? track_->times.size() : 0; }
  double time(std::size_t row) const { return track_->times[row]; }
  double number(const char* column, std::size_t row) const {
    return track_->columns[layout_->column(column)][row];
  }

 private:
  const TableLayout* layout_ = nullptr;
  const TableTrack* track_ = nullptr;
};

std::vector<double> turns_of(const Rows& rows) {
  std::vector<double> turns(rows.size(), 0);
  for (std::size_t i = 1; i < rows.size(); ++i)
    turns[i] = turns[i - 1] + M_PI * (rows.number("setting", i - 1) + rows.number("setting", i)) *
                                  (rows.time(i) - rows.time(i - 1));
  return turns;
}

}  // namespace

RigHistory::RigHistory(const engine::SimulationSpec& spec, const std::filesystem::path& trajectory)
    : spec_(spec) {
  if (!spec.lines.empty()) lines_ = read_table(trajectory, lines_layout());
  if (has_nodes(spec)) nodes_ = read_table(trajectory, line_nodes_layout());
  if (!spec.propellers.empty() || !spec.foils.empty())
    machines_ = read_table(trajectory, machines_layout());
  for (const engine::PropellerSpec& propeller : spec.propellers)
    turns_.push_back(turns_of(Rows(machines_, log_name(propeller))));
}

std::vector<Eigen::Vector3d> RigHistory::nodes_at(const engine::LineSpec& line, double time) const {
  std::vector<Eigen::Vector3d> nodes_W;
  for (std::size_t i = 0; i < node_count(line); ++i) {
    const Rows rows(nodes_, node_name(line, i));
    const auto row = rows.row_at(time);
    if (!row) return {};
    nodes_W.emplace_back(rows.number("x", *row), rows.number("y", *row), rows.number("z", *row));
    if (nodes_W.back().hasNaN()) return {};
  }
  return nodes_W;
}

DrawnRig RigHistory::at(double time, const std::vector<hydro::BodyState>& states) const {
  DrawnRig rig = rig_at_rest(spec_, states, time);
  for (std::size_t i = 0; i < spec_.lines.size(); ++i) {
    const Rows rows(lines_, log_name(spec_.lines[i]));
    if (const auto row = rows.row_at(time))
      rig.lines[i] = {.tension = rows.number("tension", *row),
                      .length = rows.number("length", *row),
                      .broken = rows.number("broken", *row) != 0};
    rig.lines[i].nodes_W = nodes_at(spec_.lines[i], time);
  }
  for (std::size_t i = 0; i < spec_.propellers.size(); ++i) {
    const Rows rows(machines_, log_name(spec_.propellers[i]));
    if (const auto row = rows.row_at(time))
      rig.propellers[i] = {.turn = turns_[i][*row],
                           .azimuth = rows.number("angle_deg", *row) * kOneDegree};
  }
  for (std::size_t i = 0; i < spec_.foils.size(); ++i) {
    const Rows rows(machines_, log_name(spec_.foils[i]));
    if (const auto row = rows.row_at(time))
      rig.foil_angles[i] = rows.number("angle_deg", *row) * kOneDegree;
  }
  return rig;
}

}  // namespace app

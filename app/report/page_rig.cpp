#include "app/report/page_rig.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "app/logs/rig_log.h"
#include "app/pages/packing.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// The columns of one thing in its table.
class Columns {
 public:
  /// @param thinning   Thinning of the rows; null: columns are counted only.
  Columns(const TableRows& table, const std::string& name, const Thinning* thinning)
      : table_(table), track_(table.tracks.at(name)), thinning_(thinning) {}

  const std::vector<double>& of(const std::string& column) const {
    return track_.columns[table_.layout.column(column)];
  }

  Columns& add(const std::string& key, std::vector<double> values) {
    ++count_;
    if (thinning_) json_[key] = packed_column(thinning_->values(values));
    return *this;
  }
  Columns& add(const std::string& key, const std::string& column) { return add(key, of(column)); }
  Columns& add_degrees(const std::string& key, const std::string& column, bool radians) {
    std::vector<double> values = of(column);
    for (double& value : values) value *= radians ? 180 / std::numbers::pi : 1;
    return add(key, std::move(values));
  }
  /// The power that what acts along a joint's coordinate absorbs.
  Columns& add_absorbed_power() {
    const std::vector<double>&effort = of("effort"), &speed = of("speed");
    std::vector<double> power;
    for (std::size_t i = 0; i < effort.size(); ++i) power.push_back(-effort[i] * speed[i] + 0.0);
    return add("power", std::move(power));
  }
  Columns& add_force() {
    const std::vector<double>&x = of("fx"), &y = of("fy"), &z = of("fz");
    std::vector<double> sizes;
    for (std::size_t i = 0; i < x.size(); ++i)
      sizes.push_back(Eigen::Vector3d(x[i], y[i], z[i]).norm());
    return add("force", std::move(sizes));
  }

  std::size_t count() const { return count_; }
  Json json() const { return json_; }

 private:
  const TableRows& table_;
  const TableTrack& track_;
  const Thinning* thinning_;
  std::size_t count_ = 0;
  Json json_ = Json::object();
};

/// Receives the entries of page_rig.
class Entries {
 public:
  Entries(const LoggedRun& run, const Thinning* thinning) : run_(run), thinning_(thinning) {}

  const engine::SimulationSpec& spec() const { return run_.built.spec; }

  Columns columns(const TableRows& table, const std::string& name) const {
    return {table, name, thinning_};
  }
  void add(const char* list, Json entry, const Columns& columns) {
    count_ += columns.count();
    entry["columns"] = columns.json();
    json_[list].push_back(std::move(entry));
  }

  std::size_t count() const { return count_; }
  Json json() const { return json_; }

 private:
  const LoggedRun& run_;
  const Thinning* thinning_;
  std::size_t count_ = 0;
  Json json_ = {{"lines", Json::array()},
                {"joints", Json::array()},
                {"propellers", Json::array()},
                {"foils", Json::array()},
                {"controls", Json::array()}};
};

Json bodies_of(const std::vector<engine::BodyId>& ids) {
  Json bodies = Json::array();
  for (const engine::BodyId id : ids)
    if (id != engine::kWorld) bodies.push_back(id);
  return bodies;
}

Json time_broken(const TableRows& table, const std::string& name) {
  const TableTrack& track = table.tracks.at(name);
  const std::vector<double>& broken = track.columns[table.layout.column("broken")];
  const auto first = std::ranges::find_if(broken, [](double b) { return b != 0; });
  if (first == broken.end()) return nullptr;
  return track.times[static_cast<std::size_t>(first - broken.begin())];
}

void add_lines(const TableRows& table, Entries& entries) {
  for (const engine::LineSpec& line : entries.spec().lines) {
    const std::string name = log_name(line);
    Columns columns = entries.columns(table, name);
    columns.add("tension", "tension").add("distance", "distance").add("length", "length");
    if (line.kind == engine::LineSpec::Kind::mooring) columns.add("resting", "resting");
    entries.add("lines",
                {{"name", name},
                 {"bodies", bodies_of({line.first.body, line.second.body})},
                 {"broken_at", time_broken(table, name)}},
                columns);
  }
}

void add_joints(const TableRows& table, Entries& entries) {
  using Type = engine::JointSpec::Type;
  constexpr std::array kTypes = {"ball", "hinge", "slider", "fixed", "universal"};
  for (const engine::JointSpec& joint : entries.spec().joints) {
    Columns columns = entries.columns(table, joint.name);
    columns.add_force();
    const bool turns = joint.type == Type::hinge;
    if (turns || joint.type == Type::slider)
      columns.add_degrees("coordinate", "coordinate", turns)
          .add_degrees("speed", "speed", turns)
          .add("effort", "effort")
          .add_absorbed_power();
    entries.add("joints",
                {{"name", joint.name},
                 {"type", kTypes.at(static_cast<std::size_t>(joint.type))},
                 {"bodies", bodies_of({joint.first, joint.second})}},
                columns);
  }
}

void add_machines(const TableRows& table, Entries& entries) {
  for (const engine::PropellerSpec& propeller : entries.spec().propellers) {
    const std::string name = log_name(propeller);
    Columns columns = entries.columns(table, name);
    columns.add("setting", "setting").add("angle", "angle_deg");
    for (const char* column : {"thrust", "torque", "advance", "wetted"})
      columns.add(column, column);
    entries.add("propellers", {{"name", name}, {"bodies", bodies_of({propeller.body})}}, columns);
  }
  for (const engine::FoilSpec& foil : entries.spec().foils) {
    const std::string name = log_name(foil);
    Columns columns = entries.columns(table, name);
    columns.add("angle", "angle_deg").add("attack", "attack_deg").add("flow", "flow").add_force();
    const bool water = foil.fluid == engine::FoilSpec::Fluid::water;
    entries.add(
        "foils",
        {{"name", name}, {"bodies", bodies_of({foil.body})}, {"fluid", water ? "water" : "air"}},
        columns);
  }
}

void add_controls(const TableRows& table, Entries& entries) {
  for (const std::string& name : table.names) {
    Columns columns = entries.columns(table, name);
    columns.add("value", "value");
    entries.add("controls", {{"name", name}}, columns);
  }
}

Entries entries_of(const LoggedRun& run, const Thinning* thinning) {
  Entries entries(run, thinning);
  for (const TableRows& table : run.tables) {
    const std::string& file = table.layout.file;
    if (file == lines_layout().file) add_lines(table, entries);
    if (file == joints_layout().file) add_joints(table, entries);
    if (file == machines_layout().file) add_machines(table, entries);
    if (file == controls_layout().file) add_controls(table, entries);
  }
  return entries;
}

}  // namespace

std::size_t rig_columns(const LoggedRun& run) { return entries_of(run, nullptr).count(); }

Json page_rig(const LoggedRun& run, const Thinning& thinning) {
  return entries_of(run, &thinning).json();
}

}  // namespace app

#pragma once

#include <string>
#include <vector>

#include "app/logs/table_layouts.h"
#include "engine/base/rig_readings.h"
#include "engine/base/spec.h"

/// @file
/// The tables of lines, joints, machines and controls (table_log.h), in the units of their columns:
/// angles in degrees where a column ends in `_deg`, otherwise SI. Forces and moments are in W.
///
/// - `lines.csv`: the springs, ropes and moorings. `x1` … `z2` are the places of the ends, `fx` …
///   `fz` is the force on the first body; `taut` and `broken` are 1 or 0; `resting` is the length
///   on the bottom, which only moorings have.
/// - `line_nodes.csv`: the places of the nodes of the lines with inertia, of each line from its
///   first end to its second. A broken line has no places.
/// - `joints.csv`: `fx` … `tz` is the load on the second body, about the anchor; `coordinate`,
///   `speed` and `effort` are those of hinges and sliders.
/// - `machines.csv`: propellers, and the foils in the water (rudders) and in the air (sails). A
///   propeller has its turns per second as `setting`, its azimuth as `angle_deg`, `thrust`,
///   `torque`, `advance` and `wetted`; a foil has `angle_deg`, `attack_deg` and `flow`. `fx` … `fz`
///   is the force on the body.
/// - `controls.csv`: the `value` of each set point that a control drives, in the unit of its name.

namespace app {

/// Names in logs: `springs[NAME]`, `ropes[NAME]`, `moorings[NAME]`.
std::string log_name(const engine::LineSpec& line);
/// Number of nodes of a line: one more than its segments with inertia, else 0.
std::size_t node_count(const engine::LineSpec& line);
/// `moorings[NAME].NODE`, the node counted from 0.
std::string node_name(const engine::LineSpec& line, std::size_t node);
/// True if any line has nodes.
bool has_nodes(const engine::SimulationSpec& spec);
/// `propellers[NAME]`
std::string log_name(const engine::PropellerSpec& propeller);
/// `rudders[NAME]` in the water, `sails[NAME]` in the air.
std::string log_name(const engine::FoilSpec& foil);

/// True for a hinge or slider: it has a coordinate.
bool has_coordinate(const engine::JointSpec& joint);

/// The tables of a simulation.
class RigLog {
 public:
  /// @param spec     It must outlive this.
  /// @param joints   Joints are logged.
  RigLog(const engine::SimulationSpec& spec, bool joints);

  bool empty() const;  ///< There are no tables.

  /// The tables that have rows; none of what the simulation does not have.
  std::vector<LogTable> tables() const;

  /// The numbers of those tables at a time.
  /// @param states   States of the bodies at the time of the readings.
  std::vector<std::vector<double>> numbers(const engine::RigReadings& readings,
                                           const std::vector<hydro::BodyState>& states) const;

 private:
  const engine::SimulationSpec& spec_;
  bool joints_;
};

}  // namespace app

#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/logs/table_log.h"
#include "hydro/spatial.h"

/// @file
/// The quantities that a comparison judges: those of the trajectory, as `position`, and those of
/// each table of the run, as `forces.buoyancy` or `lines.tension`.

namespace app {

/// A quantity of the motion.
struct ComparedQuantity {
  const char* name;
  const char* unit;
  bool from_start;  ///< Its size counts from the first row, and not from zero.
  double (*difference)(const hydro::BodyState&, const hydro::BodyState&);
};
/// position, orientation_deg, linear_velocity, angular_velocity.
extern const std::array<ComparedQuantity, 4> kComparedQuantities;

/// A table of a run. Each of its series is a quantity: the length of the vector of its columns.
struct ComparedTable {
  std::string name;    ///< `forces`
  TableLayout layout;  ///< Forces and torques are series of their own.
};
/// forces, interior, probes, lines, line_nodes, joints, machines, controls.
const std::vector<ComparedTable>& compared_tables();

/// Returns the name of a quantity of a table: `forces.buoyancy`.
std::string quantity_name(const ComparedTable& table, const TableSeries& series);

/// Returns what is wrong with a name that should be a quantity or a whole table, and the nearest
/// one; empty if it is one.
std::string fault_of_quantity(const std::string& name);

}  // namespace app

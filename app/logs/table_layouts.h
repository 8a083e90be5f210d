#pragma once

#include <vector>

#include "app/logs/table_log.h"

/// @file
/// The layouts of the tables of a run. rig_log.h and probes.h say what their columns mean.

namespace app {

TableLayout probes_layout();
TableLayout lines_layout();
TableLayout line_nodes_layout();
TableLayout joints_layout();
TableLayout machines_layout();
TableLayout controls_layout();

/// The layouts of all tables that plimsoll writes.
std::vector<TableLayout> all_table_layouts();

}  // namespace app

#include "app/logs/table_layouts.h"

namespace app {

TableLayout probes_layout() {
  return {"probes.csv",
          "a log of probes",
          "probe",
          {{"elevation", "m", {"elevation"}},
           {"position", "m", {"x", "y", "z"}},
           {"velocity", "m/s", {"vx", "vy", "vz"}},
           {"acceleration", "m/s^2", {"ax", "ay", "az"}}}};
}

TableLayout lines_layout() {
  return {"lines.csv",
          "a log of lines",
          "line",
          {{"tension", "N", {"tension"}},
           {"distance", "m", {"distance"}},
           {"length", "m", {"length"}},
           {"taut", "1", {"taut"}},
           {"broken", "1", {"broken"}},
           {"first_end", "m", {"x1", "y1", "z1"}},
           {"second_end", "m", {"x2", "y2", "z2"}},
           {"force", "N", {"fx", "fy", "fz"}},
           {"resting", "m", {"resting"}}}};
}

TableLayout line_nodes_layout() {
  return {
      "line_nodes.csv", "a log of nodes of lines", "line_node", {{"place", "m", {"x", "y", "z"}}}};
}

TableLayout joints_layout() {
  return {"joints.csv",
          "a log of joints",
          "joint",
          {{"coordinate", "rad or m", {"coordinate"}},
           {"speed", "rad/s or m/s", {"speed"}},
           {"force", "N", {"fx", "fy", "fz"}},
           {"torque", "N m", {"tx", "ty", "tz"}},
           {"effort", "N m or N", {"effort"}}}};
}

TableLayout machines_layout() {
  return {"machines.csv",
          "a log of machines",
          "machine",
          {{"setting", "1/s", {"setting"}},
           {"angle_deg", "deg", {"angle_deg"}},
           {"thrust", "N", {"thrust"}},
           {"torque", "N m", {"torque"}},
           {"advance", "1", {"advance"}},
           {"wetted", "1", {"wetted"}},
           {"attack_deg", "deg", {"attack_deg"}},
           {"flow", "m/s", {"flow"}},
           {"force", "N", {"fx", "fy", "fz"}}}};
}

TableLayout controls_layout() {
  return {"controls.csv",
          "a log of controls",
          "set_point",
          {{"value", "that of the set point", {"value"}}}};
}

std::vector<TableLayout> all_table_layouts() {
  return {probes_layout(), lines_layout(),    line_nodes_layout(),
          joints_layout(), machines_layout(), controls_layout()};
}

}  // namespace app

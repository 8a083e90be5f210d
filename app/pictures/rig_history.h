#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/logs/table_log.h"
#include "app/pictures/drawn_rig.h"
#include "engine/base/spec.h"

namespace app {

/// Lines and machines over the time of a logged run. Quantities that were not logged have their
/// values at rest.
class RigHistory {
 public:
  /// Reads the logs of lines and machines of a run.
  /// @param spec   It must outlive the object.
  /// @throws InputError with the line or row at fault.
  RigHistory(const engine::SimulationSpec& spec, const std::filesystem::path& trajectory);

  /// Returns the rig as it was logged last at or before a time.
  DrawnRig at(double time, const std::vector<hydro::BodyState>& states) const;

 private:
  /// Returns the places of a line's nodes [m, W]; none if they were not logged, as those of a
  /// broken line.
  std::vector<Eigen::Vector3d> nodes_at(const engine::LineSpec& line, double time) const;

  const engine::SimulationSpec& spec_;
  std::optional<TableRows> lines_, nodes_, machines_;
  /// Per propeller the angle that its shaft has turned through until each row [rad]: the integral
  /// of its speed by the trapezoidal rule.
  std::vector<std::vector<double>> turns_;
};

}  // namespace app

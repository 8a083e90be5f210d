#pragma once

#include <string>
#include <vector>

#include "app/logs/probes.h"
#include "app/scene/probe.h"
#include "engine/simulation.h"

namespace app {

/// The probes of a scene, and the centres of mass of its bodies in the frames of their meshes [m].
struct SensorSpec {
  std::vector<scene::Probe> probes = {};
  std::vector<Eigen::Vector3d> centers_of_mass = {};
};

/// The probes of a simulation as instruments: a point of a body reads as a unit on board does, in
/// the body's axes.
///
/// | columns | meaning |
/// | --- | --- |
/// | elevation | water's surface above the still water [m]; NaN without water |
/// | x, y, z | place in W [m] |
/// | vx, vy, vz | velocity [m/s]: of the water in W, of a body's point in body axes |
/// | ax, ay, az | its acceleration in the same axes [m/s^2] |
/// | wx, wy, wz | angular velocity in body axes, as a gyroscope [rad/s] |
/// | specific_x, _y, _z | specific force a − g in body axes, as an accelerometer [m/s^2] |
///
/// A gauge at the surface has the first two, one with a depth the first four, in the air NaN; a
/// point of a body has all.
///
/// An acceleration is the change of velocity in the last step over the step (app/logs/probes.h).
/// Before the first step and after a motion is set it is zero.
class Sensors {
 public:
  /// @param spec   It must outlive this.
  Sensors(const SensorSpec& sensors, const engine::SimulationSpec& spec);

  std::size_t size() const { return probes_.size(); }
  const std::string& name(std::size_t probe) const { return probes_[probe].name; }
  /// Returns the names of what a probe reads, in order.
  std::vector<std::string> columns(std::size_t probe) const;
  /// Returns the numbers of all probes, those of each in the order of its columns.
  std::vector<std::vector<double>> read(const engine::Simulation& simulation) const;

  void before_step(const std::vector<hydro::BodyState>& states) { readings_.before_step(states); }
  /// Forgets the last step.
  void restart() { readings_.set_velocities_before({}); }
  Probes& readings() { return readings_; }
  const Probes& readings() const { return readings_; }

 private:
  std::vector<double> read_on_board(const ProbeReading& reading, std::size_t probe,
                                    const engine::Simulation& simulation) const;

  std::vector<scene::Probe> probes_;
  std::vector<std::size_t> bodies_;  ///< Index of the body of each probe; of a gauge 0.
  Probes readings_;
};

}  // namespace app

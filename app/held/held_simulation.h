#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "app/held/motions.h"
#include "app/held/sensors.h"
#include "engine/simulation.h"

namespace app {

/// A load that acts on a body until it is changed.
struct HeldLoad {
  hydro::Wrench wrench;  ///< Force [N] at the point, and torque [N m] beside it.
  engine::Frame frame = engine::Frame::world;
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();  ///< Where the force acts, in B [m].
};

/// A simulation under loads that its user holds, with sensors, and whose motion is kept in arrays.
class HeldSimulation {
 public:
  /// @param rows   They must outlive this. The first show() writes them.
  /// @throws as engine::Simulation does
  HeldSimulation(engine::SimulationSpec spec, const MotionRows& rows,
                 const SensorSpec& sensors = {});
  HeldSimulation(const HeldSimulation&) = delete;  // The sensors refer to the engine.

  const engine::Simulation& engine() const { return engine_; }
  const std::optional<Sensors>& sensors() const { return sensors_; }  ///< None without probes.

  /// Replaces the load on a body. @throws std::invalid_argument unless it is finite.
  void hold(engine::BodyId body, const HeldLoad& load);
  /// Ends the load on a body.
  void let_go(engine::BodyId body) { loads_.erase(body); }
  const std::map<engine::BodyId, HeldLoad>& loads() const { return loads_; }

  void set(engine::SetPointId set_point, double value) { engine_.set(set_point, value); }
  void release(engine::SetPointId set_point) { engine_.release(set_point); }
  void set_motion(engine::BodyId body, const hydro::BodyState& state);

  /// One step. It leaves the rows as they are; show() writes them. @throws engine::SimulationError
  void step();
  void show() const { write(engine_.time(), engine_.states(), rows_); }

  /// Everything that changes, held loads included, as bytes: a simulation of the same
  /// specification that loads them goes on to the same bits.
  std::string save() const;
  /// @throws std::invalid_argument if they are not the bytes of such a simulation
  void load(std::string_view bytes);
  /// The held loads in such bytes. @throws as load() for what it reads
  std::map<engine::BodyId, HeldLoad> loads_in(std::string_view bytes) const;
  /// Back to time 0, without held loads.
  void reset();

 private:
  /// Takes the loads from the head of the bytes.
  std::map<engine::BodyId, HeldLoad> take_loads(std::string_view& bytes) const;

  engine::Simulation engine_;
  std::optional<Sensors> sensors_;
  MotionRows rows_;
  std::map<engine::BodyId, HeldLoad> loads_;
};

}  // namespace app

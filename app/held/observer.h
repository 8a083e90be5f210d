#pragma once

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "app/held/held_simulation.h"
#include "app/scene/scene.h"

namespace app {

/// The numbers that can be read of a simulation by name, in the units of the names:
///
/// - quantities that controls measure: `tug.heading_deg`, `joints[hinge].angle_deg`,
///   `ropes[tow].tension` (scene::measurable);
/// - attitude and velocities of bodies, as in trajectory.csv: `tug.qw` … `tug.qz`, `tug.vx` …
///   `tug.vz`, `tug.wx` … `tug.wz`;
/// - columns of the tables of lines, joints and machines: `propellers[main].thrust`, and the set
///   points of controls by their own names (app/logs/rig_log.h);
/// - readings of probes: `probes[imu].specific_z` (sensors.h).
///
/// A number that a line, joint or machine does not have is no observable. Of a name that a reading
/// and a set point share, as `ropes[tow].length`, it is the reading.
class Observables {
 public:
  Observables(const scene::Scene& scene, const HeldSimulation& simulation);

  std::vector<std::string> names() const;
  /// Units of the names, in their order (units.h).
  std::vector<std::string> units() const;

 private:
  friend class Observer;
  struct OfBody {
    engine::Measurement of;
    double unit;  ///< SI units per unit of the name.
  };
  /// A number of a body's row of trajectory.csv.
  struct OfMotion {
    std::size_t body, column;
  };
  struct OfTable {
    std::size_t table, number;
    double unit;
  };
  struct OfProbe {
    std::size_t probe, column;
  };
  struct Observable {
    std::string name;
    std::variant<OfBody, OfMotion, OfTable, OfProbe> source;
    std::string units;
  };

  void add_bodies(const scene::Scene& scene);
  void add_motions(const engine::Simulation& engine);
  void add_tables(const scene::Scene& scene, const engine::Simulation& engine);
  void add_joints(const scene::Scene& scene);
  void add_probes(const HeldSimulation& simulation);
  const Observable* find(const std::string& name) const;

  std::vector<Observable> all_;
};

/// A name that there is not.
class UnknownName : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads some of the observables of a simulation.
class Observer {
 public:
  Observer() = default;
  /// @throws UnknownName, which tells the nearest name
  Observer(const Observables& observables, const std::vector<std::string>& names);

  std::size_t size() const { return sources_.size(); }
  /// Writes size() numbers. @param simulation   One that has the same observables.
  void read(const HeldSimulation& simulation, double* numbers) const;

 private:
  std::vector<std::variant<Observables::OfBody, Observables::OfMotion, Observables::OfTable,
                           Observables::OfProbe>>
      sources_;
  bool reads_tables_ = false, reads_probes_ = false;
};

}  // namespace app

#pragma once

#include <vector>

#include "engine/base/rig_spec.h"
#include "engine/rig/moordyn/moordyn_system.h"
#include "hydro/loads/loads.h"

/// @file
/// Lines of MoorDyn on the bodies of a simulation, weakly coupled: in each step the bodies move
/// under the forces that are expected of the lines, and then the lines follow the bodies.
///
/// With F_n the force on a point at the end t_n of the last step of length h, and F_{n−1} that
/// before it, the force in the step from t_n on is
///
///     F(t) = F_n + (t − t_n)/h (F_n − F_{n−1}),                                            (E34)
///
/// which acts where the point is by then. MoorDyn then moves the points on cubics in time from
/// where they were to where they are. This is of second order.
///
/// Where h² K + 2 h C exceeds kHeavyLine of the mass that a body has along the force the update of
/// the substep h is, along that direction,
///
///     (S + ¼h² K + ½h C) Δu = h (F(t) − K (x − x(t)) − C (v − v(t))),                      (E35)
///
/// x the place of the point halfway and v its velocity before the update, x(t) and v(t) those that
/// are expected as F(t) is, by (E34). K = Σ EA/l, l the length of a segment, and C = Σ 2 √(EA m'),
/// m' the mass per length, are at least what lines do against a sudden motion (EndHold), so that
/// light bodies are not thrown about. This is of second order, too.

namespace engine {

struct SimulationSpec;
struct SubstepBody;

/// The changing side of lines of MoorDyn: a part of the state of a simulation.
struct MoorDynState {
  std::vector<Eigen::Vector3d> forces;             ///< F_n of each coupled point, in W [N].
  std::vector<Eigen::Vector3d> before;             ///< F_{n−1} [N].
  std::vector<Eigen::Vector3d> places_before;      ///< Places of the points, x_{n−1} in W [m].
  std::vector<Eigen::Vector3d> velocities_before;  ///< v_{n−1} [m/s].
  std::vector<std::uint64_t> system;               ///< MoorDyn's own state.
};

class MoorDynCoupling {
 public:
  /// Starts with the lines at rest. @param spec   It must outlive this and have `moordyn`.
  /// @throws MoorDynFault
  explicit MoorDynCoupling(const SimulationSpec& spec);

  /// True if a coupled point is on the body.
  bool acts_on(BodyId body) const;

  /// Adds (E34) to the load on a body in a state at a time [s]: the moment about its centre of
  /// mass, in W.
  void add_load(BodyId body, const hydro::BodyState& state, double time, hydro::Wrench& load) const;

  /// Adds (E34), or (E35), to the load and the inertia of a body halfway in a substep of length h
  /// [s].
  void add_update(double time, double h, SubstepBody& body) const;

  /// Notes how the points move at the start of a step [s].
  void begin_step(const std::vector<hydro::BodyState>& states, double time, double h);
  /// Takes the lines through the step. @param states   At its end. @throws MoorDynFault
  void follow(const std::vector<hydro::BodyState>& states);

  /// The lines in the order of the specification.
  std::vector<LineReading> readings() const { return system_.readings(); }

  MoorDynState state() const;
  bool fits(const MoorDynState& state) const;
  void restore(const MoorDynState& state, double time, double h);

 private:
  /// Direction of F_n; 0 without a force.
  Eigen::Vector3d direction(std::size_t point) const;
  std::vector<PointMotion> motions(const std::vector<hydro::BodyState>& states) const;

  const SimulationSpec* simulation_;
  const MoorDynSpec* spec_;
  MoorDynSystem system_;
  std::vector<EndHold> holds_;                    ///< One entry per point.
  std::vector<Eigen::Vector3d> forces_, before_;  ///< F_n, F_{n−1}.
  std::vector<PointMotion> motions_before_;       ///< At the start of the step before.
  std::vector<PointMotion> motions_;              ///< At the start of the step.
  double step_start_ = 0;                         ///< t_n [s]
  double step_ = 1;                               ///< h [s]
};

}  // namespace engine

#pragma once

#include <vector>

#include "engine/moordyn_system.h"
#include "engine/rig_spec.h"
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
/// which acts where the point is by then. MoorDyn then moves the points straight from where they
/// were to where they are. Where the forces depend on the places of the points this is of second
/// order; damping by the lines acts half a step late. It is stable while h² k/m is small against 1,
/// with k the stiffness of the lines and m what they move.

namespace engine {

struct SimulationSpec;

/// The changing side of lines of MoorDyn: a part of the state of a simulation.
struct MoorDynState {
  std::vector<Eigen::Vector3d> forces;  ///< F_n of each coupled point, in W [N].
  std::vector<Eigen::Vector3d> before;  ///< F_{n−1} [N].
  std::vector<std::uint64_t> system;    ///< That of MoorDyn.
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

  /// Notes where the points are at the start of a step [s].
  void begin_step(const std::vector<hydro::BodyState>& states, double time, double h);
  /// Takes the lines through the step. @param states   At its end. @throws MoorDynFault
  void follow(const std::vector<hydro::BodyState>& states);

  /// The lines in the order of the specification.
  std::vector<LineReading> readings() const { return system_.readings(); }

  MoorDynState state() const;
  bool fits(const MoorDynState& state) const;
  void restore(const MoorDynState& state, double time, double h);

 private:
  std::vector<Eigen::Vector3d> places(const std::vector<hydro::BodyState>& states) const;

  const MoorDynSpec* spec_;
  MoorDynSystem system_;
  std::vector<Eigen::Vector3d> forces_, before_;  ///< F_n, F_{n−1}.
  std::vector<Eigen::Vector3d> places_;           ///< At the start of the step, in W [m].
  double step_start_ = 0;                         ///< t_n [s]
  double step_ = 1;                               ///< h [s]
};

}  // namespace engine

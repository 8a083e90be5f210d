#pragma once

#include <memory>
#include <vector>

#include "engine/base/rig_readings.h"
#include "engine/constraints/joint_reaction.h"
#include "engine/contacts/broad_phase.h"
#include "engine/machines/machines.h"
#include "engine/machines/set_points.h"
#include "engine/rig/dynamic_lines.h"
#include "engine/rig/joint_drive.h"
#include "engine/rig/line_pull.h"

/// @file
/// The rig: lines, drives of joints, machines and set points, and how they act on bodies.
///
/// A line or drive acts in one of three ways, the same in every substep of a run but for the
/// second:
///
/// 1. As a load of the pose halfway and of the velocities expected there. Both ends have the same
///    force, found once.
/// 2. Where springs and moorings from one body to what cannot move are stiff, implicitly: with F of
///    the pose halfway and of the velocity u before the update, u_r that at which the rest moves,
///
///        (S + a h² K + w h C) Δu = h (F − (a − b) h K (u − u_r)),                          (E24)
///
///    K and C their stiffness and damping, a, b and w those of (E22): the implicit midpoint rule
///    where the step resolves the oscillation.
/// 3. As a row of the constraint solver (force_row.h): ropes and springs between moving bodies that
///    are stiff, and all of a drive that holds or stops.
///
/// A taut row also holds its ends sideways. Where that is stiff, as for a light body between heavy
/// ones, the body has more inertia in this substep,
///
///     h² a T/l  and, about its centre of mass,  h² a T (r²/l + max(0, n·r)),                (E25)
///
/// T the larger of the tensions in the last step and in the last solution, n the direction of its
/// pull at r, and a that of (E22). It is the same in all directions, so that S keeps the form that
/// the solver knows.
///
/// Lines with inertia are loads of their own (dynamic_lines.h).
///
/// Stiff means that the sum of h² k + 2 h c over all that acts so on a body exceeds kStiffLine of
/// the mass that they move, in the most mobile direction.

namespace engine {

struct Island;
struct MovingBody;
struct SubstepBody;

/// The changing side of a line: a part of the state of a simulation.
struct LineState {
  double length = 0;  ///< L at the end of the last step [m].
  bool broken = false;
  double impulse = 0;  ///< Impulse of its row in the last step, or so far in this one [N s].
  double tension = 0;  ///< Mean tension of its row over the step before that [N].
  Eigen::Vector2d pull = Eigen::Vector2d::Zero();  ///< (H, V) of a mooring, found last [N].
};

/// The changing side of a joint.
struct JointState {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< Impulse on the second body, W [N s].
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< The same about the anchor [N m s].
  double effort = 0;                                 ///< Impulse along q [N m s, N s].
  double motor = 0;                                  ///< Impulse of the motor, if it is a row.
};

struct RigState {
  std::vector<LineState> lines;
  std::vector<JointState> joints;
  std::vector<double> turns;  ///< Turns of the propellers' shafts since the start [rad].
  std::vector<SetPointState> set_points;
  std::vector<hydro::LumpedState> dynamic_lines;
};

class Rig {
 public:
  /// @param spec   It must outlive this. @throws std::invalid_argument for what makes no sense
  explicit Rig(const SimulationSpec& spec);

  bool empty() const;
  /// True if lines with inertia follow the bodies.
  bool has_dynamic_lines() const { return !dynamic_->empty(); }

  // Properties that stepping needs in advance.

  /// Pairs of movable bodies that lines connect, and of a body and what cannot move that a row
  /// connects. Ascending.
  const std::vector<Pair>& couplings() const { return couplings_; }
  /// True if lines or drives act on the body.
  bool acts_on(BodyId body) const { return acts_on_[body]; }
  /// True if a line with inertia acts on the body.
  bool has_dynamic_line(BodyId body) const { return dynamic_->acts_on(body); }
  /// True if a row acts on the body, so that the constraint solver moves it.
  bool constrains(BodyId body) const { return constrains_[body]; }

  // During a substep.

  /// Sets the loads and the implicit terms of lines and drives of an island whose bodies are
  /// halfway. @param all   Bodies of the simulation, by id. @param time   Halfway [s].
  void find_loads(const std::vector<MovingBody>& all, Island& island, double time, double h);
  /// Sets the rows of the island, whose midpoints are made, and the inertia of the midpoints by
  /// (E24) and (E25); rows that the island has already tell the tensions of the last solution.
  void find_rows(const std::vector<MovingBody>& all, Island& island, double time, double h);
  /// False if the tensions that were found are so much larger than those of (E25) that rows are to
  /// be set and solved again.
  static bool bounds_tensions(const Island& island);
  /// Sets the places of the joints whose reactions the solver has found.
  void find_reactions(const std::vector<MovingBody>& all, Island& island) const;
  /// Impulses that the solver has found in accepted substeps of a group.
  struct Record {
    std::vector<ForceRow> rows;
    std::vector<JointReaction> reactions;
  };
  /// Adds that of an island in a substep.
  static void add(const Island& island, double h, Record& record);
  /// Adds that of a group in a part of a step. Several threads may do so for different groups.
  void accept(const Record& record);

  // Once a step.

  /// Gives set points their values, and starts the records of the step.
  void begin_step(const std::vector<hydro::BodyState>& states, double time, double h);
  /// Takes the lines with inertia through the step. @param states   At its end.
  void follow(const std::vector<hydro::BodyState>& states);
  /// Brings the lines with inertia on a body that has been put elsewhere to rest.
  void settle(BodyId body, const std::vector<hydro::BodyState>& states, double time) {
    dynamic_->settle(body, states, time, lengths());
  }
  /// @return the lines that have broken in the step
  std::vector<std::size_t> end_step(const std::vector<hydro::BodyState>& states, double time,
                                    double h);

  /// Loads of lines and drives that are no rows, per body: moments about the centre of mass, in W.
  std::vector<hydro::Wrench> loads_now(const std::vector<hydro::BodyState>& states,
                                       double time) const;
  RigReadings readings(const std::vector<hydro::BodyState>& states, double time, double h) const;

  SetPoints& set_points() { return *set_points_; }
  const SetPoints& set_points() const { return *set_points_; }
  const Machines& machines() const { return *machines_; }

  RigState state() const;
  bool fits(const RigState& state) const;
  void restore(const RigState& state, double time, double h);

 private:
  struct End;  ///< An end of a line in a substep.
  /// A line from a body to what cannot move.
  struct LineToWorld {
    Eigen::Vector3d r_W;        ///< Its end, from the centre of mass.
    Eigen::Vector3d force_W;    ///< On the body [N].
    Eigen::Vector3d parting_W;  ///< Velocity of the end less that of the rest [m/s].
    Eigen::Matrix3d stiffness, damping;
    double mobility;  ///< Inverse mass at the end, without water [1/kg].
  };
  struct LineHold {
    Eigen::Vector3d pull_W;  ///< Direction of the pull at the end.
    double distance;         ///< [m]
  };
  /// Lines, drives and machines that act on a body, each listed with the first body that can move.
  struct Parts {
    std::vector<std::size_t> lines;     ///< Loads between moving bodies.
    std::vector<std::size_t> to_world;  ///< Loads from what cannot move.
    std::vector<std::size_t> rows;      ///< Lines that are rows.
    std::vector<std::size_t> drives;    ///< Joints with a drive.
  };
  struct Drive {
    JointCoordinate coordinate;
    bool has_coordinate = false;
    bool stiff = false;  ///< Spring and damper are rows.
    bool rows = false;   ///< A part of it is.
  };

  bool movable(BodyId body) const;
  BodyId first_movable(BodyId first, BodyId second) const;
  double mobility(BodyId body, const Eigen::Vector3d& r_B) const;
  std::vector<double> stiffness_of_bodies() const;
  void sort_line(std::size_t line, const std::vector<double>& stiffness);
  void sort_joint(std::size_t joint, const std::vector<double>& stiffness);
  void couple(BodyId first, BodyId second, bool by_row);

  LineLength length_at(std::size_t line, double time) const;
  LinePull pull_now(std::size_t line, const std::vector<hydro::BodyState>& states,
                    double time) const;
  double tension_now(std::size_t line, const LinePull& pull, double h) const;
  DynamicLines::LengthAt lengths() const;
  JointBodies joint_bodies(std::size_t joint, const std::vector<hydro::BodyState>& states) const;
  double measure(const Measurement& of, const std::vector<hydro::BodyState>& states, double time,
                 double h) const;
  LineReading line_reading(std::size_t line, const std::vector<hydro::BodyState>& states,
                           double time, double h) const;
  JointReading joint_reading(std::size_t joint, const std::vector<hydro::BodyState>& states,
                             double time, double h) const;

  End end_of(const std::vector<MovingBody>& all, Island& island, const AttachmentPoint& point,
             double h, bool expected) const;
  LinePull pull_of_line(std::size_t line, const End& first, const End& second, double time);
  void add_line(const std::vector<MovingBody>& all, Island& island, std::size_t line, double time,
                double h);
  void add_lines_to_world(const std::vector<MovingBody>& all, Island& island, SubstepBody& body,
                          double time, double h);
  std::vector<LineToWorld> lines_to_world(const std::vector<MovingBody>& all, Island& island,
                                          const SubstepBody& body, double time, double h,
                                          bool expected);
  hydro::Wrench add_implicit(const std::vector<LineToWorld>& lines, SubstepBody& body,
                             double h) const;
  void add_line_row(const std::vector<MovingBody>& all, Island& island, std::size_t line,
                    double found, double time, double h);
  double sideways_phase(BodyId body, const Eigen::Vector3d& r, double T, double l, double lever,
                        double h) const;
  void add_lateral_inertia(const ForceRow& row, const End& end, const LineHold& hold,
                           double h) const;
  void add_drive_load(const std::vector<MovingBody>& all, Island& island, std::size_t joint,
                      double time);
  void add_drive_rows(const std::vector<MovingBody>& all, Island& island, std::size_t joint,
                      double time, double h);

  const SimulationSpec* spec_;
  const hydro::Sea* sea_ = nullptr;
  std::unique_ptr<SetPoints> set_points_;
  std::unique_ptr<Machines> machines_;
  std::unique_ptr<DynamicLines> dynamic_;
  std::vector<LineState> lines_;
  std::vector<JointState> joints_;
  std::vector<double> turns_;
  std::vector<Drive> drives_;          ///< Per joint.
  std::vector<bool> is_row_;           ///< Per line.
  std::vector<Parts> parts_;           ///< Per body.
  std::vector<double> least_inertia_;  ///< Per body: its smallest principal moment [kg m²].
  std::vector<bool> acts_on_, constrains_;
  std::vector<Pair> couplings_;
  double step_start_ = 0;  ///< [s]
};

}  // namespace engine

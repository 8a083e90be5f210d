#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/motion/added_inertia.h"
#include "engine/motion/hulls.h"
#include "engine/motion/motion.h"
#include "engine/motion/reduced_joint.h"

/// @file
/// The constant side of a body with its surroundings, and how it moves without loads. Its changing
/// side is in motion.h.

namespace engine {

/// Water and gravity.
struct Environment {
  double gravity = 0;               ///< [m/s^2]
  const hydro::Sea* sea = nullptr;  ///< Null: a dry scene.
  double level = 0;                 ///< Height of the water at rest; 0 without water [m].
  double highest = 0;               ///< Height that the water surface never exceeds [m].
  double lowest = 0;                ///< Height that the water surface never falls below [m].

  bool uneven() const { return highest > lowest; }  ///< The surface is not flat at all times.
};

Environment make_environment(const SimulationSpec& spec);

/// A rigid body. B is its frame: origin in the centre of mass, axes of the mesh.
struct Body {
  const BodySpec* spec = nullptr;
  Environment environment;
  std::shared_ptr<const hydro::Hull> hull;  ///< Null if not wet; bodies of one mesh share it.
  /// The sea as that hull feels it; shared as the hull.
  std::shared_ptr<const hydro::kernel::FeltSea> felt_sea;
  Eigen::AlignedBox3d box_B;                         ///< Bounds the mesh.
  std::shared_ptr<const hydro::HullLift> hull_lift;  ///< Null: it has none; shared as the hull.
  std::shared_ptr<const WakeParts> wake;  ///< Null: its drag is steady; shared as the hull.
  double radius = 0;        ///< Distance of the farthest vertex from the centre of mass [m].
  double displacement = 0;  ///< Mass of the water that the whole body displaces [kg].
  Matrix6d rigid_B = Matrix6d::Identity();  ///< M about the centre of mass.
  Eigen::Matrix3d inverse_inertia_B = Eigen::Matrix3d::Identity();
  bool wet = false;             ///< The water has loads on it that somebody needs.
  bool feels_air = false;       ///< Wet, and the air has a load on its dry part.
  bool has_added_mass = false;  ///< A may not be zero.
  bool has_wave_load = false;   ///< Waves accelerate the water about it, or are scattered.
  bool hollow = false;          ///< It may have pockets.
  bool has_memory = false;      ///< Waves that it has made act on it.
  bool rolls_free = false;      ///< It turns without the water outside: a ball with radiation.
  bool has_flow = false;        ///< The water about it may not move with `current()`.
  bool movable = true;          ///< At least one degree of freedom is not locked.
  bool locked = false;          ///< At least one degree of freedom is locked.
  bool jointed = false;         ///< At least one joint holds it.
  bool rigged = false;          ///< Lines, drives or machines act on it.
  bool dynamic_line = false;    ///< A line with inertia acts on it.
  bool driven_by_rows = false;  ///< The constraint solver finds a part of what they do.
  std::optional<ReducedJoint> reduced_joint;

  /// All six locks or a fixed joint to what cannot move hold it where it is.
  bool held() const {
    return !movable || (reduced_joint && reduced_joint->type == JointSpec::Type::fixed);
  }
  /// Velocity of the water without its waves; in a current that changes with depth, of its surface.
  Eigen::Vector3d current() const {
    return environment.sea ? environment.sea->current : Eigen::Vector3d::Zero();
  }
};

/// All bodies of the specification, which must outlive them.
std::vector<Body> make_bodies(const SimulationSpec& spec);

/// The motion, without history, of a body that starts at a time [s] in a state that its locks
/// allow. A reduced joint projects its velocity.
Motion motion_at(const Body& body, const SimulationSpec& spec, const hydro::BodyState& state,
                 double time);

/// Heights that bound a body [m].
struct VerticalExtent {
  double lowest;  ///< z of the lowest point of its box.
  double height;
};
VerticalExtent vertical_extent(const Body& body, const hydro::BodyState& state);

/// True if the water surface may reach the body in this state.
bool may_be_wet(const Body& body, const hydro::BodyState& state);

/// The velocities that locks or the reduced joint leave to the body, in W.
Mobility mobility(const Body& body, const hydro::BodyState& state);

/// M + A in W. @param R_WB   Orientation of the motion's state.
Matrix6d inertia_W(const Body& body, const Motion& motion, const Eigen::Matrix3d& R_WB);
Matrix6d inertia_W(const Body& body, const Motion& motion);

/// Velocity of the water about the body: that of current and waves, in the mean over the body's box
/// and in the middle of its wet height, at a time [s] after `ahead` [s] more; that of `current()`
/// without `has_flow` or at a reduced joint that leaves it a motion.
Eigen::Vector3d flow_about(const Body& body, const hydro::BodyState& state, double time,
                           double ahead);

/// The water that the lift of the hull acts in: that of flow_about(), and the height of its surface
/// over the centre of mass.
hydro::HullWater water_about(const Body& body, const hydro::BodyState& state, double time);

/// Moves the wake on by a time [s] of the motion as it is; a dry body has none.
void advance_wake(const Body& body, double time, Motion& motion);
/// Moves the wake on from halfway of a substep of length h [s] to its end, or from where the body
/// has touched the water since the start.
void end_wake(const Body& body, const hydro::BodyState& start, double h, Motion& motion);

/// The part of the body's wake that is formed, f of hydro/loads/wake.h.
double formed_wake(const Body& body, const Motion& motion, const hydro::BodyState& state);

/// The state after `time` [s] of motion by inertia alone, (E1) to (E3): added mass, locks and the
/// reduced joint act, loads do not.
/// @param flow   Velocity of the water about the body.
hydro::BodyState state_after_drift(const Body& body, const Motion& motion,
                                   const Eigen::Vector3d& flow, double time);
/// Moves the body to that state, and records the work.
void drift(const Body& body, Motion& motion, double time);

/// The state moved by (Δx, Δθ) in W and projected on locks and reduced joint; its velocity stays.
hydro::BodyState displaced(const Body& body, hydro::BodyState state, const Vector6d& change);

/// Mass that resists contacts: the largest of M + A in any direction [kg].
double contact_mass(const Body& body, const Motion& motion);

/// Acceleration of that mass by weight and full buoyancy, in units of gravity, at most 1.
double contact_fall(const Body& body, const Motion& motion);

/// A of the body in a state, in B: that of the water outside, and the water in its pockets.
/// @param carried Null: it has none.
Matrix6d added_mass(const Body& body, const hydro::BodyState& state, const CarriedWater* carried,
                    double time);

/// A after a turn of the body, in its new axes: the same unless the water outside takes no part.
/// @param turn   Turn of the body in its axes, from the old orientation to the new one.
Matrix6d after_turn(const Body& body, const Matrix6d& added_B, const CarriedWater* carried,
                    const Eigen::Quaterniond& turn);

/// Sets A of the motion.
void set_added_mass(Motion& motion, const Matrix6d& added_B);

/// Agreement of the added mass that a substep was taken with and that of its final pose.
enum class AddedMassMatch {
  equal,    ///< The difference is without effect.
  near,     ///< One more update leaves no difference that matters to the energy.
  distant,  ///< More updates are needed.
};
/// Distance of two poses [m]: of the centres, and by the turn at the radius.
double pose_distance(const Body& body, const hydro::BodyState& a, const hydro::BodyState& b);
/// The part of it that changes what is wet in level water [m]: heave, and the tilt at the radius.
double dip_distance(const Body& body, const hydro::BodyState& a, const hydro::BodyState& b);

/// Largest change of added mass in units in which the inertia with A is one [-].
double scaled_change(const Body& body, const Matrix6d& added_B, const Matrix6d& change);

/// @param start_B   A at the start of the substep.
/// @param taken_B   A that the substep was taken with.
/// @param found_B   A of the pose that it led to.
AddedMassMatch compare_added_mass(const Body& body, const Matrix6d& start_B,
                                  const Matrix6d& taken_B, const Matrix6d& found_B);

/// The motion with the added mass `added_B` of its pose, where updates have not led to agreement,
/// as when a body first touches the water: the water that it gains shares its momentum (E4).
Motion share_momentum(const Body& body, const Motion& before, const Matrix6d& added_B);

}  // namespace engine

#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hydro/lines/catenary.h"
#include "hydro/machines/foil.h"
#include "hydro/machines/propeller.h"

/// @file
/// The constant description of lines, machines and controls: a part of SimulationSpec. SI units.

namespace engine {

/// Index of a body in `SimulationSpec::bodies`.
using BodyId = int;

/// Stands for the world where a body is expected.
inline constexpr BodyId kWorld = -1;

/// Index of a set point in `SimulationSpec::set_points`.
using SetPointId = int;

/// A point of a body, in B from its centre of mass, or of the world, in W [m].
struct AttachmentPoint {
  BodyId body = kWorld;                          ///< The body, or kWorld.
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< The point [m].
};

/// A value that controls and other programs may change during a run. Angles are in radians here,
/// whatever the unit of the scene's key is.
struct SetPointSpec {
  std::string name;    ///< Unique: `propellers[main].speed_rps`.
  double initial = 0;  ///< In SI units.
  double unit = 1;     ///< SI units per unit of the name: π/180 for `…_deg`.
  /// Least value; a lower one is raised to it.
  double least = -std::numeric_limits<double>::infinity();
  /// Greatest value; a higher one is lowered to it.
  double greatest = std::numeric_limits<double>::infinity();
};

/// The inertia of a line, and the water's loads on its motion (hydro/lines/lumped_line.h).
struct LineInertia {
  int segments = 20;      ///< At least 1.
  double mass = 0;        ///< Per length in air [kg/m], > 0.
  double drag_along = 0;  ///< C_t [-]
  double added_mass = 0;  ///< C_a [-]
  /// Height of the flat bottom that carries the line [m].
  double bottom = -std::numeric_limits<double>::infinity();
};

/// A line between two points.
struct LineSpec {
  /// The law of the tension T, with the distance l of the ends.
  enum class Kind {
    spring,  ///< It pulls and pushes: T = k (l − L) + c (l' − L').
    rope,    ///< The same, but it only pulls.
    mooring  ///< A catenary from a body to an anchor (hydro/lines/catenary.h).
  };
  std::string name;          ///< Unique among the lines of its kind.
  Kind kind = Kind::spring;  ///< Law of the tension.
  AttachmentPoint first;     ///< For a mooring: its fairlead.
  AttachmentPoint second;    ///< For a mooring: its anchor, in the world.
  double length = 0;         ///< L, unstretched, at the start [m].
  double stiffness = 0;      ///< k [N/m]; of a mooring E A [N].
  double damping = 0;        ///< c [N s/m]; not of a mooring.
  double breaks_at = std::numeric_limits<double>::infinity();  ///< Tension [N].
  /// A winch whose set point is L [m]; at most one of this and `set_rate`.
  std::optional<SetPointId> set_length;
  /// A winch whose set point is L' [m/s].
  std::optional<SetPointId> set_rate;
  double shortest = 0;  ///< Least L that a winch hauls in to [m].

  /// None: the line has its shape of rest at every instant. Its stiffness E A is then L k for a
  /// rope.
  std::optional<LineInertia> inertia;

  // The following are for a mooring, and for a rope with inertia.
  double weight = 0;            ///< In water, per length [N/m].
  double friction = 0;          ///< Coefficient of friction on the bottom [-].
  bool on_bottom = true;        ///< The anchor lies on a bottom that carries the line.
  double drag_diameter = 0;     ///< Diameter for the drag of the line [m]; 0: no drag.
  double drag_coefficient = 0;  ///< C_d [-].
};

/// Motor of a hinge or slider: the torque [N m] or force [N] on the first body relative to the
/// second one that drives the coordinate q of the joint [rad, m].
struct JointMotor {
  /// The quantity that the set point gives.
  enum class Mode {
    speed,     ///< q' is the set point, as far as the largest effort allows.
    position,  ///< q is; a spring and damper of critical damping pull towards it.
    effort     ///< The effort itself is.
  };
  Mode mode = Mode::speed;   ///< Quantity that the set point gives.
  SetPointId set_point = 0;  ///< [rad/s, m/s], [rad, m] or [N m, N], by mode.
  double largest_effort = std::numeric_limits<double>::infinity();  ///< Largest effort [N m, N].
  double rate = 5;  ///< For `position`: an error decays in the time 1/rate [1/s], > 0.
};

/// The drive along the coordinate q of a hinge [rad] or slider [m]. q is 0 at the start, and
/// grows as the second body moves along the axis, or turns about it, relative to the first one, or
/// to the world where that is the first.
struct JointDrive {
  std::optional<std::array<double, 2>> limits;  ///< Least and greatest q.
  std::optional<JointMotor> motor;              ///< None: there is no motor.
  double stiffness = 0;                         ///< [N m/rad, N/m]
  double rest = 0;                              ///< q at which the spring is at rest.
  double damping = 0;                           ///< [N m s/rad, N s/m]
  double friction = 0;                          ///< Coulomb's, of any speed [N m, N].

  /// True if any part of the drive exerts a load.
  bool acts() const { return limits || motor || stiffness > 0 || damping > 0 || friction > 0; }
};

/// A propeller or thruster.
struct PropellerSpec {
  std::string name;                                    ///< Unique among the propellers.
  BodyId body = 0;                                     ///< The body that carries it.
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();      ///< Centre of the disc [m].
  Eigen::Vector3d axis_B = Eigen::Vector3d::UnitX();   ///< Unit; thrust pushes along it.
  Eigen::Vector3d pivot_B = Eigen::Vector3d::UnitZ();  ///< Unit; the azimuth turns about it.
  hydro::Propeller screw;                              ///< Its curves and diameter.
  /// Inertia of screw and shaft about the axis, for the gyroscopic torque [kg m^2].
  double inertia = 0;
  bool right_handed = true;  ///< Seen from behind it turns clockwise when it drives ahead.
  SetPointId speed = 0;      ///< [1/s]
  SetPointId azimuth = 0;    ///< [rad]
};

/// A rudder, fin, keel or sail: a foil in the water or in the wind.
struct FoilSpec {
  /// The fluid in which it works.
  enum class Fluid { water, air };
  std::string name;                                ///< Unique among the foils.
  Fluid fluid = Fluid::water;                      ///< Fluid in which it works.
  BodyId body = 0;                                 ///< The body that carries it.
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();  ///< Where its force acts [m].
  /// Unit; a positive angle turns the chord about its opposite: clockwise as seen from its tip.
  Eigen::Vector3d span_B = Eigen::Vector3d::UnitZ();
  /// Unit; from the trailing to the leading edge.
  Eigen::Vector3d chord_B = Eigen::Vector3d::UnitX();
  hydro::Foil foil;                   ///< Its shape and coefficients.
  std::optional<std::size_t> behind;  ///< Index of the propeller in whose race it is.
  SetPointId angle = 0;               ///< [rad]
};

/// A quantity that a controller measures, in SI units.
struct Measurement {
  /// The quantity that is measured. Positions are in W, speeds over ground.
  enum class Quantity {
    x,
    y,
    z,      ///< Position of the centre of mass, in W.
    depth,  ///< Depth of the centre of mass below the still water.
    speed,  ///< Along the body's x axis, over ground.
    sway,   ///< Along its y axis.
    heading,
    pitch,
    roll,       ///< Angles of the body's axes; the heading is not wrapped.
    turn_rate,  ///< About the vertical.
    joint,      ///< q of a joint.
    joint_speed,
    tension,     ///< Tension of a line.
    line_length  ///< Distance of its ends.
  };
  Quantity quantity = Quantity::x;  ///< Quantity that is measured.
  std::size_t index = 0;            ///< Index of the body, joint or line.
};

/// A function of time: a table or a formula. It is called from one thread at a time.
class Signal {
 public:
  virtual ~Signal() = default;
  /// The value at a time.
  /// @param time   [s] @return in the unit of the set point's name
  virtual double at(double time) const = 0;
  /// True if the value jumps, so that a step takes the value of its start throughout.
  virtual bool jumps() const { return false; }
  /// Bytes that are equal for signals which have the same value at every time.
  virtual std::string identity() const = 0;
};

/// output = kp e + ki ∫e dt + kd de/dt, e = target − measured, in the units of the names; the
/// output is kept between limits, and the integral does not grow while it is.
struct Pid {
  Measurement of;                        ///< Quantity that is measured.
  double unit = 1;                       ///< SI units per unit of the measured name.
  std::shared_ptr<const Signal> target;  ///< The value that it is to have.
  double kp = 0, ki = 0, kd = 0;         ///< Gains of the error, its integral and its rate.
  double least = -std::numeric_limits<double>::infinity();    ///< Least output.
  double greatest = std::numeric_limits<double>::infinity();  ///< Greatest output.
};

/// A switch with hysteresis: `values[0]` until the measured quantity exceeds `high`, then
/// `values[1]` until it falls below `low`.
struct Relay {
  Measurement of;                     ///< Quantity that is measured.
  double unit = 1;                    ///< SI units per unit of the measured name.
  double low = 0, high = 0;           ///< Thresholds of the quantity.
  std::array<double, 2> values = {};  ///< Output before and after it has switched.
};

/// The source of a set point, read once a step from its start on.
struct ControlSpec {
  SetPointId set = 0;  ///< Set point that it drives.
  /// A table or formula, a controller, or a switch.
  std::variant<std::shared_ptr<const Signal>, Pid, Relay> source;
  double start = 0;  ///< Before it the set point keeps its value [s].
  double rate = std::numeric_limits<double>::infinity();  ///< Largest change [unit/s].
};

}  // namespace engine

#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hydro/machines/foil.h"
#include "hydro/machines/propeller.h"

/// @file
/// Springs, ropes, moorings, drives of joints, machines and controls of a scene. SI units; angles
/// are in radians but for what is said to be in the units of a name.

namespace scene {

/// Drag of the water on a line, and on its motion.
struct LineDrag {
  double diameter = 0;               ///< [m]; 0: it has none.
  double coefficient = 1.2;          ///< Across the line [-].
  std::optional<double> along;       ///< Along the line, of its surface [-].
  std::optional<double> added_mass;  ///< Across the line, over the displaced mass [-].
};

/// Inertia of a line.
struct LineInertia {
  int segments = 20;           ///< Straight parts into which it is divided.
  std::optional<double> mass;  ///< Per length in air [kg/m]; none: it follows from the weight.
};

/// A spring or rope between two points.
struct Tether {
  std::string name;                   ///< Unique among its kind.
  std::array<std::string, 2> bodies;  ///< Names; `world` stands for the world.
  /// In the mesh frame of each body, in W for the world [m].
  std::array<Eigen::Vector3d, 2> points = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::optional<double> length;  ///< Unstretched; none: the distance of the points at time 0 [m].
  double stiffness = 0;          ///< [N/m]
  double damping = 0;            ///< [N s/m]
  double breaks_at = std::numeric_limits<double>::infinity();  ///< Tension [N].
};

/// It pulls and pushes.
struct Spring : Tether {};

/// It only pulls.
struct Rope : Tether {
  double rate = 0;      ///< Speed at which its winch pays out [m/s].
  double shortest = 0;  ///< Least length that its winch hauls in to [m].
  double weight = 0;    ///< In water, per length [N/m].
  LineDrag drag;
  std::optional<LineInertia> inertia;  ///< None: it is straight, without weight.
};

/// A line from a body to an anchor: a catenary, or one with inertia.
struct Mooring {
  std::string name;                                    ///< Unique among the moorings.
  std::string body;                                    ///< Name of the body.
  Eigen::Vector3d fairlead = Eigen::Vector3d::Zero();  ///< In the mesh frame [m].
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();    ///< In W [m].
  double length = 0;                                   ///< Unstretched [m].
  double weight = 0;                                   ///< In water, per length [N/m].
  double stiffness = 0;                                ///< E A [N].
  double friction = 0;                                 ///< Coefficient of the bottom [-].
  bool on_bottom = true;  ///< The anchor lies on a bottom that carries the line.
  double breaks_at = std::numeric_limits<double>::infinity();  ///< Tension [N].
  LineDrag drag;
  std::optional<LineInertia> inertia;  ///< None: it is at rest at every instant.
};

/// Mooring lines of a file for MoorDyn.
struct MoorDyn {
  std::filesystem::path file;       ///< Input file of MoorDyn.
  std::vector<std::string> bodies;  ///< Body of each coupled point, or one for all.
};

/// Motor of a hinge or slider.
struct JointMotor {
  /// The quantity that the motor keeps to a set value.
  enum class Mode { speed, position, effort };
  Mode mode = Mode::speed;  ///< Quantity that it keeps.
  double value = 0;         ///< [rad/s, m/s], [rad, m] or [N m, N], by mode.
  double largest_effort = std::numeric_limits<double>::infinity();  ///< Largest effort [N m, N].
  double rate = 5;  ///< For `position`: an error decays in the time 1/rate [1/s].
};

/// Loads and stops along the coordinate of a hinge [rad] or slider [m], which is 0 at the start.
struct JointDrive {
  std::optional<std::array<double, 2>> limits;  ///< Least and largest coordinate.
  std::optional<JointMotor> motor;              ///< None: there is no motor.
  double stiffness = 0;                         ///< [N m/rad, N/m]
  double rest = 0;                              ///< Coordinate at which the spring is at rest.
  double damping = 0;                           ///< [N m s/rad, N s/m]
  double friction = 0;                          ///< [N m, N]
};

/// A propeller or thruster.
struct Propeller {
  std::string name;                                  ///< Unique among the propellers.
  std::string body;                                  ///< Name of the body.
  Eigen::Vector3d at = Eigen::Vector3d::Zero();      ///< In the mesh frame [m].
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();   ///< Unit, in the mesh frame.
  Eigen::Vector3d pivot = Eigen::Vector3d::UnitZ();  ///< Unit, in the mesh frame.
  hydro::Propeller screw;                            ///< The screw and its curves.
  double inertia = 0;                                ///< [kg m^2]
  bool right_handed = true;  ///< It turns clockwise, seen from behind, ahead.
  double speed = 0;          ///< [1/s]
  double azimuth = 0;        ///< [rad]
};

/// A rudder or sail.
struct Foil {
  std::string name;                                       ///< Unique among the foils of its kind.
  std::string body;                                       ///< Name of the body.
  Eigen::Vector3d at = Eigen::Vector3d::Zero();           ///< In the mesh frame [m].
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();        ///< Along the span; unit.
  Eigen::Vector3d chord_axis = Eigen::Vector3d::UnitX();  ///< Unit, normal to `axis`.
  hydro::Foil foil;                                       ///< Its shape and coefficients.
  double angle = 0;                                       ///< [rad]
};

/// A rudder, fin or keel: a foil in the water.
struct Rudder : Foil {
  std::optional<std::string> behind;  ///< Name of the propeller in whose race it is.
};

/// A foil in the wind.
struct Sail : Foil {};

/// The value between the rows of a table: on a line, or that of the row before.
enum class Interpolation { linear, step };

/// A column of a table over time.
struct CommandFile {
  std::filesystem::path file;  ///< The table, resolved against the scene's folder.
  std::string column;          ///< Empty: the first beside the time.
  Interpolation interpolation = Interpolation::linear;  ///< Value between the rows.
};

/// A controller. All its numbers are in the units of the names.
struct PidControl {
  std::string of;                               ///< `tug.heading_deg`
  std::string target;                           ///< A formula in the time.
  double kp = 0, ki = 0, kd = 0;                ///< Gains of the error, its integral and its rate.
  std::optional<std::array<double, 2>> limits;  ///< Least and largest output; none: no limits.
};

/// A switch with hysteresis, in the units of the names.
struct RelayControl {
  std::string of;                     ///< Quantity that is measured.
  double low = 0, high = 0;           ///< Thresholds of the quantity.
  std::array<double, 2> values = {};  ///< Output before and after it has switched.
};

/// Source of a set point over time.
struct Control {
  std::string set;  ///< `propellers[main].speed_rps`
  /// A file, a formula in the time, a controller or a switch.
  std::variant<CommandFile, std::string, PidControl, RelayControl> source;
  double start = 0;                                       ///< [s]
  double rate = std::numeric_limits<double>::infinity();  ///< [unit of the set point/s]
};

}  // namespace scene

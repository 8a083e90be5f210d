#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/spatial.h"

/// @file
/// Readings of lines, joints and machines at an instant, for logs, pictures and controllers. SI
/// units.

namespace engine {

/// A line at an instant.
struct LineReading {
  double tension = 0;   ///< At the first end; negative for a spring that pushes [N].
  double distance = 0;  ///< Distance of its ends [m].
  double length = 0;    ///< Unstretched [m].
  bool taut = false;    ///< It pulls or pushes.
  bool broken = false;  ///< It broke at an earlier time and pulls no more.
  Eigen::Vector3d first_W = Eigen::Vector3d::Zero();   ///< Place of its first end [m].
  Eigen::Vector3d second_W = Eigen::Vector3d::Zero();  ///< Place of its second end [m].
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< On the first body [N].
  double resting = 0;                                  ///< Length of a mooring on the bottom [m].
  /// Places of its nodes [m], from its first end to its second: of a line with inertia, until it
  /// breaks.
  std::vector<Eigen::Vector3d> nodes_W = {};
};

/// A joint at an instant. Forces and moments are means over the last step.
struct JointReading {
  double coordinate = 0;                               ///< q of a hinge [rad] or slider [m].
  double speed = 0;                                    ///< q' [rad/s, m/s].
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< On the second body, by the first [N].
  Eigen::Vector3d moment_W = Eigen::Vector3d::Zero();  ///< The same, about the anchor [N m].
  Eigen::Vector3d place_W = Eigen::Vector3d::Zero();   ///< The anchor, or the second body [m].
  double effort = 0;  ///< Effort of limits, motor, spring, damper and friction along q [N m, N].
  double damper = 0;  ///< −c q', of the present speed [N m, N].
  double spring = 0;  ///< −k (q − q₀), of the present coordinate [N m, N].
  double motor = 0;   ///< Effort of the motor along q, a mean over the last step [N m, N].
};

/// A propeller at an instant.
struct PropellerReading {
  double speed = 0;    ///< [1/s]
  double azimuth = 0;  ///< [rad]
  double turn = 0;     ///< Angle that the shaft has turned through since the start [rad].
  double thrust = 0;   ///< Along its axis, on the body [N].
  double torque = 0;   ///< Torque that the screw takes from its shaft [N m].
  double advance = 0;  ///< J [-]; 0 at rest.
  double wetted = 0;   ///< Share of the disc in the water [-].
};

/// A foil at an instant.
struct FoilReading {
  double angle = 0;                                   ///< [rad]
  double attack = 0;                                  ///< Angle of attack [rad].
  double speed = 0;                                   ///< Speed of the flow across its span [m/s].
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();  ///< [N]
};

/// All of a simulation, in the order of the specification.
struct RigReadings {
  std::vector<LineReading> lines;            ///< Springs, ropes and moorings.
  std::vector<JointReading> joints;          ///< All joints.
  std::vector<PropellerReading> propellers;  ///< All propellers.
  std::vector<FoilReading> foils;            ///< All foils.
  std::vector<double> set_points;            ///< In the units of their names.
};

}  // namespace engine

#pragma once

#include <vector>

#include "engine/base/rig_readings.h"
#include "engine/base/spec.h"
#include "hydro/spatial.h"

/// @file
/// The numbers of lines and machines that a picture needs beside the states of the bodies.

namespace app {

/// A line at an instant.
struct DrawnLine {
  double tension = 0;  ///< [N]
  double length = 0;   ///< Unstretched [m].
  bool broken = false;
  /// Places of its nodes [m, W], from its first end to its second: of a line with inertia that is
  /// not broken, as far as they are known.
  std::vector<Eigen::Vector3d> nodes_W = {};

  bool operator==(const DrawnLine&) const = default;
};

/// A propeller at an instant.
struct DrawnPropeller {
  double turn = 0;     ///< Angle that its shaft has turned through [rad].
  double azimuth = 0;  ///< [rad]

  bool operator==(const DrawnPropeller&) const = default;
};

/// All of a simulation, in the order of the specification.
struct DrawnRig {
  std::vector<DrawnLine> lines;
  std::vector<DrawnPropeller> propellers;
  std::vector<double> foil_angles;  ///< [rad]

  bool operator==(const DrawnRig&) const = default;
};

DrawnRig drawn_rig(const engine::RigReadings& readings);

/// State of lines and machines without readings: lines have their initial lengths and the tensions
/// that these have at rest, machines their initial settings; nodes of lines are not known.
DrawnRig rig_at_rest(const engine::SimulationSpec& spec,
                     const std::vector<hydro::BodyState>& states, double time);

/// Returns the rig at a time between two others, linear in `part` from 0 to 1. A line is broken as
/// at the later time, and its nodes are known if they are at both.
DrawnRig between(const DrawnRig& a, const DrawnRig& b, double part);

/// Returns the place of an attachment point [m, W].
Eigen::Vector3d place_of(const engine::AttachmentPoint& point,
                         const std::vector<hydro::BodyState>& states);

/// Returns the line as its catenary sees it. @param length   Unstretched [m].
hydro::CatenaryLine catenary_of(const engine::LineSpec& line, double length);

}  // namespace app

#pragma once

#include <optional>
#include <vector>

#include "engine/base/spec.h"
#include "hydro/lines/catenary.h"

/// @file
/// The force of a line between two points.
///
/// With l the distance of the ends, n the unit vector from the first to the second, L the
/// unstretched length, a spring pulls its first end with T n,
///
///     T = k (l − L) + c (l' − L'),                                                          (E23)
///
/// a rope the same while l > L and T > 0. A mooring pulls with the H and V of its catenary
/// (hydro/lines/catenary.h) in the vertical plane of its ends, and drags its fairlead with half of
/// the load of the water that crosses the part of it above the bottom,
/// ½ρ C_d d (L_s/2) |w| w, w the velocity of the water at the fairlead relative to it and across
/// the line.

namespace engine {

/// An end of a line.
struct LineEnd {
  Eigen::Vector3d place_W = Eigen::Vector3d::Zero();     ///< [m]
  Eigen::Vector3d velocity_W = Eigen::Vector3d::Zero();  ///< [m/s]
};

/// An end of a line on bodies in these states.
LineEnd line_end(const AttachmentPoint& point, const std::vector<hydro::BodyState>& states);

/// The properties of a line at a time.
struct LineLength {
  double length = 0;  ///< L [m]
  double rate = 0;    ///< L' [m/s]
};

struct LinePull {
  double tension = 0;                                   ///< T, at the first end [N].
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();    ///< On the first end [N].
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  ///< −∂F/∂x of the first end [N/m].
  Eigen::Matrix3d damping = Eigen::Matrix3d::Zero();    ///< −∂F/∂v of it [N s/m].
  double distance = 0;                                  ///< l [m]
  std::optional<hydro::CatenarySolution> catenary;      ///< Shape of a mooring.
};

/// @param sea     The water; null: none.
/// @param start   (H, V) near those of the mooring.
LinePull pull_of(const LineSpec& line, const LineLength& length, const LineEnd& first,
                 const LineEnd& second, const hydro::Sea* sea, double time,
                 const std::optional<Eigen::Vector2d>& start);

/// Span and height of a fairlead over its anchor, and the unit vector from it towards the anchor.
struct CatenaryPlane {
  double span = 0, height = 0;                           ///< [m]
  Eigen::Vector3d towards_W = Eigen::Vector3d::UnitX();  ///< Horizontal, unit.
};
CatenaryPlane catenary_plane(const Eigen::Vector3d& fairlead_W, const Eigen::Vector3d& anchor_W);

hydro::CatenaryLine catenary_line(const LineSpec& line, double length);

}  // namespace engine

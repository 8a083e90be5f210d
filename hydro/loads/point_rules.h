#pragma once

#include <Eigen/Core>
#include <array>

#include "hydro/loads/clip.h"

/// @file
/// Rules for means over triangles: of six points, exact for polynomials of fourth degree [D85], and
/// of the three middles of the edges, exact for those of second degree.
///
/// [D85] Dunavant. High degree efficient symmetrical Gaussian quadrature rules for the triangle.
///       Int. J. Numer. Methods Eng. 21 (1985) 1129-1148.

namespace hydro {

/// A point of the rule: its barycentric coordinates, and its weight in the mean.
struct TrianglePoint {
  double at[3];
  double weight;
};

namespace six_points {

inline constexpr double kInner = 0.445948490915964886, kInnerWeight = 0.223381589678011466;
inline constexpr double kOuter = 0.091576213509770743, kOuterWeight = 0.109951743655321868;

}  // namespace six_points

/// The weights add up to 1.
inline constexpr std::array<TrianglePoint, 6> kSixPoints = [] {
  std::array<TrianglePoint, 6> points{};
  for (int i = 0; i < 3; ++i) {
    TrianglePoint& near = points[i] = {{}, six_points::kInnerWeight};
    TrianglePoint& far = points[3 + i] = {{}, six_points::kOuterWeight};
    for (int corner = 0; corner < 3; ++corner) {
      near.at[corner] = corner == i ? 1 - 2 * six_points::kInner : six_points::kInner;
      far.at[corner] = corner == i ? 1 - 2 * six_points::kOuter : six_points::kOuter;
    }
  }
  return points;
}();

inline constexpr std::array<TrianglePoint, 3> kThreePoints = {
    {{{0.5, 0.5, 0}, 1.0 / 3}, {{0, 0.5, 0.5}, 1.0 / 3}, {{0.5, 0, 0.5}, 1.0 / 3}}};

/// The place of a point of a rule on a panel.
inline Eigen::Vector3d point_of(const Panel& panel, const TrianglePoint& point) {
  return point.at[0] * panel[0] + point.at[1] * panel[1] + point.at[2] * panel[2];
}

}  // namespace hydro

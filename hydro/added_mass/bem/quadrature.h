#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "hydro/added_mass/bem/element.h"

/// @file
/// Rules for integrals over a triangle.

namespace hydro::bem {

/// A point of a rule: barycentric coordinates and share of the area.
struct Node {
  Eigen::Vector3d at;
  double weight;
};
using Rule = std::vector<Node>;

/// Rules exact for polynomials of degree 2, 4 and 5, with 3, 6 and 7 interior points; the 3 points
/// have equal weights.
const Rule& rule_of_degree_2();
const Rule& rule_of_degree_4();
const Rule& rule_of_degree_5();

/// Rule of 36 points for integrands singular along edge 0; the points crowd towards the edge and
/// its ends.
const Rule& rule_at_edge();

/// Rule of 36 points for integrands singular at corner 0.
const Rule& rule_at_corner();

/// The points of a rule of N, and its weights times the hat functions there.
template <std::size_t N>
struct HatRule {
  std::array<std::array<double, 3>, N> at;
  std::array<std::array<double, 3>, N> hats;
};
const HatRule<3>& hat_rule_3();  ///< Exact to degree 2.
const HatRule<6>& hat_rule_6();  ///< Exact to degree 4.

/// Position of a rule's point on a triangle [m].
inline Eigen::Vector3d point(const std::array<Eigen::Vector3d, 3>& corners, const Node& node) {
  return node.at[0] * corners[0] + node.at[1] * corners[1] + node.at[2] * corners[2];
}

}  // namespace hydro::bem

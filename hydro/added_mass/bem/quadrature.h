#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "hydro/added_mass/bem/element.h"

/// @file
/// Rules for integrals over a triangle.

namespace hydro::bem {

/// A point of a rule: barycentric coordinates, and its part of the area.
struct Node {
  Eigen::Vector3d at;
  double weight;
};
using Rule = std::vector<Node>;

/// Exact for polynomials of degree 2, 4 and 5: 3, 6 and 7 points inside, equal weights for 3.
const Rule& rule_of_degree_2();
const Rule& rule_of_degree_4();
const Rule& rule_of_degree_5();

/// For integrands that are singular along edge 0: points crowd towards it and its ends. 36 points.
const Rule& rule_at_edge();

/// For integrands that are singular at corner 0. 36 points.
const Rule& rule_at_corner();

/// A rule's point on the element [m].
inline Eigen::Vector3d point(const std::array<Eigen::Vector3d, 3>& corners, const Node& node) {
  return node.at[0] * corners[0] + node.at[1] * corners[1] + node.at[2] * corners[2];
}

}  // namespace hydro::bem

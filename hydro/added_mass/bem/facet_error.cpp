#include "hydro/added_mass/bem/facet_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hydro/added_mass/bem/quadrature.h"

namespace hydro::bem {
namespace {

using Eigen::Vector3d;

/// N at a panel's corners, then at the middles of its edges from corner i to i + 1.
std::array<Vector6d, 6> motion_at_nodes(const Element& element) {
  std::array<Vector6d, 6> motion;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d& corner = element.corners[i];
    const Vector3d middle = 0.5 * (corner + element.corners[(i + 1) % 3]);
    motion[i] << element.normal, corner.cross(element.normal);
    motion[3 + i] << element.normal, middle.cross(element.normal);
  }
  return motion;
}

/// Area-weighted means of N over the panels at each node: one row per vertex, then one per edge.
Potential mean_motion(const Surface& surface) {
  Potential sums = Potential::Zero(function_count(surface), 6);
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(sums.rows());
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const Element& element = surface.elements[f];
    const std::array<Vector6d, 6> motion = motion_at_nodes(element);
    const std::array<int, 6> rows = functions_of(surface, f);
    for (std::size_t k = 0; k < 6; ++k) {
      sums.row(rows[k]) += element.area * motion[k].transpose();
      areas[rows[k]] += element.area;
    }
  }
  return areas.cwiseInverse().asDiagonal() * sums;
}

/// Wavelength that fits on a panel: its size, or twice its height if the panel is thin.
double width(const Element& element) {
  const double longest = *std::max_element(element.lengths.begin(), element.lengths.end());
  return std::min(std::sqrt(2 * element.area), 4 * element.area / longest);
}

}  // namespace

Matrix6d facet_error(const Surface& surface) {
  const Potential mean = mean_motion(surface);
  Matrix6d sum = Matrix6d::Zero();
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const Element& element = surface.elements[f];
    std::array<Vector6d, 6> rest = motion_at_nodes(element);
    const std::array<int, 6> rows = functions_of(surface, f);
    for (std::size_t k = 0; k < 6; ++k) rest[k] -= mean.row(rows[k]).transpose();
    for (const Node& node : rule_of_degree_4()) {
      // `here` is the quadratic function through the nodes.
      Vector6d here = Vector6d::Zero();
      for (std::size_t i = 0; i < 3; ++i) {
        const double hat = node.at[static_cast<int>(i)],
                     next = node.at[static_cast<int>((i + 1) % 3)];
        here += hat * (2 * hat - 1) * rest[i] + 4 * hat * next * rest[3 + i];
      }
      sum += width(element) / (2 * std::numbers::pi) * node.weight * element.area * here *
             here.transpose();
    }
  }
  return sum;
}

}  // namespace hydro::bem

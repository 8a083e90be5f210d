#include "hydro/bem/far_kernel.h"

#include <cmath>

#include "hydro/bem/quadrature.h"

namespace hydro::bem {
namespace {

/// Adds 1/|x − y_b| to both sums.
PLIMSOLL_VECTOR_CLONES
void add_inverse_distances(double x, double y, double z, const double* px, const double* py,
                           const double* pz, std::size_t count, double* one, double* other) {
  for (std::size_t b = 0; b < count; ++b) {
    const double dx = x - px[b], dy = y - py[b], dz = z - pz[b];
    const double inverse = 1 / std::sqrt(dx * dx + dy * dy + dz * dz);
    one[b] += inverse;
    other[b] += inverse;
  }
}

}  // namespace

FarPoints::FarPoints(const std::vector<Element>& elements)
    : count_(elements.size()), coordinates_(9 * elements.size()) {
  const Rule& rule = rule_of_degree_2();
  for (std::size_t b = 0; b < count_; ++b) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d at = point(elements[b].corners, rule[k]);
      for (std::size_t axis = 0; axis < 3; ++axis)
        coordinates_[(3 * k + axis) * count_ + b] = at[static_cast<Eigen::Index>(axis)];
    }
  }
}

Eigen::Matrix3d FarPoints::of(std::size_t element) const {
  Eigen::Matrix3d points;
  for (std::size_t k = 0; k < 3; ++k)
    points.col(static_cast<Eigen::Index>(k)) << row(k, 0)[element], row(k, 1)[element],
        row(k, 2)[element];
  return points;
}

void far_sums(const FarPoints& points, std::size_t element, double* sums) {
  const std::size_t count = points.count();
  std::fill(sums, sums + 6 * count, 0.0);
  const Eigen::Matrix3d x = points.of(element);
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d at = x.col(static_cast<Eigen::Index>(k));
    for (std::size_t l = 0; l < 3; ++l)
      add_inverse_distances(at[0], at[1], at[2], points.row(l, 0), points.row(l, 1),
                            points.row(l, 2), count, sums + k * count, sums + (3 + l) * count);
  }
}

}  // namespace hydro::bem

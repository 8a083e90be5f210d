#include "hydro/bem/interpolation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hydro/bem/far_kernel.h"

namespace hydro::bem {
namespace {

using Eigen::Index;

/// Points along a side: interpolation of 1/r at a distance of at least kDistant half diagonals
/// either way is in error by (side/distance)^order. Here it is what it is along the longest side.
int order_of(double side, double longest) {
  constexpr double kNearest = 3.2;  // distance over the half of the longest side
  if (side <= 1e-12 * longest) return 1;
  const double order = kOrder * std::log(kNearest) / std::log(kNearest * longest / side);
  return std::clamp(static_cast<int>(std::ceil(order - 1e-9)), 1, kOrder);
}

/// Chebyshev point i of `order` in [−1, 1], of the first kind.
double chebyshev(int i, int order) {
  static const auto points = [] {
    std::array<std::array<double, kOrder>, kOrder + 1> table = {};
    for (int n = 1; n <= kOrder; ++n) {
      for (int k = 0; k < n; ++k)
        table[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)] =
            std::cos(std::numbers::pi * (k + 0.5) / n);
    }
    return table;
  }();
  return points[static_cast<std::size_t>(order)][static_cast<std::size_t>(i)];
}

/// Lagrange's polynomials at t in [−1, 1].
std::array<double, kOrder> lagrange(double t, int order) {
  std::array<double, kOrder> values = {};
  for (int i = 0; i < order; ++i) {
    double value = 1;
    for (int j = 0; j < order; ++j) {
      if (j != i) value *= (t - chebyshev(j, order)) / (chebyshev(i, order) - chebyshev(j, order));
    }
    values[static_cast<std::size_t>(i)] = value;
  }
  return values;
}

PLIMSOLL_VECTOR_CLONES
void inverse_distances(const double* x, const double* y, Index count, double* out) {
  for (Index j = 0; j < count; ++j) {
    const double dx = x[0] - y[j], dy = x[1] - y[count + j], dz = x[2] - y[2 * count + j];
    out[j] = 1 / std::sqrt(dx * dx + dy * dy + dz * dz);
  }
}

/// Rows taken at a time: one after another, each sum would wait for its last addition.
constexpr Index kRows = 4;

/// sums = factors · moments for kRows rows and kBlock columns of it.
PLIMSOLL_VECTOR_CLONES
void multiply_block(const double* factors, const double* moments, Index count, Index stride,
                    double* sums) {
  double sum[kRows][kBlock] = {};
  for (Index j = 0; j < count; ++j) {
    for (Index row = 0; row < kRows; ++row) {
      const double factor = factors[row * count + j];
      for (int k = 0; k < kBlock; ++k) sum[row][k] += factor * moments[j * stride + k];
    }
  }
  for (Index row = 0; row < kRows; ++row) {
    for (int k = 0; k < kBlock; ++k) sums[row * kBlock + k] = sum[row][k];
  }
}

}  // namespace

Grid::Grid(const Eigen::AlignedBox3d& box) : center_(box.center()), half_(0.5 * box.sizes()) {
  const double longest = half_.maxCoeff();
  for (std::size_t axis = 0; axis < 3; ++axis)
    orders_[axis] = order_of(half_[static_cast<Index>(axis)], longest);
  nodes_.resize(orders_[0] * orders_[1] * orders_[2], 3);
  for (int i = 0; i < static_cast<int>(nodes_.rows()); ++i) {
    const Eigen::Vector3d at(chebyshev(i % orders_[0], orders_[0]),
                             chebyshev(i / orders_[0] % orders_[1], orders_[1]),
                             chebyshev(i / (orders_[0] * orders_[1]), orders_[2]));
    nodes_.row(i) = (center_ + half_.cwiseProduct(at)).transpose();
  }
}

Eigen::VectorXd Grid::weights_at(const Eigen::Vector3d& x) const {
  std::array<std::array<double, kOrder>, 3> along;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Index>(axis);
    const double t = orders_[axis] == 1 ? 0 : (x[k] - center_[k]) / half_[k];
    along[axis] = lagrange(t, orders_[axis]);
  }
  Eigen::VectorXd weights(count());
  Index i = 0;
  for (int w = 0; w < orders_[2]; ++w) {
    for (int v = 0; v < orders_[1]; ++v) {
      for (int u = 0; u < orders_[0]; ++u)
        weights[i++] = along[0][static_cast<std::size_t>(u)] *
                       along[1][static_cast<std::size_t>(v)] *
                       along[2][static_cast<std::size_t>(w)];
    }
  }
  return weights;
}

void add_interaction(const Grid& at, const Grid& from, const double* moments, Index columns,
                     double* field) {
  std::array<double, static_cast<std::size_t>(kRows)* kOrder* kOrder* kOrder> inverse = {};
  std::array<double, static_cast<std::size_t>(kRows) * kBlock> sums;
  for (Index first = 0; first < at.count(); first += kRows) {
    const Index rows = std::min(kRows, at.count() - first);
    for (Index row = 0; row < rows; ++row) {
      const Eigen::Vector3d x = at.nodes().row(first + row);
      inverse_distances(x.data(), from.nodes().data(), from.count(),
                        inverse.data() + row * from.count());
    }
    for (Index block = 0; block < columns; block += kBlock) {
      multiply_block(inverse.data(), moments + block, from.count(), columns, sums.data());
      for (Index row = 0; row < rows; ++row) {
        for (Index k = 0; k < kBlock; ++k)
          field[(first + row) * columns + block + k] +=
              sums[static_cast<std::size_t>(row * kBlock + k)];
      }
    }
  }
}

}  // namespace hydro::bem

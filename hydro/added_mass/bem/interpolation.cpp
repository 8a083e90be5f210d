#include "hydro/added_mass/bem/interpolation.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include "hydro/added_mass/bem/lanes.h"

namespace hydro::bem {
namespace {

using Eigen::Index;

/// Number of points along a side. The error of interpolating 1/r at a distance of at least kDistant
/// half diagonals is (side/distance)^order; the order makes it equal to that along the longest
/// side.
int order_of(double side, double longest) {
  constexpr double kNearest = 3.2;  // distance over half the longest side
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

using Floats __attribute__((vector_size(kBlock * sizeof(float)))) = float;
using FloatBits __attribute__((vector_size(kBlock * sizeof(float)))) = int;

[[gnu::always_inline]] inline void load(const float* from, Floats& to) {
  std::memcpy(&to, from, sizeof(to));
}

/// out[j] = 1/|x − y_j|: a first guess from the bits of r², then Newton's method, whose error falls
/// from 3e-2 over 2e-3 and 5e-6 to round-off.
/// @param y   `count` values of x, then of y, then of z; `count` is a multiple of kBlock.
PLIMSOLL_VECTOR_CLONES
void inverse_distances(const float* x, const float* y, Index count, float* out) {
  for (Index j = 0; j < count; j += kBlock) {
    Floats dx, dy, dz;
    load(y + j, dx);
    load(y + count + j, dy);
    load(y + 2 * count + j, dz);
    dx -= x[0];
    dy -= x[1];
    dz -= x[2];
    const Floats squared = dx * dx + dy * dy + dz * dz;
    const Floats half = 0.5F * squared;
    const FloatBits bits = 0x5f3759df - (reinterpret_cast<FloatBits>(squared) >> 1);
    Floats root = reinterpret_cast<Floats>(bits);
    for (int step = 0; step < 3; ++step) root = root * (1.5F - half * root * root);
    std::memcpy(out + j, &root, sizeof(root));
  }
}

/// Number of rows processed at a time: with one, each addition would wait for the previous one.
constexpr Index kRows = 8;

/// sums = factors · moments for kRows rows and kBlock columns.
/// @param stride   Row strides of `factors` and of `moments`.
PLIMSOLL_VECTOR_CLONES
void multiply_block(const float* factors, const float* moments, Index count,
                    std::pair<Index, Index> stride, float* sums) {
  const Floats zero = {};
  Floats sum[kRows] = {zero, zero, zero, zero, zero, zero, zero, zero};
  for (Index j = 0; j < count; ++j) {
    Floats moment;
    load(moments + j * stride.second, moment);
    for (Index row = 0; row < kRows; ++row) sum[row] += factors[row * stride.first + j] * moment;
  }
  for (Index row = 0; row < kRows; ++row)
    std::memcpy(sums + row * kBlock, &sum[row], sizeof(Floats));
}

Index whole_blocks(Index count) { return (count + kBlock - 1) / kBlock * kBlock; }

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
  offsets_.resize(whole_blocks(count()), 3);
  for (Index i = 0; i < offsets_.rows(); ++i)
    offsets_.row(i) = (nodes_.row(std::min(i, count() - 1)) - center_.transpose()).cast<float>();
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

void add_interaction(const Grid& at, const Grid& from, const FloatColumns& moments, double* field) {
  constexpr auto kMostNodes = static_cast<std::size_t>(kOrder * kOrder * kOrder);
  std::array<float, static_cast<std::size_t>(kRows) * (kMostNodes + kBlock)> inverse = {};
  std::array<float, static_cast<std::size_t>(kRows) * kBlock> sums;
  const Index padded = from.offsets().rows(), columns = moments.cols();
  const Eigen::RowVector3d apart = (at.center() - from.center()).transpose();
  for (Index first = 0; first < at.count(); first += kRows) {
    const Index rows = std::min(kRows, at.count() - first);
    for (Index row = 0; row < rows; ++row) {
      const Eigen::RowVector3f x =
          (apart + at.offsets().row(first + row).cast<double>()).cast<float>();
      inverse_distances(x.data(), from.offsets().data(), padded, inverse.data() + row * padded);
    }
    for (Index block = 0; block < columns; block += kBlock) {
      multiply_block(inverse.data(), moments.data() + block, from.count(), {padded, columns},
                     sums.data());
      for (Index row = 0; row < rows; ++row) {
        for (Index k = 0; k < kBlock; ++k)
          field[(first + row) * columns + block + k] +=
              static_cast<double>(sums[static_cast<std::size_t>(row * kBlock + k)]);
      }
    }
  }
}

}  // namespace hydro::bem

#include "hydro/water/water_window.h"

#include <algorithm>
#include <cmath>

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

/// Width of the damped edge of the window over its side, unless it is given [-].
constexpr double kEdge = 0.2;

/// Damping across the edge over the group velocity of waves as long as the edge is wide [-].
constexpr double kDamping = 8;

}  // namespace

WaterWindow::WaterWindow(const PeriodicSquare& square, const Sea& sea, double edge)
    : square_(square),
      current_(sea.current.head<2>()),
      edge_(edge > 0 ? edge : kEdge * square.side()) {}

Vector2d WaterWindow::in_square(const Vector2d& p_W, double time) const {
  return (p_W - time * current_) / square_.cell;
}

bool WaterWindow::has(const Vector2d& place) const {
  return (place - middle_).cwiseAbs().maxCoeff() <= square_.cells / 2.0 - 2;
}

Eigen::VectorXf WaterWindow::damping(int axis, double time) const {
  const double speed = std::sqrt(square_.gravity * edge_ / (2 * M_PI)) / 2;
  const double rate = kDamping * speed / edge_;
  Eigen::VectorXf factor(square_.cells);
  for (Index i = 0; i < square_.cells; ++i) {
    const double away =
        std::abs(std::remainder(static_cast<double>(i) - middle_[axis], square_.cells)) *
        square_.cell;
    const double s = std::max(0.0, (away - square_.side() / 2) / edge_ + 1);
    factor[i] = static_cast<float>(std::exp(-rate * s * s * time));
  }
  return factor;
}

SurfacePatch WaterWindow::patch(const Eigen::MatrixXf& heights, double time) const {
  const Index n = heights.rows(), half = n / 2;
  const Index first_column = static_cast<Index>(middle_.x()) - half;
  const Index first_row = static_cast<Index>(middle_.y()) - half;
  SurfacePatch patch{.heights = Eigen::MatrixXf(n, n), .cell = square_.cell};
  for (Index column = 0; column < n; ++column)
    for (Index row = 0; row < n; ++row)
      patch.heights(row, column) =
          heights((first_row + row) & (n - 1), (first_column + column) & (n - 1));
  patch.origin =
      (middle_.array() - static_cast<double>(half)).matrix() * square_.cell + time * current_;
  return patch;
}

}  // namespace hydro

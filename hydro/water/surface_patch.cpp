#include "hydro/water/surface_patch.h"

namespace hydro {
namespace {

using Eigen::Index;

/// Weights of four neighbours at a part of the way between the middle two: Catmull and Rom's
/// spline.
Eigen::Vector4d cubic_weights(double t) {
  return Eigen::Vector4d(((2 - t) * t - 1) * t, (3 * t - 5) * t * t + 2, ((4 - 3 * t) * t + 1) * t,
                         (t - 1) * t * t) /
         2;
}

}  // namespace

double SurfacePatch::at(double x, double y) const {
  const double column = (x - origin.x()) / cell, row = (y - origin.y()) / cell;
  const Index n = heights.cols();
  if (!(column >= 1 && row >= 1 && column < static_cast<double>(n - 2) &&
        row < static_cast<double>(heights.rows() - 2)))
    return 0;
  const auto c = static_cast<Index>(column), r = static_cast<Index>(row);
  const Eigen::Vector4d across = cubic_weights(column - static_cast<double>(c));
  const Eigen::Vector4d along = cubic_weights(row - static_cast<double>(r));
  return along.dot(heights.block<4, 4>(r - 1, c - 1).cast<double>() * across);
}

}  // namespace hydro

#include "hydro/added_mass/attitude_grid.h"

#include <cmath>
#include <numbers>

namespace hydro {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// Weight below which a node is left out.
constexpr double kLeastWeight = 1e-4;

/// Distance below which a place counts as lying on a node or a line of nodes [steps].
constexpr double kRoundOff = 1e-9;

}  // namespace

int AttitudeGrid::number(const Vector3i& place) const {
  const int side = 2 * divisions_ + 1;
  const int below = place[2] < 0 ? 1 : 0;
  return 2 * ((place[0] + divisions_) * side + place[1] + divisions_) + below;
}

Vector3d AttitudeGrid::direction(int node) const {
  const int side = 2 * divisions_ + 1;
  Vector3d place(node / 2 / side - divisions_, node / 2 % side - divisions_, 0);
  place[2] = (divisions_ - std::abs(place[0]) - std::abs(place[1])) * (node % 2 == 0 ? 1 : -1);
  const Vector3d angles = place / divisions_;
  // |sin(stretch·angles)| is 1 for one stretch between π/2 (on an edge) and 1.85 (face centres).
  double low = std::numbers::pi / 2, high = 1.9;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (Vector3d((middle * angles).array().sin()).norm() < 1 ? low : high) = middle;
  }
  return Vector3d((low * angles).array().sin()).normalized();
}

std::array<AttitudeGrid::Corner, 3> AttitudeGrid::around(const Vector3d& up) const {
  const Vector3d angles = up.cwiseAbs().cwiseMin(1).array().asin();
  const Vector3d place = divisions_ / angles.sum() * angles;
  const Vector3d floor = (place.array() + kRoundOff).floor();
  const Vector3d part = place - floor;
  const int missing = divisions_ - static_cast<int>(floor.sum());  // 0 on a node, 1 or 2
  std::array<Corner, 3> corners{};
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    Vector3i node = floor.cast<int>();
    double weight = 0;
    if (missing == 0) {
      weight = i == 0 ? 1 : 0;
    } else if (missing == 1) {
      ++node[i];
      weight = part[i];
    } else {
      node += Vector3i::Ones() - Vector3i::Unit(i);
      weight = 1 - part[i];
    }
    for (int axis = 0; axis < 3; ++axis)
      if (up[axis] < 0) node[axis] = -node[axis];
    if (weight < kLeastWeight) weight = 0;
    sum += weight;
    corners[static_cast<std::size_t>(i)] = {number(node), weight};
  }
  for (Corner& corner : corners) corner.weight /= sum;
  return corners;
}

}  // namespace hydro

#include "hydro/loads/clip.h"

#include <Eigen/Geometry>

namespace hydro {
namespace {

/// The point where the function is zero between its positive end `p` and its negative end `q`.
Eigen::Vector3d zero_between(const Eigen::Vector3d& p, double value_p, const Eigen::Vector3d& q,
                             double value_q) {
  return p + (value_p / (value_p - value_q)) * (q - p);
}

/// Positive part, a triangle, if only the first vertex is positive.
PanelParts corner(const Panel& r, const Eigen::Vector3d& value) {
  const Eigen::Vector3d on01 = zero_between(r[0], value[0], r[1], value[1]);
  const Eigen::Vector3d on02 = zero_between(r[0], value[0], r[2], value[2]);
  PanelParts parts;
  parts.part[0] = {.panel = {r[0], on01, on02}, .value = {value[0], 0, 0}};
  parts.count = 1;
  return parts;
}

/// Positive part, a quadrilateral, if only the first vertex is negative.
PanelParts trapezium(const Panel& r, const Eigen::Vector3d& value) {
  const Eigen::Vector3d on10 = zero_between(r[1], value[1], r[0], value[0]);
  const Eigen::Vector3d on20 = zero_between(r[2], value[2], r[0], value[0]);
  PanelParts parts;
  parts.part[0] = {.panel = {on10, r[1], r[2]}, .value = {0, value[1], value[2]}};
  parts.part[1] = {.panel = {on10, r[2], on20}, .value = {0, value[2], 0}};
  parts.count = 2;
  return parts;
}

}  // namespace

PanelParts positive_part(const Panel& panel, const Eigen::Vector3d& value) {
  const int positive = (value[0] > 0) + (value[1] > 0) + (value[2] > 0);
  if (positive == 0) return {};
  if (value.minCoeff() >= 0) {
    PanelParts whole;
    whole.part[0] = {.panel = panel, .value = value};
    whole.count = 1;
    return whole;
  }
  // A vertex with the value zero counts as negative; the cut through it makes at worst a sliver
  // without area.
  int first = 0;
  while ((value[first] > 0) != (positive == 1)) ++first;
  const int second = (first + 1) % 3;
  const int third = (first + 2) % 3;
  const Panel turned = {panel[first], panel[second], panel[third]};
  const Eigen::Vector3d turned_value(value[first], value[second], value[third]);
  return positive == 1 ? corner(turned, turned_value) : trapezium(turned, turned_value);
}

Eigen::Vector3d area_vector(const Panel& panel) {
  return 0.5 * (panel[1] - panel[0]).cross(panel[2] - panel[0]);
}

}  // namespace hydro

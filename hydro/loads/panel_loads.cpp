#include "hydro/loads/panel_loads.h"

#include <Eigen/Geometry>

namespace hydro {
namespace {

/// Weights w_i of equation (2).
Eigen::Vector3d product_weights(const Eigen::Matrix3d& q) {
  Eigen::Vector3d w;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    w[i] = (3 * q(i, i) + q(j, j) + q(k, k) + 2 * (q(i, j) + q(i, k)) + q(j, k)) / 30;
  }
  return w;
}

/// The load −k ∫ q n dA of a normal traction, equation (3).
Wrench normal_load(const Panel& panel, const Eigen::Vector3d& normal, const Eigen::Matrix3d& q,
                   double k) {
  const Eigen::Vector3d w = product_weights(q);
  const Eigen::Vector3d weighted_r = w[0] * panel[0] + w[1] * panel[1] + w[2] * panel[2];
  const Eigen::Vector3d traction = -k * area_vector(panel).norm() * normal;
  return {.force = w.sum() * traction, .moment = weighted_r.cross(traction)};
}

}  // namespace

Wrench pressure_load(const Panel& panel, const Eigen::Vector3d& pressure) {
  const Eigen::Vector3d a = area_vector(panel);
  const double sum = pressure.sum();
  Eigen::Vector3d first_moment = Eigen::Vector3d::Zero();  // 12/A times the integral of p r
  for (int i = 0; i < 3; ++i) first_moment += (sum + pressure[i]) * panel[i];
  return {.force = -sum / 3 * a, .moment = -first_moment.cross(a) / 12};
}

Wrench pressure_drag_load(const Panel& panel, const Eigen::Vector3d& normal,
                          const Eigen::Vector3d& normal_speed, double sign, double k) {
  // (2) with q_ij = s_i s_j: 30 w_i = (S² + Σ s_j²)/2 + s_i (S + s_i), with S the sum of the s_j.
  const Eigen::Vector3d& s = normal_speed;
  const double sum = s.sum();
  const double common = (sum * sum + s.squaredNorm()) / 2;
  const Eigen::Vector3d w = (common + s.array() * (sum + s.array())) / 30;
  const Eigen::Vector3d weighted_r = w[0] * panel[0] + w[1] * panel[1] + w[2] * panel[2];
  const Eigen::Vector3d traction = -sign * k * area_vector(panel).dot(normal) * normal;
  return {.force = w.sum() * traction, .moment = weighted_r.cross(traction)};
}

Wrench lift_load(const Panel& panel, const Eigen::Vector3d& normal, const Eigen::Matrix3d& velocity,
                 double k) {
  const Eigen::Matrix3d tangential = velocity - normal * (normal.transpose() * velocity);
  return normal_load(panel, normal, tangential.transpose() * tangential, k);
}

}  // namespace hydro

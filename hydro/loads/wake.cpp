#include "hydro/loads/wake.h"

#include <algorithm>
#include <cmath>

#include "hydro/loads/point_rules.h"

namespace hydro {
namespace {

/// Round-off of f = 1 in steady motion. Larger: a wake is whole too soon.
constexpr double kWholeWake = 1e-12;

/// |u| of (1).
double size(const WakeScale& scale, const Eigen::Matrix3d& R_WB, const Vector6d& u) {
  Vector6d u_B;
  u_B << R_WB.transpose() * u.head<3>(), R_WB.transpose() * u.tail<3>();
  return std::sqrt(std::max(0.0, u_B.dot(scale.square * u_B)));
}

}  // namespace

WakeScale wake_scale(const TriMesh& mesh_B) {
  WakeScale scale;
  double surface = 0;
  for (Eigen::Index face = 0; face < mesh_B.face_count(); ++face) {
    const double area = area_vector(mesh_B, face).norm();
    surface += area;
    const Panel panel = panel_of(mesh_B, face);
    for (const TrianglePoint& point : kThreePoints) {
      const Eigen::Vector3d r = point_of(panel, point);
      Eigen::Matrix<double, 3, 6> velocity;
      velocity << Eigen::Matrix3d::Identity(), -cross_matrix(r);
      scale.square += area / 3 * velocity.transpose() * velocity;
    }
  }
  if (surface > 0) scale.square /= surface;
  Eigen::Vector3d sides = bounding_box(mesh_B).sizes();
  std::sort(sides.begin(), sides.end());
  scale.length = kWakeLength * sides[1];
  return scale;
}

Vector6d advanced_wake(const WakeScale& scale, const Eigen::Matrix3d& R_WB, const Vector6d& d,
                       const Vector6d& u, double time) {
  const double speed = size(scale, R_WB, u);
  if (!(speed > 0)) return d;
  const double kept = std::exp(-speed * time / scale.length);
  return kept * d + (1 - kept) * scale.length / speed * u;
}

Vector6d steady_wake(const WakeScale& scale, const Eigen::Matrix3d& R_WB, const Vector6d& u) {
  const double speed = size(scale, R_WB, u);
  return speed > 0 ? Vector6d(scale.length / speed * u) : Vector6d(Vector6d::Zero());
}

double formed_wake(const WakeScale& scale, const Eigen::Matrix3d& R_WB, const Vector6d& d) {
  const double part = size(scale, R_WB, d) / scale.length;
  return part > 1 - kWholeWake ? 1 : part * part * part * part;
}

}  // namespace hydro

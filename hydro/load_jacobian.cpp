#include "hydro/load_jacobian.h"

#include "hydro/clip.h"
#include "hydro/refine.h"
#include "hydro/viscous_drag.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

// Panels are split no further than to this part of the body's radius, as the loads are.
constexpr double kSmallestPanel = 1.0 / 256;

/// What the sum over the panels needs.
struct Motion {
  const Coefficients& coefficients;
  Twist twist;       ///< Relative to the water.
  double scale = 1;  ///< Of the pressure drag, by its calibration.
};

/// Integrand of (2) per ½ρ C_v.
Matrix6d friction(const Vector3d& r, const Vector3d& n, const Vector3d& v) {
  const Vector3d v_t = v - v.dot(n) * n;
  const double speed = v_t.norm();
  if (speed == 0) return Matrix6d::Zero();
  const Eigen::Matrix3d along =
      Eigen::Matrix3d::Identity() - n * n.transpose() + v_t * v_t.transpose() / (speed * speed);
  Eigen::Matrix<double, 3, 6> B;
  B << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) B.col(3 + i) = Vector3d::Unit(i).cross(r);
  return speed * B.transpose() * along * B;
}

/// Adds (1), (2) per ρ and (3) per ρ g of a wet panel.
void add_panel(const Motion& motion, const Panel& panel, LoadJacobian& sum) {
  const Vector3d a = area_vector(panel);
  const double area = a.norm();
  if (area == 0) return;
  const Vector3d n = a / area;
  const PressureDrag& drag = motion.coefficients.pressure_drag;
  const ViscousDrag& law = motion.coefficients.viscous_drag;
  for (int i = 0; i < 3; ++i) {
    const Vector3d r = (panel[i] + panel[(i + 1) % 3]) / 2;
    const Vector3d v = motion.twist.at(r);
    const double v_n = v.dot(n);
    Vector6d b, c;
    b << n, r.cross(n);
    c << 0, 0, 1, r.y(), -r.x(), 0;
    const double C_p = motion.scale * (v_n > 0 ? drag.front : drag.back);
    sum.drag -= area / 3 * C_p * std::abs(v_n) * b * b.transpose();
    if (!law.none())
      sum.drag -= area / 6 * viscous_coefficient(law, (v - v_n * n).norm()) * friction(r, n, v);
    sum.waterplane += a.z() / 3 * c * c.transpose();
  }
}

}  // namespace

LoadJacobian load_jacobian(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                           const Coefficients& coefficients) {
  const Motion motion{.coefficients = coefficients,
                      .twist = {state.linear_velocity - sea.current, state.angular_velocity},
                      .scale = drag_scale(coefficients, state, sea.current)};
  const Eigen::Matrix3Xd r = state.orientation.toRotationMatrix() * hull.mesh_B.vertices;
  const SurfaceSampler surface(sea, state.position, time, kSmallestPanel * hull.radius);
  const double level = sea.level - state.position.z();
  LoadJacobian sum;
  const auto add_piece = [&](const Panel& piece, const Vector3d& elevation) {
    const Vector3d z(piece[0].z(), piece[1].z(), piece[2].z());
    const Vector3d depth = (elevation - z).array() + level;
    for (const PanelPart& wet : positive_part(piece, depth)) add_panel(motion, wet.panel, sum);
  };
  for (const auto& face : hull.mesh_B.faces.colwise()) {
    const Panel panel = {r.col(face[0]), r.col(face[1]), r.col(face[2])};
    const Vector3d elevation(surface.elevation(panel[0]), surface.elevation(panel[1]),
                             surface.elevation(panel[2]));
    for_each_linear_piece(panel, elevation, surface, add_piece);
  }
  sum.drag *= sea.density;
  sum.waterplane *= coefficients.buoyancy ? sea.density * sea.gravity : 0;
  return sum;
}

}  // namespace hydro

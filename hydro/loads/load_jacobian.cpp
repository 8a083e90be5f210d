#include "hydro/loads/load_jacobian.h"

#include <algorithm>

#include "hydro/airy_waves.h"
#include "hydro/loads/clip.h"
#include "hydro/loads/refine.h"
#include "hydro/loads/viscous_drag.h"
#include "hydro/loads/wind.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Length below which edges of coarse pieces are not split, over the body's radius [-]. Smaller:
/// bodies in contact in short waves take twice the time.
constexpr double kCoarsePiece = 1.0 / 16;

/// Input of the sum over the panels.
struct Motion {
  const Coefficients& coefficients;
  const Sea& sea;
  AiryWaves waves;
  SurfaceSampler surface;
  Vector3d p_WB;          ///< The centre of mass [m].
  Twist twist;            ///< Relative to the current.
  Eigen::Matrix3d shape;  ///< K of bluntness.h, in W.
  double scale = 1;       ///< Scale of the pressure drag, from its calibration.

  /// Velocity of the water, relative to the current of the surface, at the centre of a face [m/s]:
  /// the Jacobian takes one for all of the face.
  Vector3d water_at(const Panel& face) const {
    if (!waves.moves()) return Vector3d::Zero();
    const Vector3d r = (face[0] + face[1] + face[2]) / 3;
    const double s = surface.elevation(r) + (sea.level - p_WB.z() - r.z());
    return waves.at(p_WB + r, s).velocity - sea.current;
  }
};

void add_square(const Vector6d& b, double weight, Matrix6d& sum) {
  sum.noalias() += weight * b * b.transpose();
}

/// Adds `weight` times b bᵀ, where b = (d, r × d) is the unit load along d at r.
void add_along(const Vector3d& d, const Vector3d& r, double weight, Matrix6d& sum) {
  Vector6d b;
  b << d, r.cross(d);
  add_square(b, weight, sum);
}

/// Adds the integrand of (2) with `weight` for −½ρ C_v: 1 − n nᵀ + t tᵀ = 2 t tᵀ + s sᵀ, s = n × t.
void add_friction(const Vector3d& r, const Vector3d& n, const Vector3d& v_t, double weight,
                  Matrix6d& sum) {
  const double speed = v_t.norm();
  if (speed == 0) return;
  const Vector3d t = v_t / speed;
  add_along(t, r, 2 * speed * weight, sum);
  add_along(n.cross(t), r, speed * weight, sum);
}

/// Adds (1), (2) per ρ and (3) per ρ g of a wet panel.
/// @param water   Velocity of the water there, relative to the current of the surface [m/s].
void add_panel(const Motion& motion, const Panel& panel, const Vector3d& water, LoadJacobian& sum) {
  const Vector3d a = area_vector(panel);
  const double area = a.norm();
  if (area == 0) return;
  const Vector3d n = a / area;
  const PressureDrag& drag = motion.coefficients.pressure_drag;
  const ViscousDrag& law = motion.coefficients.viscous_drag;
  for (int i = 0; i < 3; ++i) {
    const Vector3d r = (panel[i] + panel[(i + 1) % 3]) / 2;
    const Vector3d v = motion.twist.at(r) - water;
    const Vector3d lever = r.cross(n);
    Vector6d b;
    b << motion.shape * n, lever;
    const double u = b.head<3>().dot(motion.twist.linear - water) + lever.dot(motion.twist.angular);
    const double C_p = motion.scale * (u > 0 ? drag.front : drag.back);
    add_square(b, -area / 3 * C_p * std::abs(u), sum.drag);
    if (!law.none()) {
      const Vector3d v_t = v - v.dot(n) * n;
      add_friction(r, n, v_t, -area / 6 * viscous_coefficient(law, v_t.norm()), sum.drag);
    }
    add_along(Vector3d::UnitZ(), r, a.z() / 3, sum.waterplane);
  }
}

}  // namespace

LoadJacobian load_jacobian(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                           const Coefficients& coefficients, Pieces pieces, double formed) {
  const double smallest = pieces == Pieces::coarse ? kCoarsePiece : kSmallestPanel;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Motion motion{
      .coefficients = coefficients,
      .sea = sea,
      .waves = AiryWaves(sea, time),
      .surface =
          SurfaceSampler(sea, state.position, time, smallest * hull.radius, SplitFor::surface),
      .p_WB = state.position,
      .twist = {state.linear_velocity - sea.current, state.angular_velocity},
      .shape = R_WB * coefficients.drag_shape * R_WB.transpose(),
      .scale = formed * drag_scale(coefficients, state, current_at(sea, state.position.z()))};
  const Eigen::Matrix3Xd r = R_WB * hull.mesh_B.vertices;
  const SurfaceSampler& surface = motion.surface;
  const double level = sea.level - state.position.z();
  const SurfaceBounds bounds = surface_bounds(sea);
  const double always_wet = bounds.lowest - state.position.z();
  const double always_dry = bounds.highest - state.position.z();
  LoadJacobian sum;
  Vector3d water;
  const auto add_piece = [&](const Panel& piece, const Vector3d& elevation) {
    const Vector3d z(piece[0].z(), piece[1].z(), piece[2].z());
    const Vector3d depth = (elevation - z).array() + level;
    for (const PanelPart& wet : positive_part(piece, depth))
      add_panel(motion, wet.panel, water, sum);
  };
  for (const auto& face : hull.mesh_B.faces.colwise()) {
    const Panel panel = {r.col(face[0]), r.col(face[1]), r.col(face[2])};
    const auto [low, high] = std::minmax({panel[0].z(), panel[1].z(), panel[2].z()});
    if (low >= always_dry) continue;
    water = motion.water_at(panel);
    if (high <= always_wet) {
      add_panel(motion, panel, water, sum);
      continue;
    }
    const Vector3d elevation(surface.elevation(panel[0]), surface.elevation(panel[1]),
                             surface.elevation(panel[2]));
    for_each_linear_piece(panel, elevation, surface, add_piece);
  }
  sum.drag *= sea.density;
  if (sea.air) sum.drag += wind_jacobian(hull, state, sea, time, coefficients);
  sum.waterplane *= coefficients.buoyancy ? sea.density * sea.gravity : 0;
  return sum;
}

}  // namespace hydro

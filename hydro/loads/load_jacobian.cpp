#include "hydro/loads/load_jacobian.h"

#include <algorithm>
#include <optional>

#include "hydro/loads/clip.h"
#include "hydro/loads/kernel/water_samples.h"
#include "hydro/loads/kernel/water_surface.h"
#include "hydro/loads/refine.h"
#include "hydro/loads/viscous_drag.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Length below which edges of coarse pieces are not split, over the body's radius [-]. Smaller:
/// bodies in contact in short waves take twice the time.
constexpr double kCoarsePiece = 1.0 / 16;

/// Error that the Jacobian may have in the head of waves over coarse pieces, as a part of the
/// buoyancy [-].
constexpr double kCoarseError = 1e-2;

/// Input of the sum over the panels.
struct Motion {
  const Coefficients& coefficients;
  Twist twist;            ///< Relative to the current.
  Eigen::Matrix3d shape;  ///< K of bluntness.h, in W.
  double scale = 1;       ///< Scale of the pressure drag, from its calibration.
  const Air* air = nullptr;
  Twist twist_in_air;    ///< Motion of the hull in W.
  double air_scale = 0;  ///< Scale of the drag of the air, with its density over the water's.
};

/// The water about a hull: over each vertex the elevation of its surface [m], and in the middle of
/// each face its velocity relative to the current of the surface, in W [m/s]. The Jacobian takes
/// one for all of a face.
struct WaterOverHull {
  Eigen::VectorXd elevation;
  Eigen::Matrix3Xd velocity;
};

WaterOverHull water_over(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                         double smallest) {
  const TriMesh& mesh = hull.mesh_B;
  WaterOverHull water{Eigen::VectorXd::Zero(mesh.vertex_count()),
                      Eigen::Matrix3Xd::Zero(3, mesh.face_count())};
  if (is_flat(sea) && sea.profile.empty()) return water;
  const kernel::FeltSea felt(sea, smallest * hull.radius, hull.panels.longest_edge, std::nullopt,
                             {SplitFor::current});
  const kernel::WaterSurface surface(felt, state, time, SplitFor::current);
  kernel::LoadInputs in;
  in.surface = &surface;
  in.below = sea.level - state.position.z();
  const Vector3d up_B = state.orientation.conjugate() * Vector3d::UnitZ();
  for (int axis = 0; axis < 3; ++axis) in.up[axis] = up_B[axis];
  const kernel::Node& box = hull.tree.nodes[0];
  if (surface.is_grid())
    for (Eigen::Index v = 0; v < mesh.vertex_count(); ++v) {
      const Vector3d p_W = state.position + state.orientation * mesh.vertices.col(v);
      water.elevation[v] = surface_elevation(sea, p_W.x(), p_W.y(), time);
    }
  else
    water.elevation = kernel::sample_elevation(in, box, mesh.vertices);
  if (!surface.is_airy()) return water;
  Eigen::Matrix3Xd middle(3, mesh.face_count());
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f)
    middle.col(f) = (mesh.vertices.col(mesh.faces(0, f)) + mesh.vertices.col(mesh.faces(1, f)) +
                     mesh.vertices.col(mesh.faces(2, f))) /
                    3;
  water.velocity = state.orientation.toRotationMatrix() * kernel::sample_velocity(in, box, middle);
  return water;
}

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

/// Adds (1) of the wind, per ρ of the water, of a dry panel with the given heights above it.
void add_dry_panel(const Motion& motion, const Panel& panel, const Vector3d& height,
                   LoadJacobian& sum) {
  const Vector3d a = area_vector(panel);
  const double area = a.norm();
  if (area == 0) return;
  const Wind& wind = motion.air->wind;
  const PressureDrag& drag = motion.coefficients.pressure_drag;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vector3d r = (panel[i] + panel[j]) / 2;
    const double factor = wind.factor(std::max(0.0, (height[i] + height[j]) / 2));
    const double u = (motion.twist_in_air.at(r) - factor * wind.velocity).dot(a) / area;
    const double C_p = motion.air_scale * (u > 0 ? drag.front : drag.back);
    add_along(a / area, r, -area / 3 * C_p * std::abs(u), sum.drag);
  }
}

/// Adds the wet parts of all faces, and the dry ones where there is air.
void add_faces(const Hull& hull, const Motion& motion, const BodyState& state, const Sea& sea,
               double time, Pieces pieces, LoadJacobian& sum) {
  const double smallest = pieces == Pieces::coarse ? kCoarsePiece : kSmallestPanel;
  std::optional<HeadError> error;
  if (pieces == Pieces::coarse) error = head_error(hull, {.wave_tolerance = kCoarseError});
  const SurfaceSampler surface(sea, state.position, time, smallest * hull.radius, SplitFor::surface,
                               error);
  const WaterOverHull over = water_over(hull, state, sea, time, smallest);
  const Eigen::Matrix3Xd r = state.orientation.toRotationMatrix() * hull.mesh_B.vertices;
  const double level = sea.level - state.position.z();
  const SurfaceBounds bounds = surface_bounds(sea);
  const double always_wet = sea.level + surface.limits().lowest - state.position.z();
  const double always_dry = bounds.highest - state.position.z();
  for (Eigen::Index f = 0; f < hull.mesh_B.face_count(); ++f) {
    const auto face = hull.mesh_B.faces.col(f);
    const Panel panel = {r.col(face[0]), r.col(face[1]), r.col(face[2])};
    const auto [low, high] = std::minmax({panel[0].z(), panel[1].z(), panel[2].z()});
    if (low >= always_dry && !motion.air) continue;
    const Vector3d water = over.velocity.col(f);
    if (high <= always_wet) {
      add_panel(motion, panel, water, sum);
      continue;
    }
    const auto add_piece = [&](const Panel& piece, const Vector3d& elevation) {
      const Vector3d z(piece[0].z(), piece[1].z(), piece[2].z());
      const Vector3d depth = (elevation - z).array() + level;
      for (const PanelPart& wet : positive_part(piece, depth))
        add_panel(motion, wet.panel, water, sum);
      if (!motion.air) return;
      for (const PanelPart& dry : positive_part(piece, -depth))
        add_dry_panel(motion, dry.panel, dry.value, sum);
    };
    const Vector3d elevation(over.elevation[face[0]], over.elevation[face[1]],
                             over.elevation[face[2]]);
    if (low >= always_dry)
      add_piece(panel, elevation);
    else if (surface.curves(panel))
      for_each_curved_piece(panel, elevation, level, false, surface, add_piece, add_piece);
    else
      for_each_linear_piece(panel, elevation, surface, add_piece);
  }
}

}  // namespace

LoadJacobian load_jacobian(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                           const Coefficients& coefficients, Pieces pieces, double formed) {
  LoadJacobian sum;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Motion motion{
      .coefficients = coefficients,
      .twist = {state.linear_velocity - sea.current, state.angular_velocity},
      .shape = R_WB * coefficients.drag_shape * R_WB.transpose(),
      .scale = formed * drag_scale(coefficients, state, current_at(sea, state.position.z())),
      .air = sea.air ? &*sea.air : nullptr,
      .twist_in_air = {state.linear_velocity, state.angular_velocity},
      .air_scale = sea.air ? sea.air->density / sea.density *
                                 drag_scale(coefficients, state, sea.air->wind.velocity)
                           : 0};
  if (!hull.tree.nodes.empty()) add_faces(hull, motion, state, sea, time, pieces, sum);
  sum.drag *= sea.density;
  sum.waterplane *= coefficients.buoyancy ? sea.density * sea.gravity : 0;
  return sum;
}

}  // namespace hydro

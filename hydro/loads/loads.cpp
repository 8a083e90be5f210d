#include "hydro/loads/loads.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "hydro/loads/kernel/walk.h"
#include "hydro/loads/kernel/water_surface.h"
#include "hydro/loads/wind.h"

namespace hydro {
namespace {

/// A motion slower than this has no drag: its square would be a denormal number, slow to work with
/// [m/s].
constexpr double kLeastSpeed = 1e-120;

/// A hull that dips less deep than this part of its radius counts as dry: roundings are as large.
constexpr double kLeastDip = 1e-13;

/// True if no point of the hull's box is below the highest water.
bool all_dry(const Hull& hull, const kernel::LoadInputs& in, double highest_elevation) {
  const kernel::Node& root = hull.tree.nodes[0];
  double deepest = in.below + highest_elevation;
  for (int axis = 0; axis < 3; ++axis)
    deepest += std::abs(in.up[axis]) * root.half[axis] - in.up[axis] * root.centre[axis];
  return deepest <= kLeastDip * hull.radius;
}

void set(double (&to)[3], const Eigen::Vector3d& v) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = v[axis];
}

void set_motion(const Hull& hull, const Twist& motion_B, double density,
                const Coefficients& coefficients, kernel::LoadInputs& in) {
  set(in.linear, motion_B.linear);
  set(in.angular, motion_B.angular);
  in.slender = !coefficients.drag_shape.isIdentity(0);
  for (int axis = 0; axis < 3; ++axis) set(in.shape[axis], coefficients.drag_shape.row(axis));
  set(in.drag_linear, coefficients.drag_shape * motion_B.linear);
  in.moving = motion_B.linear.norm() + hull.radius * motion_B.angular.norm() > kLeastSpeed;
  in.half_density = 0.5 * density;
  in.drag_front = in.half_density * coefficients.pressure_drag.front;
  in.drag_back = in.half_density * coefficients.pressure_drag.back;
  in.lift = in.half_density * coefficients.lift;
  if (!coefficients.viscous_drag.none()) in.viscous = &coefficients.viscous_drag;
}

Wrench wrench(const kernel::Sums& sums, int which, const Eigen::Matrix3d& R_WB) {
  const auto vector = [&](int from) {
    return Eigen::Vector3d(sums.total(from), sums.total(from + 1), sums.total(from + 2));
  };
  return {R_WB * vector(which), R_WB * vector(which + 3)};
}

/// True unless the area vectors of a mesh leave a gap.
[[maybe_unused]] bool is_closed(const TriMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    sum += area_vector(mesh, f);
    area += area_vector(mesh, f).norm();
  }
  return !(sum.norm() > 1e-9 * area);
}

/// The loads of the water alone.
Loads water_loads(const Hull& hull, const BodyState& state, const kernel::FeltSea& felt,
                  double time, const Coefficients& coefficients, const LoadAccuracy& how) {
  const Sea& sea = felt.all();
  const SurfaceBounds& bounds = felt.bounds();
  if (state.position.z() - hull.radius >= bounds.highest || hull.tree.nodes.empty()) return {};
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  kernel::LoadInputs in;
  in.wet = state.position.z() + hull.radius < bounds.lowest;
  // A constant added to the depth changes nothing on a closed surface. Depths of a wholly submerged
  // one are taken from the level of the centre of mass, so that a deep body loses no digits.
  const bool shifted = in.wet && hull.boundary == Hull::Boundary::closed;
  in.below = shifted ? 0 : sea.level - state.position.z();
  in.branches = how.branches;
  set(in.up, R_WB.row(2));
  if (!in.wet && all_dry(hull, in, bounds.highest - sea.level)) return {};
  set_motion(hull,
             {R_WB.transpose() * (state.linear_velocity - sea.current),
              R_WB.transpose() * state.angular_velocity},
             sea.density, coefficients, in);
  std::optional<kernel::WaterSurface> surface;
  if (!is_flat(sea) || !sea.profile.empty()) {
    surface.emplace(felt, state, time, SplitFor::current);
    surface->hidden_depth = sea.level - state.position.z() - in.below;
    in.surface = &*surface;
    in.moving = in.moving || surface->is_airy();
    in.wave_error = kernel::allowed_wave_error(how.wave_tolerance,
                                               kernel::volume_over_area(hull.tree), *surface);
  }
  const kernel::Sums sums = kernel::sum_hull(hull.panels, hull.tree, in);
  Loads loads{.buoyancy = wrench(sums, kernel::kBuoyancy, R_WB),
              .pressure_drag = wrench(sums, kernel::kPressureDrag, R_WB),
              .viscous_drag = wrench(sums, kernel::kViscousDrag, R_WB),
              .lift = wrench(sums, kernel::kLift, R_WB),
              .wetted_area = sums.total(kernel::kArea)};
  loads.displaced_volume =
      surface && surface->is_airy() ? sums.total(kernel::kVolume) : loads.buoyancy.force.z();
  if (in.slender)
    loads.pressure_drag.force =
        R_WB * (coefficients.drag_shape * (R_WB.transpose() * loads.pressure_drag.force));
  loads.pressure_drag =
      drag_scale(coefficients, state, current_at(sea, state.position.z())) * loads.pressure_drag;
  loads.buoyancy = (coefficients.buoyancy ? sea.density * sea.gravity : 0) * loads.buoyancy;
  return loads;
}

}  // namespace

Loads& Loads::operator+=(const Loads& other) {
  buoyancy += other.buoyancy;
  pressure_drag += other.pressure_drag;
  viscous_drag += other.viscous_drag;
  lift += other.lift;
  wave_inertia += other.wave_inertia;
  diffraction += other.diffraction;
  hull_lift += other.hull_lift;
  wind += other.wind;
  interior += other.interior;
  resistance += other.resistance;
  wetted_area += other.wetted_area;
  displaced_volume += other.displaced_volume;
  return *this;
}

Hull make_hull(TriMesh mesh_B, Hull::Boundary boundary) {
  Hull hull{.mesh_B = std::move(mesh_B), .boundary = boundary};
  if (hull.mesh_B.vertex_count() > 0)
    hull.radius = hull.mesh_B.vertices.colwise().norm().maxCoeff();
  hull.panels = kernel::make_panels(hull.mesh_B);
  hull.tree = kernel::make_tree(hull.panels);
  assert(boundary == Hull::Boundary::open || is_closed(hull.mesh_B));
  return hull;
}

HeadError head_error(const Hull& hull, const LoadAccuracy& how) {
  // The volume of a part of a surface is none: it takes that of a body of its size.
  const double volume_over_area = hull.boundary == Hull::Boundary::closed
                                      ? kernel::volume_over_area(hull.tree)
                                      : hull.radius / 6;
  return {std::max(how.wave_tolerance, kLeastWaveTolerance), volume_over_area};
}

double drag_scale(const Coefficients& coefficients, const BodyState& state,
                  const Eigen::Vector3d& current) {
  if (!coefficients.calibration) return 1;
  const Eigen::Quaterniond to_body = state.orientation.conjugate();
  return drag_factor(*coefficients.calibration, {to_body * (state.linear_velocity - current),
                                                 to_body * state.angular_velocity});
}

Loads compute_loads(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                    const Coefficients& coefficients, const LoadAccuracy& how) {
  if (hull.tree.nodes.empty()) return {};
  const kernel::FeltSea felt(sea, kSmallestPanel * hull.radius, hull.panels.longest_edge,
                             head_error(hull, how), {SplitFor::current});
  return compute_loads(hull, state, felt, time, coefficients, how);
}

std::shared_ptr<const kernel::FeltSea> make_felt_sea(const Hull& hull, const Sea& sea,
                                                     const LoadAccuracy& how) {
  if (hull.tree.nodes.empty()) return nullptr;
  return std::make_shared<const kernel::FeltSea>(
      sea, kSmallestPanel * hull.radius, hull.panels.longest_edge, head_error(hull, how),
      std::initializer_list<SplitFor>{SplitFor::current});
}

Loads compute_loads(const Hull& hull, const BodyState& state, const kernel::FeltSea& felt,
                    double time, const Coefficients& coefficients, const LoadAccuracy& how) {
  assert(is_unit(state.orientation));
  const Sea& sea = felt.all();
  Loads loads = water_loads(hull, state, felt, time, coefficients, how);
  if (sea.air) loads.wind = wind_load(hull, state, sea, time, coefficients);
  return loads;
}

}  // namespace hydro

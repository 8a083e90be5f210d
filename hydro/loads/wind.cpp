#include "hydro/loads/wind.h"

#include <algorithm>
#include <optional>

#include "hydro/loads/kernel/water_surface.h"
#include "hydro/loads/kernel/wind_walk.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Error of a table of the elevation over that of the waterline's chords, at most [-]: as small as
/// the water's loads allow for the head. Drag feels the elevation in first order.
constexpr double kTableOverChord = 1.0 / 12;

/// The motion of a hull, relative to the wind where that is uniform, and what makes drag of it.
kernel::LoadInputs inputs_in_air(const BodyState& state, const Sea& sea,
                                 const Coefficients& coefficients, const Eigen::Matrix3d& R_WB) {
  const Air& air = *sea.air;
  const Vector3d wind = air.wind.uniform() ? air.wind.velocity : Vector3d::Zero();
  kernel::LoadInputs in;
  in.below = sea.level - state.position.z();
  in.above = in.moving = true;
  in.half_density = 0.5 * air.density;
  in.drag_front = in.half_density * coefficients.pressure_drag.front;
  in.drag_back = in.half_density * coefficients.pressure_drag.back;
  Vector3d::Map(in.up) = R_WB.row(2);
  Vector3d::Map(in.linear) = R_WB.transpose() * (state.linear_velocity - wind);
  Vector3d::Map(in.drag_linear) = Vector3d::Map(in.linear);
  Vector3d::Map(in.angular) = R_WB.transpose() * state.angular_velocity;
  return in;
}

/// Height of the top of the hull's box above the centre of mass [m].
double top_of(const Hull& hull, const double (&up)[3]) {
  const kernel::Node& root = hull.tree.nodes[0];
  double top = 0;
  for (int axis = 0; axis < 3; ++axis)
    top += up[axis] * root.centre[axis] + std::abs(up[axis]) * root.half[axis];
  return top;
}

}  // namespace

Wrench wind_load(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                 const Coefficients& coefficients) {
  if (!sea.air || coefficients.pressure_drag.none() || hull.tree.nodes.empty()) return {};
  const double lowest = surface_bounds(sea).lowest - state.position.z();
  if (hull.radius <= lowest) return {};
  const Wind& wind = sea.air->wind;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  kernel::LoadInputs in = inputs_in_air(state, sea, coefficients, R_WB);
  if (top_of(hull, in.up) <= lowest) return {};
  kernel::PowerLaw law{.exponent = wind.exponent, .per_height = 1 / wind.height};
  Vector3d::Map(law.velocity) = R_WB.transpose() * wind.velocity;
  std::optional<kernel::FeltSea> felt;
  std::optional<kernel::WaterSurface> surface;
  if (!is_flat(sea)) {
    felt.emplace(sea, kSmallestPanel * hull.radius, hull.panels.longest_edge, head_error(hull, {}),
                 std::initializer_list<SplitFor>{SplitFor::surface});
    surface.emplace(*felt, state, time, SplitFor::surface);
    surface->table.allowed = kTableOverChord * surface->limits.cut_tolerance;
    in.surface = &*surface;
  }
  const kernel::Sums sums =
      kernel::sum_wind(hull.panels, hull.tree, in, wind.uniform() ? nullptr : &law);
  const auto vector = [&](int from) {
    return Vector3d(R_WB * Vector3d(sums.total(from), sums.total(from + 1), sums.total(from + 2)));
  };
  return drag_scale(coefficients, state, wind.velocity) *
         Wrench{vector(kernel::kPressureDrag), vector(kernel::kPressureDrag + 3)};
}

}  // namespace hydro

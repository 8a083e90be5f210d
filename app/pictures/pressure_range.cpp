#include "app/pictures/pressure_range.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/render/vertex_water.h"
#include "hydro/loads/loads.h"

namespace app {
namespace {

using Found = scene::ScaleEnd::Found;

/// The sea at one time.
struct SeaAtTime {
  const hydro::Sea& sea;
  double time;
  hydro::AiryWaves waves{sea, time};
};

/// Includes a body's pressures. Pressure drag uses the normals of faces, so that flat sides have
/// one pressure.
void include_body(const engine::BodySpec& body, const hydro::BodyState& state, const SeaAtTime& now,
                  scene::ShownPressure shows, PressureRange& range) {
  const hydro::Sea& sea = now.sea;
  const Eigen::Matrix3d R = state.orientation.toRotationMatrix();
  const Eigen::Matrix3Xd r = R * body.mesh_B.vertices;
  const render::VertexWater water =
      render::vertex_water(sea, now.waves, r.colwise() + state.position, now.time);
  const hydro::Twist motion{state.linear_velocity - sea.current, state.angular_velocity};
  const Eigen::Matrix3d K = R * body.coefficients.drag_shape * R.transpose();
  const hydro::PressureDrag& drag = body.coefficients.pressure_drag;
  const double scale =
      shows == scene::ShownPressure::hydrostatic
          ? 0
          : hydro::drag_scale(body.coefficients, state, hydro::current_at(sea, state.position.z()));
  const double gravity = shows == scene::ShownPressure::dynamic ? 0 : sea.gravity;
  for (Eigen::Index face = 0; face < body.mesh_B.face_count(); ++face) {
    const Eigen::Vector3d n = R * hydro::area_vector(body.mesh_B, face).normalized();
    for (int i = 0; i < 3; ++i) {
      const Eigen::Index v = body.mesh_B.faces(i, face);
      if (water.depths[v] <= 0) continue;
      const double u =
          n.dot(K * (motion.linear - water.flow.col(v)) + motion.angular.cross(r.col(v)));
      const double c_p = u > 0 ? drag.front : drag.back;
      range.include(sea.density * (gravity * water.heads[v] + 0.5 * scale * c_p * u * std::abs(u)));
    }
  }
}

render::ColorMap color_map(scene::Colors colors) {
  using render::ColorMap;
  switch (colors) {
    case scene::Colors::turbo:
      return ColorMap::turbo;
    case scene::Colors::viridis:
      return ColorMap::viridis;
    case scene::Colors::cividis:
      return ColorMap::cividis;
    case scene::Colors::coolwarm:
      return ColorMap::coolwarm;
    case scene::Colors::gray:
      return ColorMap::gray;
    case scene::Colors::thesis:
      return ColorMap::thesis;
  }
  throw std::logic_error("unknown colour scale");
}

render::Pressure shown_pressure(scene::ShownPressure shows) {
  switch (shows) {
    case scene::ShownPressure::total:
      return render::Pressure::total;
    case scene::ShownPressure::hydrostatic:
      return render::Pressure::hydrostatic;
    case scene::ShownPressure::dynamic:
      return render::Pressure::dynamic;
  }
  throw std::logic_error("unknown part of the pressure");
}

/// Rounds an end of a scale away from zero to 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of
/// ten.
double rounded_out(double value) {
  if (value == 0) return 0;
  const double size = std::abs(value);
  const double decade = std::pow(10, std::floor(std::log10(size)));
  for (const double step : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (size <= step * decade * (1 + 1e-9)) return std::copysign(step * decade, value);
  return std::copysign(10 * decade, value);
}

}  // namespace

void PressureRange::include(double pressure) {
  lowest = std::min(lowest, pressure);
  highest = std::max(highest, pressure);
}

void PressureRange::include(const PressureRange& other) {
  include(other.lowest);
  include(other.highest);
}

PressureRange pressure_range(const engine::SimulationSpec& spec, const Shot& shot,
                             scene::ShownPressure shows) {
  PressureRange range;
  if (!spec.sea) return range;
  const SeaAtTime now{*spec.sea, shot.time};
  for (std::size_t i = 0; i < spec.bodies.size(); ++i)
    include_body(spec.bodies[i], shot.states[i], now, shows, range);
  return range;
}

PressureRange pressure_range(const engine::SimulationSpec& spec, const ShotSpool& shots,
                             scene::ShownPressure shows) {
  PressureRange range;
  for (std::size_t i = 0; i < shots.size(); ++i)
    range.include(pressure_range(spec, shots.at(i), shows));
  return range;
}

render::PressureScale pressure_scale(const scene::Render& look, const PressureRange& expected,
                                     const PressureRange& drawn) {
  constexpr double kLeastSpan = 1;   // smallest range [Pa], for scenes in which nothing gets wet
  constexpr double kBeyond = 0.005;  // part of the scale beyond an end that is rounding
  const auto given = [](const scene::ScaleEnd& end) { return end.found == Found::given; };
  const auto range_of = [&](const scene::ScaleEnd& end) {
    return end.found == Found::pictures ? drawn : expected;
  };
  double low = given(look.pressure_min) ? look.pressure_min.pressure
                                        : rounded_out(range_of(look.pressure_min).lowest);
  const double top = range_of(look.pressure_max).highest;
  double high = given(look.pressure_max) ? look.pressure_max.pressure
                : top > low + kLeastSpan ? rounded_out(top)
                                         : std::max(low + 1000, 0.0);
  if (scene::diverges(look.colors)) {
    const bool low_given = given(look.pressure_min), high_given = given(look.pressure_max);
    if (!low_given && !high_given) high = std::max({-low, high, kLeastSpan});
    if (!low_given && high > 0) low = -high;
    if (low_given && !high_given && low < 0) high = -low;
  }
  if (low >= high) low = high - 1000;
  const double slack = kBeyond * (high - low);
  return {.min = low,
          .max = high,
          .colors = color_map(look.colors),
          .shows = shown_pressure(look.shows),
          .below = drawn.lowest<low - slack, .above = drawn.highest> high + slack};
}

}  // namespace app

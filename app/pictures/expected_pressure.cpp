#include "app/pictures/expected_pressure.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/motion/locks.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/statics/equilibrium.h"

namespace app {
namespace {

/// Effect of waves at the surface.
struct WaveSize {
  double height = 0;  ///< Height above the level [m].
  double speed = 0;   ///< Speed of the water [m/s].
};

WaveSize wave_size(const hydro::Sea& sea) {
  if (const auto* field = std::get_if<hydro::HeightField>(&sea.surface))
    return {.height = std::max(0.0, field->heights.maxCoeff())};
  WaveSize size;
  if (const auto* waves = std::get_if<hydro::WaveSurface>(&sea.surface)) {
    double heights = 0, speeds = 0;
    for (const hydro::WaveComponent& wave : waves->components) {
      heights += std::pow(wave.amplitude, 2);
      speeds += std::pow(wave.amplitude * wave.omega, 2);
    }
    size = {.height = std::sqrt(2 * heights), .speed = std::sqrt(2 * speeds)};
  }
  return size;
}

/// A body at its start above and below the level of the sea [m].
struct Start {
  double draught = 0;  ///< Depth of its lowest point, < 0 above the water.
  double height = 0;   ///< From its lowest to its highest point.
};

Start start_of(const engine::BodySpec& body, const hydro::Sea& sea) {
  const Eigen::RowVectorXd z =
      body.initial.orientation.toRotationMatrix().row(2) * body.mesh_B.vertices;
  return {.draught = sea.level - body.initial.position.z() - z.minCoeff(),
          .height = z.maxCoeff() - z.minCoeff()};
}

/// How joints hold a body.
enum class Hold { free, jointed, fixed };

Hold hold_of(const engine::SimulationSpec& spec, std::size_t body) {
  const auto id = static_cast<engine::BodyId>(body);
  if (engine::immovable(spec.bodies[body].locked)) return Hold::fixed;
  Hold hold = Hold::free;
  for (const engine::JointSpec& joint : spec.joints) {
    if (joint.first != id && joint.second != id) continue;
    if (joint.type == engine::JointSpec::Type::fixed) return Hold::fixed;
    hold = Hold::jointed;
  }
  return hold;
}

/// Returns z of the lowest ground [m]; none without ground.
std::optional<double> lowest_ground(const engine::Ground& ground) {
  if (const auto* plane = std::get_if<engine::PlaneGround>(&ground)) return plane->z;
  if (const auto* mesh = std::get_if<engine::MeshGround>(&ground))
    return mesh->mesh_W.vertices.row(2).minCoeff();
  return std::nullopt;
}

/// Returns the greatest depth to expect of a body's surface below the surface of the water [m].
double expected_depth(const engine::SimulationSpec& spec, std::size_t index,
                      const WaveSize& waves) {
  const hydro::Sea& sea = *spec.sea;
  const engine::BodySpec& body = spec.bodies[index];
  const Start start = start_of(body, sea);
  const Hold hold = hold_of(spec, index);
  if (hold == Hold::fixed) return start.draught + waves.height;
  const double depth = std::max(start.draught, start.draught < 0 ? start.height : 0);
  if (hold == Hold::jointed) return depth + waves.height;
  const double displaced = body.mass / sea.density;
  const double volume = hydro::solid_properties(engine::outside_B(body)).volume;
  if (displaced < volume) {
    const double draught =
        hydro::afloat(engine::outside_B(body), displaced, body.initial.orientation).draught;
    // A body that floats goes with the waves: they wet it up to its highest point.
    return std::max(depth, draught + std::clamp(start.height - draught, 0.0, waves.height));
  }
  if (const std::optional<double> ground = lowest_ground(spec.ground))
    return std::max(depth, sea.level - *ground) + waves.height;
  return std::max(depth, 2 * start.height) + waves.height;
}

/// Returns the greatest speed through the water to expect of a body [m/s].
double expected_speed(const engine::SimulationSpec& spec, const engine::BodySpec& body,
                      const WaveSize& waves) {
  const hydro::Sea& sea = *spec.sea;
  const double length = hydro::bounding_box(body.mesh_B).diagonal().norm();
  const double ahead = (body.initial.linear_velocity - sea.current).norm();
  if (engine::immovable(body.locked)) return std::max(ahead, waves.speed);
  const double fall = std::max(0.0, -start_of(body, sea).draught);
  return std::max({std::sqrt(ahead * ahead + 2 * sea.gravity * fall), waves.speed,
                   std::sqrt(sea.gravity * length) / 4});
}

}  // namespace

PressureRange expected_pressure(const engine::SimulationSpec& spec, scene::ShownPressure shows) {
  PressureRange range;
  if (!spec.sea) return range;
  const hydro::Sea& sea = *spec.sea;
  const WaveSize waves = wave_size(sea);
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    const engine::BodySpec& body = spec.bodies[i];
    if (shows != scene::ShownPressure::dynamic)
      range.include(sea.density * sea.gravity * expected_depth(spec, i, waves));
    if (shows == scene::ShownPressure::hydrostatic) continue;
    const double head = 0.5 * sea.density * std::pow(expected_speed(spec, body, waves), 2);
    range.include(head * body.coefficients.pressure_drag.front);
    range.include(-head * body.coefficients.pressure_drag.back);
  }
  return range;
}

}  // namespace app

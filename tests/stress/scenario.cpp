#include "tests/stress/scenario.h"

#include <fmt/format.h>

#include <stdexcept>

#include "app/assembly/envelope.h"
#include "tests/stress/arrangement.h"
#include "tests/stress/rigging.h"
#include "tests/stress/shapes.h"
#include "tests/stress/waters.h"

namespace stress {
namespace {

constexpr double kWater = 1000;           // [kg/m^3]
constexpr double kViscosity = 1.0034e-6;  // [m^2/s]

hydro::Coefficients coefficients(const std::string& name) {
  hydro::Coefficients c{.lift = 0};
  if (name == "default") return c;
  if (name == "thesis") {
    c = hydro::thesis_coefficients();
    c.lift = 0;
  } else if (name == "none") {
    c.pressure_drag = {0, 0};
    c.viscous_drag.law = hydro::ViscousDrag::Law::none;
  } else if (name == "lift") {
    c.lift = hydro::thesis_coefficients().lift;
  } else if (name == "x100" || name == "x100lift") {
    c.pressure_drag = {100 * c.pressure_drag.front, 100 * c.pressure_drag.back};
    c.viscous_drag = {.law = hydro::ViscousDrag::Law::constant, .coefficient = 10};
    c.lift = name == "x100" ? 0 : 100 * hydro::thesis_coefficients().lift;
  } else {
    throw std::invalid_argument(fmt::format("'{}' is no set of coefficients", name));
  }
  return c;
}

Eigen::Vector3d direction(const std::string& entry) {
  if (entry == "down") return -Eigen::Vector3d::UnitZ();
  if (entry == "slant") return Eigen::Vector3d(0.7, 0.1, -0.7).normalized();
  if (entry == "skim") return Eigen::Vector3d(0.98, 0.17, -0.1).normalized();
  throw std::invalid_argument(fmt::format("'{}' is no direction of entry", entry));
}

/// Returns the initial orientation: as many symmetry planes as possible are vertical (flat), or
/// none is (tilted).
Eigen::Quaterniond orientation(const std::string& pose) {
  if (pose == "flat") return Eigen::Quaterniond::Identity();
  if (pose == "tilted")
    return Eigen::Quaterniond(
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.48, 0.36, 0.8).normalized()));
  throw std::invalid_argument(fmt::format("'{}' is no pose", pose));
}

/// Returns the initial height of the centre of mass [m].
double height(const RunName& run, double size, double reach_down) {
  const std::string& start = run[Key::start];
  if (start == "above") return reach_down + 0.01 * size;
  if (start == "half") return 0;
  if (start == "deep") return -3 * size;
  throw std::invalid_argument(fmt::format("'{}' is no place to start", start));
}

engine::BodySpec make_body(const RunName& run, const Shape& shape, double size,
                           const hydro::Sea& sea) {
  engine::BodySpec body{.name = "body", .mesh_B = shape.mesh_B};
  body.interior = engine::Interior::flooding;
  body.closed_mesh_B = shape.closed_mesh_B;
  body.mass = run.number(Key::density) * kWater * shape.volume;
  body.inertia_B = body.mass * shape.inertia;
  body.coefficients = hydro::for_mesh(coefficients(run[Key::coefs]), body.mesh_B, kViscosity);
  add_inertia_of_water(run[Key::added], run[Key::shape], size, sea, run.number(Key::step), body);
  hydro::BodyState& state = body.initial;
  state.orientation = orientation(run[Key::pose]);
  state.position.z() = height(run, size, -lowest(body));
  state.linear_velocity = run.number(Key::speed) * direction(run[Key::entry]);
  state.angular_velocity = run.number(Key::spin) * Eigen::Vector3d(0.36, 0.48, 0.8);
  return body;
}

}  // namespace

Scenario make_scenario(const RunName& run) {
  Scenario scenario{.size = run.number(Key::size)};
  const Shape shape = make_shape(run[Key::shape], scenario.size);
  scenario.volume = shape.volume;
  scenario.steps = static_cast<long>(run.number(Key::steps));
  scenario.spec.step = run.number(Key::step);
  scenario.spec.sea = make_water(run[Key::water], scenario.size);
  arrange(run[Key::with], make_body(run, shape, scenario.size, *scenario.spec.sea), scenario);
  const engine::BodySpec& body = scenario.spec.bodies[0];
  const bool simulated = run[Key::added] == "simulated";
  if (simulated)
    scenario.spec.water =
        engine::WaterGrid{.square = square_for(body, *scenario.spec.sea, scenario.spec.step)};
  scenario.inside = assembly::inside_envelope(scenario.spec);
  const bool streams = !scenario.spec.sea->current.isZero(0);
  const bool freely = run[Key::with] == "free";
  scenario.passive = hydro::is_flat(*scenario.spec.sea) && body.coefficients.lift == 0 &&
                     (!streams || freely) && !gives_energy(run[Key::with]) && !simulated;
  return scenario;
}

}  // namespace stress

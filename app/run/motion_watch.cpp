#include "app/run/motion_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/run/radiation_warning.h"
#include "app/run/wave_warning.h"
#include "engine/motion/locks.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/resistance/thin_ship.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// Returns true if something beside the water moves the body; a pin in the world holds it.
bool is_driven(const engine::SimulationSpec& spec, engine::BodyId id) {
  const auto on_it = [id](const auto& machine) { return machine.body == id; };
  const auto pulls = [id](const engine::JointSpec& joint) {
    const bool pins = joint.type != engine::JointSpec::Type::slider &&
                      (joint.first == engine::kWorld || joint.second == engine::kWorld);
    return (joint.first == id || joint.second == id) && !pins;
  };
  const auto held = [id](const engine::LineSpec& line) {
    return line.first.body == id || line.second.body == id;
  };
  return !spec.bodies[static_cast<std::size_t>(id)].loads.empty() ||
         std::ranges::any_of(spec.propellers, on_it) || std::ranges::any_of(spec.foils, on_it) ||
         std::ranges::any_of(spec.joints, pulls) || std::ranges::any_of(spec.lines, held);
}

/// Returns true if the body is lighter than the water that it can displace.
bool can_float(const engine::BodySpec& body, const hydro::Sea& sea) {
  return body.wet && body.coefficients.buoyancy && !engine::immovable(body.locked) &&
         body.mass < sea.density * hydro::solid_properties(engine::outside_B(body)).volume;
}

/// Returns true if the still water level cuts the body.
bool is_in_surface(const engine::BodySpec& body, const hydro::BodyState& state, double level) {
  const Eigen::RowVector3d up = state.orientation.toRotationMatrix().row(2);
  const Eigen::RowVectorXd z = up * body.mesh_B.vertices;
  return state.position.z() + z.minCoeff() < level && level < state.position.z() + z.maxCoeff();
}

/// Returns true for the sides of a hull that thin-ship theory knows.
bool is_slender(const Eigen::Vector3d& sides) {
  const auto [least, largest] = std::minmax(sides.x(), sides.y());
  return largest >= hydro::kLeastThinShip * least;
}

/// Says what theory does not know of a hull with radiation under way.
std::string what_is_unknown(bool simulated, bool slender) {
  if (!simulated)
    return ", and its waves are known without forward speed: hydro.radiation: none leaves them out";
  return slender
             ? ": simulated water has its resistance by waves, but its heave and pitch in waves "
               "may be wrong by half"
             : ", and simulated water has the waves of a thin ship for it, which it is not";
}

Eigen::Vector2d speed_in_water(const hydro::Sea& sea, const hydro::BodyState& state) {
  return (state.linear_velocity - sea.current).head<2>();
}

}  // namespace

MotionWatch::MotionWatch(const assembly::BuiltScene& built) : built_(built) {
  const engine::SimulationSpec& spec = built.spec;
  if (!spec.sea || spec.sea->gravity == 0) return;
  const hydro::Sea& sea = *spec.sea;
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    const engine::BodySpec& body = spec.bodies[i];
    const Eigen::Matrix3Xd at =
        body.initial.orientation.toRotationMatrix() * engine::outside_B(body).vertices;
    const Eigen::Vector3d sides = at.rowwise().maxCoeff() - at.rowwise().minCoeff();
    const double length = std::max(sides.x(), sides.y());
    const bool driven = can_float(body, sea) && is_driven(spec, static_cast<engine::BodyId>(i));
    Speed speed{.length = length,
                .memory = hydro::time_of_mean_speed(sea, length),
                .makes_waves = body.radiation && !(body.sources && is_slender(sides) &&
                                                   !hydro::changes_with_time(sea)),
                .slender = is_slender(sides),
                .planing = kPlaningFroudeNumber *
                           std::sqrt(sea.gravity * std::cbrt(body.mass / sea.density)),
                .lacks_resistance = driven && !body.resistance && !body.sources,
                .may_plane = driven,
                .mean = speed_in_water(sea, body.initial)};
    // Such a start is told with the scene.
    if (speed.makes_waves && !body.sources &&
        assembly::froude_number(sea, speed.mean.norm(), length) > assembly::kLargestFroudeNumber)
      speed.makes_waves = false;
    speeds_.push_back(speed);
  }
}

std::vector<std::string> MotionWatch::after_step(double time,
                                                 const std::vector<hydro::BodyState>& states) {
  std::vector<std::string> warnings;
  const engine::SimulationSpec& spec = built_.spec;
  if (!waves_told_) {
    auto warning = wave_warning(spec, states);
    if (!warning) warning = radiation_warning(spec, states);
    waves_told_ = warning.has_value();
    if (warning) warnings.push_back(*std::move(warning));
  }
  for (std::size_t i = 0; i < speeds_.size(); ++i)
    if (speeds_[i].makes_waves || speeds_[i].lacks_resistance || speeds_[i].may_plane)
      add_speed_warnings(i, time, states[i], warnings);
  return warnings;
}

void MotionWatch::add_speed_warnings(std::size_t body, double time, const hydro::BodyState& state,
                                     std::vector<std::string>& warnings) {
  const hydro::Sea& sea = *built_.spec.sea;
  Speed& speed = speeds_[body];
  const double part = -std::expm1(-built_.spec.step / speed.memory);
  speed.mean += part * (speed_in_water(sea, state) - speed.mean);
  const double froude = assembly::froude_number(sea, speed.mean.norm(), speed.length);
  const auto told = [&](const char* number, double bound) {
    return fmt::format(
        "body '{}' goes through the water at {:.2g} m/s at {:.4g} s, a {} above {:g}",
        built_.spec.bodies[body].name, speed.mean.norm(), time, number, bound);
  };
  const auto in_surface = [&] { return is_in_surface(built_.spec.bodies[body], state, sea.level); };
  if (speed.makes_waves && froude > assembly::kLargestFroudeNumber) {
    speed.makes_waves = false;
    warnings.push_back(told("Froude number", assembly::kLargestFroudeNumber) +
                       what_is_unknown(built_.spec.bodies[body].sources != nullptr, speed.slender));
  }
  if (speed.lacks_resistance && froude > kWaveMakingFroudeNumber && in_surface()) {
    speed.lacks_resistance = false;
    warnings.push_back(told("Froude number", kWaveMakingFroudeNumber) +
                       ": the resistance by the waves that a hull makes is not computed, and it "
                       "goes too fast for its drive; hydro.resistance gives it one");
  }
  if (speed.may_plane && speed.mean.norm() > speed.planing && in_surface()) {
    speed.may_plane = false;
    warnings.push_back(told("volume Froude number", kPlaningFroudeNumber) +
                       ", at which hulls begin to plane: what the speed of the water does to their "
                       "bottom, lift and trim, is not computed");
  }
}

Json MotionWatch::state() const {
  Json speeds = Json::array();
  for (const Speed& speed : speeds_)
    speeds.push_back({speed.makes_waves, speed.lacks_resistance, speed.mean.x(), speed.mean.y(),
                      speed.may_plane});
  return {{"waves_told", waves_told_}, {"speeds", speeds}};
}

void MotionWatch::restore(const Json& state) {
  waves_told_ = state.at("waves_told").get<bool>();
  const Json& speeds = state.at("speeds");
  for (std::size_t i = 0; i < speeds_.size(); ++i) {
    speeds_[i].makes_waves = speeds.at(i).at(0).get<bool>();
    speeds_[i].lacks_resistance = speeds.at(i).at(1).get<bool>();
    speeds_[i].mean = {speeds.at(i).at(2).get<double>(), speeds.at(i).at(3).get<double>()};
    speeds_[i].may_plane = speeds.at(i).at(4).get<bool>();
  }
}

}  // namespace app

#include "app/fmu/interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "app/held/units.h"
#include "app/scene/rig_names.h"
#include "engine/motion/locks.h"

namespace fmu {
namespace {

constexpr std::size_t kLoads = 6;
constexpr const char* kLoadNames[kLoads] = {"force_x",  "force_y",  "force_z",
                                            "torque_x", "torque_y", "torque_z"};

bool is_driven(const engine::SimulationSpec& spec, std::size_t set_point) {
  return std::ranges::any_of(spec.controls, [&](const engine::ControlSpec& control) {
    return static_cast<std::size_t>(control.set) == set_point;
  });
}

}  // namespace

Interface::Interface(const scene::Scene& scene, const app::HeldSimulation& simulation) {
  add_set_points(scene, simulation.engine().spec());
  add_loads(simulation.engine().spec());
  add_outputs(scene, simulation);
}

void Interface::add_set_points(const scene::Scene& scene, const engine::SimulationSpec& spec) {
  const std::vector<scene::SetPoint> known = scene::set_points(scene);
  for (std::size_t i = 0; i < spec.set_points.size(); ++i) {
    const engine::SetPointSpec& point = spec.set_points[i];
    const bool driven = is_driven(spec, i);
    inputs_.push_back(
        {.name = point.name,
         .units = app::units_of(*scene::find_named(known, point.name), scene),
         .description = driven ? "set point; NaN leaves it to the scene's control" : "set point",
         .start = driven ? std::numeric_limits<double>::quiet_NaN() : point.initial / point.unit});
  }
  set_points_ = spec.set_points.size();
}

void Interface::add_loads(const engine::SimulationSpec& spec) {
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    if (engine::immovable(spec.bodies[i].locked)) continue;
    movable_.push_back(static_cast<engine::BodyId>(i));
    for (std::size_t k = 0; k < kLoads; ++k)
      inputs_.push_back({.name = spec.bodies[i].name + "." + kLoadNames[k],
                         .units = k < 3 ? "N" : "N m",
                         .description = k < 3 ? "force at the centre of mass, in the world"
                                              : "torque in the world"});
  }
}

void Interface::add_outputs(const scene::Scene& scene, const app::HeldSimulation& simulation) {
  const app::Observables observables(scene, simulation);
  const std::vector<std::string> names = observables.names(), units = observables.units();
  std::set<std::string> taken;
  for (const Variable& input : inputs_) taken.insert(input.name);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = taken.contains(names[i]) ? names[i] + ".reading" : names[i];
    outputs_.push_back({.name = name, .units = units[i]});
  }
  observer_ = app::Observer(observables, names);
}

void Interface::apply(std::size_t input, std::span<const double> values,
                      app::HeldSimulation& simulation) const {
  if (input < set_points_) {
    const auto id = static_cast<engine::SetPointId>(input);
    // A start value in the unit of its name may be the initial value but for its last digit.
    const bool release = std::isnan(values[input]) || values[input] == inputs_[input].start;
    return release ? simulation.release(id) : simulation.set(id, values[input]);
  }
  if (!std::isfinite(values[input]))
    throw std::invalid_argument(
        fmt::format("the value of '{}' is not finite", inputs_[input].name));
  const std::size_t owner = (input - set_points_) / kLoads;
  const auto load = values.subspan(set_points_ + owner * kLoads, kLoads);
  const engine::BodyId body = movable_[owner];
  if (std::ranges::all_of(load, [](double number) { return number == 0; }))
    return simulation.let_go(body);
  simulation.hold(body, {.wrench = {.force = Eigen::Vector3d(load[0], load[1], load[2]),
                                    .moment = Eigen::Vector3d(load[3], load[4], load[5])}});
}

std::vector<double> Interface::read(const app::HeldSimulation& simulation) const {
  std::vector<double> numbers(observer_.size());
  observer_.read(simulation, numbers.data());
  return numbers;
}

}  // namespace fmu

#include "engine/base/state_checks.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "engine/base/constants.h"
#include "engine/base/spatial_vector.h"

namespace engine {
namespace {

constexpr const char* kAxes[] = {"x", "y", "z"};

std::optional<std::string> vector_fault(const char* name, const Eigen::Vector3d& vector) {
  for (int i = 0; i < 3; ++i)
    if (!(std::abs(vector[i]) <= kLargestState))
      return fmt::format("the {}'s {} is {:g}{}", name, kAxes[i], vector[i],
                         std::isfinite(vector[i]) ? ", beyond all bounds" : "");
  return std::nullopt;
}

using NamedLoad = std::pair<std::string, Vector6d>;

constexpr const char* kComponents[] = {"force x",  "force y",  "force z",
                                       "moment x", "moment y", "moment z"};

std::vector<NamedLoad> by_name(const BodyLoads& loads) {
  std::vector<NamedLoad> named;
  for (std::size_t i = 0; i < loads.applied.size(); ++i)
    named.emplace_back(fmt::format("applied load {}", i + 1), to_vector6(loads.applied[i]));
  const hydro::Loads& water = loads.water;
  named.insert(named.end(), {{"buoyancy", to_vector6(water.buoyancy)},
                             {"pressure drag", to_vector6(water.pressure_drag)},
                             {"viscous drag", to_vector6(water.viscous_drag)},
                             {"lift", to_vector6(water.lift)},
                             {"wave inertia", to_vector6(water.wave_inertia)},
                             {"diffraction", to_vector6(water.diffraction)},
                             {"hull lift", to_vector6(water.hull_lift)},
                             {"wind", to_vector6(water.wind)},
                             {"water inside", to_vector6(water.interior)},
                             {"resistance", to_vector6(water.resistance)},
                             {"weight", to_vector6(loads.weight)},
                             {"lines", to_vector6(loads.lines)},
                             {"machines", to_vector6(loads.machines)}});
  return named;
}

}  // namespace

std::optional<std::string> state_fault(const hydro::BodyState& state) {
  if (auto fault = vector_fault("position", state.position)) return fault;
  if (auto fault = vector_fault("linear velocity", state.linear_velocity)) return fault;
  if (auto fault = vector_fault("angular velocity", state.angular_velocity)) return fault;
  if (!state.orientation.coeffs().allFinite()) return "the orientation is not finite";
  return std::nullopt;
}

std::optional<std::string> motion_fault(const BodySpec& body, const hydro::BodyState& state,
                                        const hydro::Wrench& load, double step) {
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Eigen::Vector3d moment_B = R_WB.transpose() * load.moment;
  hydro::BodyState next = state;
  next.linear_velocity += step / body.mass * load.force;
  next.angular_velocity += step * (R_WB * (body.inertia_B.inverse() * moment_B));
  next.position += step * next.linear_velocity;
  return state_fault(next);
}

hydro::Wrench BodyLoads::total() const {
  hydro::Wrench sum = water.total() + weight + lines + machines;
  for (const hydro::Wrench& load : applied) sum += load;
  return sum;
}

std::string load_fault(const BodyLoads& loads) {
  for (const auto& [name, load] : by_name(loads))
    for (int i = 0; i < 6; ++i)
      if (!std::isfinite(load[i]))
        return fmt::format("the {} of {} is {}", kComponents[i], name, load[i]);
  return "the sum of the loads is not finite";
}

std::string largest_load(const BodyLoads& loads) {
  double largest = 0;
  std::string text = "no load acted on it";
  for (const auto& [name, load] : by_name(loads)) {
    for (int i = 0; i < 6; ++i) {
      if (std::abs(load[i]) <= largest) continue;
      largest = std::abs(load[i]);
      text = fmt::format("the largest load was {}, {} = {:g} {}", name, kComponents[i], load[i],
                         i < 3 ? "N" : "N m");
    }
  }
  return text;
}

}  // namespace engine

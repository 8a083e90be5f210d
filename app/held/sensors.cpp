#include "app/held/sensors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "hydro/water/simulated_water.h"

namespace app {
namespace {

using Eigen::Vector3d;

// Numbers of a gauge at the surface, of one with a depth, and of a point of a body.
constexpr std::size_t kOfSurface = 4, kOfWater = 10, kOnBoard = 16;
const char* const kColumns[kOnBoard] = {
    "elevation", "x",  "y",  "z",  "vx", "vy",         "vz",         "ax",
    "ay",        "az", "wx", "wy", "wz", "specific_x", "specific_y", "specific_z"};

std::size_t width_of(const scene::Probe& probe) {
  if (probe.body) return kOnBoard;
  return probe.depth ? kOfWater : kOfSurface;
}

void append(const Vector3d& vector, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), vector.begin(), vector.end());
}

}  // namespace

Sensors::Sensors(const SensorSpec& sensors, const engine::SimulationSpec& spec)
    : probes_(sensors.probes), readings_(sensors.probes, spec, sensors.centers_of_mass) {
  for (const scene::Probe& probe : probes_) {
    const auto body =
        std::ranges::find(spec.bodies, probe.body.value_or(""), &engine::BodySpec::name);
    bodies_.push_back(probe.body ? static_cast<std::size_t>(body - spec.bodies.begin()) : 0);
  }
}

std::vector<std::string> Sensors::columns(std::size_t probe) const {
  return {kColumns, kColumns + width_of(probes_[probe])};
}

std::vector<std::vector<double>> Sensors::read(const engine::Simulation& simulation) const {
  const double time = simulation.time();
  const hydro::SimulatedWater* water = simulation.water();
  const auto waves = water ? water->patch(time) : std::nullopt;
  std::vector<std::vector<double>> numbers;
  for (const ProbeReading& reading : readings_.read(time, simulation.states(), waves)) {
    const std::size_t probe = numbers.size();
    if (probes_[probe].body)
      numbers.push_back(read_on_board(reading, probe, simulation));
    else
      numbers.emplace_back(reading.begin(), reading.begin() + width_of(probes_[probe]));
  }
  return numbers;
}

std::vector<double> Sensors::read_on_board(const ProbeReading& reading, std::size_t probe,
                                           const engine::Simulation& simulation) const {
  const hydro::BodyState& state = simulation.states()[bodies_[probe]];
  const Eigen::Quaterniond to_body = state.orientation.conjugate();
  const Eigen::Map<const Vector3d> velocity(&reading[4]), change(&reading[7]);
  const Vector3d acceleration = change.hasNaN() ? Vector3d::Zero() : Vector3d(change);
  std::vector<double> numbers(reading.begin(), reading.begin() + kOfSurface);
  append(to_body * velocity, numbers);
  append(to_body * acceleration, numbers);
  append(to_body * state.angular_velocity, numbers);
  append(to_body * (acceleration + simulation.spec().gravity * Vector3d::UnitZ()), numbers);
  return numbers;
}

}  // namespace app

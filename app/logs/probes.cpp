#include "app/logs/probes.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "hydro/airy_waves.h"

namespace app {
namespace {

using Eigen::Vector3d;

ProbeReading nothing_read() {
  ProbeReading reading;
  reading.fill(std::numeric_limits<double>::quiet_NaN());
  return reading;
}

/// First columns of the vectors of a reading.
enum Column : std::size_t { kElevation = 0, kPosition = 1, kVelocity = 4, kAcceleration = 7 };

void put(const Vector3d& vector, Column first, ProbeReading& reading) {
  std::copy_n(vector.data(), 3, reading.begin() + first);
}

/// Vector from the centre of mass to a point of a body, in W [m].
Vector3d arm(const Vector3d& at_B, const hydro::BodyState& state) {
  return state.orientation * at_B;
}

Vector3d velocity_at(const Vector3d& at_B, const hydro::BodyState& state) {
  return state.linear_velocity + state.angular_velocity.cross(arm(at_B, state));
}

}  // namespace

Probes::Probes(const std::vector<scene::Probe>& probes, const engine::SimulationSpec& spec,
               const std::vector<Vector3d>& centers_of_mass)
    : spec_(spec) {
  for (const scene::Probe& probe : probes) {
    if (probe.wave) {
      const double z = spec_.sea->level - probe.depth.value_or(0);
      points_.push_back(
          {.body = {}, .at = {probe.wave->x(), probe.wave->y(), z}, .on_surface = !probe.depth});
      continue;
    }
    const auto body = std::ranges::find(spec_.bodies, *probe.body, &engine::BodySpec::name);
    const auto index = static_cast<std::size_t>(body - spec_.bodies.begin());
    points_.push_back({.body = index, .at = probe.at - centers_of_mass[index]});
  }
}

void Probes::before_step(const std::vector<hydro::BodyState>& states) {
  velocities_before_.assign(points_.size(), Vector3d::Zero());
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[i].body)
      velocities_before_[i] = velocity_at(points_[i].at, states[*points_[i].body]);
}

void Probes::set_velocities_before(std::vector<Vector3d> velocities) {
  assert(velocities.empty() || velocities.size() == points_.size());
  velocities_before_ = std::move(velocities);
}

std::vector<ProbeReading> Probes::read(double time, const std::vector<hydro::BodyState>& states,
                                       const std::optional<hydro::SurfacePatch>& waves) const {
  const auto raise_at = [&](const Vector3d& p_W) {
    return waves ? waves->at(p_W.x(), p_W.y()) : 0;
  };
  std::vector<ProbeReading> readings;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& point = points_[i];
    if (!point.body) {
      readings.push_back(read_water(point, time, raise_at(point.at)));
      continue;
    }
    const hydro::BodyState& state = states[*point.body];
    const double raise = raise_at(state.position + arm(point.at, state));
    readings.push_back(read_body(point, time, raise, state));
    if (velocities_before_.empty()) continue;
    const Vector3d change = velocity_at(point.at, state) - velocities_before_[i];
    put(change / spec_.step, kAcceleration, readings.back());
  }
  return readings;
}

/// @param raise   Rise of the surface by the waves of bodies [m].
ProbeReading Probes::read_water(const Point& point, double time, double raise) const {
  const hydro::Sea& sea = *spec_.sea;
  ProbeReading reading = nothing_read();
  Vector3d p_W = point.at;
  const double elevation = hydro::surface_elevation(sea, p_W.x(), p_W.y(), time) + raise;
  if (point.on_surface) p_W.z() = sea.level + elevation;
  reading[kElevation] = elevation;
  put(p_W, kPosition, reading);
  if (point.on_surface || elevation + (sea.level - p_W.z()) < 0) return reading;
  const hydro::WaterMotion water = hydro::water_at(sea, p_W, time);
  put(water.velocity, kVelocity, reading);
  put(water.acceleration, kAcceleration, reading);
  return reading;
}

ProbeReading Probes::read_body(const Point& point, double time, double raise,
                               const hydro::BodyState& state) const {
  ProbeReading reading = nothing_read();
  const Vector3d p_W = state.position + arm(point.at, state);
  if (spec_.sea)
    reading[kElevation] = hydro::surface_elevation(*spec_.sea, p_W.x(), p_W.y(), time) + raise;
  put(p_W, kPosition, reading);
  put(velocity_at(point.at, state), kVelocity, reading);
  return reading;
}

}  // namespace app

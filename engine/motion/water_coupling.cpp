#include "engine/motion/water_coupling.h"

#include <algorithm>
#include <cmath>

#include "engine/base/stopwatch.h"
#include "engine/motion/locks.h"

namespace engine {
namespace {

std::vector<hydro::BodyState> states_of(const std::vector<MovingBody>& bodies) {
  std::vector<hydro::BodyState> states;
  for (const MovingBody& moving : bodies) states.push_back(moving.motion.state);
  return states;
}

}  // namespace

std::vector<hydro::WaterBody> bodies_in_water(const SimulationSpec& spec) {
  const bool water_flows = hydro::changes_with_time(*spec.sea) || !spec.sea->current.isZero(0);
  std::vector<hydro::WaterBody> bodies;
  for (const BodySpec& body : spec.bodies) {
    hydro::WaterBody& in_water = bodies.emplace_back();
    if (!body.wet || (immovable(body.locked) && !water_flows && !spec.water)) continue;
    in_water.mesh_B = &outside_B(body);
    in_water.radius = in_water.mesh_B->vertices.colwise().norm().maxCoeff();
    in_water.hull = body.sources;
    in_water.floating = body.radiation;
  }
  return bodies;
}

WaterCoupling::WaterCoupling(const SimulationSpec& spec)
    : spec_(spec),
      water_(*spec.sea, bodies_in_water(spec), spec.water->square, spec.water->edge),
      steps_(std::max(1L, static_cast<long>(water_.longest_step() / spec.step))) {}

void WaterCoupling::begin_step(long number, std::vector<MovingBody>& bodies, double& seconds) {
  if (number % steps_ != 0) return;
  const Stopwatch stopwatch(seconds);
  const double time = static_cast<double>(number) * spec_.step;
  const double root = std::sqrt(spec_.sea->density);
  const std::vector<hydro::WavesOnHull> waves =
      water_.begin(time, static_cast<double>(steps_) * spec_.step, states_of(bodies));
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].motion.water)
      begin_water_step(bodies[i], time,
                       {.load = root * waves[i].load, .momentum = root * waves[i].momentum});
}

void WaterCoupling::end_step(long number, const std::vector<MovingBody>& bodies, double& seconds) {
  if ((number + 1) % steps_ != 0) return;
  const Stopwatch stopwatch(seconds);
  const double root = std::sqrt(spec_.sea->density);
  std::vector<hydro::Vector6d> displacements(bodies.size(), Vector6d::Zero());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].motion.water) displacements[i] = bodies[i].motion.water->displacement / root;
  water_.end(states_of(bodies), displacements);
}

}  // namespace engine

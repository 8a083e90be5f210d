#include "engine/motion/wave_memory.h"

#include <cassert>
#include <cmath>

#include "engine/motion/velocity_update.h"
#include "hydro/radiation/floating_body.h"

namespace engine {
namespace {

const hydro::RadiationMemory& oscillators(const Body& body) {
  return body.spec->radiation->memory();
}

WaveMemoryRule make_rule(const hydro::RadiationMemory& memory, double h) {
  const Eigen::VectorXd& d = memory.damping;
  const auto square = memory.frequencies.array().square();
  WaveMemoryRule rule{.h = h, .inverse = 1 / (1 + h / 2 * d.array() + h * h / 4 * square)};
  rule.coupling = memory.port.transpose() * rule.inverse.asDiagonal() * memory.port;
  return rule;
}

/// Root of the density and of the body's presence, which the port for ρ = 1 is multiplied with.
double port_strength(const Body& body, const hydro::BodyState& state, double time) {
  const hydro::Sea& sea = *body.environment.sea;
  if (!may_be_wet(body, state)) return 0;
  return std::sqrt(sea.density * body.spec->radiation->presence(state, sea, time));
}

/// p − ½h Ω² q
Eigen::VectorXd known_rate(const hydro::RadiationMemory& memory, const WaveMemory& state,
                           double h) {
  return state.p - (h / 2 * memory.frequencies.array().square() * state.q.array()).matrix();
}

}  // namespace

std::optional<WaveMemory> still_memory(const Body& body) {
  if (!body.has_memory) return std::nullopt;
  const Eigen::Index m = oscillators(body).size();
  return WaveMemory{.q = Eigen::VectorXd::Zero(m), .p = Eigen::VectorXd::Zero(m)};
}

bool fits_memory(const Body& body, const Motion& motion) {
  if (!body.has_memory || !motion.memory) return body.has_memory == motion.memory.has_value();
  const Eigen::Index m = oscillators(body).size();
  return motion.memory->q.size() == m && motion.memory->p.size() == m;
}

std::optional<MemoryEffect> memory_effect(const Body& body, const MidpointState& midpoint,
                                          double time, double h, WaveMemoryRule& rule) {
  if (!body.has_memory) return std::nullopt;
  const Motion& motion = *midpoint.motion;
  assert(fits_memory(body, motion) && h > 0);
  const hydro::RadiationMemory& memory = oscillators(body);
  if (rule.h != h) rule = make_rule(memory, h);
  MemoryEffect effect{.strength = port_strength(body, motion.state, time),
                      .frame = body.spec->radiation->frame(motion.state.orientation)};
  effect.current = to_vector6(motion.flow - body.current(), Eigen::Vector3d::Zero());
  const double square = effect.strength * effect.strength;
  const Matrix6d C = square * effect.frame.tensor_out(rule.coupling);
  const Vector6d kept =
      memory.port.transpose() * rule.inverse.cwiseProduct(known_rate(memory, *motion.memory, h));
  effect.inertia = h * h / 4 * C;
  effect.load = -effect.strength * effect.frame.load_out(kept) -
                h / 2 * C * (midpoint.mean() + effect.current);
  return effect;
}

void advance_memory(const Body& body, const MidpointState& midpoint, const Vector6d& change,
                    const WaveMemoryRule& rule, Motion& end) {
  if (!midpoint.memory) return;
  assert(fits_memory(body, end) && rule.inverse.size() == end.memory->p.size());
  const MemoryEffect& effect = *midpoint.memory;
  const hydro::RadiationMemory& memory = oscillators(body);
  const Vector6d u = midpoint.mean() + change / 2 + effect.current;
  const Vector6d u_H = effect.strength * effect.frame.velocity_in(u);
  WaveMemory& state = *end.memory;
  const Eigen::VectorXd mean =
      rule.inverse.cwiseProduct(known_rate(memory, state, rule.h) + rule.h / 2 * memory.port * u_H);
  state.q += rule.h * mean;
  state.p = 2 * mean - state.p;
}

double memory_energy(const Body& body, const Motion& motion) {
  if (!motion.memory) return 0;
  const Eigen::VectorXd stretched = oscillators(body).frequencies.cwiseProduct(motion.memory->q);
  return (motion.memory->p.squaredNorm() + stretched.squaredNorm()) / 2;
}

Vector6d memory_load(const Body& body, const Motion& motion, double time) {
  if (!motion.memory) return Vector6d::Zero();
  const Vector6d load_H = oscillators(body).port.transpose() * motion.memory->p;
  return -port_strength(body, motion.state, time) *
         body.spec->radiation->frame(motion.state.orientation).load_out(load_H);
}

}  // namespace engine

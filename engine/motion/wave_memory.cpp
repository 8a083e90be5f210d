#include "engine/motion/wave_memory.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "engine/motion/added_inertia.h"
#include "engine/motion/free_motion.h"
#include "engine/motion/moving_body.h"
#include "engine/motion/velocity_update.h"
#include "hydro/radiation/floating_body.h"
#include "hydro/water/hull_sources.h"

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

/// p̄ of (E18) for B ū with the velocity ū in H times the port's strength.
Eigen::VectorXd mean_rate(const Body& body, const WaveMemory& state, const Vector6d& u_H,
                          const WaveMemoryRule& rule) {
  const hydro::RadiationMemory& memory = oscillators(body);
  return rule.inverse.cwiseProduct(known_rate(memory, state, rule.h) +
                                   rule.h / 2 * memory.port * u_H);
}

/// g C of (E18a) in H.
Matrix6d spring(const Body& body) { return body.environment.gravity * body.spec->sources->spring; }

/// f − g C ξ of (E18a) in H; f, which is known before, leaves with A as the body leaves the water.
Vector6d water_load(const Body& body, const WaterMemory& water, double strength) {
  const double presence = strength / std::sqrt(body.environment.sea->density);
  return presence * water.load - spring(body) * water.displacement;
}

/// p of (E19a) in W.
/// @param driven   Bᵀ q in W, or the momentum of the simulated waves.
/// @param stream   w − c
Vector6d wave_momentum(const Body& body, const Motion& motion, const Vector6d& driven,
                       const Vector6d& stream, double time) {
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  return driven + rotate_tensor(R_WB, motion.added()) * stream +
         to_vector6(body.spec->radiation->wave_momentum(motion.state, *body.environment.sea, time));
}

}  // namespace

std::optional<WaveMemory> still_memory(const Body& body) {
  if (!body.has_memory || body.spec->sources) return std::nullopt;
  const Eigen::Index m = oscillators(body).size();
  return WaveMemory{.q = Eigen::VectorXd::Zero(m), .p = Eigen::VectorXd::Zero(m)};
}

std::optional<WaterMemory> still_water(const Body& body) {
  if (!body.has_memory || !body.spec->sources) return std::nullopt;
  return WaterMemory();
}

void begin_water_step(MovingBody& moving, double time, const WaterMemory& water) {
  const Body& body = moving.body;
  Motion& motion = moving.motion;
  const WaterMemory last = std::exchange(*motion.water, water);
  if (motion.constrained || motion.accelerations.empty()) return;
  const double strength = port_strength(body, motion.state, time);
  const hydro::WaveFrame frame = body.spec->radiation->frame(motion.state.orientation);
  const Vector6d change = strength * frame.load_out(water_load(body, water, strength) -
                                                    water_load(body, last, strength));
  const Matrix6d mobility = mobility_matrix(inertia_W(body, motion), body.spec->locked);
  const Eigen::Matrix3d R_WB = motion.state.orientation.toRotationMatrix();
  motion.accelerations.shift(rotate(R_WB.transpose(), mobility * change), body.radius);
}

bool fits_memory(const Body& body, const Motion& motion) {
  if (motion.water || still_water(body)) return motion.water && still_water(body) && !motion.memory;
  if (!body.has_memory || !motion.memory) return body.has_memory == motion.memory.has_value();
  const Eigen::Index m = oscillators(body).size();
  return motion.memory->q.size() == m && motion.memory->p.size() == m;
}

std::optional<MemoryEffect> memory_effect(const Body& body, const MidpointState& midpoint,
                                          double time, double h, WaveMemoryRule& rule) {
  if (!body.has_memory) return std::nullopt;
  const Motion& motion = *midpoint.motion;
  assert(fits_memory(body, motion) && h > 0);
  MemoryEffect effect{.strength = port_strength(body, motion.state, time),
                      .frame = body.spec->radiation->frame(motion.state.orientation)};
  effect.current = to_vector6(motion.flow - body.current(), Eigen::Vector3d::Zero());
  Matrix6d coupling_H;
  Vector6d known_H;
  if (motion.water) {
    rule.h = h;
    coupling_H = spring(body);
    known_H = water_load(body, *motion.water, effect.strength);
  } else {
    const hydro::RadiationMemory& memory = oscillators(body);
    if (rule.h != h) rule = make_rule(memory, h);
    coupling_H = rule.coupling;
    known_H =
        -memory.port.transpose() * rule.inverse.cwiseProduct(known_rate(memory, *motion.memory, h));
  }
  const Matrix6d C = effect.strength * effect.strength * effect.frame.tensor_out(coupling_H);
  effect.inertia = h * h / 4 * C;
  effect.load = effect.strength * effect.frame.load_out(known_H) -
                h / 2 * C * (midpoint.mean() + effect.current);
  return effect;
}

Vector6d turning_load(const Body& body, const MidpointState& midpoint, double time,
                      const WaveMemoryRule& rule) {
  if (!body.spec->radiation->turns_water()) return Vector6d::Zero();
  const MemoryEffect& effect = *midpoint.memory;
  const Motion& motion = *midpoint.motion;
  const Vector6d change = rule.h * rotate(midpoint.R_WB, motion.accelerations.expected(rule.h / 2));
  const Vector6d u = midpoint.mean() + change / 2;
  const Vector6d u_H = effect.strength * effect.frame.velocity_in(u + effect.current);
  const Vector6d driven_H =
      motion.water
          ? motion.water->momentum
          : Vector6d(oscillators(body).port.transpose() *
                     (motion.memory->q + rule.h / 2 * mean_rate(body, *motion.memory, u_H, rule)));
  const Vector6d driven = effect.strength * effect.frame.load_out(driven_H);
  return kirchhoff(wave_momentum(body, motion, driven, effect.current, time), u);
}

void advance_memory(const Body& body, const MidpointState& midpoint, const Vector6d& change,
                    const WaveMemoryRule& rule, Motion& end) {
  if (!midpoint.memory) return;
  assert(fits_memory(body, end));
  const MemoryEffect& effect = *midpoint.memory;
  const Vector6d u = midpoint.mean() + change / 2 + effect.current;
  const Vector6d u_H = effect.strength * effect.frame.velocity_in(u);
  if (end.water) {
    end.water->displacement += rule.h * u_H;
    return;
  }
  assert(rule.inverse.size() == end.memory->p.size());
  WaveMemory& state = *end.memory;
  const Eigen::VectorXd mean = mean_rate(body, state, u_H, rule);
  state.q += rule.h * mean;
  state.p = 2 * mean - state.p;
}

double memory_energy(const Body& body, const Motion& motion) {
  if (motion.water)
    return motion.water->displacement.dot(spring(body) * motion.water->displacement) / 2;
  if (!motion.memory) return 0;
  const Eigen::VectorXd stretched = oscillators(body).frequencies.cwiseProduct(motion.memory->q);
  return (motion.memory->p.squaredNorm() + stretched.squaredNorm()) / 2;
}

Vector6d memory_load(const Body& body, const Motion& motion, double time) {
  if (!body.has_memory) return Vector6d::Zero();
  const double strength = port_strength(body, motion.state, time);
  const hydro::WaveFrame frame = body.spec->radiation->frame(motion.state.orientation);
  const auto out = [&](const Vector6d& load_H) -> Vector6d {
    return strength * frame.load_out(load_H);
  };
  const auto from = [&](const Eigen::VectorXd& state) -> Vector6d {
    return oscillators(body).port.transpose() * state;
  };
  const Vector6d load =
      motion.water ? out(water_load(body, *motion.water, strength)) : out(-from(motion.memory->p));
  if (!body.spec->radiation->turns_water()) return load;
  const Eigen::Vector3d flow = flow_about(body, motion.state, time, 0);
  const Vector6d driven = out(motion.water ? motion.water->momentum : from(motion.memory->q));
  const Vector6d stream = to_vector6(flow - body.current(), Eigen::Vector3d::Zero());
  return load +
         kirchhoff(wave_momentum(body, motion, driven, stream, time), velocity(motion.state, flow));
}

}  // namespace engine

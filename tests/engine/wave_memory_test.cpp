#include <complex>

#include "engine/motion/velocity_update.h"
#include "hydro/airy_waves.h"
#include "tests/engine/radiating_ball.h"

/// The waves' memory of one body in one substep.

namespace {

using support::afloat;
using support::energy;
using support::kRho;
using support::radiating_ball;
using support::uneven_data;

TEST(WaveMemory, TakesFromTheBodyWhatItGainsAndDampsForAnyStep) {
  BodySpec ball = radiating_ball(uneven_data());
  ball.wet = false;  // Nothing but the memory acts on it.
  SimulationSpec spec = afloat(ball, 0.1);
  spec.gravity = 0;
  support::Random random(3);
  for (const double h : {1e-4, 0.01, 0.1, 1.0, 1e3, 1e6}) {
    ball.initial.linear_velocity = {1, -2, 3};
    ball.initial.orientation = Eigen::AngleAxisd(0.7, Vector3d::UnitZ());
    spec.bodies = {ball};
    std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
    engine::MovingBody& moving = bodies[0];
    engine::Motion& motion = moving.motion;
    const hydro::RadiationMemory& memory = ball.radiation->memory();
    double before = energy(moving.body, motion);
    const double start = before;
    for (int i = 0; i < 50; ++i) {
      engine::MidpointState middle =
          engine::make_midpoint(moving.body, motion, motion.added(), engine::Mobility{});
      engine::WaveMemoryRule rule;
      middle.memory = engine::memory_effect(moving.body, middle, 0, h, rule);
      const engine::VelocityUpdate update = engine::free_update(moving, middle, 0, h);
      engine::Motion next = motion;
      next.state = engine::with_velocity(motion.state, middle.after + update.change, {0, 0, 0});
      engine::advance_memory(moving.body, middle, update.change, rule, next);
      const Eigen::VectorXd mean = (motion.memory->p + next.memory->p) / 2;
      const double damped = h * mean.dot(memory.damping.cwiseProduct(mean));
      const double taken = -middle.memory->impulse(update.change, h)
                                .dot(engine::velocity(motion.state, {0, 0, 0}) + update.change / 2);
      const double gained =
          engine::memory_energy(moving.body, next) - engine::memory_energy(moving.body, motion);
      // Round-off of q, which a long step makes large.
      const double round_off = tolerance(1e-12) * start * std::max(1.0, h);
      EXPECT_NEAR(gained, taken - damped, round_off) << h;
      const double now = energy(moving.body, next);
      EXPECT_LE(now, before + round_off) << h << ", step " << i;
      before = now;
      motion = next;
    }
    EXPECT_LT(before, start);
  }
}

/// The turning load on a body with this memory in a substep of length h.
Vector6d turning_load(const engine::MovingBody& moving, engine::MidpointState& middle, double h,
                      engine::WaveMemoryRule& rule) {
  middle.memory = engine::memory_effect(moving.body, middle, 0, h, rule);
  return engine::turning_load(moving.body, middle, 0, rule);
}

TEST(WaveMemory, TurnsABodyUnderWayWithoutPower) {
  support::Random random(4);
  BodySpec ball = radiating_ball(uneven_data());
  SimulationSpec spec = afloat(ball, 0.1);
  spec.sea->current = {0.4, -1.2, 0};
  ball.initial.linear_velocity = {3, -2, 0.5};
  ball.initial.angular_velocity = {0.2, 0.4, -0.3};
  ball.initial.orientation = Eigen::AngleAxisd(0.7, Vector3d(0.1, 0.2, 1).normalized());
  spec.bodies = {ball};
  std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
  engine::Motion& motion = bodies[0].motion;
  motion.flow = {0.6, -1, 0.1};  // A wave is there, too.
  for (Eigen::Index i = 0; i < motion.memory->q.size(); ++i) {
    motion.memory->q[i] = random.uniform(-1, 1);
    motion.memory->p[i] = random.uniform(-1, 1);
  }
  engine::MidpointState middle =
      engine::make_midpoint(bodies[0].body, motion, motion.added(), engine::Mobility{});
  engine::WaveMemoryRule rule;
  const Vector6d load = turning_load(bodies[0], middle, 0.01, rule);
  const Vector6d u = engine::velocity(motion.state, motion.flow);
  EXPECT_GT(load.norm(), 1);
  EXPECT_NEAR(load.dot(u), 0, tolerance(1e-13) * load.norm() * u.norm());
}

// A ship that heaves at the speed U while it goes ahead at V has the moment of strip theory,
// V (A₃₃ − A∞₃₃ + B₃₃/iω) U, less that of the water that it carries along.
TEST(WaveMemory, HasTheMomentOfStripTheoryUnderWay) {
  constexpr double kAhead = 1.5, kHeave = 0.2, kFrequency = 3;
  constexpr int kSteps = 200, kPeriods = 40;  // A period's, and in all.
  const double h = 2 * M_PI / kFrequency / kSteps;
  BodySpec ball = radiating_ball(uneven_data());
  const Eigen::Quaterniond yaw(Eigen::AngleAxisd(0.7, Vector3d::UnitZ()));
  ball.initial.orientation = yaw;
  const SimulationSpec spec = afloat(ball, h);
  std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
  engine::MovingBody& moving = bodies[0];
  engine::Motion& motion = moving.motion;
  const auto velocity_at = [&](int step) {
    const double heave = kHeave * std::cos(kFrequency * step * h);
    return engine::to_vector6(yaw * Vector3d(kAhead, 0, heave), Vector3d::Zero());
  };
  engine::WaveMemoryRule rule;
  std::complex<double> moment = 0;
  for (int i = 0; i < kSteps * kPeriods; ++i) {
    motion.state = engine::with_velocity(motion.state, velocity_at(i), {0, 0, 0});
    engine::MidpointState middle =
        engine::make_midpoint(moving.body, motion, motion.added(), engine::Mobility{});
    const Vector6d load = turning_load(moving, middle, h, rule);
    const Vector6d change = velocity_at(i + 1) - velocity_at(i);
    engine::advance_memory(moving.body, middle, change, rule, motion);
    motion.accelerations.add(engine::rotate(middle.R_WB.transpose(), Vector6d(change / h)), h,
                             moving.body.radius);
    if (i < kSteps * (kPeriods - 5)) continue;
    const double phase = kFrequency * (i + 0.5) * h;
    moment += load.tail<3>().dot(yaw * Vector3d::UnitY()) * std::polar(2.0 / (5 * kSteps), -phase);
  }
  const hydro::RadiationMemory& memory = ball.radiation->memory();
  const auto heave = response(memory, kFrequency)(2, 2) / std::complex<double>(0, kFrequency);
  const double ahead = memory.port.col(0).cwiseQuotient(memory.frequencies).squaredNorm();
  const std::complex<double> expected = kRho * kAhead * kHeave * (heave - ahead);
  EXPECT_LT(std::abs(moment - expected), 0.01 * std::abs(expected)) << moment << expected;
}

}  // namespace

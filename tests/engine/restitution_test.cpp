#include "engine/constraints/restitution.h"

#include "engine/base/spatial_vector.h"
#include "tests/engine/prelude.h"

namespace {

using engine::ConstraintResult;

constexpr double kSteps[] = {1.0 / 60, 1.0 / 240};

/// A ball of 0.1 m that falls from a height of 1 m, or another body, onto a ground.
SimulationSpec dropped(BodySpec body, CollisionShape shape, const engine::Ground& ground,
                       double restitution, double step) {
  body.collision = shape;
  body.restitution = restitution;
  SimulationSpec spec = support::dry_world({body}, step);
  spec.ground = ground;
  return spec;
}

BodySpec ball() { return support::sphere_body("ball", 0.1, 800, {0.3, 0.2, 1.1}); }

/// Heights to which the centre rises after each of the first bounces, from its energy [m].
std::vector<double> bounces(const SimulationSpec& spec, std::size_t count, double rest) {
  Simulation simulation(spec);
  std::vector<double> heights;
  bool falls = true;
  for (int i = 0; i < 100000 && heights.size() < count; ++i) {
    simulation.step();
    const bool fell = falls;
    falls = simulation.states()[0].linear_velocity.z() < 0;
    if (fell && !falls)
      heights.push_back(
          support::energy(spec, simulation.states()) / (spec.bodies[0].mass * spec.gravity) - rest);
  }
  return heights;
}

TEST(Restitution, OfOneKeepsTheHeightOfTenBounces) {
  for (const double step : kSteps) {
    for (const engine::Ground& ground :
         {engine::Ground(engine::PlaneGround{0}), engine::Ground(support::slope(0, 0, 40))}) {
      const auto heights =
          bounces(dropped(ball(), CollisionShape::sphere, ground, 1, step), 10, 0.1);
      ASSERT_EQ(heights.size(), 10U);
      // The contact's softness takes 1e-6 of the speed at each.
      EXPECT_NEAR(heights.back(), 1, tolerance(1e-4)) << step;
    }
  }
}

TEST(Restitution, OfAHalfLeavesAQuarterOfTheHeightAtEachBounce) {
  for (const double step : kSteps) {
    const auto heights =
        bounces(dropped(ball(), CollisionShape::sphere, engine::PlaneGround{0}, 0.5, step), 4, 0.1);
    ASSERT_EQ(heights.size(), 4U);
    double expected = 1;
    for (const double height : heights) {
      expected *= 0.25;
      // The ball parts from within the overlap of its first substep, v τ/64.
      EXPECT_NEAR(height, expected, tolerance(0.03 * expected)) << step;
    }
  }
}

TEST(Restitution, HoldsForABoxThatLandsOnItsWholeFace) {
  for (const CollisionShape shape : {CollisionShape::box, CollisionShape::mesh}) {
    const BodySpec box = support::box_body("box", {0.6, 0.4, 0.2}, 500, {0.1, 0.2, 1.1});
    const auto heights =
        bounces(dropped(box, shape, engine::PlaneGround{0}, 0.7, 1.0 / 60), 2, 0.1);
    ASSERT_EQ(heights.size(), 2U);
    EXPECT_NEAR(heights[0], 0.49, tolerance(0.02));
    EXPECT_NEAR(heights[1], 0.49 * 0.49, tolerance(0.02));
  }
}

TEST(Restitution, OfAPairSetsTheSpeedAtWhichTwoBodiesPart) {
  for (const double restitution : {0.0, 0.3, 1.0}) {
    BodySpec left = support::sphere_body("left", 0.2, 500, {-1, 0, 0});
    BodySpec right = support::sphere_body("right", 0.3, 900, {1, 0, 0});
    left.collision = right.collision = CollisionShape::sphere;
    left.initial.linear_velocity = {6, 0, 0};
    right.initial.linear_velocity = {-2, 0, 0};
    left.restitution = 0.9;
    SimulationSpec spec = support::dry_world({left, right}, 1.0 / 60);
    spec.gravity = 0;
    spec.contacts = {{.first = 0, .second = 1, .friction = {}, .restitution = restitution}};
    const Simulation simulation = support::after(spec, 30);
    const Vector3d a = simulation.states()[0].linear_velocity;
    const Vector3d b = simulation.states()[1].linear_velocity;
    // Without restitution the spring of the contact parts them a little.
    EXPECT_NEAR((b - a).x(), 8 * restitution, tolerance(restitution > 0 ? 1e-3 : 0.2));
    EXPECT_NEAR(left.mass * a.x() + right.mass * b.x(), left.mass * 6 - right.mass * 2,
                tolerance(1e-9 * left.mass));
  }
}

TEST(Restitution, NeverGainsEnergyWhateverTheBodiesAndTheirSpeeds) {
  support::Random random(21);
  for (int i = 0; i < 24; ++i) {
    std::vector<BodySpec> bodies;
    for (int k = 0; k < 3; ++k) {
      const Vector3d size(random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1));
      const Vector3d place(1.5 * k, 0, random.uniform(1, 3));
      BodySpec body = support::box_body(std::to_string(k), size, random.uniform(50, 2000), place);
      body.collision = i % 2 == 0 ? CollisionShape::box : CollisionShape::mesh;
      body.restitution = random.uniform(0, 1);
      body.friction = random.uniform(0, 1);
      body.initial.orientation = random.rotation();
      body.initial.linear_velocity = random.vector(10) - Vector3d(5.0 * (k - 1), 0, 0);
      body.initial.angular_velocity = random.vector(10);
      bodies.push_back(body);
    }
    SimulationSpec spec = support::dry_world(bodies, kSteps[i / 2 % 2]);
    spec.ground = engine::PlaneGround{0};
    spec.ground_restitution = i % 3 == 0 ? 1 : 0;
    Simulation simulation(spec);
    double last = support::energy(spec, simulation.states());
    const double start = last;
    for (int k = 0; k < 240; ++k) {
      simulation.step();
      const double energy = support::energy(spec, simulation.states());
      // A spring gives back what a body lost by falling into it: m g times some centimetres.
      ASSERT_LE(energy, start * (1 + tolerance(1e-9))) << i << " " << k;
      ASSERT_LE(energy, last + tolerance(0.02 * start)) << i << " " << k;
      last = energy;
    }
  }
}

/// Answers of bodies whose changes follow from their reactions.
ConstraintResult answer(const std::vector<Matrix6d>& inertia,
                        const std::vector<Vector6d>& reactions, double h) {
  ConstraintResult answer{.changes = {}, .reactions = reactions};
  for (std::size_t i = 0; i < inertia.size(); ++i)
    answer.changes.push_back(h * inertia[i].inverse() * reactions[i]);
  return answer;
}

TEST(RestitutionWork, IsTakenBackToNothing) {
  support::Random random(5);
  const double h = 3e-4;
  int gained = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<Matrix6d> inertia;
    std::vector<Vector6d> before, first, second;
    for (int k = 0; k < 2; ++k) {
      const Matrix6d root = Matrix6d::NullaryExpr([&] { return random.uniform(-1, 1); });
      inertia.push_back(root * root.transpose() + Matrix6d::Identity());
      const auto any = [&] { return engine::to_vector6(random.vector(1), random.vector(1)); };
      before.push_back(any());
      // Without restitution the bodies lose some of their motion.
      first.push_back(-0.5 / h * inertia.back() * before.back());
      second.push_back(first.back() + 2 / h * any());
    }
    const ConstraintResult plain = answer(inertia, first, h), restored = answer(inertia, second, h);
    if (!engine::adds_energy(restored, before, h, 0)) continue;
    ++gained;
    const ConstraintResult kept = engine::limit_energy(plain, restored, before, h, 0);
    EXPECT_NEAR(engine::work(kept, before, h), 0, tolerance(1e-12));
    // It lies between the two.
    const double s = (kept.changes[0] - plain.changes[0]).norm() /
                     (restored.changes[0] - plain.changes[0]).norm();
    EXPECT_GT(s, 0);
    EXPECT_LT(s, 1);
  }
  EXPECT_GT(gained, 30);
}

// What equations without a solution lead to may be beyond all numbers, or its square.
TEST(Restitution, TakesNothingOfAnAnswerBeyondAllNumbers) {
  const std::vector<Vector6d> before(1, Vector6d::Unit(0));
  const ConstraintResult plain{.changes = {Vector6d::Zero()}, .reactions = {Vector6d::Zero()}};
  for (const double size : {1e100, 1e140, 1e160, 1e300}) {
    const ConstraintResult thrown{.changes = {size * Vector6d::Unit(1)},
                                  .reactions = {size * Vector6d::Unit(1)}};
    ASSERT_TRUE(engine::adds_energy(thrown, before, 1, 1)) << size;
    const ConstraintResult kept = engine::limit_energy(plain, thrown, before, 1, 1);
    EXPECT_LE(engine::work(kept, before, 1), 1 + tolerance(1e-9)) << size;
  }
}

}  // namespace

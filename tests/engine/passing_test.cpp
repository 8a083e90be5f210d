#include "engine/step/passing.h"

#include "tests/engine/prelude.h"

namespace {

constexpr double kFlightSteps[] = {1.0 / 60, 1.0 / 240};
constexpr double kRadius = 0.01;      ///< Of the bullet [m].
constexpr double kBulletSpeed = 300;  ///< [m/s]

/// A ball of steel, 2 cm thick, that flies along +x at kBulletSpeed from -`gap`, `aside` of it.
BodySpec bullet(CollisionShape shape, double gap, const Vector3d& aside = Vector3d::Zero()) {
  BodySpec body = support::sphere_body("bullet", kRadius, 7800, Vector3d(-gap, 0, 0) + aside);
  body.collision = shape;
  body.initial.linear_velocity = {kBulletSpeed, 0, 0};
  return body;
}

/// A body of this shape in the origin, which moves or not.
BodySpec target(BodySpec body, CollisionShape shape, bool held) {
  body.collision = shape;
  if (held) body.locked.fill(true);
  return body;
}

/// Largest lead of the bullet's centre over the target's within 0.05 s [m].
double farthest(SimulationSpec spec) {
  spec.gravity = 0;
  Simulation simulation(spec);
  double lead = -1e9;
  for (long i = 0; i < support::steps_in(0.05, spec.step); ++i) {
    simulation.step();
    const std::vector<BodyState>& states = simulation.states();
    const double target = states.size() > 1 ? states[1].position.x() : 0;
    lead = std::max(lead, states[0].position.x() - target);
  }
  return lead;
}

/// Targets of a bullet, and the shapes that they may have.
struct Target {
  BodySpec body;
  std::vector<CollisionShape> shapes;
  bool flat;  ///< A bullet that meets it off its centre stops, too, and does not slip past.
};

std::vector<Target> targets() {
  using enum CollisionShape;
  return {
      {support::box_body("plate", {0.01, 1, 1}, 2000, Vector3d::Zero()), {box, mesh}, true},
      {support::box_body("block", {0.05, 0.06, 0.07}, 2000, Vector3d::Zero()), {box, mesh}, false},
      {support::sphere_body("ball", 0.015, 7800, Vector3d::Zero()), {sphere, mesh}, false}};
}

TEST(Passing, ABulletStopsAtAPlateBallAndBlock) {
  const Vector3d aside(0, 0.003, 0.002);
  for (const double step : kFlightSteps)
    for (const double gap : {0.1, 0.7, 1.33, 2.9})
      for (const CollisionShape shape : {CollisionShape::sphere, CollisionShape::mesh})
        for (const Target& hit : targets())
          for (const CollisionShape other : hit.shapes)
            for (const bool held : {true, false}) {
              const BodySpec small = bullet(shape, gap, hit.flat ? aside : Vector3d::Zero());
              EXPECT_LT(farthest(support::dry_world({small, target(hit.body, other, held)}, step)),
                        0)
                  << hit.body.name << " " << step << " " << gap << " " << held << " "
                  << static_cast<int>(shape) << static_cast<int>(other);
            }
}

TEST(Passing, ABulletStopsAtGroundAndLeavesWithItsRestitution) {
  for (const double step : kFlightSteps) {
    for (const double height : {0.1, 0.9, 2.3}) {
      for (const CollisionShape shape :
           {CollisionShape::sphere, CollisionShape::mesh, CollisionShape::box}) {
        for (const engine::Ground& ground :
             {engine::Ground(engine::PlaneGround{0}), engine::Ground(support::slope(0, 0, 40))}) {
          BodySpec small = bullet(shape, 0);
          small.initial.position = {0.3, 0.2, height};
          small.initial.linear_velocity = {0, 0, -kBulletSpeed};
          small.restitution = 0.4;
          SimulationSpec spec = support::dry_world({small}, step);
          spec.gravity = 0;
          spec.ground = ground;
          const Simulation simulation = support::after(spec, support::steps_in(0.05, step));
          const BodyState& state = simulation.states()[0];
          EXPECT_GT(state.position.z(), 0) << step << " " << height;
          // Meshes and boxes may turn at impact, by edges that are hit off their centre.
          if (shape == CollisionShape::sphere) {
            EXPECT_NEAR(state.linear_velocity.z(), 0.4 * kBulletSpeed,
                        tolerance(0.01 * kBulletSpeed));
          }
        }
      }
    }
  }
}

TEST(Passing, APlateThatSpinsAndFliesDoesNotPassAWall) {
  support::Random random(4);
  for (int i = 0; i < 10; ++i) {
    BodySpec plate = support::box_body("plate", {0.02, 0.3, 0.2}, 2000, {-1.5, 0, 0});
    plate.collision = i % 2 == 0 ? CollisionShape::box : CollisionShape::mesh;
    plate.initial.orientation = random.rotation();
    plate.initial.linear_velocity = {120, 0, 0};
    plate.initial.angular_velocity = random.vector(20);
    const BodySpec wall = support::box_body("wall", {0.02, 4, 4}, 500, Vector3d::Zero());
    const CollisionShape shape = i % 2 == 0 ? CollisionShape::box : CollisionShape::mesh;
    EXPECT_LT(farthest(support::dry_world({plate, target(wall, shape, true)}, 1.0 / 60)), 0) << i;
  }
}

TEST(Passing, BodiesThatMissEachOtherFlyAsIfAlone) {
  BodySpec small = bullet(CollisionShape::sphere, 1.3);
  small.initial.position.y() = 0.06;
  const BodySpec block = support::box_body("block", {0.1, 0.09, 0.1}, 2000, Vector3d::Zero());
  const SimulationSpec spec =
      support::dry_world({small, target(block, CollisionShape::box, true)}, 1.0 / 60);
  SimulationSpec alone = spec;
  alone.bodies.pop_back();
  const BodyState with = support::after(spec, 3).states()[0];
  const BodyState without = support::after(alone, 3).states()[0];
  EXPECT_LT(distance(with, without), tolerance(1e-12));
  EXPECT_GT(with.position.x(), 1);
}

/// Bullets that bounce for ever between six walls, 1 m apart.
SimulationSpec cage(int bullets, double step) {
  support::Random random(1);
  std::vector<BodySpec> bodies;
  for (int i = 0; i < bullets; ++i) {
    BodySpec small = bullet(CollisionShape::sphere, 0);
    small.initial.position = Vector3d(0.1 * i - 0.25, 0.05 * (i % 3), 0.04 * (i % 2));
    small.initial.linear_velocity = kBulletSpeed * random.vector(1).normalized();
    small.restitution = 1;
    small.friction = 0;
    bodies.push_back(small);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      Vector3d size = Vector3d::Constant(1.01);
      size[axis] = 0.01;
      const BodySpec wall = support::box_body("wall", size, 1000, side * Vector3d::Unit(axis));
      bodies.push_back(target(wall, CollisionShape::box, true));
    }
  }
  SimulationSpec spec = support::dry_world(bodies, step);
  spec.gravity = 0;
  return spec;
}

TEST(Passing, BulletsThatBounceStayInTheirCageAndKeepTheirEnergy) {
  for (const double step : kFlightSteps) {
    for (const int bullets : {1, 6}) {
      const SimulationSpec spec = cage(bullets, step);
      Simulation simulation(spec);
      const double start = support::energy(spec, simulation.states());
      for (int i = 0; i < support::repeats(100); ++i) {
        simulation.step();
        for (int k = 0; k < bullets; ++k)
          ASSERT_LT(simulation.states()[k].position.cwiseAbs().maxCoeff(), 0.5)
              << step << " " << bullets << " " << i << " " << k;
      }
      // Up to nine bounces of each in a step, which take 1e-6 of the speed each.
      EXPECT_NEAR(support::energy(spec, simulation.states()) / start, 1, tolerance(3e-3));
    }
  }
}

TEST(Passing, ABallThatABulletHitsStopsAtTheWallBehindIt) {
  for (const double restitution : {0.0, 1.0}) {
    BodySpec other = support::sphere_body("other", kRadius, 2000, Vector3d::Zero());
    other.restitution = restitution;
    const BodySpec wall = support::box_body("wall", {0.01, 2, 2}, 1000, {1.5, 0, 0});
    SimulationSpec spec = support::dry_world(
        {bullet(CollisionShape::sphere, 0.4), target(other, CollisionShape::sphere, false),
         target(wall, CollisionShape::box, true)},
        1.0 / 60);
    spec.gravity = 0;
    Simulation simulation(spec);
    for (int i = 0; i < 6; ++i) {
      simulation.step();
      EXPECT_LT(simulation.states()[0].position.x(), 1.5) << restitution << " " << i;
      EXPECT_LT(simulation.states()[1].position.x(), 1.5) << restitution << " " << i;
    }
  }
}

TEST(UnseenContact, IsWhereASphereReachesTheFaceOfABox) {
  engine::World world(kGravity);
  const BodySpec block = support::box_body("block", {0.1, 0.2, 0.3}, 2000, Vector3d::Zero());
  world.add_body(bullet(CollisionShape::sphere, 0));
  world.add_body(target(block, CollisionShape::box, false));
  // The block flies and turns about the way of the ball, which changes nothing.
  const Quaterniond turn(Eigen::AngleAxisd(0.8, Vector3d(1, 2, 3).normalized()));
  const auto state = [&](BodyId id, double time) {
    if (id == 0)
      return BodyState{.position = turn * Vector3d(-2 + kBulletSpeed * time, 0, 0),
                       .orientation = turn,
                       .linear_velocity = turn * Vector3d(kBulletSpeed, 0, 0)};
    const Vector3d spin(80, 0, 0);
    return BodyState{
        .position = turn * Vector3d(-40 * time, 0, 0),
        .orientation = turn * Quaterniond(Eigen::AngleAxisd(80 * time, Vector3d::UnitX())),
        .linear_velocity = turn * Vector3d(-40, 0, 0),
        .angular_velocity = turn * spin};
  };
  const double reach = world.reach({0, 1});
  EXPECT_NEAR(reach, kRadius, tolerance(1e-12));
  int queries = 100;
  const auto time = engine::unseen_contact(world,
                                           {.pair = {0, 1},
                                            .h = 1.0 / 60,
                                            .speed = 340 + 80 * 0.19,
                                            .turning = 80,
                                            .reach = reach,
                                            .slow = 0.1,
                                            .state = state},
                                           queries);
  ASSERT_TRUE(time);
  EXPECT_NEAR(*time, (2 - 0.05 - kRadius) / 340, tolerance(kRadius / 32 / 340));
}

}  // namespace

#include <numbers>

#include "engine/base/constants.h"
#include "tests/engine/prelude.h"

namespace {

// Depth of rest of a body of 1 m.
constexpr double kDepthOfRest = engine::kContactDepth;

const std::vector<engine::Ground> kFlatGrounds = {engine::PlaneGround{0}, support::slope(0, 0, 1),
                                                  support::slope(0, 0, 40)};
const std::vector<CollisionShape> kShapes = {CollisionShape::box, CollisionShape::mesh};

SimulationSpec on_ground(BodySpec body, CollisionShape shape, const engine::Ground& ground) {
  body.collision = shape;
  SimulationSpec spec = support::dry_world({body}, kStep);
  spec.ground = ground;
  return spec;
}

/// Largest energy within a time [J].
double peak_energy(Simulation& simulation, double time) {
  double peak = support::energy(simulation.spec(), simulation.states());
  for (long i = 0; i < support::steps_in(time, simulation.spec().step); ++i) {
    simulation.step();
    peak = std::max(peak, support::energy(simulation.spec(), simulation.states()));
  }
  return peak;
}

TEST(Resting, ADroppedBoxComesToRestOneSinkDeepAndStays) {
  for (const CollisionShape shape : kShapes) {
    for (const engine::Ground& ground : kFlatGrounds) {
      const BodySpec box = support::box_body("box", {1, 1, 1}, 500, {0.1, 0.2, 1});
      Simulation simulation = support::after(on_ground(box, shape, ground), 200);
      const hydro::BodyState then = simulation.states()[0];
      for (int i = 0; i < 1000; ++i) simulation.step();
      const hydro::BodyState& state = simulation.states()[0];
      EXPECT_NEAR(state.position.z(), 0.5 - kDepthOfRest, tolerance(1e-4));
      // Contact points come and go by round-off on a mesh: a tenth of the sink.
      EXPECT_LT((state.position - then.position).norm(), tolerance(1e-4));
      // It lands at 3 m/s, on a mesh one corner after the other: by a step's worth of 0.35 m/s.
      EXPECT_LT(std::hypot(state.position.x() - 0.1, state.position.y() - 0.2),
                tolerance(0.35 * kStep));
    }
  }
}

TEST(Resting, ADroppedBoxDoesNotBounce) {
  const BodySpec box = support::box_body("box", {1, 1, 1}, 500, {0, 0, 1.5});
  Simulation simulation(on_ground(box, CollisionShape::box, engine::PlaneGround{0}));
  bool landed = false;
  for (int i = 0; i < 300; ++i) {
    simulation.step();
    const double height = simulation.states()[0].position.z() - 0.5;
    landed = landed || height <= 0;
    ASSERT_TRUE(!landed || height < tolerance(1e-3)) << height;
  }
  EXPECT_TRUE(landed);
}

TEST(Resting, NoEnergyIsGainedInTumbling) {
  for (const CollisionShape shape :
       {CollisionShape::box, CollisionShape::mesh, CollisionShape::sphere}) {
    for (const engine::Ground& ground : kFlatGrounds) {
      BodySpec box = support::box_body("box", {1, 1, 1}, 500, {0.1, 0.2, 3}, 4);
      box.initial.orientation = Eigen::AngleAxisd(0.7, Vector3d(2, 1, 0.4).normalized());
      box.initial.angular_velocity = {1, 2, 3};
      Simulation simulation(on_ground(box, shape, ground));
      const double start = support::energy(simulation.spec(), simulation.states());
      EXPECT_LE(peak_energy(simulation, 10), start * (1 + tolerance(1e-12)));
      EXPECT_GT(simulation.states()[0].position.z(), 0.4);  // it has not fallen through
    }
  }
}

SimulationSpec slab_on_slope(double angle_deg, double heading, CollisionShape shape) {
  const double angle = angle_deg * std::numbers::pi / 180;
  const Eigen::Quaterniond tilt = support::lying_on_slope(angle, heading);
  BodySpec slab = support::box_body("slab", {1, 1, 0.4}, 500, tilt * Vector3d(0, 0, 0.2));
  slab.initial.orientation = tilt;
  return on_ground(slab, shape, support::slope(angle, heading, 1));
}

const double kFrictionAngleDeg = std::atan(engine::kFriction) * 180 / std::numbers::pi;

/// How far the slab creeps from 3 s to 13 s [m].
double creep(const SimulationSpec& spec) {
  Simulation simulation = support::after(spec, 300);
  const Vector3d then = simulation.states()[0].position;
  for (int i = 0; i < 1000; ++i) simulation.step();
  return (simulation.states()[0].position - then).norm();
}

TEST(Resting, ASphereDroppedOnAFlatMeshStaysWhereItFell) {
  support::Random random(8);
  for (int i = 0; i < 20; ++i) {
    const Vector3d start(random.uniform(-3, 3), random.uniform(-3, 3), 1);
    const BodySpec ball = support::sphere_body("ball", 0.5, 500, start);
    const Simulation simulation =
        support::after(on_ground(ball, CollisionShape::sphere, support::slope(0, 0, 200)), 500);
    const hydro::BodyState& state = simulation.states()[0];
    // The meshed floor is flat to its round-off, which sets the ball rolling by no more than that.
    EXPECT_LT((state.position - start).head<2>().norm(), tolerance(1e-9));
    EXPECT_LT(state.linear_velocity.norm(), tolerance(1e-9));
  }
}

TEST(Friction, HoldsABodyOnASlopeBelowTheFrictionAngle) {
  for (const double heading : {0.0, 0.4, 0.7854}) {
    const double angle = kFrictionAngleDeg - 1;
    // The friction's own slip is below 1e-6 g h.
    EXPECT_LT(creep(slab_on_slope(angle, heading, CollisionShape::box)),
              tolerance(10 * 1e-6 * support::kGravity * kStep));
    // A mesh on a mesh rocks within its sink, as contact points come and go, and creeps by that.
    EXPECT_LT(creep(slab_on_slope(angle, heading, CollisionShape::mesh)), tolerance(0.02));
    EXPECT_LT(creep(slab_on_slope(angle - 8, heading, CollisionShape::mesh)), tolerance(2e-3));
  }
}

TEST(Friction, LetsABodySlideDownASteeperSlopeWithTheRestOfItsWeight) {
  constexpr double kAngleDeg = 40;
  const double angle = kAngleDeg * std::numbers::pi / 180;
  const double time = 2;
  const double acceleration =
      support::kGravity * (std::sin(angle) - engine::kFriction * std::cos(angle));
  for (const double heading : {0.0, 0.4, 0.7854}) {
    const SimulationSpec spec = slab_on_slope(kAngleDeg, heading, CollisionShape::box);
    const Simulation simulation = support::after(spec, support::steps_in(time, kStep));
    const Vector3d way = simulation.states()[0].position - spec.bodies[0].initial.position;
    const Vector3d downhill(std::cos(angle) * std::cos(heading),
                            std::cos(angle) * std::sin(heading), -std::sin(angle));
    // Friction follows the load of the step before, and the slab first sinks in: a few steps'
    // share.
    EXPECT_NEAR(way.dot(downhill) / (acceleration * time * time / 2), 1, tolerance(0.03));
    EXPECT_LT((way - way.dot(downhill) * downhill).norm(), tolerance(0.01));
  }
}

TEST(Friction, SetsASlidingSphereRollingAtFiveSeventhsOfItsSpeed) {
  BodySpec ball = support::sphere_body("ball", 0.5, 500, {0, 0, 0.5});
  ball.initial.linear_velocity = {3, 0, 0};
  const Simulation simulation =
      support::after(on_ground(ball, CollisionShape::sphere, engine::PlaneGround{0}), 300);
  const hydro::BodyState& state = simulation.states()[0];
  // It rolls on a radius that is shorter by the sink, 0.2 %.
  EXPECT_NEAR(state.linear_velocity.x(), 3 * 5.0 / 7, tolerance(0.01));
  EXPECT_NEAR(state.angular_velocity.y() * 0.5, state.linear_velocity.x(), tolerance(0.01));
}

TEST(Collision, OfEqualBodiesConservesMomentum) {
  for (const CollisionShape shape :
       {CollisionShape::box, CollisionShape::mesh, CollisionShape::sphere}) {
    BodySpec left = support::box_body("left", {1, 1, 1}, 100, {-1, 0.1, 0.2}, 2);
    BodySpec right = support::box_body("right", {1, 1, 1}, 300, {1, 0, 0}, 2);
    left.initial.linear_velocity = {4, 0, 0};
    left.collision = right.collision = shape;
    SimulationSpec spec = support::dry_world({left, right}, kStep);
    spec.gravity = 0;
    Simulation simulation(spec);
    const double start = support::energy(spec, simulation.states());
    EXPECT_LE(peak_energy(simulation, 2), start * (1 + tolerance(1e-12)));
    const Vector3d momentum =
        100 * simulation.states()[0].linear_velocity + 300 * simulation.states()[1].linear_velocity;
    EXPECT_LT((momentum - Vector3d(400, 0, 0)).norm(), tolerance(1e-9));
    EXPECT_GT(simulation.states()[1].linear_velocity.x(), 0.9);
  }
}

TEST(Collision, SphereHoldsTheWholeBoxAndItsOffset) {
  BodySpec box = support::box_body("box", {1, 1, 1}, 500, {0, 0, 2});
  box.mesh_B = hydro::translated(box.mesh_B, {0, 0, 0.25});
  SimulationSpec spec = on_ground(box, CollisionShape::sphere, engine::PlaneGround{0});
  spec.bodies[0].locked = {false, false, false, true, true, true};
  const Simulation simulation = support::after(spec, 300);
  // The sphere of radius √3/2 about the mesh's centre, 0.25 m above the centre of mass.
  const double radius = std::sqrt(3) / 2;
  EXPECT_NEAR(simulation.states()[0].position.z(), radius - 0.25 - 2 * radius * kDepthOfRest,
              tolerance(1e-6));
}

TEST(Collision, BoxFollowsTheMeshOffTheCentreOfMass) {
  BodySpec box = support::box_body("box", {1, 1, 1}, 500, {0, 0, 2});
  box.mesh_B = hydro::translated(box.mesh_B, {0.2, 0, 0.25});
  const Simulation simulation =
      support::after(on_ground(box, CollisionShape::box, engine::PlaneGround{0}), 300);
  EXPECT_NEAR(simulation.states()[0].position.z(), 0.25 - kDepthOfRest, tolerance(1e-3));
}

TEST(Collision, WithAnImmovableBodyIsAsWithGround) {
  BodySpec table = support::box_body("table", {4, 4, 1}, 100, {0, 0, 0});
  table.mesh_B = hydro::translated(table.mesh_B, {0.3, 0.2, 0.1});
  table.locked = {true, true, true, true, true, true};
  for (const CollisionShape shape : kShapes) {
    BodySpec box = support::box_body("box", {1, 1, 1}, 500, {0.1, 0.2, 1.3});
    box.collision = table.collision = shape;
    const Simulation simulation = support::after(support::dry_world({table, box}, kStep), 400);
    EXPECT_NEAR(simulation.states()[1].position.z(), 1.1 - kDepthOfRest, tolerance(1e-4));
    EXPECT_EQ(simulation.states()[0].position, table.initial.position);
  }
}

TEST(Collision, WorksAMillionMetresAway) {
  const Vector3d far(1e6, -1e6, 0);
  const BodySpec box = support::box_body("box", {1, 1, 1}, 500, far + Vector3d(0, 0, 1));
  const Simulation simulation =
      support::after(on_ground(box, CollisionShape::box, engine::PlaneGround{0}), 300);
  EXPECT_NEAR(simulation.states()[0].position.z(), 0.5 - kDepthOfRest, tolerance(1e-6));
}

}  // namespace

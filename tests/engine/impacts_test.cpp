#include "tests/engine/prelude.h"

namespace {

BodySpec colliding(BodySpec body, CollisionShape shape, const Vector3d& velocity) {
  body.collision = shape;
  body.initial.linear_velocity = velocity;
  return body;
}

/// Without gravity: a crate that drifts at 1 m/s into one that lies skew in its way.
SimulationSpec collision(double gap, double step) {
  BodySpec other = colliding(support::box_body("other", {1, 1, 0.5}, 500, Vector3d::Zero()),
                             CollisionShape::box, Vector3d::Zero());
  other.initial.orientation = Eigen::AngleAxisd(0.4, Vector3d::UnitZ());
  SimulationSpec spec = support::dry_world(
      {colliding(support::box_body("mover", {1, 1, 0.5}, 400, {-1.2 - gap, 0.1, 0.05}),
                 CollisionShape::box, Vector3d::UnitX()),
       other},
      step);
  spec.gravity = 0;
  return spec;
}

/// Distances of the bodies' centres after a time [s] from those in another run [m].
Eigen::ArrayXd distances(double time, const SimulationSpec& first, const SimulationSpec& second) {
  const auto end = [&](const SimulationSpec& spec) {
    return support::after(spec, support::steps_in(time, spec.step)).states();
  };
  const std::vector<hydro::BodyState> a = end(first), b = end(second);
  Eigen::ArrayXd apart(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) apart[i] = (a[i].position - b[i].position).norm();
  return apart;
}

// The bodies meet after 0.25 s and part at some 0.3 m/s. Were the onset of the contact only known
// to a step, they would be off by millimetres. After 0.7 s an edge meets a face along all of its
// length; which of its ends is first hangs on the last digits.
TEST(Collision, HardlyDependsOnTheStepNorOnWhereInItBodiesMeet) {
  for (const double gap : {0.2, 0.205, 0.21, 0.2133}) {
    const SimulationSpec fine = collision(gap, 1.0 / 3840);
    EXPECT_LT(distances(0.6, collision(gap, 1.0 / 60), fine).maxCoeff(), tolerance(3e-4)) << gap;
    EXPECT_LT(distances(0.6, collision(gap, 1.0 / 240), fine).maxCoeff(), tolerance(3e-4)) << gap;
  }
}

TEST(Collision, KeepsMomentum) {
  const SimulationSpec spec = collision(0.2, 1.0 / 60);
  const auto momentum = [&](const std::vector<hydro::BodyState>& states) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < states.size(); ++i)
      sum += spec.bodies[i].mass * states[i].linear_velocity;
    return sum;
  };
  const Simulation simulation = support::after(spec, 120);
  const Vector3d before = momentum({spec.bodies[0].initial, spec.bodies[1].initial});
  EXPECT_LT((momentum(simulation.states()) - before).norm(), tolerance(1e-9 * before.norm()));
  EXPECT_LT(simulation.states()[0].linear_velocity.x(), 0.9);
}

TEST(Collision, IsCutIntoFewPiecesAndNothingElseIs) {
  SimulationSpec spec = collision(0.2, 1.0 / 60);
  BodySpec far = spec.bodies[0];
  far.name = "far";
  far.initial.position.y() = 10;
  spec.bodies.push_back(far);
  const Simulation simulation = support::after(spec, 120);
  EXPECT_EQ(simulation.counts()[2].substeps, 120);
  EXPECT_GT(simulation.counts()[0].substeps, 130);
  EXPECT_LT(simulation.counts()[0].substeps, 200);
}

// A ball falls on the ground in a vacuum: it is there after √(2 h/g), not a step later.
TEST(Collision, BeginsWhenTheGroundIsReached) {
  for (const double height : {1.0, 1.05, 1.1, 1.13}) {
    SimulationSpec spec =
        support::dry_world({colliding(support::sphere_body("ball", 0.2, 500, {0, 0, 0.2 + height}),
                                      CollisionShape::sphere, Vector3d::Zero())},
                           1.0 / 30);
    spec.ground = engine::PlaneGround{0};
    Simulation simulation(spec);
    const double fall = std::sqrt(2 * height / support::kGravity);
    double deepest = 0;
    while (simulation.time() < fall + 0.1) {
      simulation.step();
      deepest = std::max(deepest, 0.2 - simulation.states()[0].position.z());
    }
    // A damper c = 2 m/τ lets it in by no more than v τ/2; a step would by v/30 = 0.15 m.
    EXPECT_LT(deepest, tolerance(support::kGravity * fall * 0.01 / 2)) << height;
    EXPECT_LT(simulation.states()[0].linear_velocity.norm(), tolerance(0.1)) << height;
  }
}

/// Balls of 0.2 m in rows, a tenth of a millimetre apart, that fall on the ground at once.
SimulationSpec falling_balls(int rows, double step) {
  SimulationSpec spec = support::dry_world({}, step);
  for (int i = 0; i < rows * rows; ++i) {
    BodySpec ball = colliding(
        support::sphere_body("ball", 0.1, 500, {0.2001 * (i % rows), 0.2001 * (i / rows), 0.5}),
        CollisionShape::sphere, Vector3d::Zero());
    ball.name += std::to_string(i);
    ball.restitution = 0.8;
    spec.bodies.push_back(ball);
  }
  spec.ground = engine::PlaneGround{0};
  return spec;
}

// More pairs come to touch at once than a heap may have that impacts shorten substeps of. Balls
// that do not touch each other are no heap: each bounces as if it were alone, but for the lengths
// of substeps while it is off the ground (2e-5 m; in whole steps they are off by 30 mm).
TEST(Collision, OfManyBodiesAtOnceIsThatOfEach) {
  const hydro::BodyState alone = support::after(falling_balls(1, 1.0 / 60), 90).states()[0];
  const Simulation simulation = support::after(falling_balls(4, 1.0 / 60), 90);
  for (int i = 0; i < 16; ++i) {
    const Vector3d place(0.2001 * (i % 4), 0.2001 * (i / 4), 0);
    const Vector3d off = simulation.states()[i].position - place - alone.position;
    EXPECT_LT(off.norm(), tolerance(1e-4)) << i;
  }
}

/// Without gravity and friction: 27 balls of 1 m, from a grid that is not quite regular, that meet
/// in a heap.
SimulationSpec gathering_balls(double step) {
  SimulationSpec spec = support::dry_world({}, step);
  spec.gravity = 0;
  for (int i = 0; i < 27; ++i) {
    const Vector3d cell(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const Vector3d off(std::sin(12.9 * i), std::sin(78.2 * i + 1), std::sin(37.7 * i + 2));
    const Vector3d place = 1.2 * cell + 0.03 * off;
    BodySpec ball = colliding(support::sphere_body("ball", 0.5, 500, place), CollisionShape::sphere,
                              -0.5 * place);
    ball.name += std::to_string(i);
    ball.friction = 0;
    spec.bodies.push_back(ball);
  }
  return spec;
}

// They are off by 0.3, 0.27 and 0.2 mm in the mean: pairs that meet slower than (E15) do so at any
// time of a substep.
TEST(Collision, InAHeapHardlyDependsOnTheStep) {
  const SimulationSpec fine = gathering_balls(1.0 / 1920);
  EXPECT_LT(distances(0.4, gathering_balls(1.0 / 60), fine).mean(), tolerance(5e-4));
  EXPECT_LT(distances(0.4, gathering_balls(1.0 / 120), fine).mean(), tolerance(4e-4));
  EXPECT_LT(distances(0.4, gathering_balls(1.0 / 240), fine).mean(), tolerance(3e-4));
}

TEST(Collision, OfSlowBodiesIsNotLookedFor) {
  SimulationSpec spec = collision(0.2, 1.0 / 60);
  spec.bodies[0].initial.linear_velocity *= 0.009;
  spec.bodies[0].initial.position.x() += 0.22;
  const Simulation simulation = support::after(spec, 240);
  EXPECT_EQ(simulation.counts()[0].substeps, 240);
}

}  // namespace

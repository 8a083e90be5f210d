#include "engine/simulation.h"

#include <limits>

#include "engine/motion/locks.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "tests/engine/prelude.h"

/// How a program drives a simulation.

namespace {

using engine::Frame;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A box without weight, in no symmetric pose, at rest.
SimulationSpec box_at_rest() {
  SimulationSpec spec =
      support::dry_world({support::box_body("box", {1, 2, 3}, 100, {4, -5, 6})}, kStep);
  spec.gravity = 0;
  spec.bodies[0].initial.orientation = support::Random(3).rotation();
  return spec;
}

/// A barge that rocks in still water, with added mass.
SimulationSpec rocking_barge() {
  BodySpec barge = support::box_body("barge", {4, 3, 1}, 500, {0, 0, 0.2}, 2);
  barge.wet = true;
  barge.initial.orientation = Eigen::AngleAxisd(0.2, Vector3d(1, 0.5, 0.3).normalized());
  barge.added_mass = std::make_shared<hydro::ConstantAddedMass>(
      barge.mesh_B, Matrix6d(0.5 * barge.mass * Matrix6d::Identity()));
  SimulationSpec spec = support::dry_world({barge}, 1.0 / 30);
  spec.sea = hydro::Sea{.gravity = kGravity};
  return spec;
}

/// The rocking barge with a second one beside it, on a hinge between them.
SimulationSpec hinged_pair() {
  SimulationSpec spec = rocking_barge();
  spec.bodies[0].initial.orientation.setIdentity();
  spec.bodies.push_back(spec.bodies[0]);
  spec.bodies[1].initial.position.x() = 4.2;
  spec.joints = {{.type = JointSpec::Type::hinge,
                  .first = 0,
                  .second = 1,
                  .anchor_W = {2.1, 0, 0.2},
                  .axis_W = Vector3d::UnitY()}};
  return spec;
}

std::string bytes(const Simulation& simulation) { return simulation.state().to_bytes(); }

TEST(Apply, GivesItsImpulseInTheNextStepAndNoneAfterIt) {
  for (const auto method : {engine::Integrator::Method::split, engine::Integrator::Method::ode}) {
    SimulationSpec spec = box_at_rest();
    spec.integrator.method = method;
    Simulation simulation(spec);
    const Vector3d force(300, -200, 100);
    simulation.apply(0, {.force = force});
    simulation.step();
    const Vector3d expected = kStep / spec.bodies[0].mass * force;
    EXPECT_LT((simulation.states()[0].linear_velocity - expected).norm(), tolerance(1e-15));
    for (int i = 0; i < 10; ++i) simulation.step();
    EXPECT_LT((simulation.states()[0].linear_velocity - expected).norm(), tolerance(1e-15));
    EXPECT_EQ(simulation.states()[0].angular_velocity, Vector3d::Zero());
  }
}

TEST(Apply, AddsUpOverCalls) {
  Simulation simulation(box_at_rest());
  simulation.apply(0, {.force = {300, 0, 0}});
  simulation.apply(0, {.force = {-300, 50, 0}});
  simulation.apply(0, {.force = {0, 50, 0}});
  simulation.step();
  const Vector3d expected(0, 100 * kStep / simulation.spec().bodies[0].mass, 0);
  EXPECT_LT((simulation.states()[0].linear_velocity - expected).norm(), tolerance(1e-15));
}

TEST(Apply, InTheBodyFrameActsAlongTheAxesOfTheBody) {
  Simulation simulation(box_at_rest());
  const BodySpec& box = simulation.spec().bodies[0];
  const Vector3d force(300, -200, 100), torque(20, 30, -10);
  simulation.apply(0, {.force = force, .moment = torque}, Frame::body);
  simulation.step();
  const BodyState& state = simulation.states()[0];
  const Vector3d push = box.initial.orientation * (kStep / box.mass * force);
  EXPECT_LT((state.linear_velocity - push).norm(), tolerance(1e-15));
  EXPECT_LT((support::spin(box, state) - kStep * (box.initial.orientation * torque)).norm(),
            tolerance(1e-13));
}

TEST(Apply, OffTheCentreOfMassGivesTheTorqueOfItsLever) {
  for (const Frame frame : {Frame::world, Frame::body}) {
    Simulation simulation(box_at_rest());
    const BodySpec& box = simulation.spec().bodies[0];
    const Vector3d force(300, -200, 100), torque(50, 60, 70), at_B(0.5, 1, -1.5);
    simulation.apply(0, {.force = force, .moment = torque}, frame, at_B);
    simulation.step();
    const Matrix3d turn = frame == Frame::body ? box.initial.orientation.toRotationMatrix()
                                               : Matrix3d(Matrix3d::Identity());
    const Vector3d lever = box.initial.orientation * at_B;
    const Vector3d moment = turn * torque + lever.cross(turn * force);
    EXPECT_LT((support::spin(box, simulation.states()[0]) - kStep * moment).norm(),
              tolerance(1e-13));
  }
}

TEST(Apply, GivesItsImpulseToBodiesUnderAJoint) {
  SimulationSpec spec = box_at_rest();
  spec.bodies.push_back(spec.bodies[0]);
  spec.bodies[1].initial.position.x() += 2;
  spec.joints = {{.type = JointSpec::Type::fixed, .first = 0, .second = 1}};
  Simulation simulation(spec);
  const Vector3d force(300, -200, 100);
  simulation.apply(1, {.force = force});
  for (int i = 0; i < 5; ++i) simulation.step();
  const Vector3d momentum = spec.bodies[0].mass * (simulation.states()[0].linear_velocity +
                                                   simulation.states()[1].linear_velocity);
  EXPECT_LT((momentum - kStep * force).norm(), tolerance(1e-12));
  EXPECT_GT(simulation.counts()[0].constrained, 0);
}

TEST(Apply, LeavesABodyAloneThatCannotMove) {
  SimulationSpec spec = box_at_rest();
  spec.bodies[0].locked.fill(true);
  Simulation simulation(spec);
  simulation.apply(0, {.force = {1e6, 0, 0}, .moment = {0, 1e6, 0}});
  simulation.step();
  EXPECT_EQ(simulation.states()[0], spec.bodies[0].initial);
}

TEST(Apply, RefusesALoadThatIsNotFiniteAndABodyThatIsNotThere) {
  Simulation simulation(box_at_rest());
  const std::string before = bytes(simulation);
  EXPECT_THROW(simulation.apply(0, {.force = {kNan, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(simulation.apply(0, {.moment = {0, 0, 1 / 0.0}}), std::invalid_argument);
  EXPECT_THROW(simulation.apply(0, {}, Frame::body, {0, kNan, 0}), std::invalid_argument);
  EXPECT_THROW(simulation.apply(1, {}), std::invalid_argument);
  EXPECT_THROW(simulation.apply(kWorld, {}), std::invalid_argument);
  EXPECT_TRUE(bytes(simulation) == before);
}

// The limiter must take the work for what it is: nothing else holds the barge down.
TEST(Apply, LiftsABodyOutOfStillWater) {
  Simulation simulation(rocking_barge());
  const double weight = simulation.spec().bodies[0].mass * kGravity;
  while (simulation.time() < 2) {
    simulation.apply(0, {.force = {0, 0, 1.5 * weight}});
    simulation.step();
  }
  // Half of g in the inertia of the body and its added mass, but for drag.
  EXPECT_GT(simulation.states()[0].position.z(), 2);
  EXPECT_EQ(simulation.counts()[0].clamped, 0);
}

TEST(SetMotion, IsAsTheStartOfANewSimulation) {
  for (const SimulationSpec& spec : {rocking_barge(), hinged_pair()}) {
    SimulationSpec other = spec;
    for (BodySpec& body : other.bodies) body.initial.linear_velocity.z() = -0.6;
    Simulation moved(spec);
    for (int i = 0; i < 20; ++i) moved.step();
    for (std::size_t i = 0; i < spec.bodies.size(); ++i)
      moved.set_motion(static_cast<BodyId>(i), other.bodies[i].initial);
    Simulation fresh(other);
    EXPECT_TRUE(moved.states() == fresh.states());
    for (int i = 0; i < 30; ++i) moved.step(), fresh.step();
    EXPECT_TRUE(moved.states() == fresh.states());
  }
}

TEST(SetMotion, LetsABodyFallFromWhereverItIsPut) {
  Simulation simulation(rocking_barge());
  for (int i = 0; i < 20; ++i) simulation.step();
  simulation.set_motion(0, {.position = {0, 0, 50}});
  for (int i = 0; i < 30; ++i) simulation.step();
  // Nothing but the weight acts above the water, where no mass is added.
  EXPECT_NEAR(simulation.states()[0].position.z(), 50 - kGravity / 2, tolerance(1e-10));
  EXPECT_EQ(simulation.counts()[0].clamped, 0);
}

TEST(SetMotion, KeepsToTheLocks) {
  SimulationSpec spec = box_at_rest();
  spec.bodies[0].locked = {true, false, false, true, true, false};
  Simulation simulation(spec);
  support::Random random(4);
  const BodyState asked = random.state(3, 2), &start = spec.bodies[0].initial;
  simulation.set_motion(0, asked);
  const BodyState& state = simulation.states()[0];
  EXPECT_EQ(state.position.x(), start.position.x());
  EXPECT_EQ(state.position.tail<2>(), asked.position.tail<2>());
  EXPECT_EQ(state.linear_velocity,
            Vector3d(0, asked.linear_velocity.y(), asked.linear_velocity.z()));
  EXPECT_EQ(state.angular_velocity, Vector3d(0, 0, asked.angular_velocity.z()));
  const Vector3d turn = (state.orientation * start.orientation.conjugate()).vec();
  EXPECT_LT(turn.head<2>().norm(), tolerance(1e-15));
  spec.bodies[0].locked.fill(true);
  Simulation immovable(spec);
  immovable.set_motion(0, asked);
  EXPECT_EQ(immovable.states()[0].position, start.position);
  EXPECT_EQ(immovable.states()[0].linear_velocity, Vector3d::Zero());
}

TEST(SetMotion, KeepsToAReducedJoint) {
  SimulationSpec spec = box_at_rest();
  const BodyState& start = spec.bodies[0].initial;
  const Vector3d anchor = start.position + Vector3d(0.5, 1, 0.3);
  const Vector3d anchor_B = start.orientation.conjugate() * Vector3d(anchor - start.position);
  for (const auto type : {JointSpec::Type::hinge, JointSpec::Type::ball}) {
    spec.joints = {{.type = type, .first = 0, .anchor_W = anchor, .axis_W = Vector3d::UnitY()}};
    Simulation simulation(spec);
    simulation.set_motion(0, support::Random(5).state(3, 2));
    const BodyState& state = simulation.states()[0];
    const Vector3d lever = state.orientation * anchor_B;
    EXPECT_LT((state.position + lever - anchor).norm(), tolerance(1e-14));
    EXPECT_LT((state.linear_velocity + state.angular_velocity.cross(lever)).norm(),
              tolerance(1e-14));
    EXPECT_GT(state.angular_velocity.norm(), 0.1);
    if (type == JointSpec::Type::ball) continue;
    EXPECT_LT(state.angular_velocity.cross(Vector3d::UnitY()).norm(), tolerance(1e-14));
  }
}

TEST(SetMotion, BeginsTheRecordOfWorkAnew) {
  SimulationSpec spec = rocking_barge();
  spec.record_work = true;
  Simulation simulation(spec);
  for (int i = 0; i < 20; ++i) simulation.step();
  EXPECT_NE(simulation.forces()[0].works.sum(), 0);
  simulation.set_motion(0, simulation.states()[0]);
  EXPECT_EQ(simulation.forces()[0].works.sum(), 0);
}

TEST(SetMotion, RefusesStatesThatNoBodyCanHave) {
  Simulation simulation(rocking_barge());
  const std::string before = bytes(simulation);
  EXPECT_THROW(simulation.set_motion(0, {.position = {kNan, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(simulation.set_motion(0, {.linear_velocity = {0, 1e10, 0}}), std::invalid_argument);
  EXPECT_THROW(simulation.set_motion(0, {.orientation = Quaterniond(2, 0, 0, 0)}),
               std::invalid_argument);
  EXPECT_THROW(simulation.set_motion(0, {.orientation = Quaterniond(0, 0, 0, 0)}),
               std::invalid_argument);
  EXPECT_THROW(simulation.set_motion(1, {}), std::invalid_argument);
  EXPECT_THROW(simulation.set_motion(kWorld, {}), std::invalid_argument);
  EXPECT_TRUE(bytes(simulation) == before);
}

TEST(Reset, LeadsBackToTheFirstBytesAndTheSameRun) {
  for (const SimulationSpec& spec : {rocking_barge(), hinged_pair()}) {
    Simulation simulation(spec);
    const std::string start = bytes(simulation);
    for (int i = 0; i < 20; ++i) simulation.step();
    const std::string first_run = bytes(simulation);
    simulation.pull(0, engine::Pull{.to_W = {1, 2, 3}});
    simulation.set_motion(0, {.position = {0, 0, 3}});
    for (int i = 0; i < 5; ++i) simulation.step();
    simulation.apply(0, {.force = {1, 2, 3}});
    simulation.reset();
    EXPECT_EQ(simulation.time(), 0);
    EXPECT_TRUE(bytes(simulation) == start);
    for (int i = 0; i < 20; ++i) simulation.step();
    EXPECT_TRUE(bytes(simulation) == first_run);
  }
}

}  // namespace

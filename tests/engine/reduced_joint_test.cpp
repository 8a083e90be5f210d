#include "engine/motion/reduced_joint.h"

#include "engine/motion/added_inertia.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "tests/engine/prelude.h"

namespace {

using engine::ReducedJoint;
using Type = JointSpec::Type;

/// A box with drag in deep water on a joint to the world, in any pose.
SimulationSpec in_deep_water(support::Random& random, Type type, double step) {
  BodySpec box = support::box_body("box", {0.4, 1, 0.7}, 1800, {0, 0, 0}, 3);
  box.wet = true;
  box.coefficients.lift = 0;
  box.initial.orientation = random.rotation();
  box.initial.position = {random.uniform(-5, 5), random.uniform(-5, 5), -30};
  SimulationSpec spec = support::dry_world({box}, step);
  spec.sea.emplace();
  spec.joints = {{.name = "joint",
                  .type = type,
                  .first = 0,
                  .anchor_W = box.initial.position + random.vector(1),
                  .axis_W = random.vector(1).normalized()}};
  return spec;
}

TEST(ReducedJoint, MakesAPendulumOfMoreThanSecondOrder) {
  const auto after = [](double step) {
    BodySpec rod =
        support::box_body("rod", {0.1, 0.1, 2}, 1000, {2 * std::sin(1), 0, -2 * std::cos(1)});
    rod.initial.orientation = Eigen::AngleAxisd(-1, Vector3d::UnitY());
    SimulationSpec spec = support::dry_world({rod}, step);
    spec.joints = {{.type = Type::hinge, .first = 0, .axis_W = Vector3d::UnitY()}};
    return support::after(spec, support::steps_in(6, step)).states()[0];
  };
  const hydro::BodyState exact = after(1.0 / 1600);
  const double error = distance(after(1.0 / 50), exact);
  EXPECT_LT(error, tolerance(1e-5));
  EXPECT_GT(error / distance(after(1.0 / 100), exact), 7);  // 2³ of the first steps, 2⁴ of others
}

TEST(ReducedJoint, IsNeverLeft) {
  support::Random random(3);
  for (const Type type : {Type::hinge, Type::slider, Type::ball}) {
    SimulationSpec spec = in_deep_water(random, type, 0.02);
    const JointSpec& joint = spec.joints[0];
    const hydro::BodyState& start = spec.bodies[0].initial;
    const Vector3d anchor_B =
        start.orientation.conjugate() * Vector3d(joint.anchor_W - start.position);
    const hydro::BodyState end = support::after(spec, 400).states()[0];
    const Eigen::Quaterniond turn = end.orientation * start.orientation.conjugate();
    EXPECT_GT(distance(end, start), 0.1);
    if (type != Type::ball) {
      EXPECT_LT(turn.vec().cross(joint.axis_W).norm(), tolerance(1e-13));
    }
    if (type != Type::slider) {
      EXPECT_LT((end.position + end.orientation * anchor_B - joint.anchor_W).norm(),
                tolerance(1e-13 * 30));
    } else {
      EXPECT_LT((end.position - start.position).cross(joint.axis_W).norm(), tolerance(1e-12));
      EXPECT_LT(turn.vec().norm(), tolerance(1e-13));
    }
  }
}

TEST(ReducedJoint, LeadsWhereTheConstraintSolverDoes) {
  support::Random random(5);
  for (const Type type : {Type::hinge, Type::slider, Type::ball}) {
    SimulationSpec spec = in_deep_water(random, type, 1.0 / 2000);
    const hydro::BodyState ours = support::after(spec, 2000).states()[0];
    const Simulation solved = support::after(support::left_to_the_solver(spec), 2000);
    EXPECT_GT(solved.counts()[0].constrained, 0);
    // The solver's joints give way by (ω h)²/2 of the lever in a step, and it is of second order.
    EXPECT_LT(distance(ours, solved.states()[0]), tolerance(2e-5));
  }
}

TEST(ReducedJoint, LetsASliderFallAsDownASlope) {
  BodySpec body = support::box_body("carriage", {1, 2, 3}, 100, {4, -5, 6});
  SimulationSpec spec = support::dry_world({body}, 0.1);
  const Vector3d axis = Vector3d(1, 2, -2).normalized();
  spec.joints = {{.type = Type::slider, .first = 0, .axis_W = axis}};
  const double fallen = spec.gravity * -axis.z() * 3 * 3 / 2;
  EXPECT_LT((support::after(spec, 30).states()[0].position - body.initial.position - fallen * axis)
                .norm(),
            tolerance(1e-12 * fallen));
}

TEST(ReducedJoint, TakesUpTheMomentumAlongIt) {
  support::Random random(8);
  SimulationSpec spec = in_deep_water(random, Type::hinge, 0.01);
  BodySpec& body = spec.bodies[0];
  body.initial.linear_velocity = random.vector(2);
  body.initial.angular_velocity = random.vector(2);
  const ReducedJoint reduced_joint = engine::find_reduced_joint(spec, 0).value();
  const Vector6d n = engine::motion_subspace(reduced_joint, body.initial);
  const hydro::Matrix6d S = engine::rotate_tensor(body.initial.orientation.toRotationMatrix(),
                                                  engine::rigid_inertia(body));
  const Vector6d before = engine::velocity(body.initial, Vector3d::Zero());
  const Simulation simulation(spec);
  const Vector6d after = engine::velocity(simulation.states()[0], Vector3d::Zero());
  EXPECT_NEAR(n.dot(S * after), n.dot(S * before), tolerance(1e-12 * S.norm()));
  EXPECT_LT((after - n * after.dot(n) / n.dot(n)).norm(), tolerance(1e-13));
}

TEST(ReducedJoint, KeepsTheMomentumAlongItWhereAddedMassGrows) {
  support::Random random(11);
  const auto six = [&] { return engine::to_vector6(random.vector(1), random.vector(1)); };
  const auto positive = [&] {
    hydro::Matrix6d m;
    for (int i = 0; i < 6; ++i) m.col(i) = six();
    return hydro::Matrix6d(m * m.transpose() + 0.1 * hydro::Matrix6d::Identity());
  };
  for (const int count : {1, 3}) {
    const hydro::Matrix6d S = positive(), growth = positive();
    engine::Subspace N(6, count);
    for (int i = 0; i < count; ++i) N.col(i) = six();
    const Vector6d u = N * Eigen::VectorXd::LinSpaced(count, 1, 2);
    const engine::Mobility mobility{.subspace = N};
    const engine::InertiaChange in = engine::inertia_change(S, growth, mobility, u);
    const double rounding = tolerance(1e-12 * (S + growth).norm());
    const Vector6d gained = (S + growth) * in.velocity - S * u;
    const hydro::Matrix6d off = in.inertia - S - growth;
    for (int i = 0; i < count; ++i) {
      EXPECT_NEAR(N.col(i).dot(gained), 0, rounding);
      EXPECT_NEAR(N.col(i).dot(off * N.col(0)), 0, rounding);
    }
    const Vector6d out = engine::inertia_change(S + growth, -growth, mobility, u).velocity;
    EXPECT_LT((out - u).norm(), tolerance(1e-12));
  }
}

// A top without weight: about the pivot its momentum stays, as that of a free body about its
// centre.
TEST(ReducedJoint, KeepsTheMomentumAboutABallJoint) {
  support::Random random(13);
  SimulationSpec spec = in_deep_water(random, Type::ball, 0.02);
  spec.sea.reset();
  spec.gravity = 0;
  spec.bodies[0].initial.angular_velocity = random.vector(4);
  const auto momentum = [&](const hydro::BodyState& state) {
    return Vector3d(support::spin(spec.bodies[0], state) +
                    spec.bodies[0].mass *
                        (state.position - spec.joints[0].anchor_W).cross(state.linear_velocity));
  };
  Simulation simulation(spec);
  const Vector3d before = momentum(simulation.states()[0]);
  const double energy = support::energy(spec, simulation.states());
  for (int i = 0; i < 1000; ++i) simulation.step();
  EXPECT_LT((momentum(simulation.states()[0]) - before).norm(), tolerance(1e-11 * before.norm()));
  EXPECT_NEAR(support::energy(spec, simulation.states()) / energy, 1, tolerance(1e-11));
}

TEST(ReducedJoint, IsThatOfABodyWithOneJointToTheWorldAlone) {
  support::Random random(2);
  const SimulationSpec spec = in_deep_water(random, Type::hinge, 0.01);
  ASSERT_TRUE(engine::find_reduced_joint(spec, 0));
  const auto without = [&](const auto& change) {
    SimulationSpec other = spec;
    change(other);
    return !engine::find_reduced_joint(other, 0);
  };
  EXPECT_TRUE(without([](SimulationSpec& s) { s.joints.push_back(s.joints[0]); }));
  EXPECT_TRUE(without([](SimulationSpec& s) { s.joints.clear(); }));
  EXPECT_TRUE(without([](SimulationSpec& s) { s.joints[0].type = Type::universal; }));
  EXPECT_TRUE(without([](SimulationSpec& s) { s.bodies[0].locked[0] = true; }));
  const auto hung_on_another = [](SimulationSpec& s) {
    s.bodies.push_back(s.bodies[0]);
    s.joints[0].second = 1;
  };
  EXPECT_TRUE(without(hung_on_another));
  EXPECT_FALSE(without([&](SimulationSpec& s) {
    hung_on_another(s);
    s.bodies[1].locked.fill(true);
  }));
  const auto with_added_mass = [](SimulationSpec& s) {
    s.bodies[0].added_mass = std::make_shared<hydro::ConstantAddedMass>(
        s.bodies[0].mesh_B, hydro::Matrix6d(100 * hydro::Matrix6d::Identity()));
  };
  EXPECT_FALSE(without(with_added_mass));
  EXPECT_TRUE(without([&](SimulationSpec& s) {
    with_added_mass(s);
    s.sea->current = {1, 0, 0};
  }));
  EXPECT_FALSE(without([&](SimulationSpec& s) {
    with_added_mass(s);
    s.sea->current = {1, 0, 0};
    s.bodies[0].locked[0] = true;
    s.joints[0].type = Type::fixed;
  }));
}

TEST(ReducedJoint, GivesWayToContacts) {
  BodySpec flap = support::box_body("flap", {2, 1, 0.1}, 500, {1.2, 0, 1});
  flap.collision = engine::CollisionShape::box;
  SimulationSpec spec = support::dry_world({flap}, 0.01);
  spec.ground = engine::PlaneGround{0};
  spec.joints = {
      {.type = Type::hinge, .first = 0, .anchor_W = {0.1, 0, 1}, .axis_W = Vector3d::UnitY()}};
  Simulation simulation(spec);
  double lowest = 1;
  for (int i = 0; i < 1000; ++i) {
    simulation.step();
    const hydro::BodyState& state = simulation.states()[0];
    for (const double side : {-0.05, 0.05})
      lowest = std::min(lowest, (state.position + state.orientation * Vector3d(1, 0, side)).z());
  }
  EXPECT_GT(lowest, -0.06);  // it comes down at 5 m/s: 5 cm in a step
  EXPECT_LT(simulation.states()[0].angular_velocity.norm(), tolerance(1e-3));
  EXPECT_GT(simulation.counts()[0].constrained, 100);
  EXPECT_GT(simulation.counts()[0].free, 10);
}

}  // namespace

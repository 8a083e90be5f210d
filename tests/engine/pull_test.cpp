#include "engine/motion/pull.h"

#include "tests/engine/prelude.h"

/// What a hand does to the body that it draws, and that it leaves nothing behind.

namespace {

using engine::Pull;

constexpr double kRate = 5;  // [1/s]

/// p − to over its start after a time from rest.
double part_left(double time) { return (1 + kRate * time) * std::exp(-kRate * time); }

SimulationSpec box_in_space(double step = kStep) {
  SimulationSpec spec =
      support::dry_world({support::box_body("box", {1, 2, 0.5}, 700, {3, -2, 5})}, step);
  spec.gravity = 0;
  spec.bodies[0].initial.orientation =
      Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
  return spec;
}

Vector3d point(const Simulation& simulation, const Vector3d& at_B) {
  const hydro::BodyState& state = simulation.states()[0];
  return state.position + state.orientation * at_B;
}

/// Of the part of the way that is left, after a second in which the body is drawn.
double error_of_drawing(double step) {
  Simulation simulation(box_in_space(step));
  const Vector3d start = simulation.states()[0].position;
  const Vector3d way(0.3, -0.8, 0.5);
  simulation.pull(0, Pull{.to_W = start + way, .rate = kRate});
  for (long i = 0; i < support::steps_in(1, step); ++i) simulation.step();
  const Vector3d expected = start + (1 - part_left(1)) * way;
  return (simulation.states()[0].position - expected).norm() / way.norm();
}

TEST(Pull, BringsACentreOfMassAsACriticallyDampedSpringDoes) {
  const double coarse = error_of_drawing(0.02);
  const double fine = error_of_drawing(0.01);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(fine, coarse / 3);  // second order
}

TEST(Pull, BringsACornerAsFastAsTheCentreOfMass) {
  Simulation simulation(box_in_space());
  const Vector3d corner(0.5, 1, -0.25);
  const Vector3d start = point(simulation, corner);
  const Vector3d way(2e-3, 1e-3, -1e-3);  // So short that the body turns little.
  simulation.pull(0, Pull{.at_B = corner, .to_W = start + way, .rate = kRate});
  for (long i = 0; i < support::steps_in(0.4, kStep); ++i) simulation.step();
  const Vector3d expected = start + (1 - part_left(0.4)) * way;
  EXPECT_LT((point(simulation, corner) - expected).norm(), 0.01 * way.norm());
}

TEST(Pull, OfAHangingBodySagsByItsWeight) {
  SimulationSpec spec = box_in_space();
  spec.gravity = support::kGravity;
  Simulation simulation(spec);
  const Vector3d to(3, -2, 5);
  simulation.pull(0, Pull{.to_W = to, .rate = kRate});
  for (long i = 0; i < support::steps_in(6, kStep); ++i) simulation.step();
  const double sag = to.z() - simulation.states()[0].position.z();
  EXPECT_NEAR(sag, support::kGravity / (kRate * kRate), tolerance(1e-9));
}

TEST(Pull, StaysStableAtAnyRateThatIsAskedFor) {
  SimulationSpec spec = box_in_space();
  spec.gravity = support::kGravity;
  for (bool wet : {false, true}) {
    if (wet) spec.sea = hydro::Sea{.gravity = support::kGravity, .level = 5};
    spec.bodies[0].wet = wet;
    Simulation simulation(spec);
    const Vector3d corner(0.5, 1, -0.25), to(4, -2, 6);
    simulation.pull(0, Pull{.at_B = corner, .to_W = to, .rate = 1e6});
    for (long i = 0; i < support::steps_in(20, kStep); ++i) simulation.step();
    EXPECT_LT((point(simulation, corner) - to).norm(), 0.1);
    // In air it swings on for ever, no faster than by a fall of twice its corner's distance.
    const double fastest = wet ? 0.1 : std::sqrt(4 * support::kGravity * corner.norm());
    EXPECT_LT(simulation.states()[0].linear_velocity.norm(), fastest);
  }
}

TEST(Pull, LeavesABodyThatIsLetGoToFall) {
  SimulationSpec spec = box_in_space();
  spec.gravity = support::kGravity;
  Simulation simulation(spec);
  simulation.pull(0, Pull{.to_W = {5, 0, 6}, .rate = kRate});
  for (int i = 0; i < 30; ++i) simulation.step();
  simulation.pull(0, std::nullopt);
  const hydro::BodyState start = simulation.states()[0];
  for (int i = 0; i < 100; ++i) simulation.step();
  const double t = 100 * kStep;
  const Vector3d fall(0, 0, -support::kGravity * t * t / 2);
  const Vector3d expected = start.position + t * start.linear_velocity + fall;
  EXPECT_LT((simulation.states()[0].position - expected).norm(), tolerance(1e-12));
}

TEST(Pull, ThatEndsBeforeAStepChangesNoByte) {
  SimulationSpec spec = box_in_space();
  spec.gravity = support::kGravity;
  spec.bodies[0].wet = true;
  spec.sea = hydro::Sea{.gravity = support::kGravity, .level = 5};
  Simulation touched(spec), left(spec);
  touched.pull(0, Pull{.to_W = {9, 9, 9}});
  touched.pull(0, std::nullopt);
  for (int i = 0; i < 50; ++i) touched.step(), left.step();
  EXPECT_EQ(touched.states()[0], left.states()[0]);
}

}  // namespace

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/rig_specs.h"

namespace {

using Eigen::Vector3d;
using engine::JointMotor;
using engine::JointSpec;
using engine::kWorld;
using engine::Simulation;
using engine::SimulationSpec;

constexpr double kDriveStep = 1.0 / 60;

/// A box of 2 m on a hinge along y through the origin, in weightless space.
SimulationSpec hinged(double step = kDriveStep) {
  SimulationSpec spec =
      support::dry_world({support::box_body("flap", {2, 1, 0.2}, 1000, {1, 0, 0})}, step);
  spec.gravity = 0;
  spec.joints = {{.name = "hinge",
                  .type = JointSpec::Type::hinge,
                  .first = kWorld,
                  .second = 0,
                  .anchor_W = {0, 0, 0},
                  .axis_W = {0, 1, 0}}};
  return spec;
}

/// Moment of inertia of the flap about the hinge [kg m^2].
double inertia(const SimulationSpec& spec) {
  return spec.bodies[0].inertia_B(1, 1) + spec.bodies[0].mass;
}

JointMotor motor(SimulationSpec& spec, JointMotor::Mode mode, double value, double most) {
  return {.mode = mode,
          .set_point = support::add_set_point(spec, "joints[hinge].motor", value),
          .largest_effort = most};
}

TEST(JointMotor, OfSpeedAcceleratesAtItsLargestTorqueAndThenHoldsTheSpeed) {
  SimulationSpec spec = hinged();
  const double I = inertia(spec), torque = 500, speed = 1.5;
  spec.joints[0].drive.motor = motor(spec, JointMotor::Mode::speed, speed, torque);
  Simulation simulation(std::move(spec));
  for (int i = 1; i <= 300; ++i) {
    simulation.step();
    const double t = i * kDriveStep;
    const auto joint = simulation.rig().joints[0];
    const double reached = I * speed / torque;
    EXPECT_NEAR(joint.speed, std::min(torque * t / I, speed), 1e-3) << t;
    if (t < reached - kDriveStep) {
      EXPECT_NEAR(joint.coordinate, torque * t * t / (2 * I), 1e-3) << t;
    }
    if (t < reached - kDriveStep) {
      EXPECT_NEAR(joint.effort, torque, 1e-6 * torque) << t;
    }
    if (t > reached + kDriveStep) {
      EXPECT_NEAR(joint.effort, 0, 1e-3 * torque) << t;
    }
  }
}

TEST(JointMotor, OfPositionComesToItsAngleWithoutOvershoot) {
  SimulationSpec spec = hinged();
  const double target = 0.8;
  spec.joints[0].drive.motor =
      motor(spec, JointMotor::Mode::position, target, std::numeric_limits<double>::infinity());
  spec.joints[0].drive.motor->rate = 4;
  Simulation simulation(std::move(spec));
  for (int i = 1; i <= 300; ++i) {
    simulation.step();
    const double t = i * kDriveStep;
    const double exact = target * (1 - (1 + 4 * t) * std::exp(-4 * t));
    ASSERT_NEAR(simulation.rig().joints[0].coordinate, exact, 2e-3) << t;
    ASSERT_LT(simulation.rig().joints[0].coordinate, target + 1e-9);
  }
}

TEST(JointMotor, OfEffortIsATorque) {
  SimulationSpec spec = hinged();
  const double I = inertia(spec), torque = 300;
  spec.joints[0].drive.motor = motor(spec, JointMotor::Mode::effort, torque, 1e9);
  Simulation simulation(std::move(spec));
  for (int i = 0; i < 60; ++i) simulation.step();
  EXPECT_NEAR(simulation.rig().joints[0].coordinate, torque / (2 * I), 1e-9);
  EXPECT_EQ(simulation.counts()[0].constrained, 0);  // a load of the joint's own coordinate
}

TEST(JointDrive, TellsTheEffortsOfItsParts) {
  for (const JointMotor::Mode mode : {JointMotor::Mode::effort, JointMotor::Mode::speed}) {
    SimulationSpec spec = hinged();
    engine::JointDrive& drive = spec.joints[0].drive;
    drive.damping = 40;
    drive.stiffness = 300;
    drive.rest = 0.1;
    drive.motor = motor(spec, mode, mode == JointMotor::Mode::effort ? 70 : 2, 50);
    Simulation simulation(std::move(spec));
    for (int i = 0; i < 20; ++i) {
      simulation.step();
      const auto joint = simulation.rig().joints[0];
      EXPECT_EQ(joint.damper, -40 * joint.speed);
      EXPECT_EQ(joint.spring, -300 * (joint.coordinate - 0.1));
      EXPECT_NEAR(joint.motor, 50, 1e-9) << "the largest effort";
      EXPECT_NEAR(joint.effort, joint.damper + joint.spring + joint.motor, 1e-9);
    }
  }
}

TEST(JointLimits, StopAFlapThatFalls) {
  SimulationSpec spec = hinged();
  spec.gravity = support::kGravity;
  spec.joints[0].drive.limits = {{-0.2, 0.5}};  // it falls towards positive q
  Simulation simulation(std::move(spec));
  double greatest = 0;
  for (int i = 0; i < 300; ++i) {
    simulation.step();
    greatest = std::max(greatest, simulation.rig().joints[0].coordinate);
  }
  EXPECT_LT(greatest, 0.5 + 0.06);  // a step of the motion at the stop
  EXPECT_NEAR(simulation.rig().joints[0].coordinate, 0.5, 1e-4);
  EXPECT_NEAR(simulation.rig().joints[0].speed, 0, 1e-6);
}

TEST(JointLimits, GiveNoEnergyToABodyThatHitsThem) {
  for (const double speed : {1.0, 10.0, 100.0}) {
    SimulationSpec spec = hinged();
    spec.joints[0].drive.limits = {{-0.2, 0.5}};
    spec.bodies[0].initial.angular_velocity = {0, speed, 0};
    spec.bodies[0].initial.linear_velocity = {0, 0, -speed};
    Simulation simulation(std::move(spec));
    double last = speed;
    for (int i = 0; i < 300; ++i) {
      simulation.step();
      const double now = std::abs(simulation.rig().joints[0].speed);
      // What an impact has taken beyond the stop is taken back with 2e-4 of the greatest energy.
      ASSERT_LT(now * now - last * last, 1e-3 * speed * speed) << speed << " " << i;
      last = now;
    }
    EXPECT_LT(last, speed / 2) << speed;
  }
}

TEST(JointLimits, HoldTheStaticTorqueOfTheWeight) {
  SimulationSpec spec = hinged();
  spec.gravity = support::kGravity;
  spec.joints[0].drive.limits = {{-0.2, 0.5}};
  const double weight = spec.bodies[0].mass * spec.gravity;
  Simulation simulation(std::move(spec));
  for (int i = 0; i < 300; ++i) simulation.step();
  const auto joint = simulation.rig().joints[0];
  EXPECT_NEAR(joint.effort, -weight * std::cos(0.5), 1e-3 * weight);
  EXPECT_NEAR(joint.force_W.z(), weight, 1e-3 * weight);
  EXPECT_NEAR(joint.moment_W.norm(), 0, 1e-3 * weight);
}

TEST(JointSpring, OscillatesAtItsFrequency) {
  for (const double w : {2.0, 60.0}) {
    SimulationSpec spec = hinged(1.0 / 240);
    const double I = inertia(spec);
    spec.joints[0].drive.stiffness = I * w * w;
    spec.joints[0].drive.rest = 0.1;
    Simulation simulation(std::move(spec));
    for (int i = 0; i < 240; ++i) simulation.step();
    if (w == 2.0) {
      EXPECT_NEAR(simulation.rig().joints[0].coordinate, 0.1 * (1 - std::cos(w)), 1e-5);
    }
    EXPECT_LT(std::abs(simulation.rig().joints[0].coordinate - 0.1), 0.101) << w;
  }
}

TEST(JointFriction, HoldsUntilTheTorqueExceedsIt) {
  SimulationSpec spec = hinged();
  const double I = inertia(spec);
  spec.joints[0].drive.friction = 100;
  spec.bodies[0].loads = {{.torque = {0, 90, 0}}};
  Simulation held(spec);
  spec.bodies[0].loads = {{.torque = {0, 150, 0}}};
  Simulation slips(std::move(spec));
  for (int i = 0; i < 60; ++i) held.step(), slips.step();
  EXPECT_NEAR(held.rig().joints[0].coordinate, 0, 1e-8);
  EXPECT_NEAR(slips.rig().joints[0].coordinate, 50 / (2 * I), 1e-6);
}

TEST(JointMotor, OfASliderBetweenBodiesKeepsMomentumAndAngularMomentum) {
  SimulationSpec spec = support::dry_world({support::box_body("a", {1, 1, 1}, 1000, {0, 0, 0}),
                                            support::box_body("b", {1, 1, 1}, 300, {0, 2, 0.5})},
                                           kDriveStep);
  spec.gravity = 0;
  spec.joints = {{.name = "slide",
                  .type = JointSpec::Type::slider,
                  .first = 0,
                  .second = 1,
                  .axis_W = {1, 0, 0}}};
  spec.joints[0].drive.motor = motor(spec, JointMotor::Mode::speed, 0.5, 2000);
  const auto bodies = spec.bodies;
  Simulation simulation(std::move(spec));
  for (int i = 0; i < 60; ++i) simulation.step();
  Vector3d P = Vector3d::Zero(), L = Vector3d::Zero();
  for (int i = 0; i < 2; ++i) {
    const auto& s = simulation.states()[i];
    const Vector3d p = bodies[i].mass * s.linear_velocity;
    P += p;
    L += s.position.cross(p) + support::spin(bodies[i], s);
  }
  EXPECT_NEAR(simulation.rig().joints[0].speed, 0.5, 1e-3);
  EXPECT_NEAR(P.norm(), 0, 1e-6);
  EXPECT_NEAR(L.norm(), 0, 0.5);  // ODE's correction of joints turns the pair by a little
}

TEST(JointReaction, OfAReducedHingeIsTheCentripetalForce) {
  SimulationSpec spec = hinged();
  spec.record_work = true;
  spec.bodies[0].initial.angular_velocity = {0, 2, 0};
  spec.bodies[0].initial.linear_velocity = {0, 0, -2};
  const double m = spec.bodies[0].mass;
  Simulation simulation(std::move(spec));
  for (int i = 0; i < 30; ++i) simulation.step();
  EXPECT_NEAR(simulation.rig().joints[0].force_W.norm(), m * 4, 1e-3 * m * 4);
}

}  // namespace

#include "engine/step/group_stepper.h"

#include "hydro/added_mass/added_mass.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "tests/engine/island.h"
#include "tests/engine/prelude.h"

/// A step of one group, without the simulation around it.

namespace {

/// The bodies of a specification as one group.
struct OneGroup {
  OneGroup(const SimulationSpec& spec, const std::vector<engine::Pair>& joints,
           const std::vector<engine::Pair>& near, double tolerance = 0)
      : all(spec) {
    all.context.tolerance = tolerance;
    for (std::size_t i = 0; i < all.bodies.size(); ++i) {
      group.bodies.push_back(static_cast<BodyId>(i));
      limiters.push_back(engine::EnergyLimiter({static_cast<BodyId>(i)}, all.bodies));
    }
    group.joints = joints;
    group.near = near;
    for (engine::EnergyLimiter& limiter : limiters) own.push_back(&limiter);
    stepper.emplace(all.context, group, own, own, engine::PastContacts{untouched, forceless},
                    all.spec.step);
  }

  const engine::Counts& counts(std::size_t i) const { return all.bodies[i].counts; }
  const BodyState& state(std::size_t i) const { return all.bodies[i].motion.state; }

  support::IslandOfAll all;
  std::vector<engine::Pair> untouched;
  std::vector<engine::ContactForce> forceless;
  engine::Group group;
  std::vector<engine::EnergyLimiter> limiters;
  std::vector<engine::EnergyLimiter*> own;
  std::optional<engine::GroupStepper> stepper;
};

TEST(GroupStepper, LetsABodyAloneFallInOneSubstep) {
  OneGroup one(support::dry_world({support::box_body("a", {1, 1, 1}, 500, {0, 0, 9})}, kStep), {},
               {});
  one.stepper->advance(0, kStep);
  EXPECT_NEAR(one.state(0).linear_velocity.z(), -kGravity * kStep, 1e-15);
  EXPECT_NEAR(one.state(0).position.z(), 9 - kGravity * kStep * kStep / 2, 1e-14);
  EXPECT_EQ(one.counts(0).free, 1);
  EXPECT_EQ(one.counts(0).substeps, 1);
}

TEST(GroupStepper, DividesAStepInWhichABodyCrossesTheSurface) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 0.6});
  spec.step = 0.1;
  spec.bodies[0].initial.linear_velocity = {0, 0, -10};
  OneGroup one(spec, {}, {});
  one.stepper->advance(0, 0.1);
  EXPECT_GE(one.counts(0).substeps, 2);
  EXPECT_EQ(one.counts(0).free, 1);
}

/// The added mass at the end of a step is not looked at where it is foreseen.
TEST(GroupStepper, EndsEachStepWithTheAddedMassOfThePose) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 1});
  BodySpec& box = spec.bodies[0];
  box.added_mass = std::make_shared<hydro::WettedAddedMass>(
      box.mesh_B, hydro::solve_added_mass(box.mesh_B, {.tolerance = 0.1}));
  box.initial.orientation = Eigen::AngleAxisd(0.6, Vector3d(1, 2, 0).normalized());
  box.initial.linear_velocity = {3, 0, 0};
  box.initial.angular_velocity = {1, 0, 2};
  OneGroup one(spec, {}, {});
  const engine::MovingBody& moving = one.all.bodies[0];
  double largest = 0;
  for (int i = 0; i < 300; ++i) {
    one.stepper->advance(i * kStep, kStep);
    const Matrix6d found = engine::added_mass(moving.body, moving.motion.state, nullptr, 0);
    largest =
        std::max(largest, engine::scaled_change(moving.body, found, found - moving.motion.added()));
  }
  // The state is a twenty-fourth of h² times the acceleration off the pose (E9).
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 1e-4);
}

TEST(GroupStepper, DividesAStepUntilItsErrorIsWithinTheTolerance) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 0.2});
  spec.step = 0.1;
  spec.bodies[0].coefficients = {.pressure_drag = {0, 0}, .lift = 0, .viscous_drag = {}};
  spec.bodies[0].coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  OneGroup coarse(spec, {}, {}), fine(spec, {}, {}, 1e-7);
  coarse.stepper->advance(0, 0.1);
  fine.stepper->advance(0, 0.1);
  EXPECT_GT(fine.counts(0).substeps, coarse.counts(0).substeps);
  // The heave of a box is an oscillation, ω² = ρ g A / m.
  const double z = 0.2 * std::cos(std::sqrt(kGravity / 0.5) * 0.1);
  EXPECT_NEAR(fine.state(0).position.z(), z, 1e-7 * 0.1);
}

TEST(GroupStepper, MovesABodyThatNothingTouchesBySubstepsOfItsOwn) {
  std::vector<BodySpec> boxes = {support::box_body("low", {1, 1, 1}, 500, {0, 0, 0.499}),
                                 support::box_body("high", {1, 1, 1}, 500, {0, 0, 3})};
  for (BodySpec& box : boxes) box.collision = CollisionShape::box;
  SimulationSpec spec = support::dry_world(boxes, kStep);
  spec.ground = engine::PlaneGround{0};
  OneGroup heap(spec, {}, {{kWorld, 0}, {kWorld, 1}, {0, 1}});
  heap.stepper->advance(0, kStep);
  EXPECT_EQ(heap.counts(1).free, heap.counts(1).substeps);
  EXPECT_EQ(heap.counts(1).constrained, 0);
  EXPECT_GT(heap.counts(0).constrained, 0);
  EXPECT_NEAR(heap.state(1).position.z(), 3 - kGravity * kStep * kStep / 2, 1e-13);
  const std::vector<engine::Pair> ground = {{kWorld, 0}};
  EXPECT_EQ(heap.stepper->contacts().touching, ground);
}

TEST(GroupStepper, HoldsBodiesOnTheirJoint) {
  SimulationSpec spec = support::dry_world({support::box_body("a", {1, 1, 1}, 500, {0, 0, 0}),
                                            support::box_body("b", {1, 1, 1}, 100, {2, 0, 0})},
                                           kStep);
  spec.bodies[1].initial.linear_velocity = {0, 0, 1};
  spec.joints = {{.name = "pin",
                  .type = JointSpec::Type::ball,
                  .first = 0,
                  .second = 1,
                  .anchor_W = {1, 0, 0}}};
  OneGroup pair(spec, {{0, 1}}, {});
  for (int i = 0; i < 100; ++i) pair.stepper->advance(i * kStep, kStep);
  const auto anchor = [&](std::size_t i, const Vector3d& at_B) {
    return Vector3d(pair.state(i).position + pair.state(i).orientation * at_B);
  };
  EXPECT_LT((anchor(0, {1, 0, 0}) - anchor(1, {-1, 0, 0})).norm(), 1e-3);
  EXPECT_GT(pair.counts(0).constrained, 0);
}

}  // namespace

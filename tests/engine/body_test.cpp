#include "engine/motion/body.h"

#include <memory>

#include "engine/base/constants.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "tests/engine/prelude.h"

/// The constant side of a body, and what follows from it and a state.

namespace {

using engine::AddedMassMatch;
using engine::Body;
using engine::Motion;

/// A box of 1 m afloat with a constant added mass.
SimulationSpec box_with_added_mass(const Matrix6d& added) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  BodySpec& box = spec.bodies[0];
  box.added_mass = std::make_shared<const hydro::ConstantAddedMass>(box.mesh_B, added);
  return spec;
}

TEST(Body, ItsVerticalExtentIsThatOfItsTurnedBox) {
  support::Random random(3);
  SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  spec.bodies[0].mesh_B = support::box_body("b", {2, 0.5, 0.3}, 500, {0, 0, 0}).mesh_B;
  const Body body = engine::make_bodies(spec)[0];
  for (int i = 0; i < 20; ++i) {
    const BodyState state{.position = random.vector(3), .orientation = random.rotation()};
    const Eigen::Matrix3Xd corners =
        (state.orientation.toRotationMatrix() * spec.bodies[0].mesh_B.vertices).colwise() +
        state.position;
    const engine::VerticalExtent extent = engine::vertical_extent(body, state);
    EXPECT_NEAR(extent.lowest, corners.row(2).minCoeff(), 1e-14);
    EXPECT_NEAR(extent.lowest + extent.height, corners.row(2).maxCoeff(), 1e-14);
  }
}

TEST(Body, MayBeWetBelowTheHighestCrest) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  spec.sea->surface =
      hydro::WaveSurface{{hydro::WaveComponent{.amplitude = 0.7, .kx = 0.1, .omega = 1}}};
  const Body body = engine::make_bodies(spec)[0];
  EXPECT_TRUE(engine::may_be_wet(body, {.position = {0, 0, 1.19}}));
  EXPECT_FALSE(engine::may_be_wet(body, {.position = {0, 0, 1.21}}));
}

TEST(Body, BodiesOfOneMeshShareAHull) {
  SimulationSpec spec = support::box_in_still_water({0, 0, 0});
  spec.bodies.push_back(spec.bodies[0]);
  spec.bodies.push_back(spec.bodies[0]);
  spec.bodies[2].mesh_B.vertices *= 2;
  const std::vector<Body> bodies = engine::make_bodies(spec);
  EXPECT_EQ(bodies[0].hull, bodies[1].hull);
  EXPECT_NE(bodies[0].hull, bodies[2].hull);
}

TEST(Body, IsDisplacedOnlyWhereItsLocksLetIt) {
  SimulationSpec spec = support::box_in_still_water({1, 2, 3});
  spec.bodies[0].locked = {true, false, false, true, true, false};
  const Body body = engine::make_bodies(spec)[0];
  Vector6d change;
  change << 0.1, 0.2, 0.3, 0, 0, 0.4;
  const BodyState there = engine::displaced(body, spec.bodies[0].initial, change);
  EXPECT_LT((there.position - Vector3d(1, 2.2, 3.3)).norm(), 1e-15);
  EXPECT_NEAR(Eigen::AngleAxisd(there.orientation).angle(), 0.4, 1e-15);
}

TEST(Body, ResistsContactsWithItsLargestInertia) {
  Matrix6d added = Matrix6d::Zero();
  added.diagonal() << 100, 300, 200, 1, 1, 1;
  const SimulationSpec spec = box_with_added_mass(added);
  const Body body = engine::make_bodies(spec)[0];
  const Motion motion = engine::motion_at(body, spec, spec.bodies[0].initial, 0);
  EXPECT_NEAR(engine::contact_mass(body, motion), 500 + 300, 1e-9);
  // Weight and full buoyancy, 500 + 1000, are more than this mass takes at gravity's rate.
  EXPECT_EQ(engine::contact_fall(body, motion), 1);
  Motion heavy = motion;
  *heavy.added_B *= 10;
  EXPECT_NEAR(engine::contact_fall(body, heavy), 1500.0 / 3500, 1e-12);
}

TEST(Body, AddedMassesAreToldApartByTheirEffectOnTheEnergy) {
  const SimulationSpec spec = box_with_added_mass(100 * Matrix6d::Identity());
  const Body body = engine::make_bodies(spec)[0];
  const Matrix6d start = 100 * Matrix6d::Identity();
  const auto match = [&](double taken, double found) {
    return engine::compare_added_mass(body, start, taken * Matrix6d::Identity(),
                                      found * Matrix6d::Identity());
  };
  EXPECT_EQ(match(100, 100 + 1e-4), AddedMassMatch::equal);
  EXPECT_EQ(match(100, 100.1), AddedMassMatch::near);
  EXPECT_EQ(match(100, 200), AddedMassMatch::distant);
}

TEST(Body, SharesItsMomentumWithWaterThatItGains) {
  support::Random random(4);
  const SimulationSpec spec = box_with_added_mass(100 * Matrix6d::Identity());
  const Body body = engine::make_bodies(spec)[0];
  Motion motion = engine::motion_at(body, spec, random.state(0.1, 2), 0);
  motion.flow = {0.3, -0.2, 0};
  const Matrix6d more = motion.added() + 30 * Matrix6d::Identity();
  const Motion after = engine::share_momentum(body, motion, more);
  const auto momentum = [&](const Motion& m) {
    return Vector6d(engine::inertia_W(body, m) * engine::velocity(m.state, m.flow));
  };
  EXPECT_LT((momentum(after) - momentum(motion)).norm(), 1e-12 * momentum(motion).norm());
  EXPECT_EQ(after.added(), more);
}

TEST(Body, WaterThatLeavesItKeepsItsShare) {
  support::Random random(5);
  const SimulationSpec spec = box_with_added_mass(100 * Matrix6d::Identity());
  const Body body = engine::make_bodies(spec)[0];
  const Motion motion = engine::motion_at(body, spec, random.state(0.1, 2), 0);
  const Motion after = engine::share_momentum(body, motion, Matrix6d::Zero());
  EXPECT_LT((after.state.linear_velocity - motion.state.linear_velocity).norm(), 1e-13);
  EXPECT_FALSE(after.added_B);
}

}  // namespace

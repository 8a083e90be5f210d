#include "engine/motion/work_record.h"

#include <algorithm>
#include <memory>

#include "engine/motion/energy.h"
#include "engine/motion/velocity_update.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "tests/engine/prelude.h"
#include "tests/engine/rig_specs.h"

/// The record of impulses and works, event by event.

namespace {

using engine::Motion;
using engine::MovingBody;

/// A box with drag, afloat and in motion, that keeps a record.
struct Recorded {
  explicit Recorded(double added) : spec(support::box_in_still_water({0, 0, 0})) {
    spec.record_work = true;
    BodySpec& box = spec.bodies[0];
    if (added > 0)
      box.added_mass = std::make_shared<const hydro::ConstantAddedMass>(
          box.mesh_B, Matrix6d(added * Matrix6d::Identity()));
    support::Random random(7);
    box.initial = random.state(0.2, 3);
    moving.push_back(support::moving_bodies(spec)[0]);
  }

  const engine::Body& body() const { return moving[0].body; }
  Motion& motion() { return moving[0].motion; }
  double kinetic(const Motion& m) const {
    return engine::kinetic_energy(body(), m, Vector3d::Zero());
  }

  SimulationSpec spec;
  std::vector<MovingBody> moving;
};

TEST(WorkRecord, OfAnUpdateIsTheChangeOfTheKineticEnergy) {
  for (const double added : {0.0, 200.0}) {
    Recorded box(added);
    const engine::MidpointState midpoint =
        engine::make_midpoint(box.body(), box.motion(), box.motion().added(), {});
    const engine::VelocityUpdate update = engine::free_update(box.moving[0], midpoint, 0, kStep);
    Motion after = box.motion();
    after.state = engine::with_velocity(after.state, midpoint.after + update.change, after.flow);
    engine::record_update(box.moving[0], midpoint,
                          {.change = update.change, .h = kStep, .implicit = update.implicit},
                          after);
    const double gained = box.kinetic(after) - box.kinetic(box.motion());
    const double scale = box.kinetic(box.motion());
    EXPECT_NEAR(after.work->works.sum(), gained, 1e-13 * scale) << added;
    EXPECT_LT(after.work->works.pressure_drag, 0) << added;
  }
}

TEST(WorkRecord, OfADriftHasTheImpulseThatTheWaterGives) {
  Recorded box(200);
  Motion after = box.motion();
  engine::drift(box.body(), after, 0.1);
  const auto own = [&](const Motion& m) {
    const Vector6d u = engine::velocity(m.state, Vector3d::Zero());
    const Matrix3d R = m.state.orientation.toRotationMatrix();
    return engine::rotate(R, Vector6d(box.body().rigid_B * engine::rotate(R.transpose(), u)));
  };
  const Vector6d gained = own(after) - own(box.motion());
  EXPECT_LT((after.work->added_impulse - gained).norm(), 1e-12 * own(after).norm());
  EXPECT_NEAR(after.work->works.sum(), 0, 1e-10 * box.kinetic(after));
}

TEST(WorkRecord, OfTheLimiterIsTheEnergyThatItTakes) {
  Recorded box(200);
  Motion after = box.motion();
  after.state.linear_velocity *= 0.5;
  after.state.angular_velocity *= 0.5;
  engine::record_clamp(box.body(), box.motion(), after);
  EXPECT_NEAR(after.work->works.brake, -0.75 * box.kinetic(box.motion()),
              1e-13 * box.kinetic(box.motion()));
}

TEST(WorkRecord, TellsWhichShareOfAllWorksTheLimiterHas) {
  EXPECT_EQ((engine::Works{.buoyancy = 3, .weight = -4}.clamped_share()), 0);
  EXPECT_EQ((engine::Works{.buoyancy = 3, .weight = -4, .brake = -1}.clamped_share()), 1.0 / 8);
  EXPECT_EQ((engine::Works{.brake = -1}.clamped_share()), 1);
  EXPECT_EQ(engine::Works{}.clamped_share(), 0);
}

TEST(WorkRecord, OfAGainOfAddedMassIsTheEnergyThatTheWaterTakes) {
  Recorded box(200);
  const Matrix6d more = 2 * box.motion().added();
  const Motion after = engine::share_momentum(box.body(), box.motion(), more);
  EXPECT_NEAR(after.work->works.added_mass, box.kinetic(after) - box.kinetic(box.motion()),
              1e-13 * box.kinetic(after));
  EXPECT_LT(after.work->works.added_mass, 0);
}

/// That the lines of a hanging weight have the work of their only spring, and that no constraint
/// has any. The step must resolve the oscillation: the implicit midpoint rule then gives the mean
/// of the forces at both ends of a step, whose work along the spring is the change of its energy.
/// Nothing corrects the state of a dry body on a spring afterwards, so that only round-off is left.
void expect_works_of_the_spring(const SimulationSpec& spec) {
  Simulation simulation(spec);
  const auto spring_energy = [&] {
    const double stretch = simulation.rig().lines[0].distance - spec.lines[0].length;
    return spec.lines[0].stiffness / 2 * stretch * stretch;
  };
  const auto kinetic_energy = [&] {
    double sum = 0;
    for (const engine::BodyForces& forces : simulation.forces()) sum += forces.kinetic_energy;
    return sum;
  };
  const double start = spring_energy();
  double least = start;
  for (int i = 0; i < 24; ++i) {
    simulation.step();
    engine::Works works;
    for (const engine::Works& of_body : simulation.works()) {
      works.lines += of_body.lines;
      works.weight += of_body.weight;
      works.constraint += of_body.constraint;
    }
    EXPECT_NEAR(works.lines, start - spring_energy(), 1e-11 * start) << i;
    EXPECT_NEAR(works.constraint, 0, 1e-11 * start) << i;
    EXPECT_NEAR(works.lines + works.weight, kinetic_energy(), 1e-11 * start) << i;
    least = std::min(least, spring_energy());
  }
  EXPECT_LT(least, 0.1 * start);
}

// A spring is stiff if the most mobile motion of its end is, which is to turn the box: h² k 5/(2m)
// is 0.63, above the limit of 0.5. The box does not turn, and hω = 0.5 is below that of 0.7.
TEST(WorkRecord, HasTheWorkOfAStiffSpringAmongTheLines) {
  BodySpec weight = support::box_body("weight", {1, 1, 1}, 1000, {0, 0, -3});
  const double stiffness = 9e5, step = 1.0 / 60;
  using Kind = engine::LineSpec::Kind;
  SimulationSpec hung = support::dry_world({weight}, step);
  hung.record_work = true;
  hung.lines = {support::line(Kind::spring, {0, {0, 0, 0.5}}, {kWorld, {0, 0, 0}}, 2.4, stiffness)};
  expect_works_of_the_spring(hung);  // The spring is a part of the inertia.
  const BodySpec heavy = support::box_body("heavy", {1, 1, 1}, 1e5, {0, 0, 0});
  SimulationSpec between = support::dry_world({weight, heavy}, step);
  between.record_work = true;
  between.lines = {
      support::line(Kind::spring, {0, {0, 0, 0.5}}, {1, {0, 0, -0.5}}, 1.9, stiffness)};
  expect_works_of_the_spring(between);  // The spring is a row of the constraint solver.
}

TEST(WorkRecord, BeginsAStepWithoutImpulsesAndKeepsItsWorks) {
  engine::WorkRecord record;
  record.works.weight = 3;
  record.added_impulse.setOnes();
  record.constraint_impulse.setOnes();
  record.start_step();
  EXPECT_EQ(record.works.weight, 3);
  EXPECT_TRUE(record.added_impulse.isZero(0));
  EXPECT_TRUE(record.constraint_impulse.isZero(0));
}

}  // namespace

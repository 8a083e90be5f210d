#include "engine/record/body_forces.h"

#include <algorithm>
#include <memory>

#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/statics/buoyancy_energy.h"
#include "tests/engine/prelude.h"

/// What the log says of loads and works, by closed forms and by its budget.

namespace {

using engine::BodyForces;
using support::box_body;
using support::sphere_body;

constexpr double kSeaDensity = 1000;  // [kg/m^3]

SimulationSpec recording(SimulationSpec spec) {
  spec.record_work = true;
  return spec;
}

SimulationSpec in_sea(BodySpec body, double step = kStep) {
  body.wet = true;
  SimulationSpec spec = recording(support::dry_world({std::move(body)}, step));
  spec.sea = hydro::Sea{.density = kSeaDensity, .gravity = kGravity};
  return spec;
}

/// No load of the water but buoyancy and, by a number, pressure drag.
BodySpec with_drag(BodySpec body, double drag) {
  body.coefficients.pressure_drag = {drag, drag};
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  return body;
}

BodyForces forces_after(const SimulationSpec& spec, double time) {
  return support::after(spec, support::steps_in(time, spec.step)).forces()[0];
}

/// Difference of the two sides of the first equation of (E16) [J].
double unrecorded(const SimulationSpec& spec, const BodyForces& end) {
  return end.kinetic_energy - Simulation(spec).forces()[0].kinetic_energy - end.works.sum();
}

/// Distance of a wrench from a force through the centre of mass [N, N m].
double off(const hydro::Wrench& wrench, const Vector3d& force) {
  return (wrench.force - force).norm() + wrench.moment.norm();
}

TEST(ForceLog, IsRefusedWithoutARecord) {
  const Simulation simulation(support::dry_world({box_body("a", {1, 1, 1}, 1, {0, 0, 0})}, kStep));
  EXPECT_THROW(simulation.forces(), std::logic_error);
}

TEST(ForceLog, BuoyancyOfABoxAtRestCarriesItsWeight) {
  const BodySpec barge = box_body("barge", {4, 3, 1}, kSeaDensity / 2, {0, 0, 0}, 2);
  const BodyForces forces = forces_after(in_sea(barge), 1);
  const Vector3d weight(0, 0, -barge.mass * kGravity);
  EXPECT_LT(off(forces.weight, weight), tolerance(1e-9 * weight.norm()));
  EXPECT_LT(off(forces.water.buoyancy, -weight), tolerance(1e-9 * weight.norm()));
  EXPECT_NEAR(forces.water.displaced_volume, 6, tolerance(1e-9));
  EXPECT_NEAR(forces.water.wetted_area, 12 + 14 * 0.5, tolerance(1e-9));
  EXPECT_EQ(off(forces.constraint, Vector3d::Zero()), 0);
  EXPECT_LT(std::abs(forces.works.sum()), tolerance(1e-9 * weight.norm()));
}

TEST(ForceLog, WorkOfTheWeightIsTheEnergyOfAFall) {
  BodySpec box = box_body("box", {1, 2, 3}, 500, {0, 0, 100});
  box.initial.linear_velocity = {3, 0, 5};
  const SimulationSpec spec = recording(support::dry_world({box}, kStep));
  const BodyForces end = forces_after(spec, 2);
  const double drop = kGravity * 2 * 2 / 2 - 5 * 2;
  const double fall = box.mass * kGravity * drop;
  EXPECT_NEAR(end.works.weight, fall, tolerance(1e-10 * fall));
  EXPECT_NEAR(end.potential_energy, box.mass * kGravity * (100 - drop), tolerance(1e-9 * fall));
  EXPECT_LT(std::abs(unrecorded(spec, end)), tolerance(1e-10 * fall));
  EXPECT_EQ(end.works.sum(), end.works.weight);
}

TEST(ForceLog, ASphereAtItsTerminalVelocityGivesItsWeightToTheDrag) {
  const SimulationSpec spec =
      in_sea(with_drag(sphere_body("sphere", 0.5, 3000, {0, 0, -5}), 1), 0.05);
  const BodyForces start = forces_after(spec, 10);
  const BodyForces end = forces_after(spec, 15);
  const Vector3d left = end.weight.force + end.water.buoyancy.force;
  EXPECT_LT(off(end.water.pressure_drag, -left), tolerance(1e-6 * left.norm()));
  EXPECT_NEAR(end.kinetic_energy, start.kinetic_energy, tolerance(1e-6 * end.kinetic_energy));
  const double sunk = end.works.weight - start.works.weight;
  EXPECT_GT(sunk, 0);
  EXPECT_NEAR(end.works.pressure_drag - start.works.pressure_drag,
              -sunk - (end.works.buoyancy - start.works.buoyancy), tolerance(1e-6 * sunk));
}

TEST(ForceLog, AStiffUpdateRecordsTheWorkOfTheDrag) {
  BodySpec sphere = with_drag(sphere_body("sphere", 0.5, 1000, {0, 0, -50}), 1);
  sphere.initial.linear_velocity = {400, 0, 0};
  const SimulationSpec spec = in_sea(sphere, 0.1);
  const double before = Simulation(spec).forces()[0].kinetic_energy;
  const BodyForces end = forces_after(spec, 0.2);
  ASSERT_LT(end.kinetic_energy, 0.1 * before);
  EXPECT_LT(std::abs(unrecorded(spec, end)), tolerance(1e-12 * before));
  // A load explicit in a step of 40 m would have taken many times what there was.
  EXPECT_LT(end.works.pressure_drag, 0);
  EXPECT_GT(end.works.pressure_drag, -1.001 * before);
}

/// Water that a raft moves with it in heave, in proportion to its draft.
class DraftAddedMass final : public hydro::AddedMassModel {
 public:
  hydro::Matrix6d at(const hydro::BodyState& state, const hydro::Sea&, double) const override {
    hydro::Matrix6d added = hydro::Matrix6d::Zero();
    added(2, 2) = 8000 * std::clamp(0.5 - state.position.z(), 0.0, 1.0);
    return added;
  }
  hydro::Wrench wave_load(const hydro::BodyState&, const hydro::Sea&, double) const override {
    return {};
  }
};

/// A raft let go above its equilibrium, with drag and, if asked for, added mass.
SimulationSpec bobbing_raft(double step, bool adds) {
  BodySpec raft = with_drag(box_body("raft", {4, 3, 1}, kSeaDensity / 2, {0, 0, 0.3}, 2), 1);
  if (adds) raft.added_mass = std::make_shared<DraftAddedMass>();
  return in_sea(raft, step);
}

/// Largest fault of (E16) over a bob's way, as a part of the work done.
struct BudgetFaults {
  double first = 0;
  double second = 0;
  double buoyancy = 0;  ///< Of its work against hydro::buoyancy_energy.
};

BudgetFaults faults_of_bob(double step, bool adds) {
  const SimulationSpec spec = bobbing_raft(step, adds);
  Simulation simulation(spec);
  const hydro::Hull hull = hydro::make_hull(spec.bodies[0].mesh_B);
  const auto stored = [&] {
    return hydro::buoyancy_energy(hull, simulation.states()[0], *spec.sea);
  };
  const double stored_at_start = stored();
  const BodyForces start = simulation.forces()[0];
  BudgetFaults faults;
  const double scale = spec.bodies[0].mass * kGravity * 0.3;
  for (long i = 0; i < support::steps_in(6, step); ++i) {
    simulation.step();
    const BodyForces now = simulation.forces()[0];
    const double gained = now.kinetic_energy - start.kinetic_energy;
    const double raised = now.potential_energy - start.potential_energy;
    const double pushed = stored() - stored_at_start;
    faults.first = std::max(faults.first, std::abs(gained - now.works.sum()) / scale);
    faults.second = std::max(faults.second, std::abs(raised + now.works.weight) / scale);
    faults.buoyancy = std::max(faults.buoyancy, std::abs(pushed + now.works.buoyancy) / scale);
  }
  return faults;
}

TEST(ForceLog, TheBudgetOfABobClosesToTheOrderOfTheStep) {
  for (const bool adds : {false, true}) {
    const BudgetFaults coarse = faults_of_bob(0.02, adds);
    const BudgetFaults fine = faults_of_bob(0.01, adds);
    // The bob has ω = 4.4 rad/s or less: in a step of 0.01 s (hω)² is 2e-3, and the offset of the
    // states a 24th of it of the acceleration.
    EXPECT_LT(fine.first, tolerance(1e-4));
    EXPECT_LT(fine.second, tolerance(4e-4));
    EXPECT_LT(fine.buoyancy, tolerance(4e-4));
    EXPECT_LT(fine.second, 0.4 * coarse.second);
    EXPECT_LT(fine.buoyancy, 0.4 * coarse.buoyancy);
  }
}

TEST(ForceLog, AddedMassIsWhatIsMissingOfTheOtherLoads) {
  const SimulationSpec spec = bobbing_raft(kStep, true);
  Simulation simulation = support::after(spec, 20);
  const auto loads = [&] {
    const BodyForces forces = simulation.forces()[0];
    return Vector3d(forces.weight.force + forces.water.total().force);
  };
  const Vector3d loads_before = loads();
  const Vector3d velocity = simulation.states()[0].linear_velocity;
  simulation.step();
  const BodyForces end = simulation.forces()[0];
  const Vector3d pull =
      spec.bodies[0].mass * (simulation.states()[0].linear_velocity - velocity) / kStep;
  const Vector3d all = (loads_before + loads()) / 2 + end.added_mass.force;
  EXPECT_GT(end.added_mass.force.z(), 0);  // against the fall
  // Of the order of (hω)², as the bob's.
  EXPECT_LT((all - pull).norm(), tolerance(2e-3 * spec.bodies[0].mass * kGravity));
  EXPECT_LT(end.works.added_mass + end.added_kinetic_energy, 0);  // what its growth has taken
}

/// Two rafts, hinged to each other, let go above the water.
SimulationSpec hinged_rafts(double speed) {
  SimulationSpec spec = bobbing_raft(kStep, true);
  spec.bodies.push_back(spec.bodies[0]);
  spec.bodies[1].name = "other";
  spec.bodies[1].initial.position.x() = 4;
  for (BodySpec& raft : spec.bodies) raft.initial.linear_velocity = {speed, 0, -speed};
  spec.bodies[1].initial.position.z() += 0.2;
  spec.joints = {{.name = "hinge",
                  .type = engine::JointSpec::Type::hinge,
                  .first = 0,
                  .second = 1,
                  .anchor_W = {2, 0, 0.4},
                  .axis_W = {0, 1, 0}}};
  return spec;
}

TEST(ForceLog, AHingePassesOnWhatItTakes) {
  for (const double speed : {0.0, 100.0}) {  // the latter too fast for explicit loads
    const SimulationSpec spec = hinged_rafts(speed);
    const Simulation start(spec);
    const Simulation end = support::after(spec, 50);
    const std::vector<BodyForces> forces = end.forces();
    const Vector3d first = forces[0].constraint.force;
    EXPECT_GT(first.norm(), 1);
    EXPECT_LT((first + forces[1].constraint.force).norm(), tolerance(1e-6 * first.norm()));
    double most = spec.bodies[0].mass * kGravity * 0.3;
    for (std::size_t i = 0; i < 2; ++i) most += start.forces()[i].kinetic_energy;
    for (std::size_t i = 0; i < 2; ++i) {
      const BodyForces before = start.forces()[i];
      const double gained = forces[i].kinetic_energy - before.kinetic_energy;
      EXPECT_NEAR(gained, forces[i].works.sum(), tolerance(1e-9 * most)) << speed;
    }
  }
}

/// A weightless box deep in a current, with nothing but an added mass of its own in each direction.
SimulationSpec in_current() {
  BodySpec box = box_body("box", {1, 2, 3}, 500, {0, 0, -50});
  box.coefficients.buoyancy = false;
  box = with_drag(box, 0);
  box.initial.linear_velocity = {2, 1, -1};
  hydro::Matrix6d added = hydro::Matrix6d::Zero();
  added.diagonal() << 6000, 3000, 1000, 500, 700, 200;
  box.added_mass = std::make_shared<hydro::ConstantAddedMass>(box.mesh_B, added);
  SimulationSpec spec = in_sea(box);
  spec.gravity = 0;
  spec.sea->current = {0.5, -1, 0};
  return spec;
}

TEST(ForceLog, OfABodyWithoutOtherLoadsTheAddedMassIsAllThatTurnsIt) {
  SimulationSpec spec = in_current();
  spec.bodies[0].initial.angular_velocity = {0.5, 1, 2};
  Simulation simulation = support::after(spec, 100);
  const hydro::BodyState before = simulation.states()[0];
  simulation.step();
  const hydro::BodyState after = simulation.states()[0];
  const BodyForces end = simulation.forces()[0];
  const Vector3d pull =
      spec.bodies[0].mass * (after.linear_velocity - before.linear_velocity) / kStep;
  const Vector3d turn =
      (support::spin(spec.bodies[0], after) - support::spin(spec.bodies[0], before)) / kStep;
  EXPECT_GT(pull.norm(), 1);
  EXPECT_LT((end.added_mass.force - pull).norm(), tolerance(1e-8 * pull.norm()));
  EXPECT_LT((end.added_mass.moment - turn).norm(), tolerance(1e-8 * turn.norm()));
  EXPECT_LT(std::abs(unrecorded(spec, end)), tolerance(1e-9 * end.kinetic_energy));
  EXPECT_EQ(end.works.sum(), end.works.added_mass);
}

TEST(ForceLog, LocksHoldAgainstTheMunkMoment) {
  SimulationSpec spec = in_current();
  spec.bodies[0].locked = {false, false, false, true, true, true};
  const BodyForces end = forces_after(spec, 1);
  const Vector3d through = Vector3d(2, 1, -1) - spec.sea->current;
  const Vector3d munk = -through.cross(Vector3d(6000, 3000, 1000).cwiseProduct(through));
  EXPECT_LT((end.added_mass.moment - munk).norm(), tolerance(1e-9 * munk.norm()));
  EXPECT_LT((end.constraint.moment + munk).norm(), tolerance(1e-9 * munk.norm()));
}

TEST(ForceLog, TheLimitersWorkIsRecorded) {
  // A spar that whirls half out of the water, in steps far too long for it.
  BodySpec spar = with_drag(box_body("spar", {1, 1, 4}, 5, {0, 0, 3}, 2), 0);
  spar.initial.angular_velocity = {2, 30, 3};
  SimulationSpec spec = in_sea(spar, 0.5);
  const BodyForces alone = forces_after(spec, 4);
  EXPECT_LT(alone.works.brake, -1000);
  // What is left is the offset of the states, large in such steps.
  EXPECT_LT(std::abs(unrecorded(spec, alone)), tolerance(0.1 * -alone.works.brake));
  spec.bodies.push_back(spec.bodies[0]);
  spec.bodies[1].initial.position.x() = 6;
  spec.joints = {{.name = "pin",
                  .type = engine::JointSpec::Type::ball,
                  .first = 0,
                  .second = 1,
                  .anchor_W = {3, 0, 3}}};
  const Simulation end = support::after(spec, 8);
  const std::vector<BodyForces> joined = end.forces();
  EXPECT_LT(joined[0].works.brake + joined[1].works.brake, -100);
  const double start = Simulation(spec).forces()[0].kinetic_energy;
  for (const BodyForces& forces : joined)
    EXPECT_NEAR(forces.kinetic_energy - start, forces.works.sum(), tolerance(1e-9 * start));
}

TEST(ForceLog, LocksHoldWithoutWork) {
  BodySpec box = box_body("box", {1, 1, 1}, 500, {0, 0, 0});
  box.locked = {false, false, true, true, true, true};
  box.loads = {{.force = {30, 0, 0}}};
  const SimulationSpec spec = recording(support::dry_world({box}, kStep));
  const BodyForces end = forces_after(spec, 1);
  EXPECT_LT(off(end.constraint, {0, 0, box.mass * kGravity}), tolerance(1e-9));
  EXPECT_EQ(end.works.constraint, 0);
  EXPECT_LT(std::abs(unrecorded(spec, end)), tolerance(1e-9));
}

/// A dry box of half a tonne whose lower face is so high above the ground [m].
SimulationSpec box_above_ground(double height) {
  BodySpec box = box_body("box", {1, 1, 1}, 500, {0, 0, 0.5 + height});
  box.collision = engine::CollisionShape::box;
  SimulationSpec spec = recording(support::dry_world({box}, kStep));
  spec.ground = engine::PlaneGround{0};
  return spec;
}

TEST(ForceLog, TheGroundCarriesABodyThatLiesOnIt) {
  const SimulationSpec spec = box_above_ground(0);
  const BodyForces forces = forces_after(spec, 3);
  const double weight = spec.bodies[0].mass * kGravity;
  EXPECT_LT(off(forces.constraint, {0, 0, weight}), tolerance(1e-3 * weight));
}

TEST(ForceLog, AnImpactOnTheGroundTakesWhatTheWeightHasGiven) {
  const SimulationSpec spec = box_above_ground(2);
  const BodyForces end = forces_after(spec, 4);
  const double fall = spec.bodies[0].mass * kGravity * 2;
  EXPECT_NEAR(end.works.weight, fall, tolerance(0.01 * fall));
  EXPECT_NEAR(end.works.constraint, -fall, tolerance(0.01 * fall));
  EXPECT_LT(std::abs(unrecorded(spec, end)), tolerance(1e-9 * fall));
}

TEST(ForceLog, AHingeHoldsABobOnItsCircle) {
  BodySpec box = box_body("box", {0.2, 0.2, 0.2}, 500, {2, 0, 0});
  box.initial.angular_velocity = {0, 0, 3};
  box.initial.linear_velocity = {0, 6, 0};
  SimulationSpec spec = recording(support::dry_world({box}, kStep));
  spec.gravity = 0;
  spec.joints = {{.name = "pin", .type = engine::JointSpec::Type::hinge, .first = 0}};
  const Simulation end = support::after(spec, 100);
  const BodyForces forces = end.forces()[0];
  const Vector3d inward = -end.states()[0].position.normalized();
  // The mean over a step: the direction is that of its middle, 0.015 rad before.
  const double pull = box.mass * 2 * 3 * 3;
  EXPECT_LT((forces.constraint.force - pull * inward).norm(), tolerance(0.016 * pull));
  EXPECT_LT(std::abs(forces.works.constraint), tolerance(1e-9 * pull));
}

TEST(ForceLog, AnImmovableBodyIsHeldAgainstItsLoads) {
  BodySpec box = box_body("box", {1, 1, 1}, 500, {0, 0, 3});
  box.locked.fill(true);
  box.loads = {{.force = {7, 0, 0}}};
  const BodyForces forces = forces_after(recording(support::dry_world({box}, kStep)), kStep);
  EXPECT_LT(off(forces.constraint, {-7, 0, box.mass * kGravity}), tolerance(1e-9));
}

TEST(ForceLog, AppliedLoadsAreThemselves) {
  BodySpec box = box_body("box", {1, 1, 1}, 500, {0, 0, 0});
  box.loads = {{.force = {7, 0, 0}, .at_B = {0, 2, 0}}, {.torque = {0, 0, 20}}};
  SimulationSpec spec = recording(support::dry_world({box}, kStep));
  spec.gravity = 0;
  const BodyForces start = Simulation(spec).forces()[0];
  EXPECT_EQ(start.applied.force, Vector3d(7, 0, 0));
  EXPECT_EQ(start.applied.moment, Vector3d(0, 0, 6));
  const BodyForces end = forces_after(spec, 1);
  EXPECT_NEAR(end.works.applied, end.kinetic_energy, tolerance(1e-10 * end.kinetic_energy));
}

TEST(ForceLog, OdesOwnStepIsRecordedToo) {
  SimulationSpec spec = bobbing_raft(kStep, false);
  spec.integrator.method = engine::Integrator::Method::ode;
  const BodyForces end = forces_after(spec, 2);
  EXPECT_GT(std::abs(end.works.buoyancy), 1);
  EXPECT_LT(std::abs(unrecorded(spec, end)), tolerance(1e-9 * std::abs(end.works.weight) + 1e-6));
}

TEST(ForceLog, DoesNotChangeTheMotion) {
  SimulationSpec spec = bobbing_raft(kStep, true);
  const Simulation recorded = support::after(spec, 200);
  recorded.forces();
  spec.record_work = false;
  EXPECT_EQ(support::after(spec, 200).states()[0], recorded.states()[0]);
}

}  // namespace

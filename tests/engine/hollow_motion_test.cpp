#include <numbers>

#include "engine/hollows/flooding.h"
#include "engine/hollows/pocket_search.h"
#include "engine/hollows/streams.h"
#include "engine/motion/energy.h"
#include "engine/motion/moving_body.h"
#include "engine/state_data.h"
#include "hydro/interior/interior.h"
#include "hydro/loads/loads.h"
#include "tests/engine/prelude.h"
#include "tests/support/hollows.h"

/// Hollow bodies that stay dry, fill and sink.

namespace {

constexpr double kFresh = 1000;  // Density of the water [kg/m^3].

hydro::Coefficients without_drag() {
  hydro::Coefficients coefficients{.pressure_drag = {0, 0}, .lift = 0};
  coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  return coefficients;
}

/// The open box of 400 kg with its centre of mass half a metre above its bottom.
BodySpec open_box() {
  BodySpec box;
  box.name = "box";
  box.mesh_B = hydro::translated(support::open_box(), {0, 0, -0.5});
  box.mass = 400;
  box.inertia_B = Vector3d(60, 160, 170).asDiagonal();
  box.interior = engine::Interior::flooding;
  box.collision = CollisionShape::none;
  box.coefficients = without_drag();
  return box;
}

SimulationSpec in_still_water(BodySpec body, double draught) {
  body.initial.position.z() = 0.5 - draught;
  SimulationSpec spec = support::dry_world({std::move(body)}, 1.0 / 60);
  spec.sea = hydro::Sea{.density = kFresh, .gravity = kGravity};
  return spec;
}

/// The largest load on a body at the start.
hydro::Loads loads_at_start(const SimulationSpec& spec) {
  const std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
  return engine::water_loads(bodies[0].body, bodies[0].motion, bodies[0].motion.state, 0);
}

TEST(HollowBody, FloatsDryAtTheDraughtOfItsOutside) {
  const SimulationSpec spec = in_still_water(open_box(), 0.2);
  EXPECT_NEAR(loads_at_start(spec).total().force.z(), 400 * kGravity, 1e-9);
  const Simulation still = support::after(spec, 600);
  EXPECT_NEAR(still.states()[0].position.z(), 0.3, 1e-9);
  EXPECT_EQ(still.interiors()[0].pockets[0].volume, 0);
}

TEST(HollowBody, CarriesTheWaterInIt) {
  BodySpec box = open_box();
  box.interior_water = {{.at_B = {0, 0, 0}, .volume = 0.342}};
  const SimulationSpec spec = in_still_water(box, 0.371);
  const hydro::Loads loads = loads_at_start(spec);
  EXPECT_NEAR(loads.total().force.z(), 400 * kGravity, 1e-12 * 742 * kGravity);
  EXPECT_NEAR(loads.interior.force.z(), -342 * kGravity, 1e-12 * 742 * kGravity);
  const engine::PocketState pocket = Simulation(spec).interiors()[0].pockets[0];
  EXPECT_NEAR(pocket.level, 0.25 - 0.371, 1e-14);
  EXPECT_NEAR(pocket.centroid_W.z(), 0.15 - 0.371, 1e-12);
}

/// Lever of the righting moment over the sine of a heel, for the box and the water in it. Both are
/// wall-sided: it is GM + ½ (BM − free surface) tan²(heel), exactly.
double righting(BodySpec box, double draught, double water, double heel) {
  if (water > 0) box.interior_water = {{.at_B = {0, 0, 0}, .volume = water}};
  box.initial.orientation = Eigen::AngleAxisd(heel, Vector3d::UnitX());
  SimulationSpec spec = in_still_water(box, 0);
  // The axis of the waterplane stays in the surface.
  spec.bodies[0].initial.position.z() = (0.5 - draught) * std::cos(heel);
  const hydro::Loads loads = loads_at_start(spec);
  const double weight = (400 + kFresh * water) * kGravity;
  EXPECT_NEAR(loads.total().force.z(), 400 * kGravity, 1e-10 * weight);
  return -loads.total().moment.x() / (weight * std::sin(heel));
}

TEST(HollowBody, LosesStabilityByTheFreeSurfaceInside) {
  for (const double heel : {0.001, 0.05, 0.1}) {
    const double square = std::pow(std::tan(heel), 2);
    const double displaced = 0.742, outer = 1.0 / 12 * 2 / displaced;
    const double inner = 1.9 * std::pow(0.9, 3) / 12 / displaced;
    // KB + BM − KG, with the water's centre of mass at 0.15 m.
    const double solid = displaced / 4 + outer - (400 * 0.5 + 342 * 0.15) / 742;
    EXPECT_NEAR(solid, 0.071439, 1e-6);
    EXPECT_NEAR(inner, 0.155559, 1e-6);
    EXPECT_NEAR(righting(open_box(), displaced / 2, 0.342, heel),
                solid - inner + square / 2 * (outer - inner), 1e-9);
    EXPECT_NEAR(righting(open_box(), 0.2, 0, heel), 0.1 + 1.0 / 12 / 0.2 * (1 + square / 2) - 0.5,
                1e-9);
  }
}

TEST(HollowBody, TheWeightIsThatOfOutsideAndInsideInAnyAttitude) {
  support::Random random(7);
  for (int i = 0; i < 200; ++i) {
    BodySpec box = open_box();
    box.initial.orientation = random.rotation();
    SimulationSpec spec = in_still_water(box, 0);
    spec.bodies[0].initial.position = {0, 0, 5};  // In the air: only water inside acts.
    std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
    const auto interior = bodies[0].motion.carried_water->interior;
    if (!interior) continue;
    const double volume = 0.6 * interior->division.pockets[0].capacity;
    const Eigen::Matrix3d R_WB = box.initial.orientation.toRotationMatrix();
    const hydro::WaterInside water = hydro::water_of(interior->pockets[0], R_WB, volume);
    EXPECT_LT((water.push.force - Vector3d(0, 0, -volume)).norm(), 1e-12 * volume);
    const Vector3d centroid = hydro::centroid_of(interior->pockets[0], R_WB, water);
    EXPECT_LT((water.push.moment - centroid.cross(Vector3d(0, 0, -volume))).norm(), 1e-11 * volume);
  }
}

TEST(Flooding, AFreeWeirHasTheFlowOfItsHead) {
  EXPECT_NEAR(engine::weir_flow(0.1, -1, kGravity), 0.053904, 1e-6);
  EXPECT_EQ(engine::weir_flow(-0.1, -1, kGravity), 0);
  EXPECT_EQ(engine::weir_flow(0.1, 0.1, kGravity), 0);
}

/// A hole of 1e-3 m^2 at the upper side of the floor.
BodySpec holed_box() {
  BodySpec box = open_box();
  box.openings = {{.at_B = {0, 0, -0.45}, .area = 1e-3}};
  return box;
}

/// C_d a √(2g) of that hole.
const double kHole = 0.6 * 1e-3 * std::sqrt(2 * kGravity);

TEST(Flooding, AHoleFillsAHeldHullInTheTimeOfItsHead) {
  for (const bool yaws : {true, false}) {
    BodySpec box = holed_box();
    box.locked = {true, true, true, true, true, !yaws};
    Simulation simulation(in_still_water(box, 0.55));
    while (simulation.interiors()[0].pockets[0].volume < 1.9 * 0.9 * (0.5 - 1e-12) &&
           simulation.time() < 1000)
      simulation.step();
    // Torricelli: the root of the head falls linearly.
    EXPECT_NEAR(simulation.time(), 2 * 1.9 * 0.9 * std::sqrt(0.5) / kHole, 0.02);
    EXPECT_NEAR(simulation.time(), 910.090, 0.91);
  }
}

TEST(Flooding, AHoleSinksAFloatingHull) {
  BodySpec box = holed_box();
  box.locked = {true, true, false, true, true, true};
  Simulation simulation(in_still_water(box, 0.2));
  while (simulation.states()[0].position.z() > -0.5 && simulation.time() < 3000) simulation.step();
  EXPECT_NEAR(simulation.time(), 2375.303, 2.375);
  while (!simulation.interiors()[0].pockets[0].flooded && simulation.time() < 3000)
    simulation.step();
  EXPECT_TRUE(simulation.interiors()[0].pockets[0].flooded);
  for (int i = 0; i < 600; ++i) simulation.step();
  EXPECT_LT(simulation.states()[0].position.z(), -2);
}

/// The open box with drag, tilted, in still water, with some water in it.
SimulationSpec rocking_box(double water) {
  BodySpec box = open_box();
  box.coefficients = hydro::for_mesh({}, box.mesh_B, 1e-6);
  box.initial.orientation = Eigen::AngleAxisd(0.3, Vector3d(1, 0.4, 0).normalized());
  box.initial.angular_velocity = {0.5, 0.2, 0};
  if (water > 0) box.interior_water = {{.at_B = {0, 0, -0.3}, .volume = water}};
  return in_still_water(box, 0.3);
}

TEST(Flooding, WhatIsInsideIsWhatCameIn) {
  BodySpec box = holed_box();
  box.mesh_B = hydro::translated(support::divided_box(0.4), {0, 0, -0.5});
  box.openings = {{.at_B = {-0.5, 0, -0.475}, .area = 0.02}};
  box.interior_water = {{.at_B = {-0.5, 0, 0}, .volume = 0.05}};
  box.inertia_B *= 5;
  Simulation simulation(in_still_water(box, 0.25));
  for (int i = 0; i < 3000; ++i) {
    simulation.step();
    double inside = -0.05, come = 0;
    const engine::InteriorState state = simulation.interiors()[0];
    for (const engine::PocketState& pocket : state.pockets) {
      inside += pocket.volume;
      come += pocket.inflow;
    }
    ASSERT_NEAR(inside, come, 1e-13) << "at " << simulation.time();
  }
  // The second compartment is filled over the wall.
  const engine::InteriorState state = simulation.interiors()[0];
  for (const engine::PocketState& pocket : state.pockets) EXPECT_GT(pocket.volume, 0.2);
}

TEST(Flooding, CompartmentsThatMeetAboveTheirWallHaveOneLevel) {
  BodySpec box = open_box();
  box.mesh_B = hydro::translated(support::divided_box(0.4), {0, 0, -0.5});
  box.interior_water = {{.at_B = {-0.5, 0, 0}, .volume = 0.7}};
  box.locked = {true, true, true, true, true, true};
  box.locked[5] = false;
  Simulation simulation(in_still_water(box, -3));
  for (int i = 0; i < 600; ++i) simulation.step();
  const auto pockets = simulation.interiors()[0].pockets;
  ASSERT_EQ(pockets.size(), 2u);
  EXPECT_NEAR(pockets[0].level, pockets[1].level, 1e-9);
  EXPECT_NEAR(pockets[0].volume + pockets[1].volume, 0.7, 1e-14);
  // Both together fill the floor's area but for the wall: 1.85 × 0.9 m up to 0.4 m, then 1.9 × 0.9.
  EXPECT_NEAR(pockets[0].level, 3 + 0.4 + (0.7 - 1.85 * 0.9 * 0.35) / (1.9 * 0.9), 1e-6);
}

TEST(Flooding, StillWaterGivesNoEnergy) {
  for (const double water : {0.0, 0.1, 0.5, 1.2}) {
    const SimulationSpec spec = rocking_box(water);
    Simulation simulation(spec);
    const std::vector<engine::Body> bodies = engine::make_bodies(spec);
    const auto energy = [&] {
      const engine::SimulationState state = simulation.state();
      const engine::Motion& motion = state.data().bodies[0].motion;
      return engine::kinetic_energy(bodies[0], motion, Vector3d::Zero()) +
             engine::potential_energy(bodies[0], motion);
    };
    const double start = energy();
    double lowest = start, highest_gain = 0;
    for (int i = 0; i < 1800; ++i) {
      simulation.step();
      lowest = std::min(lowest, energy());
      highest_gain = std::max(highest_gain, energy() - lowest);
    }
    EXPECT_LT(highest_gain, 1e-3 * 400 * kGravity) << water;
  }
}

TEST(Flooding, AContinuedRunHasTheSameBytes) {
  SimulationSpec spec = rocking_box(0.4);
  spec.bodies[0].openings = {{.at_B = {0, 0, -0.475}, .area = 0.05}};
  spec.bodies[0].initial.angular_velocity = {3, 1, 0};
  Simulation whole(spec);
  for (int i = 0; i < 100; ++i) whole.step();
  const std::string saved = whole.state().to_bytes();
  for (int i = 0; i < 400; ++i) whole.step();
  Simulation other(spec);
  other.restore(engine::SimulationState::from_bytes(saved));
  EXPECT_EQ(other.state().to_bytes(), saved);
  for (int i = 0; i < 400; ++i) other.step();
  EXPECT_EQ(other.state().to_bytes(), whole.state().to_bytes());
}

TEST(Flooding, AFloodedPocketPartsFullToItsSpillHeight) {
  // The box hangs on a lock of all but its height, is pushed under, and lifted out.
  BodySpec box = open_box();
  box.locked = {true, true, false, true, true, true};
  Simulation simulation(in_still_water(box, 0.2));
  const auto push = [&](double force, int steps) {
    for (int i = 0; i < steps; ++i) {
      simulation.apply(
          0, {.force = {0, 0, force - 2000 * simulation.states()[0].linear_velocity.z()}});
      simulation.step();
    }
    return simulation.interiors()[0].pockets[0];
  };
  EXPECT_TRUE(push(-18000, 600).flooded);
  const engine::PocketState lifted = push(26000, 1200);
  EXPECT_FALSE(lifted.flooded);
  EXPECT_NEAR(lifted.volume, lifted.capacity, 1e-3 * lifted.capacity);
  EXPECT_GT(lifted.level, 0);
}

TEST(Flooding, PocketsPartFullToTheirRimAndNotToTheWallBetweenThem) {
  BodySpec box = open_box();
  box.mesh_B = hydro::translated(support::divided_box(0.4), {0, 0, -0.5});
  const SimulationSpec spec = in_still_water(box, 0.2);
  const std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
  engine::Motion motion = bodies[0].motion;
  const auto run_at = [&](double height) {
    motion.state.position.z() = height;
    engine::let_water_run(bodies[0].body, motion.state, 0, 1.0 / 60, {}, motion);
    return motion.carried_water->pockets;
  };
  const auto flooded = [](const engine::PocketContent& pocket) { return pocket.flooded; };
  for (int i = 0; i < 3600 && !std::ranges::all_of(run_at(-1), flooded);) ++i;
  ASSERT_TRUE(std::ranges::all_of(motion.carried_water->pockets, flooded));
  // Lifted out at once, wall and all: what stood above the wall is lifted, too.
  const std::vector<engine::PocketContent> lifted = run_at(2);
  double whole = 0;
  for (const engine::PocketContent& pocket : lifted) {
    EXPECT_FALSE(pocket.flooded);
    whole += pocket.volume;
  }
  EXPECT_NEAR(whole, (1.9 * 0.95 - 0.05 * 0.35) * 0.9, 1e-12);
}

TEST(Flooding, ATippedBucketScoopsAndKeepsWhatItHolds) {
  BodySpec box = open_box();
  box.coefficients = hydro::for_mesh({}, box.mesh_B, 1e-6);
  Simulation simulation(in_still_water(box, 0.2));
  for (int i = 0; i < 240; ++i) {
    simulation.apply(0, {.moment = {3000, 0, 0}});
    simulation.step();
  }
  EXPECT_GT(simulation.interiors()[0].pockets[0].volume, 0.05);
}

double lowest_sill(const hydro::TriMesh& mesh_B, const engine::CarriedWater& held,
                   const BodyState& state) {
  double lowest = HUGE_VAL;
  if (!held.interior) return lowest;
  for (const hydro::SillEdge& edge : held.interior->division.sills)
    for (const int v : {edge.from, edge.to})
      lowest = std::min(lowest, (state.position + state.orientation * mesh_B.vertices.col(v)).z());
  return lowest;
}

TEST(PocketSearch, AKeptDivisionGivesTheLoadsOfANewSearch) {
  support::Random random(11);
  const std::vector<hydro::TriMesh> meshes = {
      hydro::translated(support::open_box(), {0, 0, -0.5}),
      hydro::translated(support::divided_box(0.7), {0, 0, -0.5}),
      hydro::translated(support::closed_box(), {0, 0, -0.5})};
  const int cases = support::repeats(3400);
  int kept = 0;
  for (const hydro::TriMesh& mesh : meshes) {
    BodySpec box = open_box();
    box.mesh_B = mesh;
    const SimulationSpec spec = in_still_water(box, 0.2);
    std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
    engine::MovingBody& moving = bodies[0];
    for (int i = 0; i < cases; ++i) {
      BodyState state;
      // Some attitudes near the last one, as in a motion, and some anywhere.
      state.orientation =
          i % 2 == 0 ? random.rotation()
                     : Quaterniond(Eigen::AngleAxisd(random.uniform(0, 0.3), Vector3d::UnitX())) *
                           moving.motion.state.orientation;
      state.position.z() = random.uniform(-0.3, 1.2);
      moving.motion.state = state;
      const auto before = moving.motion.carried_water;
      moving.motion.carried_water = engine::divided_for(moving.body, state, state, 0, before);
      const bool same = before->interior == moving.motion.carried_water->interior;
      kept += same;
      // Both start dry and only a sea below the sills is compared.
      engine::Motion fresh{.state = state,
                           .carried_water = engine::dry_pockets(
                               moving.body, state.orientation.toRotationMatrix().row(2))};
      engine::Motion dry = fresh;
      auto emptied = std::make_shared<engine::CarriedWater>(*moving.motion.carried_water);
      for (engine::PocketContent& content : emptied->pockets) content = {};
      dry.carried_water = emptied;
      if (lowest_sill(mesh, *fresh.carried_water, state) < 0 ||
          lowest_sill(mesh, *dry.carried_water, state) < 0)
        continue;
      const hydro::Loads a = engine::water_loads(moving.body, dry, state, 0);
      const hydro::Loads b = engine::water_loads(moving.body, fresh, state, 0);
      EXPECT_LT((a.total().force - b.total().force).norm(), 1e-12 * 2000 * kGravity) << i;
      EXPECT_LT((a.total().moment - b.total().moment).norm(), 1e-12 * 2000 * kGravity) << i;
    }
  }
  EXPECT_GT(kept, 1.47 * cases);
}

}  // namespace

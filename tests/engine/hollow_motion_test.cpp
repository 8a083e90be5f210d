#include <numbers>

#include "engine/flooding.h"
#include "engine/moving_body.h"
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
    const auto interior = bodies[0].motion.held->interior;
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
  BodySpec box = holed_box();
  box.locked = {true, true, true, true, true, false};
  Simulation simulation(in_still_water(box, 0.55));
  while (simulation.interiors()[0].pockets[0].volume < 1.9 * 0.9 * (0.5 - 1e-12) &&
         simulation.time() < 1000)
    simulation.step();
  // Torricelli: the root of the head falls linearly.
  EXPECT_NEAR(simulation.time(), 2 * 1.9 * 0.9 * std::sqrt(0.5) / kHole, 0.02);
  EXPECT_NEAR(simulation.time(), 910.090, 0.91);
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

}  // namespace

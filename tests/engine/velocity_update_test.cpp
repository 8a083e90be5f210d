#include "engine/motion/velocity_update.h"

#include "engine/base/constants.h"
#include "engine/constraints/anderson.h"
#include "engine/motion/energy.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/loads/load_jacobian.h"
#include "hydro/mesh/primitives.h"
#include "hydro/statics/buoyancy_energy.h"
#include "tests/engine/prelude.h"

namespace {

constexpr double kFrame = 1.0 / 60;
constexpr double kDensity = 1000;  // of the water [kg/m^3]

hydro::Sea deep_water() {
  return {.density = kDensity, .gravity = support::kGravity, .level = 1000};
}

/// A box that meets pressure drag alone, submerged.
BodySpec dragged_box(const Vector3d& size, double density, int subdivisions = 2) {
  BodySpec body = support::box_body("box", size, density, {0, 0, 0}, subdivisions);
  body.wet = true;
  body.coefficients.buoyancy = false;
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  return body;
}

/// The body without gravity in water that stands still.
SimulationSpec in_still_water(const BodySpec& body, double step = kFrame) {
  SimulationSpec spec = support::dry_world({body}, step);
  spec.gravity = 0;
  spec.sea = deep_water();
  return spec;
}

/// Kinetic energy before and after one update of a free body [J].
struct EnergyChange {
  bool implicit = false;
  double before = 0;
  double after = 0;
};

/// Updates the only body of a scene over a substep of length h [s].
EnergyChange change_by_update(const SimulationSpec& spec, double h) {
  std::vector<engine::MovingBody> bodies = support::moving_bodies(spec);
  const engine::MidpointState middle = engine::make_midpoint(
      bodies[0].body, bodies[0].motion, bodies[0].motion.added(), engine::Mobility{});
  const engine::VelocityUpdate update = engine::free_update(bodies[0], middle, 0, h);
  const engine::Matrix6d S = engine::inertia_W(bodies[0].body, middle);
  const auto energy = [&](const Vector6d& u) { return u.dot(S * u) / 2; };
  return {update.implicit, energy(middle.after), energy(middle.after + update.change)};
}

TEST(StiffDrag, NeverAddsEnergyHoweverLightTheBody) {
  support::Random random(5);
  for (const double density : {1e-3, 0.01, 1.0, 10.0}) {
    BodySpec box = dragged_box({1, 0.7, 0.05}, density);
    box.initial = random.state(1, 20);
    const SimulationSpec spec = in_still_water(box);
    Simulation simulation(spec);
    double before = support::energy(spec, simulation.states());
    const double start = before;
    for (int i = 0; i < 100; ++i) {
      simulation.step();
      const double now = support::energy(spec, simulation.states());
      ASSERT_LE(now, before * (1 + 1e-12)) << density << ", step " << i;
      before = now;
    }
    EXPECT_LT(before, 0.01 * start);
    EXPECT_GT(simulation.counts()[0].implicit, 0);
  }
}

// An axis that is locked has no mass that could make the waterplane stiff.
TEST(StiffWaterplane, IsJudgedByTheMassAlongFreeAxes) {
  for (const bool locked : {false, true}) {
    SimulationSpec spec = support::box_in_still_water({0, 0, 0.1});
    BodySpec& box = spec.bodies[0];
    box.added_mass = std::make_shared<hydro::ConstantAddedMass>(
        box.mesh_B, 100 * hydro::Matrix6d(hydro::Matrix6d::Identity()));
    box.locked[0] = box.locked[1] = locked;
    Simulation simulation(spec);
    for (int i = 0; i < 50; ++i) simulation.step();
    EXPECT_GT(simulation.counts()[0].substeps, 0);
    EXPECT_EQ(simulation.counts()[0].implicit, 0) << locked;
  }
}

TEST(StiffDrag, LiftThatIsStrongerThanItBendsTheWayAndAddsNoEnergy) {
  support::Random random(11);
  for (const double density : {1e-4, 1e-2, 1.0})
    for (int i = 0; i < 20; ++i) {
      BodySpec box = dragged_box({1, 0.7, 0.05}, density);
      box.coefficients.lift = 10;
      box.initial = random.state(1, 20);
      const SimulationSpec spec = in_still_water(box);
      const EnergyChange change = change_by_update(spec, kFrame);
      ASSERT_TRUE(change.implicit);
      // Newton's method ends within 1e-3 of the change, whose energy is four times that before.
      EXPECT_LE(change.after, (1 + 4e-3) * change.before) << density << ", " << i;
    }
}

/// A needle of 1 cm on waves of 4 mm whose crests are all of the water on it, in any motion.
SimulationSpec needle_on_short_waves(support::Random& random, double step) {
  hydro::Sea sea;
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(2e-4, 0.004, 0.3, 0, sea.gravity)}};
  BodySpec needle = dragged_box({0.01, 1e-4, 1e-4}, 985, 1);
  needle.coefficients.pressure_drag.front *= 100;
  needle.coefficients.pressure_drag.back *= 100;
  needle.initial.linear_velocity = random.vector(10);
  needle.initial.angular_velocity = random.vector(2000);
  needle.initial.orientation = Eigen::AngleAxisd(random.uniform(-0.5, 0.5), Vector3d::UnitY()) *
                               Eigen::AngleAxisd(random.uniform(-3, 3), Vector3d::UnitX());
  needle.initial.position = {random.uniform(0, 1), 0, random.uniform(0, 1e-3)};
  SimulationSpec spec = support::dry_world({needle}, step);
  spec.sea = sea;
  return spec;
}

TEST(StiffDrag, ANeedleThatMeetsTheCrestsOfShortWavesIsNotThrown) {
  support::Random random(13);
  int implicit = 0;
  for (int i = 0; i < 200; ++i) {
    const EnergyChange change = change_by_update(needle_on_short_waves(random, kFrame), 1e-5);
    if (!change.implicit) continue;
    ++implicit;
    // The water's own speed is below 1 % of the needle's, and Newton's method ends within 1e-3.
    EXPECT_LE(change.after, (1 + 3e-2) * change.before) << i;
  }
  EXPECT_GT(implicit, 50);
}

TEST(StiffDrag, NeedlesJoinedToEachOtherAreNotThrownByTheCrestsOfShortWavesEither) {
  support::Random random(13);
  int implicit = 0;
  for (int i = 0; i < 60; ++i) {
    SimulationSpec spec = needle_on_short_waves(random, 1e-5);
    spec.bodies.push_back(spec.bodies[0]);
    spec.bodies[1].name = "other";
    spec.joints = {{.type = engine::JointSpec::Type::fixed, .first = 0, .second = 1}};
    Simulation simulation(spec);
    const double before = support::energy(spec, simulation.states());
    simulation.step();
    if (simulation.counts()[0].implicit == 0) continue;
    ++implicit;
    EXPECT_LE(support::energy(spec, simulation.states()), (1 + 3e-2) * before) << i;
  }
  EXPECT_GT(implicit, 15);
}

TEST(StiffDrag, ABodyMuchLighterThanWaterRisesAtItsTerminalVelocity) {
  for (const double density : {0.01, 1.0, 20.0, 80.0}) {
    BodySpec cube = dragged_box({0.1, 0.1, 0.1}, density);
    cube.coefficients.buoyancy = true;
    cube.locked = {false, false, false, true, true, true};  // face-on is not a stable attitude
    SimulationSpec spec = support::dry_world({cube}, kFrame);
    spec.sea = deep_water();
    Simulation simulation(spec);
    const hydro::PressureDrag& c = cube.coefficients.pressure_drag;
    const double balance = (kDensity - density) * support::kGravity * 0.1;
    const double terminal = std::sqrt(balance / (0.5 * kDensity * (c.front + c.back)));
    for (int i = 0; i < 120; ++i) {
      simulation.step();
      // It never overshoots by more than the implicit step's tolerance.
      EXPECT_LT(simulation.states()[0].linear_velocity.z(), terminal * (1 + 1e-3)) << density;
    }
    // 2 s are 20 and more times m/(2 k v): what is left of the start is below 1e-9; Newton's method
    // leaves the square of its tolerance.
    EXPECT_NEAR(simulation.states()[0].linear_velocity.z(), terminal, tolerance(2e-6 * terminal))
        << density;
  }
}

TEST(StiffDrag, BodiesHeavyForTheirSizeAreLeftToTheExplicitStep) {
  BodySpec cube = dragged_box({1, 1, 1}, 500);
  cube.initial.linear_velocity = {0, 0, -6};
  EXPECT_EQ(support::after(in_still_water(cube), 50).counts()[0].implicit, 0);
}

TEST(StiffDrag, OfAJointedBodyIsTakenImplicitlyToo) {
  BodySpec light = dragged_box({1, 1, 0.1}, 1);
  light.initial.position = {1, 0, 0};
  light.initial.linear_velocity = {0, 0, 20};
  light.initial.angular_velocity = {0, -20, 0};
  SimulationSpec spec = in_still_water(light);
  spec.joints = {{.type = engine::JointSpec::Type::hinge, .first = 0, .axis_W = Vector3d::UnitY()}};
  Simulation simulation(spec);
  const double start = support::energy(spec, simulation.states());
  double lowest = start;
  for (int i = 0; i < 200; ++i) {
    simulation.step();
    const double now = support::energy(spec, simulation.states());
    // The joint takes back what the body has strayed from it in the turn of a step.
    ASSERT_LE(now, lowest + engine::kEnergyGain * start) << i;
    lowest = std::min(lowest, now);
  }
  EXPECT_LT(lowest, 1e-3 * start);
  EXPECT_GT(simulation.counts()[0].implicit, 0);
}

TEST(StiffWaterplane, AThinLightPlateFloatsWithoutGainingEnergy) {
  for (const double density : {1.0, 50.0, 500.0}) {
    BodySpec plate = support::box_body("plate", {1, 0.7, 0.01}, density, {0, 0, 0.3}, 2);
    plate.wet = true;
    plate.coefficients.lift = 0;
    plate.initial.orientation = Eigen::AngleAxisd(0.3, Vector3d(1, 0.4, 0).normalized());
    SimulationSpec spec = support::dry_world({plate}, 1.0 / 15);
    spec.sea.emplace();
    Simulation simulation(spec);
    double top = support::total_energy(spec, simulation.states());
    const double scale = top;  // above the still water level
    for (int i = 0; i < 150; ++i) {
      simulation.step();
      const double now = support::total_energy(spec, simulation.states());
      ASSERT_LE(now, top + 1e-3 * scale) << density << ", step " << i;
      top = std::max(top, now);
    }
    EXPECT_NEAR(simulation.states()[0].position.z(), 0, 0.3) << density;
  }
}

hydro::Hull star(unsigned seed) {
  BodySpec body = support::sphere_body("ball", 1, 500, {0, 0, 0});
  support::Random random(seed);
  for (auto vertex : body.mesh_B.vertices.colwise()) vertex *= random.uniform(0.6, 1.4);
  return hydro::make_hull(body.mesh_B);
}

Vector6d drag(const hydro::Hull& hull, const hydro::BodyState& state,
              const hydro::Coefficients& coefficients) {
  const hydro::Loads loads = hydro::compute_loads(hull, state, hydro::Sea{}, 0, coefficients);
  return engine::to_vector6(loads.pressure_drag + loads.viscous_drag);
}

TEST(LoadJacobian, IsTheDerivativeOfTheDrag) {
  support::Random random(2);
  const hydro::Hull hull = star(3);
  hydro::Coefficients coefficients;
  coefficients.viscous_drag = {.law = hydro::ViscousDrag::Law::constant, .coefficient = 0.1};
  coefficients.drag_shape = random.drag_shape();
  const hydro::BodyState state = random.state(0.3, 2);
  const hydro::LoadJacobian J = hydro::load_jacobian(hull, state, hydro::Sea{}, 0, coefficients);
  for (int i = 0; i < 6; ++i) {
    const Vector6d change = 1e-5 * Vector6d::Unit(i);
    const Vector6d u = engine::velocity(state, Vector3d::Zero());
    const auto at = [&](const Vector6d& v) {
      return drag(hull, engine::with_velocity(state, v, Vector3d::Zero()), coefficients);
    };
    const Vector6d expected = (at(u + change) - at(u - change)) / 2e-5;
    // The rule of edge midpoints on faces of 0.3 m of a body of 1 m: (0.3)² of a kinked integrand.
    EXPECT_LT((J.drag.col(i) - expected).norm(), tolerance(0.03 * expected.norm())) << i;
  }
  EXPECT_LT((J.drag - J.drag.transpose()).norm(), tolerance(1e-12 * J.drag.norm()));
}

TEST(LoadJacobian, KnowsTheWavesThatAPanelIsLongerThan) {
  // The bottom's corners are dry; the crests of a short wave wet its middle.
  const BodySpec box = support::box_body("box", {4, 3, 1}, 500, {0, 0, 0.55}, 1);
  const hydro::Hull hull = hydro::make_hull(box.mesh_B);
  hydro::Sea sea;
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.1, 1.7, 0.3, 0, sea.gravity)}};
  hydro::Coefficients coefficients;
  coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  const auto drag_at = [&](double speed) {
    hydro::BodyState state = box.initial;
    state.linear_velocity.z() = speed;
    return hydro::compute_loads(hull, state, sea, 0, coefficients).pressure_drag.force.z();
  };
  hydro::BodyState sinking = box.initial;
  sinking.linear_velocity.z() = -1;
  const hydro::LoadJacobian J = hydro::load_jacobian(hull, sinking, sea, 0, coefficients);
  const double slope = (drag_at(-1.001) - drag_at(-0.999)) / -0.002;
  ASSERT_LT(slope, -100);
  // The slope's surface is cut into larger parts than the drag's: a tenth of the wave here.
  EXPECT_NEAR(J.drag(2, 2), slope, tolerance(5e-2 * std::abs(slope)));
}

TEST(LoadJacobian, OfTheWaterplaneIsThatOfAWallSidedBody) {
  BodySpec box = support::box_body("box", {4, 3, 1}, 500, {0, 0, 0.1}, 2);
  const hydro::LoadJacobian J = hydro::load_jacobian(hydro::make_hull(box.mesh_B), box.initial,
                                                     hydro::Sea{}, 0, box.coefficients);
  const double weight = 1000 * 9.80665;
  Vector6d expected = Vector6d::Zero();
  expected[2] = -weight * 12;
  expected[3] = -weight * 4 * 27 / 12;
  expected[4] = -weight * 3 * 64 / 12;
  EXPECT_LT((J.waterplane - hydro::Matrix6d(expected.asDiagonal())).norm(),
            tolerance(1e-12 * expected.norm()));
}

TEST(Energy, OfBuoyancyIsTheWorkAgainstIt) {
  support::Random random(9);
  BodySpec body = support::box_body("box", {2, 1, 0.5}, 300, {0, 0, 0}, 1);
  body.wet = true;
  SimulationSpec spec = support::dry_world({body}, 0.01);
  spec.sea.emplace();
  for (int i = 0; i < 10; ++i) {
    hydro::BodyState state = random.state(0.5, 0);
    constexpr double kChange = 1e-5;
    const auto at = [&](double dz) {
      hydro::BodyState moved = state;
      moved.position.z() += dz;
      return support::total_energy(spec, {moved});
    };
    const double slope = (at(kChange) - at(-kChange)) / (2 * kChange);
    const double force =
        hydro::compute_loads(hydro::make_hull(body.mesh_B), state, *spec.sea, 0, body.coefficients)
            .buoyancy.force.z() -
        body.mass * support::kGravity;
    // Central differences of a function with a jump of curvature: dz times the waterplane's weight.
    EXPECT_NEAR(slope, -force, tolerance(kChange * 1e4 * 3)) << i;
  }
}

/// Six derivatives of a function of the pose, about the centre of mass.
template <class Function>
hydro::Vector6d pose_gradient(const hydro::BodyState& state, double change, Function&& at) {
  hydro::Vector6d gradient;
  for (int i = 0; i < 6; ++i) {
    const auto moved = [&](double by) {
      hydro::BodyState other = state;
      if (i < 3)
        other.position[i] += by;
      else
        other.orientation = Eigen::AngleAxisd(by, Vector3d::Unit(i - 3)) * state.orientation;
      return at(other);
    };
    gradient[i] = (moved(change) - moved(-change)) / (2 * change);
  }
  return gradient;
}

/// Heights of a plane, which panels follow exactly, and with bumps on it.
hydro::Sea uneven_sea(bool has_bumps) {
  support::Random random(3);
  Eigen::MatrixXd heights(41, 41);
  for (int row = 0; row < 41; ++row)
    for (int column = 0; column < 41; ++column)
      heights(row, column) =
          0.13 * column - 0.07 * row - 1.2 + (has_bumps ? random.uniform(-0.4, 0.4) : 0);
  return {.surface = hydro::make_height_field(heights, 1, {-20, -20})};
}

TEST(Energy, OfBuoyancyUnderASlopeIsTheWorkAgainstIt) {
  support::Random random(10);
  const hydro::Sea sea = uneven_sea(false);
  const hydro::Hull hull = hydro::make_hull(hydro::make_box({2, 1, 0.5}));
  const hydro::Coefficients pressure{.pressure_drag = {0, 0}, .lift = 0};
  for (int i = 0; i < 20; ++i) {
    const hydro::BodyState state = random.state(0.5, 0);
    const hydro::Vector6d slope = pose_gradient(
        state, 1e-5, [&](const auto& s) { return hydro::buoyancy_energy(hull, s, sea); });
    const hydro::Vector6d force =
        engine::to_vector6(hydro::compute_loads(hull, state, sea, 0, pressure).buoyancy);
    // As above, with a lever of at most 1.2 m.
    EXPECT_LT((slope + force).cwiseAbs().maxCoeff(), tolerance(1e-5 * 1e4 * 3 * 1.2)) << i;
  }
}

TEST(Energy, OfBuoyancyUnderBumpsIsTheSumOfAllDepths) {
  support::Random random(11);
  const hydro::Sea sea = uneven_sea(true);
  const Vector3d size(2, 1, 0.5);
  const hydro::Hull hull = hydro::make_hull(hydro::make_box(size));
  const Eigen::Vector3i count(80, 40, 20);
  const double part = size.prod() / count.prod();
  for (int i = 0; i < 10; ++i) {
    const hydro::BodyState state = random.state(0.5, 0);
    double sum = 0;  // by the midpoint rule
    for (int x = 0; x < count.x(); ++x)
      for (int y = 0; y < count.y(); ++y)
        for (int z = 0; z < count.z(); ++z) {
          const Eigen::Array3d place =
              (Eigen::Array3d(x, y, z) + 0.5) / count.cast<double>().array();
          const Vector3d p =
              state.position + state.orientation * Vector3d((place - 0.5) * size.array());
          sum += part * std::max(0.0, hydro::surface_height(sea, p.x(), p.y(), 0) - p.z());
        }
    // The rule misses a tenth of the square of its distance of 25 mm at the surface; the panels
    // follow the surface to less than kSagTolerance.
    EXPECT_NEAR(hydro::buoyancy_energy(hull, state, sea), 1000 * support::kGravity * sum,
                tolerance(1000 * support::kGravity * 2e-4 + hydro::energy_error_per_volume(sea)));
  }
}

TEST(Energy, IsThatOfWaterThatStandsStillOnly) {
  BodySpec body = support::box_body("box", {2, 1, 0.5}, 300, {0, 0, 0}, 1);
  body.wet = true;
  SimulationSpec spec = support::dry_world({body}, 0.01);
  const auto bounded = [&] { return engine::must_not_gain_energy(engine::make_bodies(spec)[0]); };
  spec.sea = uneven_sea(true);
  EXPECT_TRUE(bounded());
  spec.sea->current = {0.1, 0, 0};  // the field does not drift with it
  EXPECT_FALSE(bounded());
  spec.sea = hydro::Sea{.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.1, 5, 0, 0, 9.8)}}};
  EXPECT_FALSE(bounded());
}

TEST(Energy, IsBoundedInACurrentOnlyWhereNothingHoldsTheBody) {
  BodySpec body = support::box_body("box", {2, 1, 0.5}, 300, {0, 0, 0}, 1);
  body.wet = true;
  SimulationSpec spec = support::dry_world({body}, 0.01);
  spec.sea = {.current = {1, 0, 0}};
  const auto bounded = [&] { return engine::must_not_gain_energy(engine::make_bodies(spec)[0]); };
  EXPECT_TRUE(bounded());
  spec.bodies[0].locked[0] = true;
  EXPECT_FALSE(bounded());
  spec.bodies[0].locked[0] = false;
  spec.joints = {{.type = engine::JointSpec::Type::hinge, .first = 0, .axis_W = Vector3d::UnitY()}};
  EXPECT_FALSE(bounded());
  spec.sea->current.setZero();
  EXPECT_TRUE(bounded());
}

TEST(Anderson, EndsOnAnAffineMapAfterAsManyStepsAsItHasDimensions) {
  Eigen::MatrixXd map(3, 3);
  map << 3, 1, 0,  //
      0, -2, 1,    //
      1, 0, 5;     // plain iteration diverges
  const Eigen::VectorXd offset = Eigen::VectorXd::LinSpaced(3, 1, 3);
  engine::Anderson anderson(5);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
  for (int i = 0; i < 5; ++i) x = anderson.next(x, map * x + offset);
  EXPECT_LT((map * x + offset - x).norm(), tolerance(1e-10));
}

}  // namespace

#include <numbers>

#include "engine/base/constants.h"
#include "engine/motion/added_inertia.h"
#include "engine/motion/energy.h"
#include "engine/motion/free_motion.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "tests/engine/prelude.h"
#include "tests/support/repeats.h"

namespace {

/// Deep below the surface: the body never meets it.
SimulationSpec submerged(std::vector<BodySpec> bodies, double step) {
  SimulationSpec spec = support::dry_world(std::move(bodies), step);
  spec.sea = hydro::Sea{.gravity = support::kGravity, .level = 1000};
  return spec;
}

void add_mass(BodySpec& body, const Matrix6d& added) {
  body.added_mass = std::make_shared<hydro::ConstantAddedMass>(body.mesh_B, added);
}

Matrix6d diagonal(const Vector6d& values) { return values.asDiagonal(); }

/// Symmetric and positive semi-definite, all motions coupled, entries of the order of `size`.
Matrix6d random_inertia(support::Random& random, double size) {
  Matrix6d root;
  for (int i = 0; i < 36; ++i) root(i / 6, i % 6) = random.uniform(-1, 1);
  return size / 6 * root * root.transpose();
}

struct EllipsoidCase {
  double factor;  ///< Of the added mass.
  Vector3d end;   ///< Position after 1 s [m].
};

// Reference positions: gz-sim, test/integration/added_mass.cc (numbers only), from an independent
// integration of the same equations.
TEST(AddedMass, ForcedEllipsoidsGoWhereGazeboHasThem) {
  const EllipsoidCase cases[] = {{1, {0.16150346, 0.10710151, -0.00249428}},
                                 {0.1, {0.19339397, 0.18238589, -0.00061475}},
                                 {10, {0.06168088, 0.02095114, -0.00068374}}};
  Vector6d added;
  added << 236.14304479483277, 901.6370915802705, 901.6370915802705, 0, 64.40264939859075,
      64.40264939859075;
  for (const auto& [factor, end] : cases) {
    BodySpec body = support::sphere_body("ellipsoid", 0.5, 1000, {0, 0, 0});
    body.mass = 1073.3774899765126;
    body.inertia_B =
        Vector3d(107.33774899765126, 268.34437249412815, 268.34437249412815).asDiagonal();
    add_mass(body, factor * diagonal(added));
    body.loads = {{.force = {2000, 2000, 0}}, {.torque = {200, 200, 0}}};
    body.loads[0].sine = {.frequency = 1.5};
    body.loads[1].sine = {.frequency = 1};
    SimulationSpec spec = submerged({body}, 1e-3);
    spec.gravity = 0;
    const Simulation simulation = support::after(spec, 1000);
    // The measure of the reference itself; the step's own error is below 1e-6 m.
    EXPECT_LT((simulation.states()[0].position - end).norm(), tolerance(1e-5)) << factor;
  }
}

/// A spheroid of 2 : 1 : 1 and the water's density that moves nearly along its long axis, which is
/// unstable (Munk): m + A and I + A of its first line in tests/data/kirchhoff_prolate_munk.csv.
SimulationSpec munk_spheroid(double step) {
  constexpr double kMass = 8377.580409572781;  // 4/3 π a b² ρ
  BodySpec body = support::sphere_body("spheroid", 0.5, 1000, {0, 0, 0});
  body.mass = kMass;
  body.inertia_B = Vector3d(3351.0321638291125, 8377.580409572781, 8377.580409572781).asDiagonal();
  Vector6d added;
  added << 10136.99836959496 - kMass, 14277.15987739361 - kMass, 14277.15987739361 - kMass, 0,
      10383.373326788156 - 8377.580409572781, 10383.373326788156 - 8377.580409572781;
  add_mass(body, diagonal(added));
  body.initial.linear_velocity = {1, 0.01, 0};
  SimulationSpec spec = submerged({body}, step);
  spec.gravity = 0;
  return spec;
}

TEST(AddedMass, ASpheroidTumblesByMunksMomentAsItsEquationsSay) {
  const Simulation simulation = support::after(munk_spheroid(0.01), 6000);
  // Last line of shared reference: DOP853 at a relative tolerance of 1e-13, a path of 60 m.
  const Vector3d exact(56.729788007605, 0.77207762664287, 0);
  // Phase error (ω h)²/12 with ω < 0.5 1/s: 2e-6 of the path.
  EXPECT_LT((simulation.states()[0].position - exact).norm(), tolerance(60 * 2e-6));
}

TEST(AddedMass, KeepsKirchhoffsEnergy) {
  const SimulationSpec spec = munk_spheroid(0.01);
  Simulation simulation(spec);
  const double start = support::total_energy(spec, simulation.states());
  for (int i = 0; i < 6000; ++i) simulation.step();
  // The scheme keeps it; round-off of 12,000 half-steps adds up.
  EXPECT_NEAR(support::total_energy(spec, simulation.states()), start, tolerance(1e-10 * start));
}

TEST(AddedMass, InACurrentIsAsInStillWater) {
  SimulationSpec spec = munk_spheroid(0.05);
  spec.bodies[0].initial.angular_velocity = {0.1, 0.2, -0.3};
  const Simulation still = support::after(spec, 200);
  const Vector3d current(3, -2, 0.5);
  spec.sea->current = current;
  spec.bodies[0].initial.linear_velocity += current;
  const Simulation carried = support::after(spec, 200);
  // Round-off of velocities.
  EXPECT_LT((carried.states()[0].position - 10 * current - still.states()[0].position).norm(),
            tolerance(1e-11));
}

TEST(FreeMotion, KeepsEnergyAndBothMomentaForAnyStep) {
  support::Random random(11);
  for (const double time : {0.01, 0.3, 2.0}) {
    const Matrix6d S = random_inertia(random, 10) + Matrix6d(2 * Matrix6d::Identity());
    const hydro::BodyState start = random.state(3, 2);
    const Vector3d none = Vector3d::Zero();
    const hydro::BodyState end = engine::drifted(S, start, none, time);
    const auto momentum = [&](const hydro::BodyState& state) {
      const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
      const Vector6d p = engine::rotate_tensor(R_WB, S) * engine::velocity(state, none);
      return engine::to_vector6(p.head<3>(), p.tail<3>() + state.position.cross(p.head<3>()));
    };
    const auto energy = [&](const hydro::BodyState& state) {
      const Eigen::Matrix3d R_BW = state.orientation.conjugate().toRotationMatrix();
      const Vector6d u = engine::rotate(R_BW, engine::velocity(state, none));
      return u.dot(S * u) / 2;
    };
    EXPECT_NEAR(energy(end), energy(start), tolerance(1e-12 * energy(start)));
    EXPECT_LT((momentum(end) - momentum(start)).norm(), tolerance(1e-12 * momentum(start).norm()));
    EXPECT_GT((end.orientation * start.orientation.conjugate()).vec().norm(), 1e-3);
  }
}

// A needle of a millimetre at 30 m/s, whose Munk moment turns it thousands of times in a step.
TEST(FreeMotion, KeepsEnergyWhereItsEquationCannotBeSolved) {
  Vector6d rigid, added;
  rigid << 1, 1, 1, 2e-10 / 12, 1e-6 / 12, 1e-6 / 12;
  added << 1000, 500, 250, 500 * rigid[3], 1000 * rigid[4], 250 * rigid[5];
  Matrix6d S = diagonal(rigid + added);
  S(0, 4) = S(4, 0) = 0.3 * std::sqrt(added[0] * added[4]);
  support::Random random(11);
  for (const double time : {1e-5, 1e-3, 1.0 / 120, 1.0 / 30}) {
    hydro::BodyState state{.orientation = random.rotation(), .linear_velocity = random.vector(30)};
    const auto energy = [&](const hydro::BodyState& s) {
      const Vector6d u = engine::velocity(s, Vector3d::Zero());
      const Matrix6d S_W = engine::rotate_tensor(s.orientation.toRotationMatrix(), S);
      return u.dot(S_W * u) / 2;
    };
    const double before = energy(state);
    // 1024 parts, each halved up to 6 times, each within 1e-9 of the energy.
    EXPECT_NEAR(energy(engine::drifted(S, state, Vector3d::Zero(), time)) / before, 1,
                tolerance(6.6e-5));
  }
}

// A body nearly without mass of its own, locked in a current, turns ever faster as it comes across.
TEST(FreeMotion, WithLocksKeepsTheEnergyThatTheyLeave) {
  Vector6d inertia;
  inertia << 0.01, 0.05, 0.3, 1e-9, 8e-10, 1.2e-9;
  const Matrix6d S = diagonal(inertia);
  const Vector3d current(1.5, -0.5, 0);
  support::Random random(11);
  for (const double time : {1e-5, 1e-3, 1.0 / 60}) {
    const hydro::BodyState state{.orientation = random.rotation(),
                                 .angular_velocity = {60, -20, 0}};
    const auto energy = [&](const hydro::BodyState& s) {
      const Matrix6d S_W = engine::rotate_tensor(s.orientation.toRotationMatrix(), S);
      Vector6d free = engine::velocity(s, current), locked_part = free;
      for (const int i : {0, 1, 5}) free[i] = 0;
      for (const int i : {2, 3, 4}) locked_part[i] = 0;
      return (free.dot(S_W * free) - locked_part.dot(S_W * locked_part)) / 2;
    };
    const engine::DofMask locked = {true, true, false, false, false, true};
    const hydro::BodyState end = engine::drifted(S, locked, state, current, time);
    // A part of the most that the locked motion can give.
    const double most = 0.3 * current.squaredNorm() / 2;
    EXPECT_NEAR(energy(end), energy(state), tolerance(0.01 * most)) << time;
    EXPECT_EQ(end.linear_velocity.head<2>(), Vector3d::Zero().head<2>());
  }
}

// A needle of 1 cm that weighs nothing, nearly out of the water: solutions that overflow are none.
TEST(FreeMotion, WithLocksNeverDiverges) {
  Matrix6d S;
  S << 2.44051e-10, -2.1134e-11, 2.29677e-11, 5.1586e-17, -1.11088e-13, -1.03163e-13,    //
      -2.1134e-11, 1.99151e-09, -1.36074e-11, -8.79035e-15, -3.12663e-13, 9.44474e-12,   //
      2.29677e-11, -1.36074e-11, 2.00701e-09, -1.07133e-14, -9.49388e-12, 3.37775e-13,   //
      5.1586e-17, -8.79035e-15, -1.07133e-14, 2.27743e-18, 5.33424e-17, -4.48153e-17,    //
      -1.11088e-13, -3.12663e-13, -9.49388e-12, 5.33424e-17, 4.49824e-14, -3.38662e-15,  //
      -1.03163e-13, 9.44474e-12, 3.37775e-13, -4.48153e-17, -3.38662e-15, 4.48738e-14;
  const engine::DofMask locked = {true, true, false, false, false, true};
  support::Random random(12);
  for (int i = 0; i < support::repeats(3); ++i) {
    const Vector3d spin(random.uniform(-1000, 1000), random.uniform(-1000, 1000), 0);
    const hydro::BodyState state{.orientation = random.rotation(), .angular_velocity = spin};
    const hydro::BodyState end = engine::drifted(S, locked, state, {3, 1, 0}, 1.0 / 500);
    // At most 4.5e-8 J of the start and 1e-8 J of the locked motion, with no less than 9e-6 of 2e-9
    // kg: the least eigenvalue of S in terms of its diagonal.
    EXPECT_LT(end.linear_velocity.norm(), 2500) << i;
  }
}

// The matrix given here comes and goes as a whole: no pass over a step can foresee it.
TEST(AddedMass, ThatABodyMeetsWithTheWaterSharesItsMomentumAtOnce) {
  BodySpec body = support::box_body("cube", {1, 1, 1}, 300, {0, 0, 0.9});
  body.wet = true;
  body.coefficients.lift = 0;
  body.initial.orientation = support::Random(5).rotation();
  add_mass(body, diagonal(Vector6d::Constant(300)));
  SimulationSpec spec = support::dry_world({body}, 1.0 / 60);
  spec.sea = hydro::Sea{.gravity = support::kGravity};
  Simulation simulation(spec);
  const double first = support::total_energy(spec, simulation.states());
  double lowest = first;
  for (int i = 0; i < 300; ++i) {
    simulation.step();
    const double energy = support::total_energy(spec, simulation.states());
    // The greatest energy is that of the cube's first fall.
    EXPECT_LE(energy - lowest, tolerance(1e-3) * first) << "step " << i;
    lowest = std::min(lowest, energy);
  }
  EXPECT_LT(lowest, 0.9 * first);
}

TEST(AddedInertia, GrowthKeepsMomentumAndLossKeepsVelocity) {
  support::Random random(4);
  const Matrix6d S = random_inertia(random, 3) + Matrix6d(Matrix6d::Identity());
  const Matrix6d growth = random_inertia(random, 50);
  Vector6d u;
  for (int i = 0; i < 6; ++i) u[i] = random.uniform(-2, 2);
  const engine::InertiaChange in = engine::inertia_change(S, growth, {}, u);
  // Round-off of a matrix of condition 1e4.
  EXPECT_LT(((S + growth) * in.velocity - S * u).norm(), tolerance(1e-11 * (S * u).norm()));
  EXPECT_LT((in.inertia - S - growth).norm(), tolerance(1e-11 * growth.norm()));
  const engine::InertiaChange out = engine::inertia_change(S + growth, -growth, {}, u);
  EXPECT_LT((out.velocity - u).norm(), tolerance(1e-11 * u.norm()));
}

TEST(AddedInertia, NoChangeAddsEnergy) {
  support::Random random(5);
  for (int i = 0; i < 200; ++i) {
    const double ratio = std::pow(10, random.uniform(-3, 3));
    const Matrix6d before = random_inertia(random, ratio);
    const Matrix6d after = random_inertia(random, ratio * random.uniform(0, 2));
    const Matrix6d S = before + Matrix6d(Matrix6d::Identity());
    Vector6d u;
    for (int k = 0; k < 6; ++k) u[k] = random.uniform(-2, 2);
    const Vector6d v = engine::inertia_change(S, after - before, {}, u).velocity;
    const double end = v.dot(v) + v.dot(after * v);
    EXPECT_LE(end, u.dot(S * u) * (1 + 1e-12));
  }
}

TEST(AddedInertia, LockedDegreesOfFreedomTakeNoPart) {
  support::Random random(6);
  const Matrix6d S = random_inertia(random, 3) + Matrix6d(Matrix6d::Identity());
  const Matrix6d growth = random_inertia(random, 5);
  const engine::DofMask locked = {true, true, false, true, true, true};
  const Vector6d u = Vector6d::Unit(2);
  const Vector6d v = engine::inertia_change(S, growth, {.locked = locked}, u).velocity;
  EXPECT_NEAR(v[2], S(2, 2) / (S(2, 2) + growth(2, 2)), tolerance(1e-14));
  EXPECT_NEAR(v.norm(), v[2], tolerance(1e-15));
}

/// A plate of mass m with added mass of up to `ratio` m, unequal in all directions.
BodySpec plate(double ratio, const Vector3d& position) {
  BodySpec body = support::box_body("plate", {1, 0.6, 0.05}, 3000, position);
  Vector6d parts;
  parts << 0.1, 0.3, 1, 0.02, 0.05, 0.01;
  add_mass(body, ratio * body.mass * diagonal(parts));
  return body;
}

constexpr double kRatios[] = {0.5, 1, 2, 10, 100, 1000};

/// Largest rise of the energy above its start within a time (a quarter of it where a sanitizer
/// watches) [s], as a part of the weight times 1 m.
double energy_gain(const SimulationSpec& spec, int seconds) {
  Simulation simulation(spec);
  const double start = support::total_energy(spec, simulation.states());
  double gain = 0;
  double weight = 0;
  for (const BodySpec& body : spec.bodies) weight += body.mass * support::kGravity;
  for (long i = 0; i < support::steps_in(support::repeats(seconds), spec.step); ++i) {
    simulation.step();
    gain = std::max(gain, support::total_energy(spec, simulation.states()) - start);
  }
  for (const engine::Counts& counts : simulation.counts()) EXPECT_EQ(counts.unconverged, 0);
  return gain / weight;
}

SimulationSpec hanging_plate(double ratio, JointSpec::Type type) {
  SimulationSpec spec = submerged({plate(ratio, {0.5, 0.3, 0})}, 0.01);
  spec.joints = {{.type = type, .first = 0, .axis_W = Vector3d::UnitY()}};
  return spec;
}

TEST(AddedMass, OfAnyRatioFeedsNoBodyOnAReducedJoint) {
  for (const double ratio : {1, 1000})
    for (const auto type : {JointSpec::Type::hinge, JointSpec::Type::ball}) {
      const SimulationSpec spec = hanging_plate(ratio, type);
      // (ω h)²/8 with ω = 4 1/s of a swing of 1 m.
      EXPECT_LT(energy_gain(spec, 15), tolerance(2e-4)) << ratio;
      EXPECT_EQ(support::after(spec, 10).counts()[0].constrained, 0);
    }
}

TEST(AddedMass, OfAnyRatioFeedsNoHingedBodyThatIsLeftToTheSolver) {
  for (const double ratio : kRatios) {
    const SimulationSpec spec =
        support::left_to_the_solver(hanging_plate(ratio, JointSpec::Type::hinge));
    EXPECT_LT(energy_gain(spec, 30), tolerance(2e-4)) << ratio;
    EXPECT_GT(support::after(spec, 10).counts()[0].iterations, 10);
  }
}

TEST(AddedMass, OfAnyRatioFeedsNoBallJointedBodyThatIsLeftToTheSolver) {
  for (const double ratio : kRatios)
    EXPECT_LT(
        energy_gain(support::left_to_the_solver(hanging_plate(ratio, JointSpec::Type::ball)), 30),
        tolerance(2e-4))
        << ratio;
}

TEST(AddedMass, OfAnyRatioFeedsNoChain) {
  for (const double ratio : kRatios) {
    SimulationSpec spec = submerged({}, 0.01);
    for (int i = 0; i < 3; ++i) {
      spec.bodies.push_back(plate(ratio, {0.5 + i, 0, 0}));
      spec.joints.push_back({.first = i, .second = i - 1, .anchor_W = Vector3d(i, 0, 0)});
    }
    EXPECT_LT(energy_gain(spec, 60), tolerance(2e-4)) << ratio;
  }
}

TEST(AddedMass, OfAnyRatioLetsAPlatePushedAgainstAWallComeToRest) {
  for (const double ratio : kRatios) {
    BodySpec body = plate(ratio, {0, 0, 1});
    body.collision = engine::CollisionShape::box;
    body.loads = {{.force = {0, 0, -2000}}};
    body.initial.orientation = Eigen::AngleAxisd(0.5, Vector3d(1, 2, 0).normalized());
    SimulationSpec spec = submerged({body}, 0.01);
    spec.gravity = 0;
    spec.ground = engine::PlaneGround{0};
    const Simulation simulation = support::after(spec, 6000);
    // Half its thickness, less the depth of rest.
    EXPECT_NEAR(simulation.states()[0].position.z(), 0.025 - 0.05 * engine::kContactDepth,
                tolerance(1e-5))
        << ratio;
    EXPECT_LT(simulation.states()[0].linear_velocity.norm(), tolerance(1e-7)) << ratio;
  }
}

constexpr double kLever = 0.5;  // [m]

/// A plate that hangs on a hinge in its plane and leans by an angle.
SimulationSpec swinging_plate(double ratio, double angle, double step) {
  BodySpec body = plate(ratio, kLever * Vector3d(std::sin(angle), 0, -std::cos(angle)));
  body.initial.orientation = Eigen::AngleAxisd(std::numbers::pi / 2 - angle, Vector3d::UnitY());
  SimulationSpec spec = submerged({body}, step);
  spec.joints = {{.type = JointSpec::Type::hinge, .first = 0, .axis_W = Vector3d::UnitY()}};
  return spec;
}

/// Time between the first two passages below the hinge, interpolated between steps [s].
double swinging_period(const SimulationSpec& spec) {
  Simulation simulation(spec);
  std::vector<double> crossings;
  double before = spec.bodies[0].initial.position.x();
  while (crossings.size() < 2) {
    simulation.step();
    const double now = simulation.states()[0].position.x();
    if (before > 0 && now <= 0)
      crossings.push_back(simulation.time() - spec.step * now / (now - before));
    before = now;
  }
  return crossings[1] - crossings[0];
}

// The hinge lies in the plane of the plate, so that A about it is A_zz L² + A_pitch.
TEST(AddedMass, AHingedPlateSwingsWithThePeriodOfItsWholeInertia) {
  constexpr double kAngle = 0.1;
  for (const double ratio : kRatios) {
    const SimulationSpec spec = swinging_plate(ratio, kAngle, 0.01);
    const BodySpec& body = spec.bodies[0];
    const double inertia = body.inertia_B(1, 1) + body.mass * kLever * kLever +
                           ratio * body.mass * (0.05 + kLever * kLever);
    const double omega = std::sqrt(body.mass * kGravity * kLever / inertia);
    const double exact = 2 * std::numbers::pi / omega * (1 + kAngle * kAngle / 16);
    for (const SimulationSpec& hinge : {spec, support::left_to_the_solver(spec)})
      EXPECT_NEAR(swinging_period(hinge), exact, tolerance(2e-3 * exact)) << ratio;
  }
}

TEST(AddedMass, AHingedPlateKeepsItsSwingAtLongSteps) {
  constexpr double kAngle = 0.5;
  const SimulationSpec spec = swinging_plate(1, kAngle, 1.0 / 15);
  for (const SimulationSpec& hinge : {spec, support::left_to_the_solver(spec)}) {
    Simulation simulation(hinge);
    double widest = 0;
    for (int i = 0; i < 30 * 15; ++i) {
      simulation.step();
      if (i > 27 * 15) widest = std::max(widest, simulation.states()[0].position.x());
    }
    // ω is about 3 rad/s, so that a step goes through (ω h)²/8 = 0.005 of the swing past its end;
    // the energy of the scheme swings by (ω h)²/4 and must not be taken for a gain each time.
    EXPECT_NEAR(widest, kLever * std::sin(kAngle), tolerance(0.02 * kLever));
  }
}

}  // namespace

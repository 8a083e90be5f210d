#include "engine/step/constrained_update.h"

#include <map>

#include "engine/base/constants.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "tests/engine/island.h"
#include "tests/engine/prelude.h"

/// (E7) against the same equations solved at once by another method, and in islands whose loads
/// are stiff.

namespace {

using engine::Integrator;
using Type = JointSpec::Type;

constexpr double kSubstep = 0.01;  // [s]
// Bounds that of a joint between two boxes of the tests, whose joints respond to an impulse with no
// more than 1 1/kg [1/(N s)].
constexpr double kCompliance = engine::kLeastCompliance * kSubstep;

const std::map<Type, std::string> kNames = {{Type::ball, "ball"},
                                            {Type::hinge, "hinge"},
                                            {Type::slider, "slider"},
                                            {Type::fixed, "fixed"},
                                            {Type::universal, "universal"}};

/// Symmetric and positive definite, all motions coupled, the largest eigenvalue `size`.
Matrix6d random_added_mass(support::Random& random, double size) {
  Matrix6d root;
  for (int i = 0; i < 36; ++i) root(i / 6, i % 6) = random.uniform(-1, 1);
  const Matrix6d matrix = root * root.transpose();
  return size / Eigen::SelfAdjointEigenSolver<Matrix6d>(matrix).eigenvalues()[5] * matrix;
}

/// Two boxes deep under water in no symmetric pose, whose added mass is up to `ratio` times their
/// mass, pushed and moving at random.
SimulationSpec two_boxes(unsigned seed, double ratio) {
  support::Random random(seed);
  SimulationSpec spec = support::dry_world({}, kSubstep);
  spec.sea = hydro::Sea{.gravity = kGravity, .level = 1000};
  for (const double x : {-0.6, 0.7}) {
    BodySpec box = support::box_body("box", {1, 0.6, 0.3}, 800, Vector3d(x, 0, 0));
    box.initial.orientation = random.rotation();
    box.initial.linear_velocity = random.vector(1);
    box.initial.angular_velocity = random.vector(1);
    box.loads = {{.force = random.vector(5000), .torque = random.vector(2000)}};
    box.added_mass = std::make_shared<hydro::ConstantAddedMass>(
        box.mesh_B, random_added_mass(random, ratio * box.mass));
    spec.bodies.push_back(box);
  }
  return spec;
}

JointSpec between(Type type, BodyId first, BodyId second, const Vector3d& anchor = {0.1, 0.2, 0}) {
  return {.type = type,
          .first = first,
          .second = second,
          .anchor_W = anchor,
          .axis_W = Vector3d(1, 2, -1).normalized(),
          .axis2_W = Vector3d(2, -1, 0).normalized()};
}

/// The conditions J u = 0 of a joint on the velocities of both bodies, twelve numbers.
Eigen::MatrixXd conditions(const JointSpec& joint, const std::vector<BodySpec>& bodies) {
  const Vector3d &e = joint.axis_W, p = e.unitOrthogonal(), q = e.cross(p);
  // Rates of the anchor's separation and of the relative turn.
  Eigen::MatrixXd separation(3, 12), turn(3, 12);
  separation.setZero(), turn.setZero();
  for (const auto& [body, sign] : {std::pair(joint.first, 1.0), std::pair(joint.second, -1.0)}) {
    if (body == kWorld) continue;
    const Vector3d r = joint.anchor_W - bodies[static_cast<std::size_t>(body)].initial.position;
    separation.block<3, 3>(0, 6 * body) = sign * Matrix3d::Identity();
    separation.block<3, 3>(0, 6 * body + 3) = -sign * engine::cross_matrix(r);
    turn.block<3, 3>(0, 6 * body + 3) = sign * Matrix3d::Identity();
  }
  Eigen::MatrixXd all(6, 12);
  all << separation, turn;
  if (joint.type == Type::ball) return separation;
  if (joint.type == Type::fixed) return all;
  Eigen::MatrixXd rows(joint.type == Type::universal ? 4 : 5, 12);
  if (joint.type == Type::hinge)
    rows << separation, p.transpose() * turn, q.transpose() * turn;
  else if (joint.type == Type::slider)
    rows << turn, p.transpose() * separation, q.transpose() * separation;
  else
    rows << separation, e.cross(joint.axis2_W).transpose() * turn;
  return rows;
}

Eigen::MatrixXd all_conditions(const SimulationSpec& spec) {
  Eigen::MatrixXd J(0, 12);
  for (const JointSpec& joint : spec.joints) {
    const Eigen::MatrixXd rows = conditions(joint, spec.bodies);
    J.conservativeResize(J.rows() + rows.rows(), 12);
    J.bottomRows(rows.rows()) = rows;
  }
  return J;
}

using Vector12d = Eigen::Matrix<double, 12, 1>;

/// What is known of both bodies before an update.
struct Problem {
  Eigen::Matrix<double, 12, 12> S = Eigen::Matrix<double, 12, 12>::Zero();
  Vector12d load;    ///< F
  Vector12d start;   ///< u⁻
  Vector12d before;  ///< u⁻ after the change of the added mass
};

Problem problem(support::IslandOfAll& all) {
  Problem p;
  for (int i = 0; i < 2; ++i) {
    engine::SubstepBody& b = all.members[static_cast<std::size_t>(i)];
    p.S.block<6, 6>(6 * i, 6 * i) = engine::inertia_W(b.body(), b.midpoint);
    p.load.segment<6>(6 * i) =
        engine::to_vector6(engine::find_loads(*b.moving, b.halfway.state, kSubstep / 2));
    p.start.segment<6>(6 * i) = b.midpoint.before;
    p.before.segment<6>(6 * i) = b.midpoint.after;
  }
  return p;
}

/// Δu of S Δu = h (F + Jᵀλ), J u⁺ = −J u⁻, in a basis of the velocities that J leaves.
Vector12d solved_at_once(const Problem& p, const Eigen::MatrixXd& J) {
  Eigen::FullPivLU<Eigen::MatrixXd> lu(J);
  lu.setThreshold(1e-10);
  const Eigen::MatrixXd N = lu.kernel();
  const Vector12d push = kSubstep * p.load + p.S * (p.before + p.start);
  const Eigen::VectorXd rates = (N.transpose() * p.S * N).ldlt().solve(N.transpose() * push);
  return N * rates - p.start - p.before;
}

/// What a solution of (E7) must be, for the given specification and a change of added mass.
void expect_exact(const SimulationSpec& spec, double growth) {
  support::IslandOfAll all(spec);
  all.make_midpoints(growth);
  const Problem p = problem(all);
  engine::constrained_update(all.context, all.island, kSubstep / 2, kSubstep);
  Vector12d change, reaction;
  for (int i = 0; i < 2; ++i) {
    const engine::SubstepBody& b = all.members[static_cast<std::size_t>(i)];
    change.segment<6>(6 * i) = b.update.change;
    reaction.segment<6>(6 * i) = engine::rotate(b.midpoint.R_WB, b.reaction_B);
    EXPECT_EQ(b.moving->counts.unconverged, 0);
    EXPECT_FALSE(b.update.implicit);
  }
  const Eigen::MatrixXd J = all_conditions(spec);
  const Vector12d impulse = kSubstep * (p.load + reaction);
  EXPECT_LT((p.S * change - impulse).norm(), tolerance(1e-9 * (impulse.norm() + change.norm())));
  // Reactions do no work on any velocity that the joints allow.
  const Eigen::MatrixXd allowed = Eigen::FullPivLU<Eigen::MatrixXd>(J).setThreshold(1e-10).kernel();
  for (Eigen::Index k = 0; k < allowed.cols(); ++k)
    EXPECT_LT(std::abs(allowed.col(k).dot(reaction)),
              tolerance(1e-9 * reaction.norm() * allowed.col(k).norm()));
  // What the joints give way by under that reaction, whose moments count about other points; no
  // more than four times that comes to the motion of the bodies.
  const double way = 2 * kCompliance * reaction.norm() + 1e-9 * p.before.norm();
  const Vector12d exact = solved_at_once(p, J);
  EXPECT_LT((J * (p.start + p.before + change)).norm(), tolerance(way));
  EXPECT_LT((change - exact).norm(), tolerance(4 * way));
}

constexpr double kAddedOverMass[] = {0, 0.5, 10, 1000};

TEST(ConstrainedUpdate, OfTwoMovingBodiesIsTheSolutionWithTheirWholeInertia) {
  for (const auto& [type, name] : kNames)
    for (const double ratio : kAddedOverMass)
      for (const unsigned seed : {1U, 2U, 3U}) {
        SCOPED_TRACE(name + ", " + std::to_string(ratio) + ", seed " + std::to_string(seed));
        SimulationSpec spec = two_boxes(seed, ratio);
        spec.joints = {between(type, 0, 1)};
        expect_exact(spec, 1);
      }
}

TEST(ConstrainedUpdate, OfAChainFromTheWorldIsThatToo) {
  for (const auto& [type, name] : kNames)
    for (const double ratio : kAddedOverMass) {
      SCOPED_TRACE(name + ", " + std::to_string(ratio));
      SimulationSpec spec = two_boxes(4, ratio);
      spec.joints = {between(type, 0, 1), between(Type::ball, 0, kWorld, {-1, 0, 0.2})};
      expect_exact(spec, 1);
    }
}

// Two ball joints are a hinge; a ball joint on a hinge's axis, or a second slider, asks for nothing
// that the first joint does not.
TEST(ConstrainedUpdate, WithTwoJointsToTheWorldIsThatToo) {
  const Vector3d anchor(-1, 0, 0.2);
  for (const double ratio : kAddedOverMass) {
    SCOPED_TRACE(ratio);
    SimulationSpec spec = two_boxes(5, ratio);
    const std::vector<std::vector<JointSpec>> pairs = {
        {between(Type::ball, 0, kWorld, anchor), between(Type::ball, 0, kWorld, {0, 1, 0})},
        {between(Type::hinge, 0, kWorld, anchor), between(Type::ball, kWorld, 0, anchor)},
        {between(Type::slider, 0, kWorld), between(Type::slider, kWorld, 0)}};
    for (const std::vector<JointSpec>& pair : pairs) {
      spec.joints = pair;
      spec.joints.push_back(between(Type::slider, 0, 1));
      expect_exact(spec, 1);
    }
  }
}

TEST(ConstrainedUpdate, TakesAChangeOfAddedMassIntoAccount) {
  for (const double growth : {0.0, 0.5, 3.0})
    for (const auto& [type, name] : kNames) {
      SCOPED_TRACE(name + ", " + std::to_string(growth));
      SimulationSpec spec = two_boxes(6, 5);
      spec.joints = {between(type, 0, 1)};
      expect_exact(spec, growth);
    }
}

// One sweep, a Newton step, and the sweep that finds nothing left.
TEST(ConstrainedUpdate, OfJointsTakesOneNewtonStepWhateverTheAddedMass) {
  for (const double ratio : kAddedOverMass) {
    SimulationSpec spec = two_boxes(7, ratio);
    spec.joints = {between(Type::hinge, 0, 1)};
    support::IslandOfAll all(spec);
    all.make_midpoints();
    engine::constrained_update(all.context, all.island, kSubstep / 2, kSubstep);
    for (const engine::MovingBody& moving : all.bodies) EXPECT_EQ(moving.counts.iterations, 2);
  }
}

/// Three plates in a row, much lighter than the water that they are in, that meet pressure drag
/// alone and move at random.
SimulationSpec light_plates(Type type, double density, double step) {
  support::Random random(8);
  SimulationSpec spec = support::dry_world({}, step);
  spec.gravity = 0;
  spec.sea = hydro::Sea{.gravity = kGravity, .level = 1000};
  for (int i = 0; i < 3; ++i) {
    BodySpec plate = support::box_body("plate", {1, 0.7, 0.05}, density, {1.1 * i, 0, 0}, 2);
    plate.wet = true;
    plate.coefficients.buoyancy = false;
    plate.coefficients.lift = 0;
    plate.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
    plate.initial.linear_velocity = random.vector(5);
    plate.initial.angular_velocity = random.vector(5);
    spec.bodies.push_back(plate);
    if (i > 0) spec.joints.push_back(between(type, i - 1, i, {1.1 * i - 0.55, 0, 0}));
  }
  return spec;
}

TEST(StiffIslands, NeverGainEnergyHoweverLightTheirBodies) {
  for (const auto& [type, name] : kNames)
    for (const double density : {0.1, 1.0, 10.0})
      for (const double step : {1.0 / 60, 1.0 / 15}) {
        SCOPED_TRACE(name + ", " + std::to_string(density) + ", " + std::to_string(step));
        const SimulationSpec spec = light_plates(type, density, step);
        Simulation simulation(spec);
        simulation.step();  // The joints take what of the motion they do not allow.
        const double start = support::energy(spec, simulation.states());
        double lowest = start;
        for (int i = 0; i < 60; ++i) {
          simulation.step();
          const double now = support::energy(spec, simulation.states());
          // A joint takes back what the bodies have strayed from it in the turn of a step.
          ASSERT_LE(now, lowest + 2 * engine::kEnergyGain * start) << i;
          lowest = std::min(lowest, now);
        }
        EXPECT_LT(lowest, 0.05 * start);
        long implicit = 0, clamped = 0;
        for (const engine::Counts& counts : simulation.counts()) {
          implicit += counts.implicit;
          clamped += counts.clamped;
          EXPECT_EQ(counts.unconverged, 0);
          EXPECT_GT(counts.constrained, 0);
        }
        EXPECT_GT(implicit, 0);
        EXPECT_EQ(clamped, 0);
      }
}

/// The least, over the weights θ of (E6), of what S Δu = h (F(u + θ Δu) + R) lacks, of h |F|.
double implicit_residual(engine::SubstepBody& b, double h) {
  const Matrix6d S = engine::inertia_W(b.body(), b.midpoint);
  const Vector6d R = engine::rotate(b.midpoint.R_WB, b.reaction_B);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 1000; ++i) {
    const Vector6d at = b.midpoint.after + (0.5 + i / 2000.0) * b.update.change;
    const BodyState state = engine::with_velocity(b.halfway.state, at, Vector3d::Zero());
    const Vector6d F = engine::to_vector6(engine::find_loads(*b.moving, state, h / 2));
    const double missed = (S * b.update.change - h * (F + R)).norm() / (h * F.norm());
    least = std::min(least, missed);
  }
  return least;
}

// One update ends when it has solved the constraints often enough, some two linearisations after
// rest; the next one begins where it has ended.
TEST(StiffIslands, ConvergeToTheLoadsAtTheVelocityThatTheyLeadTo) {
  const double h = 1.0 / 30;
  for (const auto& [type, name] : kNames)
    for (const double density : {10.0, 100.0}) {
      SCOPED_TRACE(name + ", " + std::to_string(density));
      support::IslandOfAll all(light_plates(type, density, h));
      all.make_midpoints();
      for (int i = 0; i < 6; ++i) {
        const long before = all.bodies[0].counts.iterations;
        engine::constrained_update(all.context, all.island, h / 2, h);
        EXPECT_LE(all.bodies[0].counts.iterations - before, 2 * engine::kMostLinearisations);
      }
      for (engine::SubstepBody& b : all.members) {
        EXPECT_TRUE(b.update.implicit);
        // The weights that are tried are 5e-4 apart, of loads up to 50 times the momentum.
        EXPECT_LT(implicit_residual(b, h), tolerance(0.015));
      }
    }
}

// Two cubes held upright, which rise side by side: neither does anything to the other.
TEST(StiffIslands, RiseAtTheTerminalVelocityOfTheirBodies) {
  for (const auto type : {Type::ball, Type::slider, Type::fixed}) {
    SimulationSpec spec = support::dry_world({}, 1.0 / 60);
    spec.sea = hydro::Sea{.density = 1000, .gravity = kGravity, .level = 1000};
    for (const double x : {0.0, 0.2}) {
      BodySpec cube = support::box_body("cube", {0.1, 0.1, 0.1}, 20, {x, 0, 0}, 2);
      cube.wet = true;
      cube.coefficients.lift = 0;
      cube.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
      cube.locked = {false, false, false, true, true, true};
      spec.bodies.push_back(cube);
    }
    spec.joints = {between(type, 0, 1)};
    const Simulation simulation = support::after(spec, 120);
    const hydro::PressureDrag& c = spec.bodies[0].coefficients.pressure_drag;
    const double terminal =
        std::sqrt((1000 - 20) * kGravity * 0.1 / (0.5 * 1000 * (c.front + c.back)));
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(simulation.states()[i].linear_velocity.z(), terminal, tolerance(2e-6 * terminal));
      EXPECT_GT(simulation.counts()[i].implicit, 0);
      EXPECT_GT(simulation.counts()[i].constrained, 0);
    }
  }
}

}  // namespace

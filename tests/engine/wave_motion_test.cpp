#include <numbers>

#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/engine/prelude.h"

/// Bodies in waves against linear theory.

namespace {

using engine::BodyForces;
using hydro::Sea;

/// ψ_m = x_m/2 on a sphere: its exact potentials.
std::shared_ptr<const hydro::AddedMassModel> sphere_added_mass(const hydro::TriMesh& mesh) {
  hydro::AddedMassSolution solution;
  for (const auto& face : mesh.faces.colwise()) {
    hydro::CornerPotentials psi = hydro::CornerPotentials::Zero();
    std::array<Vector3d, 3> corners;
    for (int i = 0; i < 3; ++i) {
      corners[static_cast<std::size_t>(i)] = mesh.vertices.col(face[i]);
      psi.col(i).head<3>() = mesh.vertices.col(face[i]) / 2;
    }
    const hydro::Matrix6d share = hydro::triangle_share(corners, psi);
    solution.matrix += 0.5 * (share + share.transpose());
    solution.potentials.push_back(psi);
  }
  return std::make_shared<hydro::WettedAddedMass>(mesh, solution);
}

/// A ball without drag and lift.
BodySpec ball(double radius, double density, const Vector3d& position) {
  BodySpec body = support::sphere_body("ball", radius, 1, position);
  body.mesh_B = hydro::make_icosphere(radius, 3);
  body.mass = density * hydro::solid_properties(body.mesh_B).volume;
  body.inertia_B = 0.4 * body.mass * radius * radius * Eigen::Matrix3d::Identity();
  body.coefficients.pressure_drag = {0, 0};
  body.coefficients.lift = 0;
  body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  body.added_mass = sphere_added_mass(body.mesh_B);
  body.wet = true;
  return body;
}

Sea one_wave(double amplitude, double wave_number, double depth,
             const Vector3d& current = Vector3d::Zero()) {
  Sea sea{.density = 1000, .gravity = kGravity, .depth = depth, .current = current};
  sea.surface = hydro::WaveSurface{{hydro::linear_wave(sea, amplitude, wave_number, 0.4, 0.2)}};
  return sea;
}

SimulationSpec in_sea(BodySpec body, const Sea& sea, double step) {
  SimulationSpec spec = support::dry_world({std::move(body)}, step);
  spec.sea = sea;
  return spec;
}

constexpr double kDeep = std::numeric_limits<double>::infinity();

/// The water has the forces ρV u̇ and ½ρV u̇ on a sphere in its place, and none other.
TEST(Waves, TakeANeutrallyBuoyantBallAlongAsTheirWater) {
  const double amplitude = 1e-4, k = 0.6;
  for (const double water_depth : {kDeep, 5.0}) {
    for (const double depth : {1.5, 3.0}) {
      const Sea sea = one_wave(amplitude, k, water_depth);
      BodySpec body = ball(0.5, 1000, {0.3, 0.1, -depth});
      body.initial.linear_velocity = hydro::water_at(sea, body.initial.position, 0).velocity;
      const double period =
          2 * std::numbers::pi / hydro::intrinsic_frequency(k, water_depth, kGravity);
      const SimulationSpec spec = in_sea(body, sea, period / 200);
      Simulation simulation(spec);
      Vector3d water = body.initial.position;  // a drop, by the midpoint rule
      double farthest = 0, off = 0;
      for (int i = 0; i < 200; ++i) {
        const double t = simulation.time(), h = spec.step;
        const Vector3d half = water + h / 2 * hydro::water_at(sea, water, t).velocity;
        water += h * hydro::water_at(sea, half, t + h / 2).velocity;
        simulation.step();
        const Vector3d& p = simulation.states()[0].position;
        farthest = std::max(farthest, (water - body.initial.position).norm());
        off = std::max(off, (p - water).norm());
      }
      // The ball feels ∂u/∂t and not Du/Dt: over a period it misses 2π² k a of its way.
      EXPECT_LT(off, 1e-3 * farthest) << "depth " << depth << " of " << water_depth;
      EXPECT_GT(farthest, 0.3 * amplitude * std::exp(-k * depth));
    }
  }
}

/// The half-wet added mass is not that of a sphere, but it moves through no water.
TEST(Waves, DoNotSpinASmallBallThatMovesWithThem) {
  const double amplitude = 0.4, k = 2 * std::numbers::pi / 12;
  BodySpec body = ball(0.2, 500, {0, 0, amplitude});
  body.initial.linear_velocity = {amplitude * std::sqrt(kGravity * k), 0, 0};
  const double period = 2 * std::numbers::pi / std::sqrt(kGravity * k);
  Simulation simulation(in_sea(body, one_wave(amplitude, k, kDeep), period / 200));
  for (int i = 0; i < 4 * 200; ++i) simulation.step();
  // Relative to the current alone the Munk moment makes 0.6 rad/s in this time; the ball's mesh
  // and what it moves relative to the water leave 1 % of it.
  EXPECT_LT(simulation.states()[0].angular_velocity.norm(), 0.02);
}

TEST(Waves, LookTheSameToABallThatDrifts) {
  const Vector3d current(0.8, -0.3, 0);
  Sea still = one_wave(0.1, 0.8, 6), moving = one_wave(0.1, 0.8, 6, current);
  BodySpec body = ball(0.5, 600, {0, 0, -0.2});
  body.coefficients = {};
  Simulation at_rest(in_sea(body, still, 0.02));
  body.initial.linear_velocity = current;
  Simulation drifting(in_sea(body, moving, 0.02));
  for (int i = 0; i < 150; ++i) {
    at_rest.step();
    drifting.step();
  }
  const hydro::BodyState a = at_rest.states()[0], b = drifting.states()[0];
  EXPECT_LT((a.position + at_rest.time() * current - b.position).norm(), 1e-9);
  EXPECT_LT((a.linear_velocity + current - b.linear_velocity).norm(), 1e-9);
}

/// Amplitude of the heave at the wave's frequency, by least squares with a mean and with the motion
/// at the frequency of its own that nothing damps.
double heave_amplitude(const std::vector<double>& z, double step, double omega, double own) {
  Eigen::MatrixXd columns(z.size(), 5);
  Eigen::VectorXd heights(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double t = step * static_cast<double>(i + 1);
    columns.row(static_cast<Eigen::Index>(i)) << 1, std::cos(omega * t), std::sin(omega * t),
        std::cos(own * t), std::sin(own * t);
    heights[static_cast<Eigen::Index>(i)] = z[i];
  }
  const Eigen::VectorXd c = columns.colPivHouseholderQr().solve(heights);
  return std::hypot(c[1], c[2]);
}

/// Linear theory with Hulme's added mass a and damping b of a floating hemisphere, over its mass,
/// and Haskind's excitation √(4b/(3π kR)) [H82]: heave over amplitude is
/// 1.5 √(4b/(3π kR)) / |1.5 − kR (1 + a − ib)|.
///
/// [H82] Hulme. The wave forces acting on a floating hemisphere undergoing forced periodic
///       oscillations. J. Fluid Mech. 121 (1982) 443-463.
TEST(Waves, HeaveAFloatingBallAsLinearTheory) {
  struct Row {
    double kR, heave;
  };
  for (const Row& row :
       {Row{2 * std::numbers::pi / 20, 1.030}, Row{2 * std::numbers::pi / 40, 1.003}}) {
    const double amplitude = 0.005;
    const Sea sea = one_wave(amplitude, row.kR, kDeep);
    const double omega = hydro::intrinsic_frequency(row.kR, kDeep, kGravity);
    const SimulationSpec spec = in_sea(ball(1, 500, {0, 0, 0}), sea, 0.04);
    Simulation simulation(spec);
    std::vector<double> z;
    for (int i = 0; i < 1500; ++i) {
      simulation.step();
      z.push_back(simulation.states()[0].position.z());
    }
    // Half of the mass of the water in its place is added: ω_n² = 1.5 g/R / 1.5.
    const double heave = heave_amplitude(z, spec.step, omega, std::sqrt(kGravity)) / amplitude;
    EXPECT_NEAR(heave, row.heave, 0.03 * row.heave) << "kR = " << row.kR;
  }
}

/// K − K(0) less the sum of the works, over the works of the waves.
double budget_error(double step) {
  BodySpec body = ball(0.7, 700, {0, 0, 0.1});
  body.coefficients = {};
  SimulationSpec spec = in_sea(body, one_wave(0.4, 0.9, 8, {0.2, 0, 0}), step);
  spec.record_work = true;
  const BodyForces start = Simulation(spec).forces()[0];
  const BodyForces end = support::after(spec, support::steps_in(6, step)).forces()[0];
  const double all = std::abs(end.works.buoyancy) + std::abs(end.works.wave_inertia);
  EXPECT_GT(std::abs(end.works.wave_inertia), 1e-3 * all);
  return std::abs(end.kinetic_energy - start.kinetic_energy - end.works.sum()) / all;
}

/// What is missing is the correction (E9) of the state, (h²/24) of accelerations and their rates.
/// Steps of 0.02 s are too long for its order to show.
TEST(Waves, CloseTheBudgetOfWorksButForTheCorrection) {
  const double coarse = budget_error(0.01), fine = budget_error(0.0025);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_LT(fine, coarse / 12);
}

}  // namespace

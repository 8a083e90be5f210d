#include "hydro/water/hull_sources.h"

#include <gtest/gtest.h>

#include "hydro/mesh/primitives.h"
#include "hydro/radiation/diffraction_load.h"
#include "hydro/radiation/froude_krylov.h"
#include "hydro/radiation/radiation_solve.h"
#include "tests/hydro/floating_hull.h"
#include "tests/support/tolerance.h"

namespace hydro {
namespace {

using support::tolerance;

constexpr double kVolume = 2 * M_PI / 3;  ///< Of the hemisphere of radius 1.

/// Water with g = 1.
PeriodicSquare square_of(int cells, double depth = HUGE_VAL, double cell = 0.5) {
  return {.cells = cells, .cell = cell, .deepest = 1, .layers = 5, .gravity = 1, .depth = depth};
}

/// Cells of half a radius, and a tenth of the shortest wave at most.
PeriodicSquare square_for(double kR) { return square_of(128, HUGE_VAL, kR < 2 ? 0.5 : 0.3); }

Sea sea_of(double depth = HUGE_VAL) {
  Sea sea;
  sea.gravity = 1;
  sea.depth = depth;
  return sea;
}

TEST(HullSources, OfAHemisphereHaveItsAddedMass) {
  const HullSources hull = make_hull_sources(make_icosphere(1, 4), {}, square_of(128));
  // Waves shorter than two cells find no zero potential: surge is 0.2732 without them.
  EXPECT_NEAR(hull.added_mass(2, 2) / kVolume, 0.5, tolerance(0.01));
  EXPECT_NEAR(hull.added_mass(0, 0) / kVolume, 0.288, tolerance(0.005));
  EXPECT_NEAR(hull.added_mass(1, 1), hull.added_mass(0, 0), tolerance(0.01));
}

/// Green's identity: the load by one motion's waves on another one is symmetric.
TEST(HullSources, HaveASymmetricSpringThatTakesEnergy) {
  for (const TriMesh& mesh : {make_icosphere(1, 3), make_box({4, 2, 1.6}, 3)}) {
    const HullSources hull = make_hull_sources(mesh, {}, square_of(128));
    const Matrix6d spring = hull.reply * hull.motions;
    const double scale = spring.cwiseAbs().maxCoeff();
    EXPECT_LT((spring - spring.transpose()).cwiseAbs().maxCoeff(), tolerance(0.05) * scale);
    EXPECT_LT((spring - hull.spring).cwiseAbs().maxCoeff(), tolerance(0.05) * scale);
  }
}

/// The square on which the sources' answers are found does not matter.
TEST(HullSources, DoNotDependOnTheSizeOfTheSquare) {
  const TriMesh mesh = make_icosphere(1, 3);
  const HullSources small = make_hull_sources(mesh, {}, square_of(64), 120);
  const HullSources large = make_hull_sources(mesh, {}, square_of(512), 120);
  EXPECT_LT((small.added_mass - large.added_mass).cwiseAbs().maxCoeff(),
            tolerance(1e-9) * large.added_mass(2, 2));
  // The mean height of the water does not change on a square: the volume of a heave of 1 is spread
  // over its area, and its load is by that over the waterplane and the flow that it makes.
  const auto spread = [](double side) { return M_PI * M_PI / (side * side); };
  EXPECT_NEAR(large.spring(2, 2) - small.spring(2, 2), spread(32) - spread(256),
              tolerance(0.5) * spread(32));
}

/// A sphere of radius 1 half under water: A and B/ω over the displaced mass; WAMIT's numbers, as in
/// radiation_solve_test.cpp.
struct SphereRow {
  double kR;
  double heave[3], surge[3];
};
constexpr SphereRow kSphere[] = {
    {0.3, {0.7157, 0.3248, 0.6786}, {0.5847, 0.0258, 0.2687}},
    {1.0, {0.4284, 0.2484, 0.3247}, {0.5739, 0.3532, 0.5476}},
    {2.0, {0.3884, 0.1032, 0.1480}, {0.2498, 0.3422, 0.3812}},
};

TEST(HullSources, OfAHemisphereRadiateAsTheTableHasIt) {
  const Sea sea = sea_of();
  for (const SphereRow& row : kSphere) {
    const PeriodicSquare square = square_for(row.kR);
    const support::FloatingHull hull =
        support::floating_hull(make_icosphere(1, 4), {}, square, sea);
    for (const Eigen::Index mode : {2, 0}) {
      SimulatedWater water(sea, {hull.in_water()}, square, square.side() / 3);
      const double omega = std::sqrt(row.kR), part = row.kR < 2 ? 0.02 : 0.03;
      const auto load = support::forced_loads(water, {&hull}, {BodyState()}, 0, mode, omega, 60, 5);
      const auto found = support::coefficients_of(load[0][mode], omega);
      const double* wanted = mode == 2 ? row.heave : row.surge;
      const double size = std::hypot(wanted[0], wanted[1]);
      EXPECT_NEAR((found.added_mass + hull.sources->added_mass(mode, mode)) / kVolume, wanted[0],
                  tolerance(part) * size)
          << row.kR << ' ' << mode;
      EXPECT_NEAR(found.damping_over_omega / kVolume, wanted[1], tolerance(part) * size)
          << row.kR << ' ' << mode;
    }
  }
}

/// The far field follows from the damping: the same rings that simulated_water_test.cpp has for
/// sources of V·n, which are 1.19 to 1.40 times as high.
TEST(HullSources, OfAHeavingHemisphereMakeTheTrueRings) {
  struct Row {
    double k, cell, ring;  ///< Amplitude √(r/R) over that of the heave.
    int periods;           ///< Until the rings are there.
  };
  const Sea sea = sea_of();
  for (const Row& row : {Row{0.3, 0.5, 0.1396, 6}, {0.5, 0.5, 0.2376, 8}, {1, 0.3, 0.4069, 12}}) {
    const PeriodicSquare square = square_of(256, HUGE_VAL, row.cell);
    const support::FloatingHull hull =
        support::floating_hull(make_icosphere(1, 4), {}, square, sea);
    SimulatedWater water(sea, {hull.in_water()}, square);
    const double omega = std::sqrt(row.k), r = 16;
    support::forced_loads(water, {&hull}, {BodyState()}, 0, 2, omega, 40, row.periods);
    const double time = row.periods * 2 * M_PI / omega;
    const auto now = water.patch(time), later = water.patch(time + M_PI / 2 / omega);
    double amplitude = 0;
    for (int i = 0; i < 32; ++i) {
      const double x = r * std::cos(i * M_PI / 16), y = r * std::sin(i * M_PI / 16);
      amplitude += std::hypot(now->at(x, y), later->at(x, y)) / 32;
    }
    EXPECT_NEAR(amplitude * std::sqrt(r), row.ring, tolerance(0.03) * row.ring) << row.k;
  }
}

TEST(HullSources, OfAHeldHemisphereScatterAsTheTableHasIt) {
  for (const SphereRow& row : kSphere) {
    Sea sea = sea_of();
    const PeriodicSquare square = square_for(row.kR);
    const double omega = std::sqrt(row.kR), part = row.kR < 2 ? 0.02 : 0.03;
    sea.surface = WaveSurface{{{.amplitude = 1, .kx = row.kR, .omega = omega}}};
    const support::FloatingHull hull =
        support::floating_hull(make_icosphere(1, 4), {}, square, sea);
    SimulatedWater water(sea, {hull.in_water()}, square, square.side() / 3);
    const Vector6cd later =
        support::forced_loads(water, {&hull}, {BodyState()}, -1, 0, omega, 60, 5)[0];
    const DiffractionLoad at_once(hull.floating->data());
    const Loads6cd pressure = froude_krylov(hull.mesh, {}, {.gravity = 1}, {omega}, {0})[0];
    // The elevation over H is cos(−ωt): the amplitudes of e^{−iωt} are the conjugates.
    const Vector6cd X = pressure.col(0) + at_once.coefficients(omega, 0) + later.conjugate();
    EXPECT_NEAR(std::abs(X[2]) / M_PI, row.heave[2], tolerance(part) * row.heave[2]) << row.kR;
    EXPECT_NEAR(std::abs(X[0]) / M_PI, row.surge[2], tolerance(part) * row.surge[2]) << row.kR;
  }
}

/// A barge of 10 x 4 m and a draught of 1 m, whose waterplane sloshes at its shorter waves.
TEST(HullSources, OfABargeRadiateAsTheSolution) {
  const double gravity = 9.80665, cell = 0.55;
  const TriMesh mesh = make_box({10, 4, 2.4}, 2);
  const MeanPose pose{.height = 0.2};
  const PeriodicSquare square{
      .cells = 128, .cell = cell, .deepest = 1, .layers = 5, .gravity = gravity};
  Sea sea;
  const support::FloatingHull hull = support::floating_hull(mesh, pose, square, sea);
  for (const double k : {0.3, 1.0}) {
    const double omega = std::sqrt(gravity * k);
    const RadiationData wanted =
        solve_radiation(mesh, pose, {.gravity = gravity},
                        {.frequencies = {omega}, .headings = 36, .patches = 250})
            .data;
    for (const Eigen::Index mode : {0, 2, 4}) {
      SimulatedWater water(sea, {hull.in_water()}, square, 21);
      std::vector<BodyState> states(1);
      states[0].position.z() = 0.2;
      const auto load = support::forced_loads(water, {&hull}, states, 0, mode, omega, 30, 6);
      const auto found = support::coefficients_of(load[0][mode], omega);
      const double A = wanted.added_mass[0](mode, mode), B = wanted.damping[0](mode, mode) / omega;
      constexpr double part = 0.03;
      EXPECT_NEAR(found.added_mass + hull.sources->added_mass(mode, mode), A,
                  tolerance(part) * (A + B))
          << k << ' ' << mode;
      EXPECT_NEAR(found.damping_over_omega, B, tolerance(part) * (A + B)) << k << ' ' << mode;
    }
  }
}

/// In shallow water the method of radiation_solve.h is another one.
TEST(HullSources, InShallowWaterAgreeWithTheSolution) {
  const double depth = 2, k = 0.5, omega = std::sqrt(k * std::tanh(k * depth));
  const TriMesh mesh = make_icosphere(1, 4);
  const RadiationData wanted =
      solve_radiation(mesh, {}, {.gravity = 1, .depth = depth},
                      {.frequencies = {omega}, .headings = 8, .patches = 150})
          .data;
  const Sea sea = sea_of(depth);
  const PeriodicSquare square = square_of(128, depth);
  const support::FloatingHull hull = support::floating_hull(mesh, {}, square, sea);
  for (const Eigen::Index mode : {Eigen::Index{2}, Eigen::Index{0}}) {
    SimulatedWater water(sea, {hull.in_water()}, square, 128 * 0.5 / 3);
    const auto load = support::forced_loads(water, {&hull}, {BodyState()}, 0, mode, omega, 60, 6);
    const auto found = support::coefficients_of(load[0][mode], omega);
    const double A = wanted.added_mass[0](mode, mode), B = wanted.damping[0](mode, mode) / omega;
    EXPECT_NEAR(found.added_mass + hull.sources->added_mass(mode, mode), A, tolerance(0.03) * A)
        << mode;
    EXPECT_NEAR(found.damping_over_omega, B, tolerance(0.03) * std::max(A, B)) << mode;
  }
}

/// Two hemispheres, their centres three radii apart, by another program: A and B in heave and surge
/// of a hull by its own motion and by the other one's, and in surge by heave.
TEST(HullSources, OfTwoHemispheresActOnEachOther) {
  struct Row {
    double kR;
    double heave[4], surge[4], surge_by_heave[4];
  };
  constexpr Row kRows[] = {{0.3,
                            {1.576, 0.374, 0.156, 0.290},
                            {1.240, 0.023, -0.165, 0.018},
                            {0.018, -0.013, 0.287, 0.047}},
                           {0.6,
                            {1.172, 0.612, -0.120, 0.301},
                            {1.480, 0.202, -0.419, -0.022},
                            {0.099, 0.025, 0.262, 0.260}},
                           {1.0,
                            {0.816, 0.556, -0.232, 0.139},
                            {1.228, 1.014, -0.217, -0.739},
                            {-0.093, 0.131, -0.169, 0.431}}};
  const Sea sea = sea_of();
  const support::FloatingHull hull =
      support::floating_hull(make_icosphere(1, 4), {}, square_of(128), sea);
  std::vector<BodyState> states(2);
  states[1].position.x() = 3;
  for (const Row& row : kRows) {
    const double omega = std::sqrt(row.kR);
    double largest = 0;
    for (const double* four : {row.heave, row.surge})
      for (int i = 0; i < 4; ++i) largest = std::max(largest, std::abs(four[i]));
    const auto check = [&](std::complex<double> load, double constant, const double* wanted,
                           const char* what) {
      const auto found = support::coefficients_of(load, omega);
      EXPECT_NEAR(found.added_mass + constant, wanted[0], tolerance(0.03) * largest)
          << what << row.kR;
      EXPECT_NEAR(found.damping_over_omega * omega, wanted[1], tolerance(0.03) * largest)
          << what << row.kR;
    };
    const auto run = [&](Eigen::Index mode) {
      SimulatedWater water(sea, {hull.in_water(), hull.in_water()}, square_of(128), 128 * 0.5 / 3);
      return support::forced_loads(water, {&hull, &hull}, states, 1, mode, omega, 60, 5);
    };
    const Matrix6d& A = hull.sources->added_mass;
    const auto heave = run(2), surge = run(0);
    check(heave[1][2], A(2, 2), row.heave, "heave, own ");
    check(heave[0][2], 0, row.heave + 2, "heave, other ");
    check(surge[1][0], A(0, 0), row.surge, "surge, own ");
    check(surge[0][0], 0, row.surge + 2, "surge, other ");
    check(heave[1][0], 0, row.surge_by_heave, "surge by own heave ");
    check(-heave[0][0], 0, row.surge_by_heave + 2, "surge by the other's heave ");
  }
}

TEST(HullSources, AreNoneOfADryBody) {
  EXPECT_THROW(make_hull_sources(make_icosphere(1, 2), {.height = 2}, square_of(64)),
               std::invalid_argument);
  EXPECT_THROW(make_hull_sources(make_icosphere(1, 2), {}, square_of(64, 0.9)),
               std::invalid_argument);
}

}  // namespace
}  // namespace hydro

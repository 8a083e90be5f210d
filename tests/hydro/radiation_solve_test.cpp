#include "hydro/radiation/radiation_solve.h"

#include <gtest/gtest.h>
#include <math.h>  // j0 to y1, which <cmath> need not have

#include <cmath>
#include <numbers>

#include "hydro/mesh/primitives.h"

/// Radiation and diffraction by boundary elements, against tables and an independent solution.

namespace {

using Eigen::Vector3d;
using hydro::Matrix6d;
using hydro::MeanPose;
using hydro::RadiationData;
using hydro::RadiationSolution;
using hydro::TriMesh;
using hydro::Vector6cd;
using std::numbers::pi;

constexpr double kGravity = 9.80665;

std::vector<double> frequencies(const std::vector<double>& wave_numbers) {
  std::vector<double> omega;
  for (const double k : wave_numbers) omega.push_back(std::sqrt(kGravity * k));
  return omega;
}

RadiationSolution solved(const TriMesh& mesh, const MeanPose& pose,
                         const std::vector<double>& wave_numbers, int patches, int headings = 24) {
  return hydro::solve_radiation(
      mesh, pose, {.gravity = kGravity},
      {.frequencies = frequencies(wave_numbers), .headings = headings, .patches = patches});
}

Vector6cd excitation(const RadiationData& data, std::size_t frequency, Eigen::Index heading) {
  return data.froude_krylov[frequency].col(heading) + data.diffraction[frequency].col(heading);
}

/// A sphere of radius 1 half under water: A and B/ω over the displaced mass, |X| over ρ g π R².
struct SphereRow {
  double kR;
  double heave[3], surge[3];
};

/// WAMIT's numbers for the sphere, and its limits.
constexpr SphereRow kSphere[] = {
    {0.1, {0.8624, 0.1813, 0.8779}, {0.5223, 0.0011, 0.0964}},
    {0.3, {0.7157, 0.3248, 0.6786}, {0.5847, 0.0258, 0.2687}},
    {0.5, {0.5862, 0.3388, 0.5366}, {0.6436, 0.0988, 0.4090}},
    {1.0, {0.4284, 0.2484, 0.3247}, {0.5739, 0.3532, 0.5476}},
    {2.0, {0.3884, 0.1032, 0.1480}, {0.2498, 0.3422, 0.3812}},
    {4.0, {0.4321, 0.0220, 0.0483}, {0.1624, 0.1511, 0.1791}},
};

TEST(RadiationSolve, OfAFloatingSphereIsThatOfTheTable) {
  const TriMesh mesh = hydro::make_icosphere(1, 4);
  std::vector<double> wave_numbers;
  for (const SphereRow& row : kSphere) wave_numbers.push_back(row.kR);
  const RadiationData data = solved(mesh, {}, wave_numbers, 250).data;
  // The table has four digits, and the polyhedron 0.2 % less volume than the sphere.
  for (std::size_t f = 0; f < data.frequencies.size(); ++f)
    for (const bool heave : {true, false}) {
      const Eigen::Index m = heave ? 2 : 0;
      const double* row = heave ? kSphere[f].heave : kSphere[f].surge;
      // Waves as long as a quarter of the circumference are three patches long.
      const double off = kSphere[f].kR < 4 ? 0.005 : 0.01;
      const double scale = std::max(row[1], 0.05);
      EXPECT_NEAR(data.added_mass[f](m, m) / data.volume, row[0], off * row[0]) << f << m;
      EXPECT_NEAR(data.damping[f](m, m) / data.volume / data.frequencies[f], row[1], 0.01 * scale)
          << f << m;
      EXPECT_NEAR(std::abs(excitation(data, f, 0)[m]) / (kGravity * pi), row[2], off * row[2])
          << f << m;
    }
  EXPECT_NEAR(data.infinite_added_mass(2, 2) / data.volume, 0.5, 2e-3);
  EXPECT_NEAR(data.infinite_added_mass(0, 0) / data.volume, 0.2732, 1e-3);
}

TEST(RadiationSolve, KnowsNoSloshingInsideTheHull) {
  // At kR = 2.56 heave and at 4 surge would be off by a seventh.
  const RadiationData data = solved(hydro::make_icosphere(1, 3), {}, {2.5, 2.56, 2.62}, 120).data;
  for (std::size_t f = 0; f < 3; ++f)
    EXPECT_NEAR(data.added_mass[f](2, 2) / data.volume, 0.4002, 0.006) << f;
}

TEST(RadiationSolve, ItsDampingIsThatOfTheWavesFarAway) {
  const double mismatch = solved(hydro::make_icosphere(1, 3), {}, {0.3, 1.0, 2.0}, 120).mismatch;
  EXPECT_LT(mismatch, 0.01);
}

/// A barge of 10 × 4 × 2.4 m with a draught of 1 m, its centre of mass 0.2 m above the water.
/// Numbers of tools/validation/potential_flow.py, barge(10, 4, 1, (20, 12, 9)), for ρ = 1.
struct BargeRow {
  double k;
  double added[4], damping[4];  ///< Surge, heave, pitch, surge with pitch.
  std::complex<double> excitation[3];
};
const BargeRow kBarge[] = {
    {0.3,
     {9.2232, 60.844, 401.92, 12.926},
     {6.8288, 55.286, 143.25, 31.074},
     {{-9.9705, -59.840}, {96.201, -66.808}, {-45.989, -313.98}}},
    {1.0,
     {2.5694, 55.631, 330.02, -3.2520},
     {22.049, 13.709, 59.176, 16.095},
     {{19.075, 43.858}, {0.1572, 18.738}, {9.2666, 33.842}}},
};

TEST(RadiationSolve, OfABargeHasItsCouplings) {
  const TriMesh mesh = hydro::make_box({10, 4, 2.4}, 2);
  const RadiationData data = solved(mesh, {.height = 0.2}, {kBarge[0].k, kBarge[1].k}, 250).data;
  EXPECT_NEAR(data.volume, 40, 1e-12);
  // In waves as long as two thirds of the barge patches of 0.5 m are coarse.
  const double tolerance[] = {0.01, 0.06};
  constexpr Eigen::Index at[4][2] = {{0, 0}, {2, 2}, {4, 4}, {0, 4}};
  for (std::size_t f = 0; f < 2; ++f) {
    for (std::size_t e = 0; e < 4; ++e) {
      const auto [i, j] = at[e];
      const auto near = [&](const Matrix6d& matrix, const double* wanted) {
        const double scale = i == j ? wanted[e] : std::sqrt(wanted[0] * wanted[2]);
        EXPECT_NEAR(matrix(i, j), wanted[e], tolerance[f] * scale) << f << e;
      };
      near(data.added_mass[f], kBarge[f].added);
      near(data.damping[f], kBarge[f].damping);
    }
    for (std::size_t m = 0; m < 3; ++m) {
      const std::complex<double> wanted = kBarge[f].excitation[m];
      const std::complex<double> found = excitation(data, f, 0)[2 * static_cast<Eigen::Index>(m)];
      EXPECT_LT(std::abs(found - wanted), tolerance[f] * std::abs(wanted)) << f << m;
    }
  }
}

TEST(RadiationSolve, OfACylinderThatStandsOnTheBottomHasTheLoadOfWavesInClosedForm) {
  // MacCamy and Fuchs (1954). Two gaps below, of which the load is a linear function, are
  // extrapolated to none. A prism of 32 sides has the section of the cylinder.
  const double draught = 2, gaps[] = {0.05, 0.02};
  const double radius = std::sqrt(pi / (16 * std::sin(pi / 16)));
  const TriMesh mesh = hydro::make_cylinder(radius, 3, 32, 6);
  const std::vector<double> wave_numbers = {0.5, 1.0, 2.0};
  std::vector<std::vector<double>> loads;  // over that of the closed form
  for (const double gap : gaps) {
    const double depth = draught + gap;
    std::vector<double> omega, ratios;
    for (const double k : wave_numbers)
      omega.push_back(std::sqrt(kGravity * k * std::tanh(k * depth)));
    const RadiationSolution solution = hydro::solve_radiation(
        mesh, {.height = 1.5 - draught}, {.gravity = kGravity, .depth = depth},
        {.frequencies = omega, .headings = 8, .patches = 200});
    EXPECT_LT(solution.mismatch, 0.015) << gap;
    for (std::size_t f = 0; f < omega.size(); ++f) {
      const double k = wave_numbers[f];
      const double j = ::j0(k) - ::j1(k) / k, y = ::y0(k) - ::y1(k) / k;  // slopes of J₁ and Y₁
      const double wanted = 4 * kGravity / (k * k) * std::tanh(k * depth) / std::hypot(j, y);
      ratios.push_back(std::abs(excitation(solution.data, f, 0)[0]) / wanted);
    }
    loads.push_back(ratios);
  }
  for (std::size_t f = 0; f < wave_numbers.size(); ++f) {
    const double ratio = loads[1][f] + (loads[1][f] - loads[0][f]) * gaps[1] / (gaps[0] - gaps[1]);
    EXPECT_NEAR(ratio, 1, 0.005) << wave_numbers[f];
  }
}

TEST(RadiationSolve, OfAFloatingSphereInShallowWaterIsThatOfAnotherMethod) {
  // tools/validation/potential_flow.py, of constant panels and another integral for the depth, of
  // 12 by 12 and 16 by 16 panels a quarter, extrapolated to small panels. R = 1 m, h = 1.5 m.
  struct Row {
    double k, surge, heave, heave_damping, surge_load, heave_load;
  };
  constexpr Row kRows[] = {{0.2, 1.2455, 2.3521, 1.1348, 6.3544, 28.5834},
                           {0.5, 1.3567, 1.4292, 2.0538, 14.1824, 22.0146}};
  const double depth = 1.5;
  std::vector<double> omega;
  for (const Row& row : kRows)
    omega.push_back(std::sqrt(kGravity * row.k * std::tanh(row.k * depth)));
  const RadiationSolution solution =
      hydro::solve_radiation(hydro::make_icosphere(1, 4), {}, {.gravity = kGravity, .depth = depth},
                             {.frequencies = omega, .headings = 8});
  EXPECT_LT(solution.mismatch, 0.003);
  for (std::size_t f = 0; f < omega.size(); ++f) {
    const Row& row = kRows[f];
    const Matrix6d &A = solution.data.added_mass[f], &B = solution.data.damping[f];
    EXPECT_NEAR(A(0, 0), row.surge, 0.005 * row.surge) << row.k;
    EXPECT_NEAR(A(2, 2), row.heave, 0.005 * row.heave) << row.k;
    EXPECT_NEAR(B(2, 2), row.heave_damping, 0.005 * row.heave_damping) << row.k;
    const hydro::Vector6cd X = excitation(solution.data, f, 0);
    EXPECT_NEAR(std::abs(X[0]), row.surge_load, 0.005 * row.surge_load) << row.k;
    EXPECT_NEAR(std::abs(X[2]), row.heave_load, 0.005 * row.heave_load) << row.k;
  }
}

// The waves from both ends of a slender hull interfere, in short ones over a few degrees: with 36
// headings the damping of these hulls differed by 18 and 89 % from that by the pressure.
TEST(RadiationSolve, OfASlenderHullAgreesWithItsWavesFarAway) {
  for (const double length : {7.0, 30.0}) {
    const TriMesh hull = hydro::make_box({length, 1, 1}, 4);
    const RadiationSolution solution = hydro::solve_radiation(hull, {}, {});
    EXPECT_LT(solution.mismatch, 0.1) << length;
    EXPECT_GE(static_cast<double>(solution.data.headings.size()),
              std::pow(solution.data.frequencies.back(), 2) / kGravity * length);
  }
}

TEST(RadiationSolve, TurnsWithTheBody) {
  // A body whose mesh is turned by 30° has the loads of waves that come from 30° less.
  const TriMesh mesh = hydro::make_box({3, 1, 1}, 2);
  TriMesh turned = mesh;
  const Eigen::Matrix3d R = Eigen::AngleAxisd(pi / 6, Vector3d::UnitZ()).toRotationMatrix();
  turned.vertices = R * mesh.vertices;
  const int patches = 100;
  const RadiationData a = solved(mesh, {.height = 0.1}, {1.0}, patches, 12).data;
  const RadiationData b = solved(turned, {.height = 0.1}, {1.0}, patches, 12).data;
  Matrix6d six = Matrix6d::Zero();
  six.topLeftCorner<3, 3>() = six.bottomRightCorner<3, 3>() = R;
  const Matrix6d wanted = six * a.added_mass[0] * six.transpose();
  // Patches of the turned mesh are others.
  EXPECT_LT((b.added_mass[0] - wanted).norm(), 0.05 * wanted.norm());
  for (Eigen::Index h = 0; h < 12; ++h) {
    const Vector6cd load = six.cast<std::complex<double>>() * excitation(a, 0, (h + 11) % 12);
    EXPECT_LT((excitation(b, 0, h) - load).norm(), 0.05 * load.norm()) << h;
  }
}

TEST(RadiationSolve, TakesTheMeanPose) {
  // The sphere is the same in every attitude.
  const MeanPose tilted{.orientation = Eigen::Quaterniond(0.8, 0.2, -0.3, 0.1).normalized()};
  const TriMesh mesh = hydro::make_icosphere(1, 3);
  const RadiationData data = solved(mesh, tilted, {0.5}, 120).data;
  EXPECT_NEAR(data.added_mass[0](2, 2) / data.volume, 0.5862, 0.006);
  EXPECT_TRUE(data.pose == tilted);
}

}  // namespace

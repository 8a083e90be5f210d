#include "hydro/resistance/thin_ship.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hydro/mesh/primitives.h"
#include "hydro/resistance/resistance.h"
#include "tests/support/ship_hulls.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::ThinShip;
using hydro::TriMesh;
using support::tolerance;

constexpr double kGravityOnEarth = 9.80665;
constexpr double kHullLength = 10, kHullBeam = 1, kHullDraught = 0.625;

TriMesh wigley(int divisions = 32) {
  return support::make_wigley(kHullLength, kHullBeam, kHullDraught, 0.4, divisions);
}

TriMesh turned(const TriMesh& mesh, double heading, const Vector3d& offset = Vector3d::Zero()) {
  Eigen::Isometry3d turn(Eigen::AngleAxisd(heading, Vector3d::UnitZ()));
  turn.pretranslate(offset);
  return hydro::transformed(mesh, turn);
}

/// Both meshes, side by side.
TriMesh together(const TriMesh& a, const TriMesh& b) {
  TriMesh both;
  both.vertices.resize(3, a.vertex_count() + b.vertex_count());
  both.vertices << a.vertices, b.vertices;
  both.faces.resize(3, a.face_count() + b.face_count());
  both.faces << a.faces, b.faces.array() + static_cast<int>(a.vertex_count());
  return both;
}

/// The mesh with each face split into four.
TriMesh split(const TriMesh& mesh) {
  std::vector<Vector3d> vertices(mesh.vertices.colwise().begin(), mesh.vertices.colwise().end());
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] =
        middles.emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
    if (is_new) vertices.push_back((mesh.vertices.col(a) + mesh.vertices.col(b)) / 2);
    return place->second;
  };
  TriMesh fine;
  fine.faces.resize(3, 4 * mesh.face_count());
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    const int a = mesh.faces(0, f), b = mesh.faces(1, f), c = mesh.faces(2, f);
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.faces.middleCols(4 * f, 4) << a, ab, ca, ab,  //
        ab, b, bc, bc,                                 //
        ca, bc, c, ca;
  }
  fine.vertices.resize(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    fine.vertices.col(static_cast<Eigen::Index>(i)) = vertices[i];
  return fine;
}

double resistance(const TriMesh& mesh, double speed, const hydro::MeanPose& pose = {}) {
  return ThinShip(mesh, pose).resistance(speed, kGravityOnEarth);
}

double speed_at(double froude, double length = kHullLength) {
  return froude * std::sqrt(kGravityOnEarth * length);
}

/// R/ρ of Wigley's hull from its lines: f_x = −(2B/L) ξ (1 − ζ²) makes both integrals of I + iJ
/// closed forms, and Simpson's rule over u the third. @param apart   Distance of two hulls; 0: one.
double from_lines(double speed, double apart = 0) {
  const double k = kGravityOnEarth / (speed * speed), a = kHullLength / 2;
  const auto integrand = [&](double u) {
    const double lambda = std::cosh(u), p = k * lambda, q = k * lambda * lambda;
    const double along = 2 / a * (std::sin(p * a) / (p * p) - a * std::cos(p * a) / p);
    const double t = q * kHullDraught, decay = std::exp(-t);
    // ∫ (1 − ζ²) e^{qz} dz
    const double deep = kHullDraught * (1 / t - (2 - (2 + 2 * t) * decay) / (t * t * t));
    const double J = 2 * kHullBeam / kHullLength * along * deep * lambda;
    const double beside = 2 * std::cos(k * lambda * std::sinh(u) * apart / 2);
    return J * J * (apart > 0 ? beside * beside : 1);
  };
  const int n = 40000;
  const double h = 5.0 / n;
  double sum = 0;
  for (int i = 0; i <= n; ++i) sum += integrand(i * h) * (i == 0 || i == n ? 1 : 2 + 2 * (i % 2));
  return 4 * kGravityOnEarth * k / M_PI * sum * h / 3;
}

// Wigley's hull 10:1:0.625 has a wetted surface of 0.1481 L².
TEST(ThinShip, GivesMichellsResistanceOfWigleysHull) {
  const ThinShip ship(wigley(), {});
  EXPECT_NEAR(ship.length(), kHullLength, tolerance(1e-12));
  for (const auto& [froude, coefficient] :
       {std::pair{0.20, 0.888}, {0.25, 1.064}, {0.30, 2.142}, {0.40, 2.734}, {0.50, 4.517}}) {
    const double speed = speed_at(froude);
    const double unit = speed * speed / 2 * 0.1481 * kHullLength * kHullLength / 1000;
    EXPECT_NEAR(from_lines(speed) / unit, coefficient, tolerance(0.01) * coefficient) << froude;
    EXPECT_NEAR(ship.resistance(speed, kGravityOnEarth) / unit, coefficient,
                tolerance(0.02) * coefficient)
        << froude;
  }
}

// The facets' own error falls as the square of their size.
TEST(ThinShip, ConvergesToTheIntegralOverTheLines) {
  for (const double froude : {0.22, 0.35, 0.8}) {
    const double exact = from_lines(speed_at(froude));
    const double coarse = resistance(wigley(16), speed_at(froude)) / exact - 1;
    const double fine = resistance(wigley(32), speed_at(froude)) / exact - 1;
    EXPECT_LT(std::abs(fine), tolerance(0.02)) << froude;
    EXPECT_NEAR(fine / coarse, 0.25, tolerance(0.08)) << froude;
  }
}

TEST(ThinShip, IsTheSameForFacesThatAreSplit) {
  const TriMesh mesh = wigley(8);
  for (const double froude : {0.15, 0.3, 1.0}) {
    const double whole = resistance(mesh, speed_at(froude));
    EXPECT_NEAR(resistance(split(mesh), speed_at(froude)), whole, tolerance(1e-7) * whole);
  }
}

/// A hull that is fuller forward and has a rake.
TriMesh uneven() {
  TriMesh mesh = wigley(16);
  for (Eigen::Index i = 0; i < mesh.vertex_count(); ++i) {
    const double x = mesh.vertices(0, i), z = mesh.vertices(2, i);
    mesh.vertices(1, i) *= 1 + 0.06 * x;
    mesh.vertices(0, i) += 0.5 * z;
  }
  return mesh;
}

TEST(ThinShip, IsTheSameAheadAsAsternAndOnAnyHeading) {
  const TriMesh mesh = uneven();
  const double ahead = resistance(mesh, 3);
  EXPECT_GT(std::abs(ahead - resistance(wigley(16), 3)), 0.01 * ahead);
  EXPECT_NEAR(resistance(turned(mesh, M_PI), 3), ahead, tolerance(1e-9) * ahead);
  EXPECT_NEAR(resistance(turned(mesh, 1.1, {3, -7, 0}), 3), ahead, tolerance(1e-9) * ahead);
}

TEST(ThinShip, TakesTheHullInItsPose) {
  const hydro::MeanPose pose{
      .orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.02, Vector3d::UnitY())), .height = 0.2};
  Eigen::Isometry3d turn(pose.orientation);
  turn.pretranslate(Vector3d(0, 0, pose.height));
  const double in_pose = resistance(uneven(), 3, pose);
  EXPECT_NEAR(in_pose, resistance(hydro::transformed(uneven(), turn), 3),
              tolerance(1e-9) * in_pose);
  EXPECT_LT(in_pose, 0.7 * resistance(uneven(), 3));
}

TEST(ThinShip, FollowsFroudesLaw) {
  const double small = resistance(uneven(), 3);
  const double large = resistance(hydro::scaled(uneven(), 4), 6);
  EXPECT_NEAR(large, 64 * small, tolerance(1e-9) * large);
}

TEST(ThinShip, LetsHullsBesideEachOtherInterfere) {
  const TriMesh one = wigley();
  const auto pair = [&](double apart) {
    return together(turned(one, 0, {0, apart / 2, 0}), turned(one, 0, {0, -apart / 2, 0}));
  };
  for (const double froude : {0.25, 0.4})
    for (const double apart : {2.0, 4.0}) {
      const double exact = from_lines(speed_at(froude), apart);
      EXPECT_NEAR(resistance(pair(apart), speed_at(froude)), exact, tolerance(0.015) * exact)
          << froude << ", " << apart;
    }
  const ThinShip ship(pair(4), {});
  ASSERT_EQ(ship.parts().size(), 2u);
  EXPECT_NEAR(std::abs(ship.parts()[0].y), 2, tolerance(1e-9));
  EXPECT_NEAR(ship.parts()[0].beam, kHullBeam, tolerance(1e-12));
  // Hulls in one place are one of twice the breadth.
  const double once = resistance(one, 4);
  EXPECT_NEAR(resistance(together(one, one), 4), 4 * once, tolerance(1e-9) * once);
}

// The same integral over the lines, 320 × 40 sources and 160 × 20 points on a side, is 0.01644 L³
// Fn² per waterplane.
TEST(ThinShip, DrawsAHullDownAsTheFlowOfLowSpeedDoes) {
  const double waterplane = 2.0 / 3 * kHullLength * kHullBeam;
  for (const int divisions : {24, 48}) {
    const ThinShip::Suction suction = ThinShip(wigley(divisions), {}).suction();
    EXPECT_NEAR(suction.area / waterplane, 0.01644, tolerance(8e-4)) << divisions;
    EXPECT_LT(suction.centre.norm(), tolerance(1e-9));
  }
  const ThinShip::Suction even = ThinShip(uneven(), {}).suction();
  const ThinShip::Suction turned_about = ThinShip(turned(uneven(), 2, {1, 3, 0}), {}).suction();
  EXPECT_NEAR(turned_about.area, even.area, tolerance(1e-9));
  const Eigen::Vector2d centre = Eigen::Rotation2Dd(2) * even.centre + Eigen::Vector2d(1, 3);
  EXPECT_LT((turned_about.centre - centre).norm(), tolerance(1e-6));
  EXPECT_GT(even.centre.x(), 0.02);
}

TEST(ThinShip, KnowsWhereTheTheoryDoesNotHold) {
  EXPECT_EQ(ThinShip(wigley(), {}).bluntness(), 0);
  EXPECT_EQ(ThinShip(hydro::make_box({10, 1, 1}), {}).bluntness(), 1);
  const auto fault = [](const TriMesh& mesh, double height) -> std::string {
    try {
      ThinShip(mesh, {.height = height});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(fault(wigley(), 0), "none");
  EXPECT_EQ(fault(wigley(), 1), "nothing of it is in the water");
  EXPECT_EQ(fault(hydro::make_box({3.9, 1, 1}), 0),
            "a part of it in the water is 3.9 m long and 1 m wide, and thin-ship theory asks for a "
            "length of 4 widths");
  EXPECT_EQ(fault(hydro::make_box({4.1, 1, 1}), 0), "none");
}

TEST(ThinShip, HasATableThatFollowsHumpsAndHollows) {
  const ThinShip ship(wigley(12), {});
  const hydro::WaveResistance table = hydro::wave_resistance(ship, kGravityOnEarth);
  ASSERT_EQ(table.speeds.size(), table.forces.size());
  EXPECT_NEAR(table.speeds.front(), speed_at(0.1), tolerance(1e-9));
  EXPECT_NEAR(table.speeds.back(), speed_at(1), tolerance(1e-9));
  const hydro::ResistanceCurve curve(table.speeds, table.forces);
  for (double froude = 0.2; froude < 1; froude += 0.0137) {
    const double exact = ship.resistance(speed_at(froude), kGravityOnEarth);
    EXPECT_NEAR(curve.at(speed_at(froude)), exact, tolerance(0.01) * exact) << froude;
  }
}

}  // namespace

#include "hydro/statics/equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "hydro/loads/loads.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using hydro::Flotation;
using hydro::Stability;
using hydro::TriMesh;

constexpr double kDegree = std::numbers::pi / 180;

/// Height of the centre of mass above the centre of buoyancy: potential energy over weight [m].
double energy(const Flotation& f) { return -f.hydrostatics.centre_of_buoyancy.z(); }

/// A lumpy body of some relative density, about its centre of mass, which is off its centroid.
struct Body {
  TriMesh mesh_B;
  double volume;  ///< Of water that weighs as much [m^3].
};
Body random_body(support::Random& random) {
  const TriMesh mesh = support::random_star(random);
  const hydro::SolidProperties solid = hydro::solid_properties(mesh);
  return {hydro::translated(mesh, -solid.centroid + random.vector(0.2)),
          random.uniform(0.05, 0.95) * solid.volume};
}

/// Water's load plus weight, for a density and a gravity of 1.
hydro::Wrench net_load(const TriMesh& mesh_B, double volume, const Quaterniond& orientation,
                       double height) {
  hydro::Wrench net = hydro::compute_loads(hydro::make_hull(mesh_B),
                                           {.position = {0, 0, height}, .orientation = orientation},
                                           {.density = 1, .gravity = 1}, 0, {})
                          .buoyancy;
  net.force.z() -= volume;
  return net;
}

TEST(Equilibrium, LeavesNoForceAndNoMomentOnRandomBodies) {
  support::Random random(71);
  for (int i = 0; i < 40; ++i) {
    const Body body = random_body(random);
    const Flotation rest = hydro::equilibrium(body.mesh_B, body.volume, random.rotation());
    const hydro::Wrench net = net_load(body.mesh_B, body.volume, rest.orientation, rest.height);
    EXPECT_LT(net.force.norm(), support::tolerance(1e-13) * body.volume);
    EXPECT_LT(net.moment.norm(), support::tolerance(1e-13) * body.volume);
    EXPECT_EQ(hydro::stability(body.mesh_B, rest), Stability::stable);
  }
}

TEST(Equilibrium, IsALeastPotentialEnergyByTheLoadsOfTheWaterAround) {
  support::Random random(72);
  for (int i = 0; i < 20; ++i) {
    const Body body = random_body(random);
    const Flotation rest = hydro::equilibrium(body.mesh_B, body.volume, random.rotation());
    for (int k = 0; k < 16; ++k) {
      const Vector3d axis(std::cos(k * std::numbers::pi / 8), std::sin(k * std::numbers::pi / 8),
                          0);
      // Small beside the distance of the next valley, large beside round-off.
      const Flotation turned =
          hydro::afloat(body.mesh_B, body.volume, AngleAxisd(1e-4, axis) * rest.orientation);
      const hydro::Wrench net =
          net_load(body.mesh_B, body.volume, turned.orientation, turned.height);
      EXPECT_LT(net.moment.dot(axis), 0);
      EXPECT_GT(energy(turned), energy(rest));
    }
  }
}

TEST(Equilibrium, IsNotHigherThanItsStart) {
  support::Random random(73);
  for (int i = 0; i < 20; ++i) {
    const Body body = random_body(random);
    const Flotation start = hydro::afloat(body.mesh_B, body.volume, random.rotation());
    const Flotation rest = hydro::equilibrium(body.mesh_B, body.volume, start.orientation);
    EXPECT_LE(energy(rest), energy(start));
  }
}

TEST(Equilibrium, OfAStableStartIsThatStart) {
  const TriMesh barge = hydro::translated(hydro::make_box({20, 8, 3}, 4), {0, 0, 0.5});
  const Flotation rest = hydro::equilibrium(barge, 20 * 8 * 1.25, Quaterniond::Identity());
  EXPECT_LT(rest.orientation.angularDistance(Quaterniond::Identity()), support::tolerance(1e-14));
  EXPECT_NEAR(rest.draught, 1.25, support::tolerance(1e-14));
  EXPECT_NEAR(rest.height, 1.0 - 1.25, support::tolerance(1e-14));  // the keel is at -1 in B
}

/// The body diagonal of a cube that is nearest to vertical, its angle with the vertical [rad].
double diagonal_tilt(const Quaterniond& orientation) {
  double least = std::numbers::pi;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const Vector3d d = orientation * Vector3d(x, y, 1).normalized();
      least = std::min(least, std::asin(std::min(1.0, d.head<2>().norm())));
    }
  return least;
}

TEST(Equilibrium, OfACubeOfHalfTheDensityOfWaterIsCornerUpFromAnyStart) {
  support::Random random(74);
  const TriMesh cube = hydro::make_box({1, 1, 1});
  const Quaterniond corner_up = Quaterniond::FromTwoVectors(Vector3d(1, 1, 1), Vector3d::UnitZ());
  const double least = energy(hydro::afloat(cube, 0.5, corner_up));
  for (int i = 0; i < 30; ++i) {
    const Flotation rest = hydro::equilibrium(cube, 0.5, random.rotation());
    EXPECT_NEAR(energy(rest), least, support::tolerance(1e-13));
    EXPECT_LT(diagonal_tilt(rest.orientation), support::tolerance(1e-6));
  }
}

TEST(Equilibrium, OfACubeLeavesTheSaddlesFlatAndEdgeUpTheSameWayEveryTime) {
  // Edge up the metacentric height of pitch is zero, √2/12 / V − √2/6, and only higher orders tell.
  const TriMesh cube = hydro::make_box({1, 1, 1}, 3);
  for (const auto& [angle, expected] :
       {std::pair(0.0, Stability::unstable), std::pair(45.0, Stability::neutral),
        std::pair(90.0, Stability::unstable)}) {
    const Quaterniond start(AngleAxisd(angle * kDegree, Vector3d::UnitX()));
    EXPECT_EQ(hydro::stability(cube, hydro::afloat(cube, 0.5, start)), expected);
    const Flotation rest = hydro::equilibrium(cube, 0.5, start);
    EXPECT_LT(diagonal_tilt(rest.orientation), support::tolerance(1e-6));
    const Flotation again = hydro::equilibrium(cube, 0.5, start);
    EXPECT_EQ(again.orientation.coeffs(), rest.orientation.coeffs());
  }
}

TEST(Equilibrium, OfACubeOf055IsNotFlat) {
  const TriMesh cube = hydro::make_box({1, 1, 1}, 2);
  const Flotation flat = hydro::afloat(cube, 0.55, Quaterniond::Identity());
  EXPECT_EQ(hydro::stability(cube, flat), Stability::unstable);
  const Flotation rest = hydro::equilibrium(cube, 0.55, Quaterniond::Identity());
  EXPECT_LT(energy(rest), energy(flat) - 0.01);
  EXPECT_EQ(hydro::stability(cube, rest), Stability::stable);
}

TEST(Equilibrium, OfABallastedSphereHasItsCentreOfMassBelowTheMiddle) {
  support::Random random(75);
  const Vector3d middle_B(0.02, -0.05, 0.3);
  const TriMesh ball = hydro::translated(hydro::make_icosphere(1, 4), middle_B);
  for (int i = 0; i < 8; ++i) {
    const Flotation rest = hydro::equilibrium(ball, 1.5, random.rotation());
    const Vector3d up = rest.orientation * middle_B.normalized();
    // The faces of an icosphere depart from the sphere by 1e-3 of the radius.
    EXPECT_LT(up.head<2>().norm(), 5e-3);
    EXPECT_GT(up.z(), 0);
  }
}

TEST(Equilibrium, TurnsWithItsStartAboutTheVertical) {
  support::Random random(76);
  for (int i = 0; i < 10; ++i) {
    const Body body = random_body(random);
    const Quaterniond start = random.rotation();
    const Quaterniond yaw(AngleAxisd(random.uniform(-3, 3), Vector3d::UnitZ()));
    const Flotation rest = hydro::equilibrium(body.mesh_B, body.volume, start);
    const Flotation turned = hydro::equilibrium(body.mesh_B, body.volume, yaw * start);
    EXPECT_NEAR(energy(turned), energy(rest), support::tolerance(1e-13));
    EXPECT_NEAR(turned.draught, rest.draught, support::tolerance(1e-11));
    // The attitude is as exact as the moment's arm, 1e-15, over the metacentric height.
    EXPECT_LT(turned.orientation.angularDistance(yaw * rest.orientation),
              support::tolerance(1e-11));
  }
}

TEST(Equilibrium, DoesNotDependOnHowTheFacesAreSplit) {
  const TriMesh coarse = hydro::translated(hydro::make_box({4, 2, 1.5}), {0.1, 0.05, 0.1});
  const TriMesh fine = hydro::translated(hydro::make_box({4, 2, 1.5}, 6), {0.1, 0.05, 0.1});
  const Flotation a = hydro::equilibrium(coarse, 5, Quaterniond::Identity());
  const Flotation b = hydro::equilibrium(fine, 5, Quaterniond::Identity());
  EXPECT_LT(a.orientation.angularDistance(b.orientation), support::tolerance(1e-13));
  EXPECT_NEAR(a.height, b.height, support::tolerance(1e-14));
}

TEST(Equilibrium, OfTheEllipsoidalBuoyHasTheKnownMetacentricHeight) {
  // Semi-axes 5, 5, 2.5 m, half immersed: 134,172 kg in water of 1025 kg/m^3. KB = 5/8·2.5 m,
  // BM = (π/4·5⁴)/(2/3·π·62.5) = 3.75 m; with KG = 0.5 m, 2 m below the waterplane, GM = 4.8125 m.
  const auto gm_error = [](int slices) {
    const TriMesh buoy =
        hydro::translated(hydro::make_ellipsoid({5, 5, 2.5}, slices, slices), {0, 0, 2});
    const Quaterniond start(AngleAxisd(0.3, Vector3d::UnitX()));
    const Flotation rest = hydro::equilibrium(buoy, 134172 / 1025.0, start);
    const Eigen::Matrix2d gm = hydro::metacentric_heights(rest.hydrostatics);
    EXPECT_LT((rest.orientation * Vector3d::UnitZ()).head<2>().norm(), support::tolerance(1e-13));
    EXPECT_NEAR(gm(0, 0), gm(1, 1), support::tolerance(1e-12));
    return std::abs(gm(0, 0) - 4.8125);
  };
  const double coarse = gm_error(32), middle = gm_error(64), fine = gm_error(128);
  EXPECT_NEAR(coarse / middle, 4, support::tolerance(0.3));
  EXPECT_NEAR(middle / fine, 4, support::tolerance(0.3));
  EXPECT_LT(fine, 5e-3);
}

TEST(Equilibrium, IsRefusedToWhatSinks) {
  const TriMesh cube = hydro::make_box({1, 1, 1});
  EXPECT_THROW(hydro::equilibrium(cube, 1, Quaterniond::Identity()), std::invalid_argument);
  EXPECT_THROW(hydro::righting_arms(cube, 1.5, {0.1}), std::invalid_argument);
}

std::vector<double> heels_deg(double last) {
  std::vector<double> heels;
  for (double heel = -last; heel <= last; ++heel) heels.push_back(heel * kDegree);
  return heels;
}

TEST(RightingArms, OfABoxFollowTheWallSidedFormula) {
  // 20 × 8 × 4 m drawing 2 m, centre of mass 0.5 m above the middle: BM = B²/(12 T), and the deck
  // edge is dry and the bilge wet up to tan φ = 2 T / B = 0.5, 26.5 degrees.
  const double B = 8, T = 2, kg = 2.5;
  const TriMesh box = hydro::translated(hydro::make_box({20, B, 4}, 2), {0, 0, -0.5});
  const double bm = B * B / (12 * T), gm = T / 2 + bm - kg;
  for (const hydro::RightingArm& arm : hydro::righting_arms(box, 20 * B * T, heels_deg(26))) {
    const double t = std::tan(arm.heel);
    const double exact = (gm + bm / 2 * t * t) * std::sin(arm.heel);
    EXPECT_NEAR(arm.lever, exact, support::tolerance(1e-13));
    EXPECT_NEAR(arm.trim, 0, support::tolerance(1e-13));
  }
}

TEST(RightingArms, LeaveNoTrimmingMomentAndTheFullWeightAfloat) {
  support::Random random(77);
  const Body body = random_body(random);
  for (const hydro::RightingArm& arm :
       hydro::righting_arms(body.mesh_B, body.volume, {-2, -1, -0.3, 0, 0.4, 1.2, 3})) {
    const Quaterniond orientation(AngleAxisd(arm.trim, Vector3d::UnitY()) *
                                  AngleAxisd(arm.heel, Vector3d::UnitX()));
    const double height = hydro::afloat(body.mesh_B, body.volume, orientation).height;
    const hydro::Wrench net = net_load(body.mesh_B, body.volume, orientation, height);
    EXPECT_LT(net.force.norm(), support::tolerance(1e-13) * body.volume);
    EXPECT_NEAR(net.moment.y(), 0, support::tolerance(1e-13) * body.volume);
    EXPECT_NEAR(net.moment.x(), -body.volume * arm.lever, support::tolerance(1e-13) * body.volume);
  }
}

TEST(RightingArms, AreTheSlopeOfThePotentialEnergy) {
  support::Random random(78);
  const Body body = random_body(random);
  const double step = 1e-4;
  const auto arms = hydro::righting_arms(body.mesh_B, body.volume, {0.5 - step, 0.5, 0.5 + step});
  const auto energy_at = [&](const hydro::RightingArm& arm) {
    return energy(hydro::afloat(body.mesh_B, body.volume,
                                Quaterniond(AngleAxisd(arm.trim, Vector3d::UnitY()) *
                                            AngleAxisd(arm.heel, Vector3d::UnitX()))));
  };
  const double slope = (energy_at(arms[2]) - energy_at(arms[0])) / (2 * step);
  // Central differences: step² = 1e-8 times the third derivative.
  EXPECT_NEAR(slope, arms[1].lever * std::cos(arms[1].trim), support::tolerance(1e-6));
}

TEST(EulerAngles, ComposeToTheOrientation) {
  support::Random random(79);
  for (int i = 0; i < 50; ++i) {
    const Quaterniond orientation = random.rotation();
    const Vector3d e = hydro::euler_angles(orientation);
    const Quaterniond composed(AngleAxisd(e[2], Vector3d::UnitZ()) *
                               AngleAxisd(e[1], Vector3d::UnitY()) *
                               AngleAxisd(e[0], Vector3d::UnitX()));
    EXPECT_LT(composed.angularDistance(orientation), support::tolerance(1e-13));
    const Quaterniond turned = hydro::with_heading(orientation, 0.7);
    EXPECT_NEAR(hydro::euler_angles(turned)[2], 0.7, support::tolerance(1e-14));
    EXPECT_LT(
        (turned.inverse() * Vector3d::UnitZ() - orientation.inverse() * Vector3d::UnitZ()).norm(),
        support::tolerance(1e-14));
  }
}

}  // namespace

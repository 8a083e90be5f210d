#include "hydro/loads/hull_lift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/decompositions.h"
#include "hydro/loads/loads.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"
#include "tests/support/ship_hulls.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::BodyState;
using hydro::HullLift;
using hydro::HullWater;
using hydro::make_box;
using hydro::make_ellipsoid;
using hydro::Matrix6d;
using hydro::TriMesh;
using hydro::Vector6d;
using hydro::Wrench;
using support::tolerance;

constexpr double kPi = M_PI;
const HullWater kCalm{.velocity = Vector3d::Zero(), .surface = 0, .density = 1000};
const HullWater kDeep{.velocity = Vector3d::Zero(), .surface = 1e3, .density = 1000};

/// A body at the origin, upright, that moves by (v, ω).
BodyState moving(const Vector3d& v, const Vector3d& w = Vector3d::Zero()) {
  return {.linear_velocity = v, .angular_velocity = w};
}

/// A hull of a cylinder of revolution about x with a blunt end.
TriMesh round_bar(double radius, double length) {
  const Eigen::Isometry3d turned(Eigen::AngleAxisd(kPi / 2, Vector3d::UnitY()));
  return hydro::transformed(hydro::make_cylinder(radius, length, 64, 8), turned);
}

// The outline within which points are left out takes 1 % of a circle's added mass, and the last
// section of 20 is not quite at the end.
TEST(HullLift, OfABluntEndIsThePlaneFlowOfItsSectionThere) {
  const double R = 0.5, L = 10, U = 3, v = 0.1, r = 0.01;
  const HullLift lift(round_bar(R, L));
  const Wrench load = lift.load(moving({U, v, 0}, {0, 0, r}), kDeep);
  const double force = -1000 * U * kPi * R * R * (v - L / 2 * r);
  EXPECT_NEAR(load.force.y(), force, tolerance(0.03 * std::abs(force)));
  EXPECT_NEAR(load.moment.z(), -L / 2 * load.force.y(), tolerance(1e-9));
  EXPECT_NEAR(load.force.x(), 0, 1e-9);
}

TEST(HullLift, ActsAtTheEndThatTheFlowLeaves) {
  const HullLift lift(round_bar(0.5, 10));
  const Wrench ahead = lift.load(moving({2, 0, 0.1}), kDeep);
  const Wrench astern = lift.load(moving({-2, 0, 0.1}), kDeep);
  EXPECT_NEAR(ahead.force.z(), astern.force.z(), tolerance(1e-9 * std::abs(ahead.force.z())));
  EXPECT_NEAR(ahead.moment.y(), -astern.moment.y(), tolerance(1e-9 * ahead.moment.norm()));
  EXPECT_GT(ahead.moment.y() * ahead.force.z(), 0);  // at x = −5: moment 5 F about y
}

TEST(HullLift, VanishesWithTheSpeedAlongTheHull) {
  const HullLift lift(round_bar(0.5, 10));
  EXPECT_TRUE(lift.load(moving({0, 1, 1}, {0, 0.2, 0.3}), kDeep).force.isZero(0));
  const double little = lift.load(moving({1e-6, 1, 0}), kDeep).force.norm();
  EXPECT_LT(little, 1e-5 * lift.load(moving({1, 1, 0}), kDeep).force.norm());
}

/// C − 1 of a rectangle that is `ratio` times as thick along its motion as high across it.
double rectangle(double ratio) { return 0.561 * std::sqrt(ratio) / (1 + 0.1 * std::sqrt(ratio)); }

// DNV-RP-C205, table D-1; and the few per cent of κ that the sections leave at a blunt end.
TEST(HullLift, KnowsTheAddedMassOfRectangles) {
  const std::pair<double, double> table[] = {{0.1, 1.14}, {0.2, 1.21}, {0.5, 1.36}, {1, 1.51},
                                             {2, 1.70},   {5, 1.98},   {10, 2.23}};
  for (const auto& [ratio, C] : table) {
    const HullLift lift(make_box({100, ratio, 1}));  // 1 m high across the motion along y
    const double a = -lift.load(moving({1, 1, 0}), kDeep).force.y() / 1000;
    EXPECT_NEAR(a, kPi / 4 * C, tolerance(0.06 * kPi / 4 * C)) << ratio;
  }
}

// The free surface is a wall across: half of the double body's plate, ½ ρ π T².
TEST(HullLift, OfAHullAfloatHasItsDraughtAndHalfItsBeam) {
  const double L = 10, B = 0.4, T = 0.6, U = 2, v = 0.1;
  const TriMesh mesh = hydro::translated(make_box({L, B, 1}), {0, 0, 0.5 - T});
  const HullLift lift(mesh);
  const double across = lift.load(moving({U, v, 0}), kCalm).force.y();
  const double upward = lift.load(moving({U, 0, v}), kCalm).force.z();
  const double C_y = 1 + rectangle(B / (2 * T));
  const double C_z = 1 + rectangle(2 * T / B);
  const double flux = -1000 * U * v * kPi / 2;
  EXPECT_NEAR(across, flux * C_y * T * T, tolerance(0.02 * std::abs(flux * T * T)));
  EXPECT_NEAR(upward, flux * C_z * B * B / 4, tolerance(0.02 * std::abs(flux * B * B)));
}

TEST(HullLift, OfTwoHullsIsTwiceThatOfOne) {
  const TriMesh left = hydro::translated(make_box({5, 0.4, 0.6}), {0, 1, -0.1});
  const TriMesh right = hydro::translated(make_box({5, 0.4, 0.6}), {0, -1, -0.1});
  const TriMesh deck = hydro::translated(make_box({2, 2.4, 0.1}), {0, 0, 0.2});
  const HullLift one(left), two(support::united(support::united(left, right), deck));
  const BodyState state = moving({2, 0.1, 0.05}, {0, 0.1, 0.1});
  const Wrench single = one.load(state, kCalm), twin = two.load(state, kCalm);
  EXPECT_NEAR(twin.force.y(), 2 * single.force.y(), tolerance(1e-9 * single.force.norm()));
  EXPECT_NEAR(twin.force.z(), 2 * single.force.z(), tolerance(1e-9 * single.force.norm()));
  EXPECT_NEAR(twin.moment.z(), 2 * single.moment.z(), tolerance(1e-9 * single.moment.norm()));
  EXPECT_NEAR(twin.moment.x() - 2 * (single.moment.x() - single.force.z()), 0,
              tolerance(1e-9 * single.moment.norm()));
}

TEST(HullLift, OfBodiesThatAreNotSlenderIsZero) {
  const BodyState state = moving({2, 0.3, 0.1}, {0.1, 0.2, 0.3});
  for (const TriMesh& mesh :
       {make_box({1, 1, 1}), hydro::make_icosphere(1, 2), make_box({4, 2, 1})}) {
    const HullLift lift(mesh);
    for (const HullWater& water : {kCalm, kDeep}) {
      const Wrench load = lift.load(state, water);
      EXPECT_EQ(load.force.norm(), 0);
      EXPECT_EQ(load.moment.norm(), 0);
    }
  }
  EXPECT_FALSE(HullLift(make_box({1, 1, 1})).may_lift());
}

TEST(HullLift, OfADryBodyIsZero) {
  const HullLift lift(round_bar(0.5, 10));
  const HullWater below{.velocity = Vector3d::Zero(), .surface = -20, .density = 1000};
  EXPECT_EQ(lift.load(moving({2, 0.3, 0.1}), below).force.norm(), 0);
}

/// The bare hull of the submarine Suboff, about: a nose of 1.016 m, a parallel body, and a tail of
/// 1.01 m. Its volume is 0.706 m³.
TriMesh suboff() {
  const double L = 4.356, R = 0.254;
  constexpr int kRings = 60, kAround = 32;
  const auto radius = [&](double x) {  // x from the nose
    if (x < 1.016) return R * std::sqrt(1 - std::pow(1 - x / 1.016, 2));
    const double t = std::max(0.0, (x - 3.346) / (L - 3.346));
    return R * (0.9 * (1 - 3 * t * t + 2 * t * t * t) + 0.1 * std::sqrt(1 - t));
  };
  TriMesh mesh = hydro::make_sphere(1, kAround, kRings);  // its poles on z, the nose below
  for (Eigen::Index i = 0; i < mesh.vertex_count(); ++i) {
    const Vector3d u = mesh.vertices.col(i);
    const double flat = std::hypot(u.x(), u.y()), x = L * (1 - u.z()) / 2;
    const double r = flat > 1e-9 ? radius(x) / flat : 0;
    mesh.vertices.col(i) << L / 2 - x, r * u.x(), r * u.y();
  }
  return mesh;
}

// Measured on Suboff's bare hull (Roddy 1990): Y_v' = −0.00595, Y_r' = 0.00181, N_r' = −0.00160;
// its Munk moment of −0.0158 and the measured N_v' = −0.0128 leave 0.0030 for the lift. All of the
// largest section would be Y_v' = −0.0214.
TEST(HullLift, OfATaperedTailIsASmallPartOfThatOfABluntOne) {
  const double L = 4.356;
  const HullLift lift(suboff());
  ASSERT_NEAR(hydro::solid_properties(suboff()).volume, 0.706, tolerance(0.03));
  const Matrix6d J = lift.jacobian(moving({1, 0, 0}), kDeep);
  const double Y = 0.5 * 1000 * L * L, N = Y * L;
  EXPECT_NEAR(J(1, 1) / Y, -0.00595, tolerance(0.2 * 0.00595));
  EXPECT_NEAR(J(5, 1) / N, 0.0030, tolerance(0.25 * 0.0030));
  EXPECT_NEAR(J(1, 5) / N, 0.00181, tolerance(0.4 * 0.00181));
  EXPECT_NEAR(J(5, 5) / N / L, -0.00160, tolerance(0.5 * 0.00160));
}

// A spar that floats upright only bobs along its axis; deep below the surface it may travel.
TEST(HullLift, OfAnUprightBodyWhoseEndIsDryIsZero) {
  const HullLift lift(round_bar(0.5, 10));
  BodyState state = moving({0.1, 0, 2});
  state.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(kPi / 2, Vector3d::UnitY()));
  EXPECT_LT(lift.load(state, kCalm).force.norm(), 1e-9);
  EXPECT_GT(lift.load(state, kDeep).force.norm(), 100);
}

TEST(HullLift, TakesEnergyFromEveryMotion) {
  support::Random random(11);
  const std::vector<TriMesh> meshes = {round_bar(0.5, 10), make_box({6, 1, 1.2}),
                                       support::make_tanker(7, 1.27, 0.455, 0.2, 16),
                                       make_ellipsoid({4, 0.6, 0.5}, 24, 24)};
  for (const TriMesh& mesh : meshes) {
    const HullLift lift(mesh);
    double most = 0;
    for (int i = 0; i < 200; ++i) {
      BodyState state = moving(random.vector(2), random.vector(2));
      state.orientation = random.rotation();
      state.position.z() = random.uniform(-1, 1);
      const Wrench load = lift.load(state, kCalm);
      const double power =
          load.force.dot(state.linear_velocity) + load.moment.dot(state.angular_velocity);
      EXPECT_LE(power, 0);
      most = std::max(most, -power);
      const Matrix6d J = lift.jacobian(state, kCalm);
      EXPECT_LT((J - J.transpose()).norm(), tolerance(1e-12 * (1 + J.norm())));
      EXPECT_LT(hydro::eigenvalues(J)[5], tolerance(1e-10 * (1 + J.norm())));
    }
    EXPECT_GT(most, 0);
  }
}

/// The load of drag and lift on the tanker that moves by (v, ω), moment about midships.
Wrench load_on_tanker(const TriMesh& mesh, const HullLift& lift, const Vector3d& v,
                      const Vector3d& w) {
  static const hydro::Hull hull = hydro::make_hull(mesh);
  const hydro::Sea sea{.density = 1000};
  const hydro::Coefficients coefficients = hydro::for_mesh({}, mesh, 1.1e-6);
  const hydro::Loads loads = hydro::compute_loads(hull, moving(v, w), sea, 0, coefficients);
  return loads.pressure_drag + loads.viscous_drag + lift.load(moving(v, w), kCalm);
}

// The tanker KVLCC2 at 1:45.7, ½ρ L T U² and L (SIMMAN; Yasukawa and Yoshimura 2015): Y_v' =
// −0.315, N_v' = −0.137, Y_r' = 0.083, N_r' = −0.049 about midships. Here at a drift of 2 degrees
// and a yaw rate r' of 0.05, with the measured m_y' − m_x' = 0.201 for Munk's moment.
TEST(HullLift, OfATankerGivesItsMeasuredDerivatives) {
  const double L = 320 / 45.7, B = 58 / 45.7, T = 20.8 / 45.7, U = 1.183;
  const TriMesh mesh = support::make_tanker(L, B, T, 9.2 / 45.7, 16);
  const HullLift lift(mesh);
  const double Y = 0.5 * 1000 * L * T * U * U, N = Y * L;
  const double drift = 2 * kPi / 180, rate = 0.05;
  const Wrench drifting =
      load_on_tanker(mesh, lift, {U * std::cos(drift), U * std::sin(drift), 0}, Vector3d::Zero());
  EXPECT_NEAR(drifting.force.y() / Y / drift, -0.315, tolerance(0.35 * 0.315));
  EXPECT_NEAR(drifting.moment.z() / N / drift - 0.201, -0.137, tolerance(0.35 * 0.137));
  const Wrench turning = load_on_tanker(mesh, lift, {U, 0, 0}, {0, 0, rate * U / L});
  EXPECT_NEAR(turning.force.y() / Y / rate, 0.083, tolerance(0.35 * 0.083));
  // The drag of the panels at bow and stern adds −0.023 to this.
  const Wrench alone = lift.load(moving({U, 0, 0}, {0, 0, rate * U / L}), kCalm);
  EXPECT_NEAR(alone.moment.z() / N / rate, -0.049, tolerance(0.35 * 0.049));
}

}  // namespace

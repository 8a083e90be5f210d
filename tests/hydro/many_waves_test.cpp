#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/loads/felt_waves.h"
#include "hydro/loads/kernel/water_surface.h"
#include "hydro/loads/load_jacobian.h"
#include "hydro/loads/loads.h"
#include "hydro/loads/plain_loads.h"
#include "hydro/loads/point_rules.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "hydro/wave_spectrum.h"
#include "tests/support/random_pose.h"
#include "tests/support/repeats.h"
#include "tests/support/tolerance.h"

/// The loads of irregular seas: sums at points, tables of the sea, and waves that are left out.

namespace {

using hydro::BodyState;
using hydro::Hull;
using hydro::Loads;
using hydro::Sea;
namespace kernel = hydro::kernel;

/// A steep sea of a peak period over which a wave is `length` long [m].
Sea irregular(double length, int waves, int seed,
              double depth = std::numeric_limits<double>::infinity()) {
  Sea sea{.density = 1025, .depth = depth};
  const double period = std::sqrt(2 * M_PI * length / sea.gravity);
  sea.surface = hydro::jonswap_sea({.significant_height = 0.03 * length,
                                    .peak_period = period,
                                    .spreading = 4,
                                    .seed = seed,
                                    .components = waves},
                                   sea);
  return sea;
}

double buoyancy_of(const Hull& hull, const Sea& sea) {
  return sea.density * sea.gravity * hydro::solid_properties(hull.mesh_B).volume;
}

struct Errors {
  double force, moment, drag;
};

/// Over the buoyancy of the submerged hull, moments over its radius as well.
Errors errors(const Hull& hull, const Sea& sea, const Loads& a, const Loads& b) {
  const double scale = buoyancy_of(hull, sea);
  const auto drag = [](const Loads& l) {
    return Eigen::Vector3d(l.pressure_drag.force + l.viscous_drag.force + l.lift.force);
  };
  return {(a.buoyancy.force - b.buoyancy.force).norm() / scale,
          (a.buoyancy.moment - b.buoyancy.moment).norm() / (scale * hull.radius),
          (drag(a) - drag(b)).norm() / scale};
}

/// A few large faces, many small ones, and a boat.
std::vector<Hull> hulls() {
  std::vector<Hull> all;
  all.push_back(hydro::make_hull(hydro::make_box({1, 1, 1})));
  all.push_back(hydro::make_hull(hydro::make_box({6, 1.6, 0.8}, 2)));
  all.push_back(hydro::make_hull(hydro::make_icosphere(0.5, 3)));
  all.push_back(hydro::make_hull(hydro::make_ellipsoid({3, 0.8, 0.5}, 24, 11)));
  return all;
}

/// Moving, the waterline across the hull.
BodyState state_of(support::Random& random) {
  BodyState state = random.state(0.15, 1);
  state.orientation = Eigen::AngleAxisd(random.uniform(-0.3, 0.3), Eigen::Vector3d::UnitX()) *
                      Eigen::AngleAxisd(random.uniform(-3, 3), Eigen::Vector3d::UnitZ()) *
                      Eigen::Quaterniond::Identity();
  return state;
}

/// The plain sum at a hundredth of the tolerance has the sums over all waves and small pieces.
TEST(ManyWaves, HaveTheForcesOfThePlainSumWithinTheTolerance) {
  support::Random random(151);
  int seed = 0;
  for (const Hull& hull : hulls())
    for (const double length : {1.0, 2.2, 10.0, 25.0, 100.0})
      for (const double depth : {std::numeric_limits<double>::infinity(), 3.0}) {
        if (depth < length / 20) continue;
        const Sea sea = irregular(length, 24, ++seed, depth);
        const BodyState state = state_of(random);
        const hydro::Coefficients coefficients{.lift = 0.05};
        const Loads plain =
            hydro::plain_loads(hull, state, sea, 0.7, coefficients, {.wave_tolerance = 1e-6});
        for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
          SCOPED_TRACE(testing::Message() << hull.mesh_B.face_count() << " faces, waves of "
                                          << length << " m, tolerance " << tolerance);
          const Loads fast = hydro::compute_loads(hull, state, sea, 0.7, coefficients,
                                                  {.wave_tolerance = tolerance});
          const Errors e = errors(hull, sea, fast, plain);
          EXPECT_LT(e.force, support::tolerance(tolerance));
          EXPECT_LT(e.moment, support::tolerance(tolerance));
          EXPECT_LT(e.drag, support::tolerance(tolerance));
        }
      }
}

TEST(ManyWaves, HaveSmallerErrorsWithASmallerTolerance) {
  const Hull hull = hydro::make_hull(hydro::make_ellipsoid({3, 0.8, 0.5}, 24, 11));
  double coarse = 0, fine = 0;
  for (int seed = 1; seed <= 6; ++seed) {
    const Sea sea = irregular(25, 48, seed);
    const auto loads = [&](double tolerance) {
      return hydro::compute_loads(hull, {}, sea, 0, {}, {.wave_tolerance = tolerance});
    };
    const Loads exact = loads(1e-6);
    coarse = std::max(coarse, errors(hull, sea, loads(1e-3), exact).force);
    fine = std::max(fine, errors(hull, sea, loads(1e-5), exact).force);
  }
  EXPECT_LT(3 * fine, coarse);
}

/// Without their table, the sums over all waves are those of fewer than kFewestTabulated.
TEST(ManyWaves, AreTheSumOfTheLoadsOfWaveAfterWaveOfSmallAmplitudes) {
  const Hull hull = hydro::make_hull(hydro::make_icosphere(0.5, 4));
  Sea sea{.density = 1025};
  hydro::WaveSurface all;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const hydro::Coefficients still{.pressure_drag = {0, 0},
                                  .viscous_drag = {hydro::ViscousDrag::Law::none}};
  const BodyState deep{.position = {0, 0, -2}};
  const Eigen::Vector3d rest = hydro::compute_loads(hull, deep, sea, 0, still).buoyancy.force;
  for (int i = 0; i < 16; ++i) {
    all.components.push_back(hydro::deep_water_wave(1e-3, 4 + i, 0.7 * i, 1.3 * i, sea.gravity));
    Sea one = sea;
    one.surface = hydro::WaveSurface{{all.components.back()}};
    sum +=
        hydro::compute_loads(hull, deep, one, 0.3, still, {.wave_tolerance = 1e-6}).buoyancy.force -
        rest;
  }
  sea.surface = all;
  const Eigen::Vector3d together =
      hydro::compute_loads(hull, deep, sea, 0.3, still, {.wave_tolerance = 1e-6}).buoyancy.force -
      rest;
  EXPECT_LT((together - sum).norm(), support::tolerance(0.01) * sum.norm());
}

TEST(ManyWaves, ThatCannotMoveABodyAreLeftOut) {
  const auto waves_of = [](const Sea& sea) {
    return std::get<hydro::WaveSurface>(sea.surface).components.size();
  };
  const Sea chop = irregular(1, 64, 3);
  const auto felt_by_ship = hydro::without_weak_waves(chop, {1e-4, 5});
  ASSERT_TRUE(felt_by_ship);
  EXPECT_LT(waves_of(*felt_by_ship), 32u);
  // A body that is short against them all feels all.
  EXPECT_FALSE(hydro::without_weak_waves(chop, {1e-4, 0.002}));
  // Few waves stay.
  EXPECT_FALSE(hydro::without_weak_waves(irregular(1, 8, 3), {1e-4, 5}));
  // What is left are the longest.
  double longest_left_out = 0, shortest = 0;
  for (const auto& w : std::get<hydro::WaveSurface>(felt_by_ship->surface).components)
    shortest = std::max(shortest, std::hypot(w.kx, w.ky));
  for (const auto& w : std::get<hydro::WaveSurface>(chop.surface).components) {
    const double k = std::hypot(w.kx, w.ky);
    if (k > shortest) longest_left_out = std::max(longest_left_out, 1 / k);
  }
  EXPECT_LT(longest_left_out, 1 / shortest);
}

/// While the amplitudes still are 0, a flat hull in a table of no height has its load in still
/// water.
TEST(ManyWaves, ThatAreStillRampedToNothingLeaveAPlateItsLoads) {
  const Hull plate = hydro::make_hull(hydro::make_box({2, 1, 1e-9}, 8));
  Sea sea = irregular(10, 48, 3);
  std::get<hydro::WaveSurface>(sea.surface).ramp = 5;
  const BodyState state{.position = {0.3, 0.2, -0.5}, .linear_velocity = {0.2, 0.1, -0.3}};
  const Loads ramped = hydro::compute_loads(plate, state, sea, 0, {});
  const Loads still = hydro::compute_loads(plate, state, Sea{.density = 1025}, 0, {});
  EXPECT_NEAR(ramped.pressure_drag.force.z(), still.pressure_drag.force.z(),
              support::tolerance(1e-9) * still.pressure_drag.force.norm());
  EXPECT_GT(still.pressure_drag.force.norm(), 0);
}

/// A part of a surface has no volume that its errors could be a part of.
TEST(ManyWaves, ActOnAnOpenPartOfAHullAsOnTheWhole) {
  hydro::TriMesh sphere = hydro::make_icosphere(0.5, 3), parts[2];
  const Eigen::Index faces = sphere.face_count();
  for (int side = 0; side < 2; ++side) {
    std::vector<Eigen::Index> kept;
    for (Eigen::Index f = 0; f < faces; ++f) {
      const double z =
          (sphere.vertices.col(sphere.faces(0, f)) + sphere.vertices.col(sphere.faces(1, f)) +
           sphere.vertices.col(sphere.faces(2, f)))
              .z();
      if ((z > 0) == (side == 0)) kept.push_back(f);
    }
    parts[side].vertices = sphere.vertices;
    parts[side].faces.resize(3, static_cast<Eigen::Index>(kept.size()));
    for (std::size_t i = 0; i < kept.size(); ++i)
      parts[side].faces.col(static_cast<Eigen::Index>(i)) = sphere.faces.col(kept[i]);
  }
  const Sea sea = irregular(3, 48, 9);
  const BodyState state{.position = {0, 0, -0.1}, .linear_velocity = {1, 0, 0}};
  const Hull whole = hydro::make_hull(sphere);
  Loads sum;
  for (const hydro::TriMesh& part : parts)
    sum += hydro::compute_loads(hydro::make_hull(part, Hull::Boundary::open), state, sea, 0.4, {});
  const Loads loads = hydro::compute_loads(whole, state, sea, 0.4, {});
  const Errors e = errors(whole, sea, sum, loads);
  EXPECT_LT(e.force, support::tolerance(2e-4));
  EXPECT_LT(e.drag, support::tolerance(2e-4));
}

/// Seas that a prepared one treats each in its way.
std::vector<Sea> seas() {
  std::vector<Sea> all;
  for (const int waves : {3, 24, 150}) all.push_back(irregular(10, waves, waves));
  all.push_back(irregular(2, 64, 4, 3));
  all.push_back(all[1]);
  std::get<hydro::WaveSurface>(all.back().surface).ramp = 1;
  all.push_back(all[1]);
  std::get<hydro::WaveSurface>(all.back().surface).kinematics = hydro::Kinematics::hydrostatic;
  all.push_back(all[1]);
  all.back().profile = {{0, {0.5, 0.1}}, {0.3, {0.2, 0.3}}, {2, {0, 0}}};
  all.back().current = {0.5, 0.1, 0};
  return all;
}

void expect_equal(const hydro::Wrench& a, const hydro::Wrench& b) {
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.moment, b.moment);
}

TEST(ManyWaves, HaveTheSameLoadsInAPreparedSeaToTheBit) {
  support::Random random(17);
  const hydro::Coefficients coefficients{.lift = 0.05};
  for (const Hull& hull : hulls())
    for (const Sea& sea : seas())
      for (const double tolerance : {1e-3, 1e-4}) {
        const hydro::LoadAccuracy how{.wave_tolerance = tolerance};
        const auto felt = hydro::make_felt_sea(hull, sea, how);
        for (int i = 0; i < 4; ++i) {
          const BodyState state = state_of(random);
          const double time = random.uniform(-0.2, 2);
          const Loads plain = hydro::compute_loads(hull, state, sea, time, coefficients, how);
          const Loads prepared = hydro::compute_loads(hull, state, *felt, time, coefficients, how);
          expect_equal(prepared.buoyancy, plain.buoyancy);
          expect_equal(prepared.pressure_drag, plain.pressure_drag);
          expect_equal(prepared.viscous_drag, plain.viscous_drag);
          expect_equal(prepared.lift, plain.lift);
          EXPECT_EQ(prepared.wetted_area, plain.wetted_area);
          EXPECT_EQ(prepared.displaced_volume, plain.displaced_volume);
          EXPECT_GT(plain.wetted_area, 0);
        }
      }
}

/// Of the seas, a model is prepared for one and asked about all.
TEST(ManyWaves, GiveAPreparedModelTheSameAddedMassToTheBit) {
  support::Random random(23);
  const hydro::TriMesh mesh = hydro::make_ellipsoid({3, 0.8, 0.5}, 12, 7);
  const auto solution = hydro::solve_added_mass(mesh, {.tolerance = 1e3});
  const hydro::WettedAddedMass plain(mesh, solution);
  for (const Sea& own : seas()) {
    const hydro::WettedAddedMass prepared(mesh, solution, &own);
    for (const Sea& sea : seas()) {
      const BodyState state = state_of(random);
      const double time = random.uniform(-0.2, 2);
      EXPECT_EQ(prepared.at(state, sea, time), plain.at(state, sea, time));
      expect_equal(prepared.wave_load(state, sea, time), plain.wave_load(state, sea, time));
    }
  }
}

TEST(ManyWaves, OfAPreparedSeaAreThoseOfSeasWithTheSameWavesAndWater) {
  const Sea sea = seas().back();
  const kernel::FeltSea felt(sea, 0.01, 1, std::nullopt, {hydro::SplitFor::surface});
  Sea other = sea;
  other.density = 1000;
  EXPECT_TRUE(felt.is_like(other));
  const auto differs = [&](auto&& change) {
    other = sea;
    change(other);
    return !felt.is_like(other);
  };
  const auto waves = [](Sea & s) -> auto& { return std::get<hydro::WaveSurface>(s.surface); };
  EXPECT_TRUE(differs([](Sea& s) { s.gravity = 1.6; }));
  EXPECT_TRUE(differs([](Sea& s) { s.level = 1; }));
  EXPECT_TRUE(differs([](Sea& s) { s.depth = 20; }));
  EXPECT_TRUE(differs([](Sea& s) { s.current.x() += 0.1; }));
  EXPECT_TRUE(differs([](Sea& s) { s.profile.pop_back(); }));
  EXPECT_TRUE(differs([](Sea& s) { s.surface = hydro::FlatSurface{}; }));
  EXPECT_TRUE(differs([&](Sea& s) { waves(s).ramp = 2; }));
  EXPECT_TRUE(differs([&](Sea& s) { waves(s).components.pop_back(); }));
  EXPECT_TRUE(differs([&](Sea& s) { waves(s).components[5].phase += 0.1; }));
}

/// The Jacobian is taken over coarse pieces: it is within some percent of the change of the drag.
TEST(ManyWaves, ChangeTheDragAsTheJacobianSays) {
  const Hull hull = hydro::make_hull(hydro::make_ellipsoid({3, 0.8, 0.5}, 24, 11));
  const Sea sea = irregular(25, 48, 5);
  const hydro::Coefficients coefficients{.viscous_drag = {hydro::ViscousDrag::Law::none}};
  BodyState state{.position = {0.3, 0.2, -0.05}, .linear_velocity = {2, 0.5, -0.3}};
  const auto J = hydro::load_jacobian(hull, state, sea, 0, coefficients).drag;
  const double step = 1e-3;
  const auto drag_at = [&](double change) {
    BodyState moved = state;
    moved.linear_velocity.z() += change;
    return hydro::compute_loads(hull, moved, sea, 0, coefficients, {.wave_tolerance = 1e-6})
        .pressure_drag.force.z();
  };
  const double slope = (drag_at(step) - drag_at(-step)) / (2 * step);
  EXPECT_NEAR(J(2, 2), slope, support::tolerance(0.05) * std::abs(slope));
}

/// ∫ x^i y^j over the triangle (0, 0), (1, 0), (0, 1) is i! j! / (i + j + 2)!.
template <std::size_t kPoints>
double error_of(const std::array<hydro::TrianglePoint, kPoints>& rule, int i, int j) {
  double sum = 0;
  for (const hydro::TrianglePoint& p : rule)
    sum += 0.5 * p.weight * std::pow(p.at[1], i) * std::pow(p.at[2], j);
  return std::abs(sum - std::tgamma(i + 1) * std::tgamma(j + 1) / std::tgamma(i + j + 3));
}

TEST(PointRules, AreExactForPolynomialsOfTheirDegree) {
  for (int degree = 0; degree <= 4; ++degree)
    for (int i = 0; i <= degree; ++i) {
      EXPECT_LT(error_of(hydro::kSixPoints, i, degree - i), 1e-15);
      if (degree > 2) continue;
      EXPECT_LT(error_of(hydro::kThreePoints, i, degree - i), 1e-15);
    }
  EXPECT_GT(error_of(hydro::kSixPoints, 5, 0), 1e-6);
  EXPECT_GT(error_of(hydro::kThreePoints, 3, 0), 1e-6);
}

}  // namespace

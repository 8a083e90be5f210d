#include "hydro/airy_waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hydro/loads/loads.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "hydro/wave_spectrum.h"
#include "hydro/wave_sums.h"
#include "tests/support/random_pose.h"

namespace {

using Eigen::Vector3d;
using hydro::AiryWaves;
using hydro::BodyState;
using hydro::Hull;
using hydro::Sea;
using hydro::WaterMotion;
using hydro::WaveSurface;

constexpr double kGravity = 9.80665;
constexpr double kDeep = std::numeric_limits<double>::infinity();

TEST(Dispersion, HasTheTabulatedWaveNumbers) {
  struct Row {
    double period, depth, wave_number;
  };
  const Row rows[] = {
      {10, 20, 0.0518372526}, {8, 5, 0.1183910625}, {12, 10, 0.0554670656}, {15, 30, 0.0268322790}};
  for (const Row& row : rows)
    EXPECT_NEAR(hydro::wave_number(2 * M_PI / row.period, row.depth, kGravity).value(),
                row.wave_number, 1e-10);
}

TEST(Dispersion, IsSolvedToRoundOffOnAnyDepthAndCurrent) {
  support::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const double k = std::pow(10, random.uniform(-4, 2));
    const double depth = i % 3 == 0 ? kDeep : std::pow(10, random.uniform(-1, 3.5));
    const double sigma = hydro::intrinsic_frequency(k, depth, kGravity);
    EXPECT_NEAR(sigma * sigma, kGravity * k * std::tanh(k * depth), 1e-14 * sigma * sigma);
    const double group = sigma / (2 * k);  // The least group velocity.
    const double along = random.uniform(-0.8, 3) * group;
    const auto found = hydro::wave_number(sigma + k * along, depth, kGravity, along);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, k, 1e-12 * k) << "depth " << depth << ", current " << along;
  }
}

TEST(Dispersion, KnowsTheCurrentThatStopsAWave) {
  // In deep water ω = σ − |U| k has no solution above g/(4 |U|).
  const double current = 2, limit = kGravity / (4 * current);
  EXPECT_TRUE(hydro::wave_number(0.999 * limit, kDeep, kGravity, -current));
  EXPECT_FALSE(hydro::wave_number(1.001 * limit, kDeep, kGravity, -current));
}

Sea some_sea(support::Random& random, double depth) {
  Sea sea{.level = 0.3, .depth = depth, .current = {0.7, -0.4, 0}};
  WaveSurface waves;
  for (int i = 0; i < 5; ++i)
    waves.components.push_back(hydro::linear_wave(sea, random.uniform(0.02, 0.15),
                                                  random.uniform(0.2, 1.5), random.uniform(-3, 3),
                                                  random.uniform(-3, 3)));
  sea.surface = waves;
  return sea;
}

TEST(AiryWaves, HaveNoPressureOnTheSurfaceToTheLastBit) {
  support::Random random(4);
  for (const double depth : {kDeep, 6.0}) {
    const Sea sea = some_sea(random, depth);
    for (int i = 0; i < 100; ++i) {
      const Vector3d p = random.vector(20);
      EXPECT_EQ(AiryWaves(sea, 0.1 * i).at(p, 0).head, 0);
    }
  }
}

/// For amplitudes of 1e-6 m stretching is as small: what it adds is below 1e-5 of the derivatives.
TEST(AiryWaves, ObeyLinearTheoryForSmallAmplitudes) {
  support::Random random(5);
  for (const double depth : {kDeep, 4.0}) {
    for (int i = 0; i < 50; ++i) {
      Sea sea = some_sea(random, depth);
      for (auto& w : std::get<WaveSurface>(sea.surface).components) w.amplitude *= 1e-5;
      Vector3d p = random.vector(3);
      p.z() = sea.level - random.uniform(0.1, 3);
      const double t = random.uniform(0, 10), d = 1e-3;
      const auto at = [&](const Vector3d& r, double time) { return hydro::water_at(sea, r, time); };
      const WaterMotion here = at(p, t);
      const auto derivative = [&](auto&& of, int axis) {
        const Vector3d e = d * Vector3d::Unit(axis);
        return ((of(at(p + e, t)) - of(at(p - e, t))) / (2 * d)).eval();
      };
      Eigen::Matrix3d G;
      for (int axis = 0; axis < 3; ++axis)
        G.col(axis) = derivative([](const WaterMotion& w) { return w.velocity; }, axis);
      const double scale = 1e-5;
      EXPECT_NEAR(G.trace(), 0, 1e-4 * scale);
      EXPECT_LT((G - G.transpose()).norm(), 1e-4 * scale);
      Vector3d gradient;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3d e = d * Vector3d::Unit(axis);
        gradient[axis] = ((at(p + e, t).head + e.z()) - (at(p - e, t).head - e.z())) / (2 * d);
      }
      EXPECT_LT((here.acceleration + sea.gravity * gradient).norm(), 1e-4 * scale);
      // Du/Dt of linear theory: by the time, for one who drifts with the current.
      const Vector3d drift = d * sea.current;
      const Vector3d rate =
          (at(p + drift, t + d).velocity - at(p - drift, t - d).velocity) / (2 * d);
      EXPECT_LT((here.acceleration - rate).norm(), 1e-4 * scale);
    }
  }
}

/// The elevation as a sum over seas of one wave each [m].
double elevation_wave_by_wave(const Sea& sea, double x, double y, double time) {
  double sum = 0;
  for (const hydro::WaveComponent& w : std::get<WaveSurface>(sea.surface).components) {
    Sea one = sea;
    std::get<WaveSurface>(one.surface).components = {w};
    sum += hydro::surface_elevation(one, x, y, time);
  }
  return sum;
}

/// Rounding of a sum of waves whose phases are as large as these tests' [-].
constexpr double kRounding = 1e-11;

TEST(ManyAiryWaves, AreTheSumOfEachInAnyNumberAndDepth) {
  support::Random random(31);
  for (const int waves : {8, 13, 64, 130})
    for (const double depth : {kDeep, 4.0, 0.5}) {
      Sea sea{.depth = depth, .current = {0.4, -0.2, 0}};
      sea.surface = hydro::jonswap_sea(
          {.significant_height = 0.2, .peak_period = 3, .spreading = 2, .components = waves}, sea);
      std::get<WaveSurface>(sea.surface).ramp = 20;
      for (int i = 0; i < 20; ++i) {
        const Vector3d p = random.vector(100) - Vector3d(0, 0, random.uniform(0, 3));
        const double time = random.uniform(1, 40);
        const double rise = hydro::surface_elevation(sea, p.x(), p.y(), time);
        EXPECT_NEAR(rise, elevation_wave_by_wave(sea, p.x(), p.y(), time), kRounding);
        const Vector3d at(p.x(), p.y(), -0.4 * random.uniform(0, 1));
        const WaterMotion here = hydro::water_at(sea, at, time);
        const WaterMotion there = AiryWaves(sea, time).at(at, rise - at.z());
        EXPECT_NEAR(here.head, there.head, kRounding);
        EXPECT_LT((here.velocity - there.velocity).norm(), 10 * kRounding);
        EXPECT_LT((here.acceleration - there.acceleration).norm(), 10 * kRounding);
        const Eigen::Matrix3d box =
            random.rotation().toRotationMatrix() * Vector3d(2, 1, 0.5).asDiagonal();
        const Vector3d mean = hydro::mean_velocity(sea, at, rise - at.z(), box, time);
        const Vector3d expected = AiryWaves(sea, time).mean_velocity(at, rise - at.z(), box);
        EXPECT_LT((mean - expected).norm(), 10 * kRounding);
      }
    }
}

TEST(ManyAiryWaves, KeepTheirPhasesFarAwayAndLate) {
  Sea sea;
  sea.surface =
      hydro::jonswap_sea({.significant_height = 2, .peak_period = 7, .components = 16}, sea);
  const double far = 3e7, late = 4e6;
  const double expected = elevation_wave_by_wave(sea, far, -far, late);
  // A phase of 1e8 has lost 1.5e-8 before its cosine is taken.
  EXPECT_NEAR(hydro::surface_elevation(sea, far, -far, late), expected, 1e-6);
}

TEST(AiryWaves, StandStillAtTheBottom) {
  support::Random random(6);
  const Sea sea = some_sea(random, 5);
  const WaterMotion water = hydro::water_at(sea, {1, 2, sea.level - 5}, 3);
  EXPECT_NEAR(water.velocity.z(), 0, 1e-15);
  EXPECT_GT(water.velocity.head<2>().norm(), 0.01);
}

TEST(AiryWaves, LookTheSameToOneWhoDrifts) {
  support::Random random(7);
  const Sea moving = some_sea(random, 7);
  Sea still = moving;
  still.current.setZero();
  auto& waves = std::get<WaveSurface>(still.surface).components;
  for (auto& w : waves) {
    const auto again = hydro::linear_wave(still, w.amplitude, std::hypot(w.kx, w.ky),
                                          std::atan2(w.ky, w.kx), w.phase);
    w.omega = again.omega;
  }
  for (int i = 0; i < 50; ++i) {
    const double t = random.uniform(0, 20);
    Vector3d p = random.vector(5);
    p.z() -= 3;
    const WaterMotion a = hydro::water_at(still, p, t);
    const WaterMotion b = hydro::water_at(moving, p + t * moving.current, t);
    EXPECT_NEAR(a.head, b.head, 1e-12);
    EXPECT_LT((a.velocity + moving.current - b.velocity).norm(), 1e-12);
    EXPECT_LT((a.acceleration - b.acceleration).norm(), 1e-12);
  }
}

/// The force of the waves' pressure: ∫ −p n dS without the still water's.
hydro::Wrench wave_force(const Hull& hull, const BodyState& state, Sea sea, double time) {
  const auto force = [&] { return hydro::compute_loads(hull, state, sea, time, {}).buoyancy; };
  const hydro::Wrench all = force();
  sea.surface = hydro::FlatSurface{};
  return all + -1.0 * force();
}

/// The mean of a harmonic function over a ball is its value at the centre: F = ρ V u̇ for any kR.
TEST(FroudeKrylov, OnADeepSphereIsThatOfTheWaterInItsPlace) {
  const Hull hull = hydro::make_hull(hydro::make_icosphere(1, 5));
  const double volume = hydro::solid_properties(hull.mesh_B).volume;
  for (const double kR : {0.1, 0.5, 1.0, 2.0}) {
    Sea sea;
    sea.surface = WaveSurface{{hydro::linear_wave(sea, 1e-5, kR, 0.4, 0.3)}};
    const BodyState state{.position = {0.2, 0.1, -1.5}};
    const Vector3d u = hydro::water_at(sea, state.position, 0.7).acceleration;
    const hydro::Wrench force = wave_force(hull, state, sea, 0.7);
    EXPECT_LT((force.force - sea.density * volume * u).norm(), 2e-3 * force.force.norm())
        << "kR = " << kR;
    EXPECT_LT(force.moment.norm(), 2e-3 * force.force.norm());
  }
}

/// Over ρ g π R² a, by exact quadrature of the closed form.
TEST(FroudeKrylov, OnAHemisphereHasTheTabulatedHeaveAndSurge) {
  struct Row {
    double kR, heave, surge;
  };
  const Row rows[] = {{0.1, 0.9345831597, 0.0641673610},
                      {0.3, 0.8112359533, 0.1775561552},
                      {0.5, 0.6978084981, 0.2712653326},
                      {1, 0.4566187311, 0.4234824404},
                      {2, 0.1402294359, 0.4364953718}};
  const Hull hull = hydro::make_hull(hydro::make_icosphere(1, 5));
  for (const Row& row : rows) {
    Sea sea;
    const double amplitude = 1e-5;
    sea.surface = WaveSurface{{hydro::linear_wave(sea, amplitude, row.kR, 0, 0)}};
    const double unit = sea.density * sea.gravity * M_PI * amplitude;
    const double period = 2 * M_PI / hydro::intrinsic_frequency(row.kR, kDeep, sea.gravity);
    EXPECT_NEAR(wave_force(hull, {}, sea, 0).force.z() / unit, row.heave, 2e-3);
    EXPECT_NEAR(std::abs(wave_force(hull, {}, sea, period / 4).force.x()) / unit, row.surge, 2e-3);
  }
}

/// Waves that are long for the body move its water as a whole: drag, lift and friction are those of
/// a body that moves the other way.
TEST(Loads, InLongWavesAreThoseOfTheRelativeMotion) {
  support::Random random(8);
  const Hull hull = hydro::make_hull(hydro::make_icosphere(0.5, 3));
  const hydro::Coefficients coefficients{.lift = 0.2};
  for (int i = 0; i < 20; ++i) {
    Sea sea;
    sea.surface = WaveSurface{{hydro::linear_wave(sea, 2, 1e-5, random.uniform(-3, 3), i)}};
    BodyState state = random.state(1, 1);
    state.position.z() = -40;
    const hydro::Loads moved = hydro::compute_loads(hull, state, sea, 2, coefficients);
    state.linear_velocity -= hydro::water_at(sea, state.position, 2).velocity;
    const hydro::Loads still = hydro::compute_loads(hull, state, Sea{}, 0, coefficients);
    const double scale = still.pressure_drag.force.norm() + still.viscous_drag.force.norm();
    EXPECT_LT((moved.pressure_drag.force - still.pressure_drag.force).norm(), 1e-4 * scale);
    EXPECT_LT((moved.lift.force - still.lift.force).norm(), 1e-4 * scale);
    EXPECT_LT((moved.viscous_drag.force - still.viscous_drag.force).norm(), 1e-4 * scale);
  }
}

/// The same sea without a ramp, with the amplitudes that it has at a time.
Sea at_amplitudes_of(Sea sea, double time) {
  auto& waves = std::get<WaveSurface>(sea.surface);
  const double factor = hydro::amplitude_factor(waves, time);
  for (hydro::WaveComponent& w : waves.components) w.amplitude *= factor;
  waves.ramp = 0;
  return sea;
}

TEST(WaveRamp, GrowsSmoothlyFromNothingToOne) {
  const WaveSurface waves{.components = {}, .ramp = 8};
  EXPECT_EQ(hydro::amplitude_factor(waves, -1), 0);
  EXPECT_EQ(hydro::amplitude_factor(waves, 0), 0);
  EXPECT_NEAR(hydro::amplitude_factor(waves, 2), (1 - std::sqrt(0.5)) / 2, 1e-15);
  EXPECT_NEAR(hydro::amplitude_factor(waves, 4), 0.5, 1e-15);
  EXPECT_EQ(hydro::amplitude_factor(waves, 8), 1);
  EXPECT_EQ(hydro::amplitude_factor(waves, 100), 1);
  // Both ends are flat: the factor differs from theirs by (πε/2)², ε in ramps.
  EXPECT_NEAR(hydro::amplitude_factor(waves, 8e-3), std::pow(M_PI / 2 * 1e-3, 2), 1e-11);
  EXPECT_NEAR(1 - hydro::amplitude_factor(waves, 8 - 8e-3), std::pow(M_PI / 2 * 1e-3, 2), 1e-11);
  for (const double time : {-3.0, 0.0, 3.0}) EXPECT_EQ(hydro::amplitude_factor({}, time), 1);
}

TEST(WaveRamp, BeginsInStillWater) {
  support::Random random(40);
  Sea sea = some_sea(random, 12);
  std::get<WaveSurface>(sea.surface).ramp = 5;
  for (int i = 0; i < 20; ++i) {
    const Vector3d p(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-5, 0.3));
    EXPECT_EQ(hydro::surface_elevation(sea, p.x(), p.y(), 0), 0);
    EXPECT_EQ(hydro::surface_slope(sea, p.x(), p.y(), 0), Eigen::Vector2d(0, 0));
    const WaterMotion water = hydro::water_at(sea, p, 0);
    EXPECT_EQ(water.head, sea.level - p.z());
    EXPECT_EQ(water.velocity, sea.current);
    EXPECT_EQ(water.acceleration, Vector3d(0, 0, 0));
  }
}

/// Elevation, slope, pressure, velocity, acceleration and loads have one factor at a time.
TEST(WaveRamp, IsOneFactorOfAllThatWavesDo) {
  support::Random random(41);
  const Hull hull = hydro::make_hull(hydro::make_icosphere(0.5, 3));
  for (const double depth : {12.0, kDeep}) {
    Sea sea = some_sea(random, depth);
    std::get<WaveSurface>(sea.surface).ramp = 5;
    sea.air = hydro::Air{.wind = {.velocity = {20, 9, 0}}};
    for (const double time : {0.0, 0.7, 2.9, 4.999, 6.0}) {
      const Sea now = at_amplitudes_of(sea, time);
      const Vector3d p(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-5, 0));
      EXPECT_NEAR(hydro::surface_elevation(sea, p.x(), p.y(), time),
                  hydro::surface_elevation(now, p.x(), p.y(), time), 1e-15);
      EXPECT_LT((hydro::surface_slope(sea, p.x(), p.y(), time) -
                 hydro::surface_slope(now, p.x(), p.y(), time))
                    .norm(),
                1e-15);
      const WaterMotion a = hydro::water_at(sea, p, time), b = hydro::water_at(now, p, time);
      EXPECT_NEAR(a.head, b.head, 1e-14);
      EXPECT_LT((a.velocity - b.velocity).norm(), 1e-14);
      EXPECT_LT((a.acceleration - b.acceleration).norm(), 1e-14);
      BodyState state = random.state(1, 1);
      state.position.z() = 0.2;
      const hydro::Loads c = hydro::compute_loads(hull, state, sea, time, {});
      const hydro::Loads d = hydro::compute_loads(hull, state, now, time, {});
      EXPECT_LT((c.total().force - d.total().force).norm(), 1e-11 * d.buoyancy.force.norm());
      EXPECT_LT((c.total().moment - d.total().moment).norm(), 1e-11 * d.buoyancy.force.norm());
      EXPECT_LT((c.wind.force - d.wind.force).norm(), 1e-11 * d.wind.force.norm());
    }
  }
}

}  // namespace

#include "hydro/measured_elevation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/support/tolerance.h"

namespace {

using hydro::ElevationChoice;
using hydro::ElevationRecord;
using hydro::MeasuredSea;
using hydro::Sea;
using support::tolerance;

ElevationRecord recorded(int count, double interval, double start,
                         const std::function<double(double)>& elevation) {
  ElevationRecord record{.start = start, .interval = interval, .elevations = {}};
  for (int i = 0; i < count; ++i) record.elevations.push_back(elevation(start + i * interval));
  return record;
}

double hertz(double f) { return 2 * M_PI * f; }

/// Three waves whose periods divide the record of 20 s, about a mean of 0.3 m.
double three_waves(double t) {
  return 0.3 + 0.8 * std::cos(hertz(0.25) * t + 1) + 0.3 * std::cos(hertz(0.4) * t - 2) +
         0.1 * std::sin(hertz(0.7) * t);
}

/// The elevation of waves at a place; the kinematics play no part in it.
double elevation(const Sea& sea, const MeasuredSea& waves, const Eigen::Vector2d& at, double time) {
  Sea wavy = sea;
  wavy.surface = hydro::WaveSurface{waves.components};
  return hydro::surface_elevation(wavy, at.x(), at.y(), time);
}

const Sea kSea{.gravity = 9.80665, .level = 2, .depth = 6, .current = {0.4, -0.3, 0}};

TEST(MeasuredElevation, WavesHaveTheElevationOfASyntheticRecordToRoundOff) {
  const ElevationChoice choice{.at = {7, -3}, .heading = 0.6};
  for (const int count : {200, 201, 256}) {
    const double interval = 20.0 / count;
    const ElevationRecord record = recorded(count, interval, -4, three_waves);
    const MeasuredSea waves = hydro::sea_of_record(record, choice, kSea);
    EXPECT_NEAR(waves.fit.mean, 0.3, tolerance(1e-14));
    EXPECT_LT(waves.fit.residual, tolerance(1e-12));
    for (double time = -4; time < 16; time += 0.113)  // also between the record's times
      EXPECT_NEAR(elevation(kSea, waves, choice.at, time), three_waves(time) - 0.3,
                  tolerance(1e-12));
  }
}

TEST(MeasuredElevation, WavesObeyTheDispersionRelationOnTheCurrent) {
  const ElevationRecord record = recorded(200, 0.1, 0, three_waves);
  for (const auto& w : hydro::sea_of_record(record, {.heading = 0.6}, kSea).components) {
    const double k = std::hypot(w.kx, w.ky);
    const double sigma = w.omega - w.kx * 0.4 + w.ky * 0.3;
    EXPECT_NEAR(sigma * sigma / (9.80665 * k * std::tanh(6 * k)), 1, tolerance(1e-12));
    EXPECT_NEAR(std::atan2(w.ky, w.kx), 0.6, tolerance(1e-13));
  }
}

/// Noise that depends on the time alone: waves of many frequencies, of which few fit the record.
double noisy(double t) {
  double sum = 0;
  for (int i = 1; i < 40; ++i) sum += std::cos(0.37 * i * t + i * i) / (3 + (i - 12) * (i - 12));
  return sum;
}

TEST(MeasuredElevation, TheResidualIsThatOfTheWavesAtTheTimesOfTheRecord) {
  const ElevationRecord record = recorded(300, 0.2, 0, noisy);
  for (const int components : {1024, 12}) {
    const ElevationChoice choice{.at = {1, 2}, .heading = 2, .components = components};
    const MeasuredSea waves = hydro::sea_of_record(record, choice, kSea);
    double left = 0, all = 0;
    for (int i = 0; i < 300; ++i) {
      const double measured = record.elevations[i] - waves.fit.mean;
      const double difference = elevation(kSea, waves, choice.at, 0.2 * i) - measured;
      left += difference * difference;
      all += measured * measured;
    }
    EXPECT_NEAR(waves.fit.residual, std::sqrt(left / all), tolerance(1e-12));
    EXPECT_GT(waves.fit.residual, 0.01);
    EXPECT_NEAR(waves.fit.significant_height, 4 * std::sqrt(all / 300), tolerance(1e-12));
    EXPECT_EQ(waves.fit.dropped > 0, components == 12);
  }
}

TEST(MeasuredElevation, ABandLeavesOutTheEnergyOutsideIt) {
  const ElevationRecord record = recorded(200, 0.1, 0, three_waves);
  const ElevationChoice choice{.lowest = hertz(0.3), .highest = hertz(0.5)};
  const hydro::ElevationFit fit = hydro::sea_of_record(record, choice, kSea).fit;
  EXPECT_NEAR(fit.below, 0.64 / 0.74, tolerance(1e-12));
  EXPECT_NEAR(fit.above, 0.01 / 0.74, tolerance(1e-12));
  EXPECT_NEAR(fit.residual, std::sqrt(0.65 / 0.74), tolerance(1e-12));
}

TEST(MeasuredElevation, EndsOfTheBandBelongToIt) {
  const ElevationRecord record = recorded(200, 0.1, 0, three_waves);
  const ElevationChoice choice{.lowest = hertz(0.25), .highest = hertz(0.7)};
  EXPECT_LT(hydro::sea_of_record(record, choice, kSea).fit.residual, tolerance(1e-12));
}

TEST(MeasuredElevation, TheBandFollowsThePeak) {
  const hydro::ElevationFit fit =
      hydro::sea_of_record(recorded(200, 0.1, 0, three_waves), {}, kSea).fit;
  EXPECT_NEAR(fit.peak_period, 4, tolerance(1e-12));
  EXPECT_NEAR(fit.lowest, 0.3 * hertz(0.25), tolerance(1e-12));
  EXPECT_NEAR(fit.highest, 3 * hertz(0.25), tolerance(1e-12));
}

TEST(MeasuredElevation, WavesThatTheCurrentStopsAreToldAndLeftOut) {
  // Against 4 m/s waves below 0.613 rad/s alone travel: g/(4U) on deep water.
  const Sea against{.gravity = 9.80665, .current = {-4, 0, 0}};
  const auto two = [](double t) { return std::cos(hertz(0.05) * t) + std::cos(hertz(0.2) * t); };
  const ElevationChoice choice{.lowest = hertz(0.01), .highest = hertz(1)};
  const MeasuredSea waves = hydro::sea_of_record(recorded(200, 0.1, 0, two), choice, against);
  EXPECT_NEAR(waves.fit.stopped, 0.5, tolerance(1e-12));
  for (const auto& w : waves.components) EXPECT_LT(w.omega, 0.613);
}

TEST(MeasuredElevation, ADriftShowsAsAJump) {
  const auto jump = [](double drift) {
    const auto drifting = [&](double t) { return three_waves(t) + drift * t; };
    return hydro::sea_of_record(recorded(200, 0.1, 0, drifting), {}, kSea).fit.jump;
  };
  EXPECT_LE(jump(0), 1.01);
  EXPECT_GT(jump(0.1), 5);
}

TEST(MeasuredElevation, RecordsWithoutWavesAreRefused) {
  EXPECT_THROW(hydro::sea_of_record(recorded(50, 0.1, 0, [](double) { return 2; }), {}, kSea),
               std::invalid_argument);
  EXPECT_THROW(hydro::sea_of_record(recorded(50, 0.1, 0, three_waves),
                                    {.lowest = hertz(0.21), .highest = hertz(0.22)}, kSea),
               std::invalid_argument);
}

}  // namespace

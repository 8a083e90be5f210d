#include "hydro/radiation/diffraction_load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hydro/airy_waves.h"
#include "hydro/loads/loads.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Complex = std::complex<double>;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using hydro::BodyState;
using hydro::DiffractionLoad;
using hydro::RadiationData;
using hydro::Sea;
using hydro::Vector6cd;
using hydro::Vector6d;
using hydro::WaveSurface;
using hydro::Wrench;
using support::tolerance;

Quaterniond turn(double angle) { return Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitZ())); }

Vector6d stacked(const Wrench& w) { return (Vector6d() << w.force, w.moment).finished(); }

Vector6cd random_load(support::Random& random) {
  Vector6cd load;
  for (Complex& x : load) x = {random.uniform(-1, 1), random.uniform(-1, 1)};
  return load;
}

/// Random loads with harmonics up to `most` in the heading, in the order k.
RadiationData some_data(support::Random& random, int headings, int most,
                        double depth = std::numeric_limits<double>::infinity()) {
  RadiationData data;
  data.pose.orientation = Eigen::AngleAxisd(0.3, Vector3d(1, 2, 0).normalized());
  data.water = {.gravity = 9.82, .depth = depth};
  data.frequencies = {0.6, 1, 1.7, 2.5, 4};
  for (int j = 0; j < headings; ++j) data.headings.push_back(2 * M_PI * j / headings);
  for (const double omega : data.frequencies) {
    const double k = *hydro::wave_number(omega, depth, data.water.gravity);
    auto& loads = data.diffraction.emplace_back(hydro::Loads6cd::Zero(6, headings));
    for (int m = -most; m <= most; ++m) {
      const Vector6cd harmonic = random_load(random);
      for (int j = 0; j < headings; ++j)
        loads.col(j) +=
            k * std::polar(1.0, m * data.headings[static_cast<std::size_t>(j)]) * harmonic;
    }
  }
  return data;
}

Sea sea_of(const RadiationData& data, std::vector<hydro::WaveComponent> waves) {
  return {.density = 1025,
          .gravity = data.water.gravity,
          .level = 0.4,
          .depth = data.water.depth,
          .surface = WaveSurface{.components = std::move(waves)}};
}

BodyState state_of(const RadiationData& data, double heading, const Vector3d& position) {
  return {.position = position, .orientation = turn(heading) * data.pose.orientation};
}

/// The load on a body whose frame H turns with it.
Wrench load_on(const DiffractionLoad& load, const RadiationData& data, const BodyState& state,
               const Sea& sea, double time) {
  return load.at(state.position, {state.linear_velocity, state.angular_velocity},
                 {.R_WH = state.orientation * data.pose.orientation.conjugate()}, sea, time);
}

TEST(DiffractionLoad, IsTheDataAtTheirFrequenciesAndHeadings) {
  support::Random random(1);
  for (const double depth : {3.0, std::numeric_limits<double>::infinity()}) {
    for (const int headings : {8, 9}) {
      const RadiationData data = some_data(random, headings, 5, depth);
      const DiffractionLoad load(data);
      for (std::size_t i = 0; i < data.frequencies.size(); ++i) {
        for (std::size_t j = 0; j < data.headings.size(); ++j) {
          const Vector6cd X = data.diffraction[i].col(static_cast<Eigen::Index>(j));
          EXPECT_LT((load.coefficients(data.frequencies[i], data.headings[j]) - X).norm(),
                    tolerance(1e-13) * X.norm());
        }
      }
    }
  }
}

TEST(DiffractionLoad, IsExactBetweenHeadingsForFewHarmonics) {
  support::Random random(2), again(2);
  const RadiationData data = some_data(random, 11, 5);
  const RadiationData fine = some_data(again, 44, 5);  // The same loads at more headings.
  const DiffractionLoad load(data);
  for (std::size_t j = 0; j < fine.headings.size(); ++j) {
    const Vector6cd X = fine.diffraction[2].col(static_cast<Eigen::Index>(j));
    EXPECT_LT((load.coefficients(fine.frequencies[2], fine.headings[j]) - X).norm(),
              tolerance(1e-13) * X.norm());
  }
}

/// Smooth data of many frequencies: X/k = 1/(1 + ω²) + i ω²/(4 + ω²) in every component.
RadiationData smooth_data(int count) {
  RadiationData data;
  data.headings = {0};
  for (int i = 0; i < count; ++i) data.frequencies.push_back(0.5 + 3.0 * i / (count - 1));
  for (const double w : data.frequencies)
    data.diffraction.emplace_back(Vector6cd::Constant(
        w * w / data.water.gravity * Complex(1 / (1 + w * w), w * w / (4 + w * w))));
  return data;
}

TEST(DiffractionLoad, ConvergesWithThirdOrderInTheFrequency) {
  double last = 0;
  for (const int count : {8, 15, 29}) {
    const RadiationData data = smooth_data(count);
    const DiffractionLoad load(data);
    double error = 0;
    for (double w = 0.5; w < 3.5; w += 0.01) {
      const Complex exact =
          w * w / data.water.gravity * Complex(1 / (1 + w * w), w * w / (4 + w * w));
      error = std::max(error, std::abs(load.coefficients(w, 0)[2] - exact));
    }
    if (last > 0) {
      EXPECT_GT(last / error, 5);  // 2³ in the limit.
    }
    last = error;
  }
}

TEST(DiffractionLoad, ChangesContinuouslyWithItsSlopeBetweenTheFrequencies) {
  support::Random random(3);
  const RadiationData data = some_data(random, 4, 1);
  const DiffractionLoad load(data);
  const double h = 1e-5;
  for (std::size_t i = 1; i + 1 < data.frequencies.size(); ++i) {
    const double w = data.frequencies[i];
    const Vector6cd here = load.coefficients(w, 0.3), before = load.coefficients(w - h, 0.3),
                    after = load.coefficients(w + h, 0.3);
    // The slopes on both sides differ by the second derivative times h, some 10 h.
    EXPECT_LT(((after - here) - (here - before)).norm() / h, tolerance(1e-3));
  }
}

TEST(DiffractionLoad, GoesWithTheWaveNumberInLongWavesAndDiesOutInShortOnes) {
  support::Random random(4);
  const RadiationData data = some_data(random, 5, 2);
  const DiffractionLoad load(data);
  const double g = data.water.gravity;
  const auto over_k = [&](double k) -> Vector6cd {
    return load.coefficients(std::sqrt(g * k), 1.1) / k;
  };
  // Over k it is on one line with the loads at the two lowest frequencies, 0.6 and 1 rad/s.
  const double low = 0.36 / g, next = 1 / g, high = 16 / g;
  const Vector6cd slope = (over_k(next) - over_k(low)) / (next - low);
  for (const double k : {1e-9, low / 3, 0.999 * low}) {
    const Vector6cd expected = over_k(low) + (k - low) * slope;
    EXPECT_LT((over_k(k) - expected).norm(), 1e-12 * expected.norm()) << k;
  }
  EXPECT_LT((over_k(10 * high) * 1000 - over_k(high)).norm(), 1e-12 * over_k(high).norm());
}

TEST(DiffractionLoad, IsThatOfEveryWaveOfTheSea) {
  support::Random random(5);
  const RadiationData data = some_data(random, 11, 5);
  const DiffractionLoad load(data);
  const Sea sea =
      sea_of(data, {{0.3, 0.2, 0.1, 1.7, 0.4}, {0.1, -0.5, 0.6, 2.9, 2}, {0.2, 0, 0, 0, 0}});
  const double psi = 0.8, time = 12.3;
  const BodyState state = state_of(data, psi, {3, -5, 0.7});
  Vector6d expected = Vector6d::Zero();
  const auto& waves = std::get<WaveSurface>(sea.surface).components;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& w = waves[i];
    const double theta = w.kx * 3 - w.ky * 5 - w.omega * time + w.phase;
    const double sigma = std::sqrt(sea.gravity * std::hypot(w.kx, w.ky));
    const Vector6cd X = load.coefficients(sigma, std::atan2(w.ky, w.kx) - psi);
    expected += sea.density * w.amplitude * w.omega / sigma * (X * std::polar(1.0, theta)).real();
  }
  Vector6d in_W;
  in_W << turn(psi) * Vector3d(expected.head<3>()), turn(psi) * Vector3d(expected.tail<3>());
  EXPECT_LT((stacked(load_on(load, data, state, sea, time)) - in_W).norm(), 1e-12 * in_W.norm());
}

TEST(DiffractionLoad, IsTheRateAtWhichTheScatteredWavesLoseTheirMomentum) {
  support::Random random(9);
  const RadiationData data = some_data(random, 12, 3, 7);
  const DiffractionLoad load(data);
  std::vector<hydro::WaveComponent> waves;
  for (const double omega : {0.8, 1.3, 3.1}) {
    const double k = *hydro::wave_number(omega, data.water.depth, data.water.gravity);
    const double direction = random.uniform(0, 2 * M_PI);
    waves.push_back({.amplitude = random.uniform(0.1, 1),
                     .kx = k * std::cos(direction),
                     .ky = k * std::sin(direction),
                     .omega = omega,
                     .phase = random.uniform(0, 6)});
  }
  const Sea sea = sea_of(data, waves);
  const hydro::Twist motion{.linear = {1.2, -0.7, 0.2}, .angular = {0, 0, 0.6}};
  const auto frame_at = [](double later) {
    return hydro::WaveFrame{.R_WH = turn(0.8 + 0.6 * later),
                            .origin = turn(0.6 * later) * Vector3d(0.1, 0.2, -0.3)};
  };
  const auto position_at = [&](double later) -> Vector3d {
    return Vector3d(3, -2, 0.3) + later * motion.linear;
  };
  constexpr double kTime = 2.2, kStep = 1e-3;
  // In axes that turn with H.
  const auto momentum = [&](double later) -> Vector6d {
    const hydro::Wrench p = load.momentum(position_at(later), frame_at(later), sea, kTime + later);
    return stacked(
        {.force = turn(-0.6 * later) * p.force, .moment = turn(-0.6 * later) * p.moment});
  };
  const Vector6d change = momentum(kStep / 2) - momentum(-kStep / 2);
  const Vector6d expected = stacked(load.at(position_at(0), motion, frame_at(0), sea, kTime));
  EXPECT_LT((expected + change / kStep).norm(), tolerance(1e-5) * expected.norm());
}

TEST(DiffractionLoad, TurnsWithBodyAndWaves) {
  support::Random random(6);
  const RadiationData data = some_data(random, 12, 4);
  const DiffractionLoad load(data);
  const Quaterniond tilt(Eigen::AngleAxisd(0.2, Vector3d(3, 1, 0).normalized()));
  const double angle = 2.1;
  const auto load_at = [&](double by) {
    const Vector3d k = turn(by) * Vector3d(0.3, 0.4, 0);
    const Sea sea = sea_of(data, {{0.3, k.x(), k.y(), 2.2, 1}});
    return load_on(load, data,
                   {.position = turn(by) * Vector3d(1, 2, 0.3),
                    .orientation = turn(by) * tilt * turn(0.5) * data.pose.orientation},
                   sea, 0.7);
  };
  const Wrench first = load_at(0), second = load_at(angle);
  EXPECT_LT((turn(angle) * first.force - second.force).norm(), 1e-12 * first.force.norm());
  EXPECT_LT((turn(angle) * first.moment - second.moment).norm(), 1e-12 * first.moment.norm());
}

TEST(DiffractionLoad, DoesNotTurnABodyOfRevolutionAboutItsTiltedAxis) {
  support::Random random(10);
  RadiationData data = some_data(random, 12, 4);
  data.pose.orientation.setIdentity();
  for (hydro::Loads6cd& loads : data.diffraction) loads.row(5).setZero();
  const Quaterniond tilted(Eigen::AngleAxisd(0.3, Vector3d(1, -2, 0).normalized()));
  const Wrench load = load_on(DiffractionLoad(data), data, {.orientation = tilted * turn(0.7)},
                              sea_of(data, {{0.3, 0.2, 0.1, 1.7, 0.4}}), 1.3);
  EXPECT_LT(std::abs(load.moment.dot(tilted * Vector3d::UnitZ())), 1e-14 * load.moment.norm());
}

TEST(DiffractionLoad, ActsAboutTheOriginOfTheFrame) {
  support::Random random(11);
  const RadiationData data = some_data(random, 12, 4);
  const DiffractionLoad load(data);
  const Sea sea = sea_of(data, {{0.3, 0.2, 0.1, 1.7, 0.4}});
  const Vector3d from_centre(0.3, -0.2, 0.5), place(4, 5, 0.6);
  const Wrench about_origin = load.at(place, {}, {.R_WH = turn(0.4)}, sea, 2);
  const Wrench about_centre =
      load.at(place - from_centre, {}, {.R_WH = turn(0.4), .origin = from_centre}, sea, 2);
  EXPECT_LT((about_centre.force - about_origin.force).norm(), 1e-12 * about_origin.force.norm());
  const Vector3d moment = about_origin.moment + from_centre.cross(about_origin.force);
  EXPECT_LT((about_centre.moment - moment).norm(), 1e-12 * moment.norm());
}

TEST(DiffractionLoad, FollowsTheRampAndHasTheFrequencyOfTheWaterThatDrifts) {
  support::Random random(7);
  const RadiationData data = some_data(random, 12, 4);
  const DiffractionLoad load(data);
  Sea sea = sea_of(data, {});
  BodyState state = state_of(data, 0.4, {1, 2, 0});
  auto& surface = std::get<WaveSurface>(sea.surface);
  surface.components = {hydro::linear_wave(sea, 0.2, 0.3, 0.9, 0.1)};
  const Vector6d still = stacked(load_on(load, data, state, sea, 0));
  // Without a time that passes, the current changes the frequency at the spot alone.
  sea.current = {1.5, -0.5, 0};
  surface.components = {hydro::linear_wave(sea, 0.2, 0.3, 0.9, 0.1)};
  state.linear_velocity = sea.current;
  EXPECT_LT((stacked(load_on(load, data, state, sea, 0)) - still).norm(), 1e-14 * still.norm());
  state.linear_velocity.setZero();
  surface.ramp = 8;
  EXPECT_TRUE(stacked(load_on(load, data, state, sea, 0)).isZero(0));
  const Vector6d whole = stacked(load_on(load, data, state, sea, 8));
  const Vector6d half = stacked(load_on(load, data, state, sea, 4));
  surface.ramp = 0;
  EXPECT_EQ(stacked(load_on(load, data, state, sea, 8)), whole);
  EXPECT_LT((2 * half - stacked(load_on(load, data, state, sea, 4))).norm(), 1e-14 * whole.norm());
}

TEST(DiffractionLoad, IsZeroWithoutAiryWavesOrHeadings) {
  support::Random random(8);
  RadiationData data = some_data(random, 6, 2);
  Sea sea = sea_of(data, {{0.3, 0.2, 0.1, 1.7, 0.4}});
  std::get<WaveSurface>(sea.surface).kinematics = hydro::Kinematics::hydrostatic;
  EXPECT_TRUE(stacked(DiffractionLoad(data).at({}, {}, {}, sea, 1)).isZero(0));
  EXPECT_TRUE(stacked(DiffractionLoad(data).at({}, {}, {}, Sea{}, 1)).isZero(0));
  data.headings.clear();
  std::get<WaveSurface>(sea.surface).kinematics = hydro::Kinematics::airy;
  EXPECT_TRUE(stacked(DiffractionLoad(data).at({}, {}, {}, sea, 1)).isZero(0));
}

TEST(DiffractionLoad, RefusesHeadingsThatAreNotEven) {
  support::Random random(9);
  RadiationData data = some_data(random, 6, 2);
  data.headings[2] += 0.01;
  EXPECT_THROW(DiffractionLoad{data}, std::invalid_argument);
  data = some_data(random, 6, 2);
  data.headings.pop_back();
  EXPECT_THROW(DiffractionLoad{data}, std::invalid_argument);
  data = some_data(random, 6, 2);
  data.diffraction.pop_back();
  EXPECT_THROW(DiffractionLoad{data}, std::invalid_argument);
}

/// −∫ g e^{kz} e^{ik·x} N dS over the faces of a mesh below the water, by one point a face.
Vector6cd froude_krylov(const hydro::TriMesh& mesh_H, double height, double gravity, double k,
                        double heading) {
  Vector6cd load = Vector6cd::Zero();
  for (Eigen::Index f = 0; f < mesh_H.face_count(); ++f) {
    Vector3d r = Vector3d::Zero();
    for (int i = 0; i < 3; ++i) r += mesh_H.vertices.col(mesh_H.faces(i, f)) / 3;
    const double z = r.z() + height;
    if (z > 0) continue;
    const Vector3d a = hydro::area_vector(mesh_H, f);
    const Complex p =
        gravity *
        std::exp(Complex(k * z, k * (r.x() * std::cos(heading) + r.y() * std::sin(heading))));
    load.head<3>() -= p * a;
    load.tail<3>() -= p * r.cross(a);
  }
  return load;
}

// With the pressure of the undisturbed wave in the place of the diffraction, the load is what small
// waves change of the buoyancy.
TEST(DiffractionLoad, HasThePhaseOfThePressureOfTheWave) {
  const double height = 0.125, heading = 0.7, gravity = 9.82, amplitude = 1e-5;
  // Faces end at the water, which is 4 of 32 rows below the middle.
  const hydro::TriMesh box = hydro::make_box({2, 0.8, 1}, 32);
  RadiationData data;
  data.pose.height = height;
  data.water.gravity = gravity;
  data.frequencies = {1, 2, 3};
  for (int j = 0; j < 24; ++j) data.headings.push_back(2 * M_PI * j / 24);
  for (const double omega : data.frequencies) {
    auto& loads = data.diffraction.emplace_back(6, 24);
    for (Eigen::Index j = 0; j < 24; ++j)
      loads.col(j) = froude_krylov(box, height, gravity, omega * omega / gravity,
                                   data.headings[static_cast<std::size_t>(j)]);
  }
  const DiffractionLoad load(data);
  const hydro::Hull hull = hydro::make_hull(box);
  const hydro::Coefficients coefficients;
  const BodyState state{.position = {1.3, -0.4, height}, .orientation = turn(heading)};
  Sea still{.gravity = gravity};
  for (const double beta : {0.2, 2.0, -2.5}) {
    Sea sea = still;
    sea.surface =
        WaveSurface{.components = {hydro::linear_wave(sea, amplitude, 4 / gravity, beta, 0.3)}};
    for (const double time : {0.0, 0.4, 1.1}) {
      const Vector6d change =
          stacked(hydro::compute_loads(hull, state, sea, time, coefficients,
                                       {.branches = true, .wave_tolerance = 0})
                      .buoyancy) -
          stacked(hydro::compute_loads(hull, state, still, time, coefficients).buoyancy);
      const Vector6d expected = stacked(load_on(load, data, state, sea, time));
      // One point a face of 1/16 of the draught is wrong by some 1e-3.
      EXPECT_LT((change - expected).norm(), tolerance(3e-3) * 1000 * gravity * 1.6 * amplitude)
          << change.transpose() << "\n"
          << expected.transpose();
    }
  }
}

}  // namespace

#include "hydro/radiation/linear_response.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/radiating_sphere.h"

namespace {

using Complex = std::complex<double>;
using hydro::LinearBody;
using hydro::Matrix6cd;
using hydro::Matrix6d;
using hydro::RadiationData;
using hydro::Vector6cd;

const Complex kI(0, 1);

/// A sphere of radius 1 that floats half submerged.
LinearBody sphere_afloat(const RadiationData& data) {
  LinearBody body;
  body.inertia = data.infinite_added_mass;
  body.inertia.topLeftCorner<3, 3>() += data.volume * Eigen::Matrix3d::Identity();
  body.inertia.bottomRightCorner<3, 3>() += 0.4 * data.volume * Eigen::Matrix3d::Identity();
  body.stiffness(2, 2) = hydro::LinearWater().gravity * M_PI;
  return body;
}

Matrix6d random_positive(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Matrix6d root = Matrix6d::NullaryExpr([&] { return normal(random); });
  return root * root.transpose();
}

/// The left side of (1) without ξ.
Matrix6cd dynamic_stiffness(const LinearBody& body, const Matrix6cd& memory, double omega) {
  return -omega * omega * body.inertia.cast<Complex>() -
         kI * omega * (body.damping + memory.conjugate()) + body.stiffness;
}

TEST(LinearResponse, OfASphereFollowsFromItsAddedMassAndDamping) {
  const RadiationData data = support::radiating_sphere(1);
  const LinearBody body = sphere_afloat(data);
  const hydro::RadiationMemory memory = hydro::fit_memory(data);
  const Vector6cd load = Vector6cd::Unit(2) * Complex(2, -1);
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    const double omega = data.frequencies[f];
    const Vector6cd motion =
        hydro::linear_response(body, hydro::response(memory, omega), omega, load);
    const Complex heave =
        load[2] / (-omega * omega * (data.volume + data.added_mass[f](2, 2)) -
                   kI * omega * data.damping[f](2, 2) + hydro::LinearWater().gravity * M_PI);
    // The fit of the oscillators is within 0.4 % of the largest response.
    EXPECT_NEAR(std::abs(motion[2] - heave) / std::abs(heave), 0, 0.02) << omega;
    EXPECT_EQ(motion[0], Complex(0));
    // The load does the work that the waves take away.
    EXPECT_GT((load[2] * std::conj(-kI * omega * motion[2])).real(), 0);
  }
}

TEST(LinearResponse, IsTheSteadyMotionOfTheOscillatorsInTime) {
  const RadiationData data = support::radiating_sphere(1);
  const LinearBody body = sphere_afloat(data);
  const hydro::RadiationMemory memory = hydro::fit_memory(data);
  const double omega = 2.5, mass = body.inertia(2, 2), stiffness = body.stiffness(2, 2);
  const Eigen::VectorXd port = memory.port.col(2), squares = memory.frequencies.cwiseAbs2();
  // z'' = (cos ωt − C z − bᵀq')/(M + A∞) and q'' = b z' − D q' − Ω² q, by the midpoint's rule.
  const auto m = memory.size();
  Eigen::VectorXd state = Eigen::VectorXd::Zero(2 + 2 * m);
  const auto rate = [&](const Eigen::VectorXd& s, double t) {
    const auto q = s.segment(2, m), v = s.segment(2 + m, m);
    Eigen::VectorXd r(s.size());
    r[0] = s[1];
    r[1] = (std::cos(omega * t) - stiffness * s[0] - port.dot(v)) / mass;
    r.segment(2, m) = v;
    r.segment(2 + m, m) = port * s[1] - memory.damping.cwiseProduct(v) - squares.cwiseProduct(q);
    return r;
  };
  const int per_period = 1000, periods = 30;
  const double step = 2 * M_PI / omega / per_period;
  Complex amplitude = 0;  // Of z = Re{amplitude e^{−iωt}}, by the last period.
  for (int i = 0; i < periods * per_period; ++i) {
    const double t = i * step;
    if (i >= (periods - 1) * per_period)
      amplitude += 2.0 / per_period * state[0] * std::exp(kI * omega * t);
    const Eigen::VectorXd middle = state + step / 2 * rate(state, t);
    state += step * rate(middle, t + step / 2);
  }
  const Vector6cd motion = hydro::linear_response(body, hydro::response(memory, omega), omega,
                                                  Vector6cd(Vector6cd::Unit(2)));
  // What is left of the start and the error of the steps.
  EXPECT_LT(std::abs(motion[2] - amplitude), 1e-3 * std::abs(amplitude));
}

TEST(LinearResponse, SolvesTheEquationsOfTheFreeMotionsAlone) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  LinearBody body{.inertia = random_positive(random),
                  .damping = random_positive(random),
                  .stiffness = random_positive(random)};
  const Matrix6cd memory = random_positive(random) + kI * random_positive(random);
  const Vector6cd load =
      Vector6cd::NullaryExpr([&] { return Complex(normal(random), normal(random)); });
  const double omega = 1.3;
  const Matrix6cd Z = dynamic_stiffness(body, memory, omega);
  EXPECT_LT((Z * hydro::linear_response(body, memory, omega, load) - load).norm(), 1e-9);
  body.locked = {true, false, false, true, false, true};
  const Vector6cd held = hydro::linear_response(body, memory, omega, load);
  for (const int i : {0, 3, 5}) EXPECT_EQ(held[i], Complex(0));
  const Vector6cd left = Z * held - load;
  for (const int i : {1, 2, 4}) EXPECT_LT(std::abs(left[i]), 1e-9);
  body.locked.fill(true);
  EXPECT_EQ(hydro::linear_response(body, memory, omega, load), Vector6cd(Vector6cd::Zero()));
}

TEST(NaturalModes, OfTwoCoupledMotionsAreThoseOfTheirQuadraticEquation) {
  // Sway, without restoring, and roll, coupled by inertia: sway follows freely, so that the roll
  // has the inertia I − p²/m, and heave is by itself.
  LinearBody body;
  body.inertia = Matrix6d::Identity();
  body.inertia.diagonal() << 5, 4, 3, 7, 6, 9;
  body.inertia(1, 3) = body.inertia(3, 1) = 2;
  body.stiffness.diagonal() << 0, 0, 12, 24, -5, 0;
  const auto modes = hydro::natural_modes(body);
  ASSERT_EQ(modes.size(), 2);
  EXPECT_NEAR(modes[0].frequency, 2, 1e-14);
  EXPECT_NEAR(modes[1].frequency, std::sqrt(24.0 / (7 - 4.0 / 4)), 1e-14);
  // ½ C q² = 1, and the momentum of sway is zero.
  EXPECT_NEAR(std::abs(modes[1].shape[3]), std::sqrt(2 / 24.0), 1e-14);
  EXPECT_NEAR(modes[1].shape[1], -2.0 / 4 * modes[1].shape[3], 1e-14);
  EXPECT_NEAR(std::abs(modes[0].shape[2]), std::sqrt(2 / 12.0), 1e-14);
  body.locked = {false, true, false, false, false, false};
  EXPECT_NEAR(hydro::natural_modes(body)[1].frequency, 2, 1e-14) << "of heave: roll has 24/7";
  EXPECT_NEAR(hydro::natural_modes(body)[0].frequency, std::sqrt(24.0 / 7), 1e-14);
}

TEST(NaturalModes, HaveTheAddedMassOfTheirOwnFrequency) {
  // With the excess a/(1 + ω²) over the inertia m, ω² (m + a/(1 + ω²)) = C is a quadratic equation
  // for x = ω²: m x² + (m + a − C) x − C = 0.
  const double m = 2, a = 3, C = 17;
  LinearBody body{.inertia = m * Matrix6d::Identity()};
  body.stiffness(2, 2) = C;
  const auto modes = hydro::natural_modes(
      body, [&](double omega) { return Matrix6d(a / (1 + omega * omega) * Matrix6d::Identity()); });
  const double b = m + a - C;
  ASSERT_EQ(modes.size(), 1);
  EXPECT_NEAR(modes[0].frequency, std::sqrt((-b + std::sqrt(b * b + 4 * m * C)) / (2 * m)), 1e-13);
}

TEST(NaturalModes, OfARandomBodySolveTheirEquation) {
  std::mt19937 random(11);
  const LinearBody body{.inertia = random_positive(random), .stiffness = random_positive(random)};
  const Matrix6d more = random_positive(random);
  const auto excess = [&](double omega) { return Matrix6d(more / (1 + omega)); };
  const auto modes = hydro::natural_modes(body, excess);
  ASSERT_EQ(modes.size(), 6);
  for (const hydro::NaturalMode& mode : modes) {
    const double square = mode.frequency * mode.frequency;
    const hydro::Vector6d left =
        body.stiffness * mode.shape - square * (body.inertia + excess(mode.frequency)) * mode.shape;
    EXPECT_LT(left.norm(), 1e-10 * (body.stiffness * mode.shape).norm());
  }
}

TEST(NaturalModes, OfAHeavingSphereAreWhereItsReactanceVanishes) {
  const RadiationData data = support::radiating_sphere(1);
  const hydro::RadiationMemory memory = hydro::fit_memory(data);
  const auto modes = hydro::natural_modes(sphere_afloat(data), [&](double omega) {
    return hydro::memory_mass(hydro::response(memory, omega), omega);
  });
  ASSERT_EQ(modes.size(), 1);
  const double omega = modes[0].frequency;
  const auto f = static_cast<std::size_t>(std::ranges::lower_bound(data.frequencies, omega) -
                                          data.frequencies.begin());
  ASSERT_GT(f, 0);
  ASSERT_LT(f, data.frequencies.size());
  const double A = std::lerp(
      data.added_mass[f - 1](2, 2), data.added_mass[f](2, 2),
      (omega - data.frequencies[f - 1]) / (data.frequencies[f] - data.frequencies[f - 1]));
  // The fit of the oscillators and the straight line between two points are within 1 % of each
  // other.
  EXPECT_NEAR(omega * omega * (data.volume + A) / (hydro::LinearWater().gravity * M_PI), 1, 0.01);
  EXPECT_NEAR(omega * omega / hydro::LinearWater().gravity, 1.055, 0.01);  // kR
}

TEST(LinearResponse, TurnsWithItsFrame) {
  const Matrix6d turn = hydro::turn_of_heading(0.7);
  EXPECT_NEAR((turn * hydro::Vector6d::Unit(3))[4], std::sin(0.7), 1e-15);
  EXPECT_NEAR((turn * turn.transpose() - Matrix6d::Identity()).norm(), 0, 1e-14);
}

}  // namespace

#include "hydro/radiation/radiation_memory.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <stdexcept>

#include "tests/support/radiating_sphere.h"
#include "tests/support/tolerance.h"

namespace {

using hydro::Matrix6cd;
using hydro::Matrix6d;
using hydro::RadiationData;
using hydro::RadiationMemory;
using support::radiating_sphere;
using support::tolerance;

/// A spar of radius 1 m and draught 2 m in surge and pitch about a point 1.2 m below the water, by
/// tools/validation/potential_flow.py: spar(1, 2, 16, 8).
RadiationData radiating_spar() {
  struct Row {
    double frequency, A11, A15, A55, B11, B15, B55;
  };
  constexpr Row kRows[] = {
      {0.442869, 4.698871, 1.490992, 1.318228, 0.000103, 0.000033, 0.000011},
      {0.700237, 4.775557, 1.527510, 1.336589, 0.002430, 0.000804, 0.000266},
      {0.990285, 4.927310, 1.598809, 1.371829, 0.025597, 0.008734, 0.002977},
      {1.291174, 5.178908, 1.718273, 1.430837, 0.149295, 0.053180, 0.018927},
      {1.627205, 5.561930, 1.911744, 1.530337, 0.661381, 0.250171, 0.094569},
      {1.980571, 5.926395, 2.135315, 1.661622, 2.164940, 0.882770, 0.359837},
      {2.364274, 5.818230, 2.199434, 1.751508, 5.368160, 2.400588, 1.073543},
      {2.800950, 4.649902, 1.758285, 1.615151, 9.361754, 4.688703, 2.349256},
      {3.284405, 3.053082, 0.948342, 1.228338, 10.696299, 6.085958, 3.465541},
      {3.835359, 2.108796, 0.312897, 0.832273, 9.029591, 5.894254, 3.851636},
      {4.428691, 1.882243, 0.032271, 0.582333, 6.608583, 4.905398, 3.644411},
      {5.145673, 1.984619, -0.033896, 0.449525, 4.395482, 3.688666, 3.093266},
      {6.023670, 2.173673, -0.002788, 0.392818, 2.583213, 2.491980, 2.314418},
      {7.002375, 2.401052, 0.115443, 0.442432, 1.775652, 1.762406, 1.757784},
  };
  const auto matrix = [](double m11, double m15, double m55) {
    Matrix6d result = Matrix6d::Zero();
    result(0, 0) = m11;
    result(0, 4) = result(4, 0) = m15;
    result(4, 4) = m55;
    return result;
  };
  RadiationData data{.volume = 2 * M_PI};
  for (const Row& row : kRows) {
    data.frequencies.push_back(row.frequency);
    data.added_mass.push_back(matrix(row.A11, row.A15, row.A55));
    data.damping.push_back(matrix(row.B11, row.B15, row.B55));
  }
  data.infinite_added_mass = matrix(2.980188, 0.500365, 0.705985);
  return data;
}

/// Least eigenvalue of Re Ĥ over its largest entry, over frequencies far beyond the data.
double least_damping(const RadiationMemory& memory) {
  double least = 0, largest = 0;
  for (double frequency = 1e-3; frequency < 1e3; frequency *= 1.02) {
    const Matrix6d damping = response(memory, frequency).real();
    least = std::min(least, Eigen::SelfAdjointEigenSolver<Matrix6d>(damping).eigenvalues()[0]);
    largest = std::max(largest, damping.cwiseAbs().maxCoeff());
  }
  return least / largest;
}

TEST(RadiationMemory, OfASphereIsNearTheData) {
  const RadiationData data = radiating_sphere(1);
  const RadiationMemory memory = fit_memory(data);
  // What the data, with its panels and its gap at an irregular frequency, lets a passive body have.
  EXPECT_LT(memory.rms_error.maxCoeff(), 0.0026);
  EXPECT_LT(memory.largest_error.maxCoeff(), 0.0047);
  // At kR = 0.8, which is a frequency of the data.
  const Matrix6cd H = response(memory, 2.800950);
  EXPECT_NEAR(H(2, 2).real(), 1.707141, 0.003);
  EXPECT_NEAR(H(2, 2).imag(), 2.800950 * (0.986429 - 1.049240), 0.003);
  // An oscillator of one motion does not act on another motion.
  EXPECT_EQ(H(0, 2), 0.0);
  EXPECT_TRUE(memory.port.rightCols<3>().isZero(0));
}

TEST(RadiationMemory, ErrorsAreThoseOfItsResponse) {
  const RadiationData data = radiating_spar();
  const RadiationMemory memory = fit_memory(data);
  double square = 0, largest = 0, surge = 0, pitch = 0;
  for (std::size_t k = 0; k < data.frequencies.size(); ++k) {
    Matrix6cd H = data.damping[k].cast<std::complex<double>>();
    H.imag() = data.frequencies[k] * (data.added_mass[k] - data.infinite_added_mass);
    const double off = std::abs(response(memory, data.frequencies[k])(0, 4) - H(0, 4));
    square += off * off / static_cast<double>(data.frequencies.size());
    largest = std::max(largest, off);
    surge = std::max(surge, std::abs(H(0, 0)));
    pitch = std::max(pitch, std::abs(H(4, 4)));
  }
  EXPECT_NEAR(memory.rms_error(0, 4), std::sqrt(square / (surge * pitch)), 1e-12);
  EXPECT_NEAR(memory.largest_error(0, 4), largest / std::sqrt(surge * pitch), 1e-12);
}

TEST(RadiationMemory, CouplesSurgeAndPitch) {
  const RadiationMemory memory = fit_memory(radiating_spar());
  EXPECT_LT(memory.rms_error.maxCoeff(), 0.0065);
  EXPECT_LT(memory.largest_error.maxCoeff(), 0.015);
  EXPECT_GT(response(memory, 3.284405)(0, 4).real(), 6);
}

TEST(RadiationMemory, IsPassiveAtEveryFrequency) {
  EXPECT_GT(least_damping(fit_memory(radiating_sphere(1))), -1e-14);
  EXPECT_GT(least_damping(fit_memory(radiating_spar())), -1e-14);
  // Data that is not: the damping of some frequencies is negative.
  RadiationData data = radiating_sphere(1);
  for (std::size_t k = 0; k < data.frequencies.size(); k += 3) data.damping[k] *= -0.5;
  EXPECT_GT(least_damping(fit_memory(data)), -1e-14);
}

TEST(RadiationMemory, IsNotSpoiltByShortWaves) {
  // The added mass that a solver finds at an irregular frequency.
  RadiationData data = radiating_sphere(1);
  const Matrix6cd sound = response(fit_memory(data), 2.800950);
  data.added_mass.back()(2, 2) += 0.2;
  const Matrix6cd spoilt = response(fit_memory(data), 2.800950);
  EXPECT_GT(0.2 * data.frequencies.back(), 0.6 * std::abs(sound(2, 2)));
  EXPECT_LT(std::abs(spoilt(2, 2) - sound(2, 2)), 0.02 * std::abs(sound(2, 2)));
}

/// Largest difference of two responses over the largest entry, at frequencies in the data and
/// beyond.
double difference(const RadiationMemory& a, const RadiationMemory& b, double size = 1) {
  const double rate = 1 / std::sqrt(size);
  double off = 0, largest = 0;
  for (double frequency = 0.1; frequency < 20; frequency *= 1.01) {
    const Matrix6cd H = response(a, frequency);
    const Matrix6cd other = response(b, rate * frequency) / (std::pow(size, 3) * rate);
    off = std::max(off, (other - H).cwiseAbs().maxCoeff());
    largest = std::max(largest, H.cwiseAbs().maxCoeff());
  }
  return off / largest;
}

// Nothing of the fit has a size: what is left is round-off.
TEST(RadiationMemory, DoesNotDependOnTheBodysSize) {
  const RadiationMemory one = fit_memory(radiating_sphere(1));
  for (const double radius : {1e-3, 100.0})
    EXPECT_LT(difference(one, fit_memory(radiating_sphere(radius)), radius), tolerance(1e-9));
}

/// The data of a body without symmetry, all of whose motions act on each other.
RadiationData radiating_lump() {
  RadiationData data = radiating_sphere(1);
  Matrix6d mix = Matrix6d::Identity();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) mix(i, j) += 0.3 * std::sin(1 + 2 * i + 5 * j);
  for (std::size_t k = 0; k < data.frequencies.size(); ++k)
    for (Matrix6d* matrix : {&data.added_mass[k], &data.damping[k]}) {
      matrix->bottomRightCorner<3, 3>() = 0.5 * matrix->topLeftCorner<3, 3>();
      *matrix = mix * *matrix * mix.transpose();
    }
  Matrix6d& infinite = data.infinite_added_mass;
  infinite.bottomRightCorner<3, 3>() = 0.5 * infinite.topLeftCorner<3, 3>();
  infinite = mix * infinite * mix.transpose();
  return data;
}

// Products of matrices are divided by the sizes of the processor's caches, and so their sums are
// rounded differently on different processors.
TEST(RadiationMemory, IsTheSameOnProcessorsWithOtherCaches) {
  const auto fit = [](std::ptrdiff_t first_cache, const RadiationData& data) {
    Eigen::setCpuCacheSizes(first_cache, 2 << 20, 32 << 20);
    return fit_memory(data);
  };
  const std::ptrdiff_t l1 = Eigen::l1CacheSize(), l2 = Eigen::l2CacheSize(),
                       l3 = Eigen::l3CacheSize();
  for (const RadiationData& data : {radiating_sphere(1), radiating_spar(), radiating_lump()}) {
    const RadiationMemory small = fit(32 << 10, data), large = fit(48 << 10, data);
    EXPECT_LT(difference(small, large), 1e-9);
  }
  Eigen::setCpuCacheSizes(l1, l2, l3);
}

// Data that differs in its last digits, as a solver's does between two processors.
TEST(RadiationMemory, DependsSmoothlyOnTheData) {
  RadiationData data = radiating_spar();
  const RadiationMemory one = fit_memory(data);
  for (std::size_t k = 0; k < data.frequencies.size(); ++k) {
    data.damping[k] *= 1 + 1e-12 * std::sin(7.0 * static_cast<double>(k));
    data.added_mass[k] *= 1 + 1e-12 * std::sin(3.0 * static_cast<double>(k));
  }
  EXPECT_LT(difference(one, fit_memory(data)), 1e-9);
}

TEST(RadiationMemory, IsTheSameEachTime) {
  const RadiationMemory a = fit_memory(radiating_spar()), b = fit_memory(radiating_spar());
  EXPECT_EQ(a.frequencies, b.frequencies);
  EXPECT_EQ(a.damping, b.damping);
  EXPECT_EQ(a.port, b.port);
}

TEST(RadiationMemory, IsNoneWithoutWaves) {
  RadiationData data{.frequencies = {1, 2}, .added_mass = {2, Matrix6d::Identity()}};
  data.damping = {2, Matrix6d::Zero()};
  data.infinite_added_mass.setIdentity();
  EXPECT_EQ(fit_memory(data).size(), 0);
  EXPECT_TRUE(response(fit_memory(data), 1).isZero(0));
}

TEST(RadiationMemory, OfOneFrequencyIsExactThere) {
  const RadiationData all = radiating_sphere(1);
  const RadiationData data{.frequencies = {all.frequencies[7]},
                           .added_mass = {all.added_mass[7]},
                           .damping = {all.damping[7]},
                           .infinite_added_mass = all.infinite_added_mass};
  const RadiationMemory memory = fit_memory(data);
  EXPECT_GT(memory.size(), 0);
  EXPECT_LT(memory.largest_error.maxCoeff(), 0.003);
}

TEST(RadiationMemory, RefusesDataWithoutSense) {
  EXPECT_THROW(hydro::fit_memory({}), std::invalid_argument);
  RadiationData data = radiating_sphere(1);
  std::swap(data.frequencies[2], data.frequencies[3]);
  EXPECT_THROW(fit_memory(data), std::invalid_argument);
  data = radiating_sphere(1);
  data.damping.pop_back();
  EXPECT_THROW(fit_memory(data), std::invalid_argument);
  data = radiating_sphere(1);
  data.added_mass[1](2, 2) = std::nan("");
  EXPECT_THROW(fit_memory(data), std::invalid_argument);
}

}  // namespace

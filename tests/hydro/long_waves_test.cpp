#include "hydro/radiation/long_waves.h"

#include <gtest/gtest.h>

#include "hydro/airy_waves.h"
#include "hydro/radiation/diffraction_load.h"
#include "tests/support/radiating_sphere.h"

namespace {

using hydro::Loads6cd;
using hydro::RadiationData;
using hydro::Vector6cd;
using Complex = std::complex<double>;

constexpr double kHeading = M_PI / 2;

/// u_w in deep water of a wave that travels along an axis.
Vector6cd water_velocity(double frequency, double heading) {
  Vector6cd u = Vector6cd::Zero();
  u.head<3>() << frequency * std::cos(heading), frequency * std::sin(heading),
      Complex(0, -frequency);
  return u;
}

/// A sphere for which the waves have a constant velocity over its draught.
RadiationData small_sphere() {
  RadiationData data = support::radiating_sphere(1);
  data.headings = {0, kHeading, 2 * kHeading, 3 * kHeading};
  for (std::size_t i = 0; i < data.frequencies.size(); ++i) {
    Loads6cd loads(6, 4);
    for (Eigen::Index j = 0; j < 4; ++j)
      loads.col(j) =
          (data.damping[i].cast<Complex>() - Complex(0, data.frequencies[i]) * data.added_mass[i]) *
          water_velocity(data.frequencies[i], data.headings[static_cast<std::size_t>(j)]);
    data.diffraction.push_back(loads);
  }
  return data;
}

/// The load of the memory and A∞ on a body that moves as the water, and that of scattered waves.
Vector6cd load_on_follower(const RadiationData& data, const hydro::RadiationMemory& memory,
                           const RadiationData& scattering, double frequency) {
  const hydro::Matrix6cd H =
      response(memory, frequency).conjugate() - Complex(0, frequency) * data.infinite_added_mass;
  return hydro::DiffractionLoad(scattering).coefficients(frequency, kHeading) -
         H * water_velocity(frequency, kHeading);
}

TEST(LongWaves, LeaveABodyThatFollowsThemAlone) {
  const RadiationData data = small_sphere();
  const hydro::RadiationMemory memory = fit_memory(data);
  const RadiationData balanced = balanced_diffraction(data, memory);
  const double lowest = data.frequencies[0];
  // The loads are some of those of the displaced water. The fit, and a line below the lowest
  // frequency, would leave a few parts in a hundred of them.
  for (const double part : {0.03, 0.1, 0.3, 0.45, 0.6, 0.8, 1.0}) {
    const double frequency = part * lowest;
    const double scale = 2 * M_PI / 3 * frequency * frequency;
    const double tolerance = part < 0.6 ? 3e-3 : 2e-3;  // Below, the outermost oscillators end.
    EXPECT_LT(load_on_follower(data, memory, balanced, frequency).norm() / scale, tolerance)
        << frequency;
  }
}

/// At the surface of shallow water the horizontal velocity is gk/ω, 1/tanh kh of the vertical one.
TEST(LongWaves, AreOfShallowWaterToo) {
  RadiationData data = small_sphere();
  data.water.depth = 2;
  for (std::size_t i = 0; i < data.frequencies.size(); ++i) {
    const double frequency = data.frequencies[i];
    const double k = *hydro::wave_number(frequency, 2, data.water.gravity);
    data.diffraction[i].topRows<2>() *= data.water.gravity * k / (frequency * frequency);
  }
  const hydro::RadiationMemory memory = fit_memory(data);
  const RadiationData balanced = balanced_diffraction(data, memory);
  const double lowest = data.frequencies[0];
  for (const double frequency : {0.1 * lowest, 0.6 * lowest, lowest}) {
    const double speed =
        data.water.gravity * *hydro::wave_number(frequency, 2, data.water.gravity) / frequency;
    const Vector6cd own = (response(memory, frequency).conjugate() -
                           Complex(0, frequency) * data.infinite_added_mass) *
                          Vector6cd(speed * Vector6cd::Unit(1));
    const Vector6cd load = hydro::DiffractionLoad(balanced).coefficients(frequency, kHeading);
    EXPECT_NEAR(std::abs(load[1] - own[1]) / std::abs(own[1]), 0, 5e-3) << frequency;
  }
}

TEST(LongWaves, DampAsHaskindsRelationSays) {
  const RadiationData data = support::radiating_sphere(1);
  const hydro::RadiationMemory memory = fit_memory(data);
  const double lowest = data.frequencies[0], damping = data.damping[0](2, 2);
  for (const double part : {0.6, 0.7, 0.8, 0.9})
    EXPECT_NEAR(response(memory, part * lowest)(2, 2).real() / damping, std::pow(part, 3), 0.08)
        << part;
}

TEST(LongWaves, OfOneFrequencyAreNotContinued) {
  RadiationData data = small_sphere();
  data.frequencies.resize(1);
  data.added_mass.resize(1);
  data.damping.resize(1);
  data.diffraction.resize(1);
  EXPECT_EQ(with_long_waves(data).frequencies, data.frequencies);
}

}  // namespace

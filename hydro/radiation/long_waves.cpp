#include "hydro/radiation/long_waves.h"

#include <cmath>

#include "hydro/radiation/incident_wave.h"

namespace hydro {
namespace {

using Complex = std::complex<double>;

constexpr int kPerOctave = 4;  ///< Lower frequencies that are added.
constexpr int kOctaves = 1;    ///< To which the memory is fitted.
/// The diffraction is balanced below them, too, where the outermost oscillators end.
constexpr int kBalancedOctaves = 4;

/// u_w of (1), a column for each heading.
Loads6cd water_velocities(const IncidentWave& wave, const std::vector<double>& headings) {
  Loads6cd result = Loads6cd::Zero(6, static_cast<Eigen::Index>(headings.size()));
  for (Eigen::Index j = 0; j < result.cols(); ++j) {
    const double heading = headings[static_cast<std::size_t>(j)];
    result.col(j).head<3>() << std::cos(heading), std::sin(heading), Complex(0, -wave.rise(0));
  }
  return wave.gravity * wave.k / wave.omega * result;
}

/// B − iωA
Matrix6cd load_of_relative_velocity(const RadiationData& data, std::size_t i) {
  return data.damping[i].cast<Complex>() - Complex(0, data.frequencies[i]) * data.added_mass[i];
}

/// The same of the memory.
Matrix6cd load_of_relative_velocity(const RadiationData& data, const RadiationMemory& memory,
                                    double frequency) {
  return response(memory, frequency).conjugate() - Complex(0, frequency) * data.infinite_added_mass;
}

/// Puts (2) at a lower frequency before the result.
void continue_to(double frequency, const RadiationData& data, RadiationData& result) {
  const IncidentWave first(data.frequencies[0], data.water), wave(frequency, data.water);
  const double part = wave.omega * wave.k / (first.omega * first.k);
  result.frequencies.insert(result.frequencies.begin(), frequency);
  result.added_mass.insert(result.added_mass.begin(), data.added_mass[0]);
  result.damping.insert(result.damping.begin(), part * data.damping[0]);
  if (data.diffraction.empty()) return;
  const Loads6cd rest = data.diffraction[0] -
                        load_of_relative_velocity(data, 0) * water_velocities(first, data.headings);
  result.diffraction.insert(
      result.diffraction.begin(),
      std::pow(wave.k / first.k, 2) * rest +
          load_of_relative_velocity(result, 0) * water_velocities(wave, data.headings));
}

/// The data with (2) before it.
RadiationData continued(const RadiationData& data, int octaves) {
  RadiationData result = data;
  result.froude_krylov.clear();
  if (data.frequencies.size() < 2) return result;
  for (int step = 1; step <= kPerOctave * octaves; ++step)
    continue_to(data.frequencies[0] * std::exp2(-step / double{kPerOctave}), data, result);
  return result;
}

}  // namespace

RadiationData with_long_waves(const RadiationData& data) { return continued(data, kOctaves); }

RadiationData balanced_diffraction(const RadiationData& data, const RadiationMemory& memory) {
  RadiationData result = continued(data, kBalancedOctaves);
  for (std::size_t i = 0; i < result.diffraction.size(); ++i) {
    const IncidentWave wave(result.frequencies[i], data.water);
    const Matrix6cd difference =
        load_of_relative_velocity(data, memory, wave.omega) - load_of_relative_velocity(result, i);
    result.diffraction[i] +=
        wave.head(std::cbrt(data.volume)) * difference * water_velocities(wave, data.headings);
  }
  return result;
}

}  // namespace hydro

#include "hydro/radiation/long_waves.h"

#include <cmath>

#include "hydro/radiation/incident_wave.h"

namespace hydro {
namespace {

using Complex = std::complex<double>;

constexpr int kLower = 4;                   ///< Number of frequencies that are added.
const double kRatio = std::pow(2.0, 0.25);  ///< Of one of them to the next [-].

/// u_w of (1), a column for each heading.
Loads6cd water_velocities(const IncidentWave& wave, const std::vector<double>& headings) {
  Loads6cd result = Loads6cd::Zero(6, static_cast<Eigen::Index>(headings.size()));
  for (Eigen::Index j = 0; j < result.cols(); ++j) {
    const double heading = headings[static_cast<std::size_t>(j)];
    result.col(j).head<3>() << wave.omega * std::cos(heading), wave.omega * std::sin(heading),
        Complex(0, -wave.omega * wave.rise(0));
  }
  return result;
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

}  // namespace

RadiationData with_long_waves(const RadiationData& data) {
  RadiationData result = data;
  if (data.frequencies.size() < 2) return result;
  const IncidentWave first(data.frequencies[0], data.water);
  for (int step = 1; step <= kLower; ++step) {
    const IncidentWave wave(first.omega * std::pow(kRatio, -step), data.water);
    const double part = wave.omega * wave.k / (first.omega * first.k);
    result.frequencies.insert(result.frequencies.begin(), wave.omega);
    result.added_mass.insert(result.added_mass.begin(), data.added_mass[0]);
    result.damping.insert(result.damping.begin(), part * data.damping[0]);
    if (data.diffraction.empty()) continue;
    const Loads6cd rest = data.diffraction[0] - load_of_relative_velocity(data, 0) *
                                                    water_velocities(first, data.headings);
    result.diffraction.insert(
        result.diffraction.begin(),
        std::pow(wave.k / first.k, 2) * rest +
            load_of_relative_velocity(result, 0) * water_velocities(wave, data.headings));
  }
  result.froude_krylov.clear();
  return result;
}

RadiationData balanced_diffraction(const RadiationData& data, const RadiationMemory& memory) {
  RadiationData result = with_long_waves(data);
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

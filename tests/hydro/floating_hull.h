#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "hydro/water/simulated_water.h"

/// @file
/// Hulls in simulated water whose motions are given.

namespace support {

/// A hull with its sources.
struct FloatingHull {
  hydro::TriMesh mesh;
  std::shared_ptr<const hydro::HullSources> sources;
  std::shared_ptr<const hydro::FloatingBody> floating;

  hydro::WaterBody in_water() const {
    return {.mesh_B = &mesh,
            .radius = mesh.vertices.colwise().norm().maxCoeff(),
            .hull = sources,
            .floating = floating};
  }
};

inline FloatingHull floating_hull(const hydro::TriMesh& mesh, const hydro::MeanPose& pose,
                                  const hydro::PeriodicSquare& square, const hydro::Sea& sea) {
  FloatingHull hull{.mesh = mesh};
  hull.sources =
      std::make_shared<const hydro::HullSources>(hydro::make_hull_sources(mesh, pose, square));
  hull.floating = hydro::floating_hull(*hull.sources, mesh, sea);
  return hull;
}

/// The complex amplitudes F of the loads Re{F e^{iωt}} on each hull, in H for ρ = 1.
using LoadAmplitudes = std::vector<hydro::Vector6cd>;

/// Runs hulls in `states` while one of them makes the motion sin ωt in one of its modes, or while
/// all are held (`moved` < 0), and returns the loads of the water's waves in the last two periods.
/// @param steps   A period.
inline LoadAmplitudes forced_loads(hydro::SimulatedWater& water,
                                   const std::vector<const FloatingHull*>& hulls,
                                   const std::vector<hydro::BodyState>& states, int moved,
                                   Eigen::Index mode, double omega, int steps, int periods) {
  const double h = 2 * M_PI / omega / steps;
  LoadAmplitudes amplitudes(hulls.size(), hydro::Vector6cd::Zero());
  for (int i = 0; i < steps * periods; ++i) {
    std::vector<hydro::WavesOnHull> waves = water.begin(i * h, h, states);
    std::vector<hydro::Vector6d> ways(hulls.size(), hydro::Vector6d::Zero());
    if (moved >= 0) {
      hydro::Vector6d& way = ways[static_cast<std::size_t>(moved)];
      way[mode] = std::sin(omega * (i + 1) * h) - std::sin(omega * i * h);
      const hydro::HullSources& sources = *hulls[static_cast<std::size_t>(moved)]->sources;
      waves[static_cast<std::size_t>(moved)].load -=
          sources.water.gravity * sources.spring * way / 2;
    }
    water.end(states, ways);
    if (i < steps * (periods - 2)) continue;
    const std::complex<double> turn = std::polar(1.0 / steps, -omega * (i + 0.5) * h);
    for (std::size_t b = 0; b < hulls.size(); ++b) amplitudes[b] += turn * waves[b].load;
  }
  return amplitudes;
}

/// A and B/ω of a load by the motion sin ωt, beyond a constant added mass.
struct AddedMassAndDamping {
  double added_mass, damping_over_omega;
};
inline AddedMassAndDamping coefficients_of(std::complex<double> load, double omega) {
  // F = Re{F̂ e^{iωt}} = A ω² sin ωt − B ω cos ωt.
  return {-load.imag() / (omega * omega), -load.real() / (omega * omega)};
}

}  // namespace support

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/base/reporter.h"
#include "hydro/radiation/diffraction_load.h"
#include "hydro/radiation/linear_response.h"

/// @file
/// The bodies of a scene that make waves as linear theory sees them, and their motions in regular
/// waves (hydro/radiation/linear_response.h).

namespace app {

/// A regular wave on a scene's sea, seen by an observer at rest.
struct RegularWave {
  double period = 0;       ///< [s]
  double heading = 0;      ///< Direction of travel, counter-clockwise from W's x axis [rad].
  double frequency = 0;    ///< ω [rad/s]
  double intrinsic = 0;    ///< σ of airy_waves.h [rad/s].
  double wave_number = 0;  ///< k [rad/m]
};

/// The wave of this period and heading.
/// @throws InputError if the current stops it
RegularWave regular_wave(const hydro::Sea& sea, double period, double heading);

/// A body in its mean pose, over the place of its start.
struct LinearMotions {
  std::string name;
  hydro::LinearBody body;         ///< In W axes.
  hydro::RadiationMemory memory;  ///< In H, for water of density 1.
  std::shared_ptr<const hydro::DiffractionLoad> diffraction;
  hydro::TriMesh mesh_B;
  hydro::MeanPose pose;
  hydro::Sea sea;
  double heading = 0;                 ///< Heading of H in W [rad].
  std::vector<std::string> left_out;  ///< Loads on the body that its numbers leave out.

  /// Motions over the elevation a e^{−iωt} at the centre of mass, along the axes of H: [m/m,
  /// rad/m], a column for each wave. @param waves   All of one heading.
  hydro::Loads6cd in(const std::vector<RegularWave>& waves) const;
};

/// The bodies that make waves, or the one with this name. Their radiation is solved or read from
/// the store.
/// @param file    The scene's, in faults.
/// @param built   With choices of radiation, which need not be solved.
/// @param only    Name of a body; empty: all.
/// @throws InputError if there is no such body, with the reason why it makes no waves
std::vector<LinearMotions> linear_motions(const std::filesystem::path& file,
                                          const assembly::BuiltScene& built,
                                          const std::string& only, assembly::RadiationStore& store,
                                          Reporter& reporter);

}  // namespace app

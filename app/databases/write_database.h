#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hydro/radiation/radiation_data.h"
#include "hydro/statics/hydrostatics.h"

/// @file
/// Databases in the formats of other programs, about the body's centre of mass, in the frame H.

namespace databases {

/// Data of a body to write.
struct WrittenBody {
  std::string name;
  const hydro::RadiationData& data;
  double density = 1000;             ///< Density of the water [kg/m^3].
  hydro::Hydrostatics statics = {};  ///< In the mean pose.
};

/// Writes a dataset as Capytaine does, NetCDF in its classic format. The origin lies in the still
/// water under or over the centre of mass.
/// @throws std::runtime_error if it cannot be written
void write_capytaine(const std::filesystem::path& file, const WrittenBody& body);

/// Writes WAMIT's numeric files STEM.1, STEM.3 and STEM.hst for a length of 1 m, with six digits.
/// @return the files. @throws std::runtime_error if one cannot be written
std::vector<std::filesystem::path> write_wamit(const std::filesystem::path& stem,
                                               const WrittenBody& body);

}  // namespace databases

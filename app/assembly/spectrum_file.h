#pragma once

#include <filesystem>

#include "hydro/tabulated_spectrum.h"

namespace assembly {

/// Reads a wave spectrum: a table (column_file.h) with the column `frequency_hz` [Hz] or
/// `frequency_rad_s` [rad/s], `density` [m^2/Hz, or m^2 s/rad] and, if given, `heading_deg`, the
/// direction of travel counter-clockwise from +x.
/// @return frequencies, densities and headings alone
/// @throws InputError if the table cannot be read, lacks a column, has fewer than two rows or no
///     energy; if frequencies do not ascend from 0 or a density is negative (with the line).
hydro::TabulatedSpectrum read_spectrum(const std::filesystem::path& file);

}  // namespace assembly

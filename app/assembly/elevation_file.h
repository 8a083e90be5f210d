#pragma once

#include <filesystem>

#include "hydro/measured_elevation.h"

namespace assembly {

/// Reads a measured elevation: a table (column_file.h) with the columns `time` [s] and `elevation`
/// [m].
/// @throws InputError if the table cannot be read, lacks a column or has fewer than
///     kFewestElevations rows; if times do not ascend in equal intervals (with the line).
hydro::ElevationRecord read_elevation(const std::filesystem::path& file);

}  // namespace assembly

#pragma once

#include <filesystem>

#include "hydro/resistance/resistance.h"

namespace assembly {

/// Reads a table of a resistance over the speed (column_file.h): the columns `speed` [m/s],
/// ascending from 0 or more, and `force` [N], not negative and 0 at rest.
/// @throws scene::InputError that names the file, and the row that is not so
hydro::ResistanceCurve read_resistance(const std::filesystem::path& file);

}  // namespace assembly

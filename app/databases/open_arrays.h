#pragma once

#include <memory>

#include "app/databases/array_file.h"

namespace databases {

/// Opens a file by its first bytes.
/// @throws InputError if it is no such file, cannot be read, or is HDF5 and the program was built
///     without its library
std::unique_ptr<ArrayFile> open_arrays(const std::filesystem::path& file);

/// Opens an HDF5 file. @throws InputError as open_arrays does
std::unique_ptr<ArrayFile> open_hdf5(const std::filesystem::path& file);

}  // namespace databases

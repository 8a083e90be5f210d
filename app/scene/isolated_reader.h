#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/base/forked_call.h"

namespace scene {

/// Reads a file by a foreign library in a process of its own (app/base/forked_call.h), since a
/// damaged file may crash the library, let it run on or fill the memory.
/// @param reader   Name of the reader in faults: `the reader of HDF5`.
/// @param read     Writes what it reads to its argument. An InputError comes back as one of this
///     function, with the message of its first fault and its line in `file`; other exceptions
///     become faults of the file.
/// @return what `read` has written
/// @throws InputError also if the file ends the process or exceeds a limit
std::string read_isolated(const std::filesystem::path& file, const std::string& reader,
                          const std::function<void(const app::CallOutput&)>& read,
                          const app::CallLimits& limits);

/// Reads a file by the library of HDF5 so, in 10 s and another second per megabyte.
std::string read_hdf5_isolated(const std::filesystem::path& file,
                               const std::function<void(const app::CallOutput&)>& read);

/// Returns limits for a file by its size: so much time, and another second per `bytes_per_second`;
/// 4 GiB of memory and another 64 bytes per byte of the file, but no more than is free.
app::CallLimits limits_by_size(const std::filesystem::path& file, int seconds,
                               double bytes_per_second);

}  // namespace scene

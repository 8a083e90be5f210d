#include "app/databases/open_arrays.h"
#include "app/scene/diagnostics.h"

/// Replaces hdf5_arrays.cpp in a build without the library.

namespace databases {

std::unique_ptr<ArrayFile> open_hdf5(const std::filesystem::path& file) {
  throw scene::InputError(
      file,
      "the file is HDF5, and this plimsoll was built without its library; install libhdf5-dev "
      "(Debian, Ubuntu; or HDF5 1.10.7 or later) and build it again from a new configuration");
}

}  // namespace databases

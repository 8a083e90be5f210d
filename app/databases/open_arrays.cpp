#include "app/databases/open_arrays.h"

#include <fstream>

#include "app/databases/netcdf_classic.h"
#include "app/scene/diagnostics.h"

namespace databases {

std::unique_ptr<ArrayFile> open_arrays(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string start(8, '\0');
  if (!in || std::filesystem::is_directory(file))
    throw scene::InputError(file, "the file cannot be opened");
  in.read(start.data(), 8);
  if (start.starts_with("CDF")) return open_netcdf_classic(file);
  if (start == "\x89HDF\r\n\x1a\n") return open_hdf5(file);
  throw scene::InputError(file, "the file is neither NetCDF nor HDF5");
}

}  // namespace databases

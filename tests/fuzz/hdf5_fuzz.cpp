#include "app/logs/hdf5_log_reader.h"
#include "tests/fuzz/fuzz_input.h"

/// @file
/// The log of a run as HDF5.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("run.h5");
  const std::filesystem::path& path = file.holding(fuzz::text_of(data, size));
  fuzz::expect_content_or_faults(path.string(), [&] {
    if (!app::is_hdf5(path)) return;
    app::read_hdf5_trajectory(path);
    app::read_hdf5_forces(path);
  });
  return 0;
}

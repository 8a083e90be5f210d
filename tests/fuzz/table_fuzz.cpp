#include "app/assembly/elevation_file.h"
#include "app/assembly/height_io.h"
#include "app/assembly/spectrum_file.h"
#include "tests/fuzz/fuzz_input.h"

/// @file
/// Height fields, as tables and as pictures, measured elevations and wave spectra. Each input is
/// given to every reader.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("table");
  const std::filesystem::path& path = file.holding(fuzz::text_of(data, size));
  const auto expect = [&](const auto& read) {
    fuzz::expect_content_or_faults(path.string(), read);
  };
  expect([&] { assembly::read_heights(path); });
  expect([&] { assembly::read_heights(path, std::array<double, 2>{-1, 2}); });
  expect([&] { assembly::read_elevation(path); });
  expect([&] { assembly::read_spectrum(path); });
  return 0;
}

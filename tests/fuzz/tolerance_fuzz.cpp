#include "app/compare/comparison.h"
#include "tests/fuzz/fuzz_input.h"

/// @file
/// A file of tolerances of `plimsoll compare`.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("tolerances.yaml");
  const std::filesystem::path& path = file.holding(fuzz::text_of(data, size));
  fuzz::expect_content_or_faults(path.string(), [&] { app::read_tolerances(path); });
  return 0;
}

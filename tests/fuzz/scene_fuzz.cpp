#include "app/scene/reader.h"
#include "tests/fuzz/fuzz_input.h"

/// @file
/// The text of a scene.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::expect_content_or_faults("folder/scene.yaml", [&] {
    const scene::Scene scene =
        scene::parse(std::string(fuzz::text_of(data, size)), "folder/scene.yaml", {});
    if (!(scene.step > 0) || !(scene.duration >= 0)) std::abort();
  });
  return 0;
}

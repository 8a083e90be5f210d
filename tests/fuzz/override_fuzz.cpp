#include "app/scene/reader.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/support/varied_scene.h"

/// @file
/// The arguments of `--set`, one on each line, over a scene with something of everything.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text = fuzz::text_of(data, size);
  fuzz::expect_content_or_faults("", [&] {
    std::vector<scene::Override> overrides;
    for (std::size_t end = 0; end != std::string_view::npos && overrides.size() < 8;) {
      end = text.find('\n');
      overrides.push_back(scene::parse_override(std::string(text.substr(0, end))));
      if (end != std::string_view::npos) text.remove_prefix(end + 1);
    }
    scene::parse(support::kVariedScene, "folder/scene.yaml", overrides);
  });
  return 0;
}

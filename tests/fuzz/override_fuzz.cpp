#include "app/scene/reader.h"
#include "tests/fuzz/fuzz_input.h"

/// @file
/// The arguments of `--set`, one on each line, over a scene with something of everything.

namespace {

const std::string kScene =
    "plimsoll: 1\n"
    "duration: 3.6\n"
    "water:\n"
    "  current: [0, 0.5, 0]\n"
    "  surface: {waves: [{amplitude: 0.3, wavelength: 12, heading_deg: -30}]}\n"
    "air: {density: 1.2, wind: {speed: 9, heading_deg: 40, exponent: 0.2}}\n"
    "hydro: &none {lift: false, viscous_drag: thesis}\n"
    "bodies:\n"
    "  - name: a\n"
    "    box: {size: [1, 2, 3], divisions: 2}\n"
    "    mass: 5\n"
    "    orientation: {euler_deg: [10, 20, 30]}\n"
    "  - {name: b, sphere: {radius: 1}, density: 5e2, hydro: {<<: *none, buoyancy: true}}\n"
    "joints:\n"
    "  - {type: hinge, bodies: [a, b], anchor: [0, 0, 1], axis: [0, 1, 0]}\n"
    "ropes: [{name: r, bodies: [a, b], points: [[0, 0, 0], [0, 0, 1]], length: 1, stiffness: 1}]\n"
    "propellers: [{name: p, body: a, at: [0, 0, 0], axis: [1, 0, 0], diameter: 1, speed_rps: 1,\n"
    "  model: {wageningen: {blades: 4, area_ratio: 0.7, pitch_ratio: 1}}}]\n"
    "render: {size: [320, 240], pressure: {min: 0, max: auto}}\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text = fuzz::text_of(data, size);
  fuzz::expect_content_or_faults("", [&] {
    std::vector<scene::Override> overrides;
    for (std::size_t end = 0; end != std::string_view::npos && overrides.size() < 8;) {
      end = text.find('\n');
      overrides.push_back(scene::parse_override(std::string(text.substr(0, end))));
      if (end != std::string_view::npos) text.remove_prefix(end + 1);
    }
    scene::parse(kScene, "folder/scene.yaml", overrides);
  });
  return 0;
}

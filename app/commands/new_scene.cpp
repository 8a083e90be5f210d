#include "app/commands/new_scene.h"

#include <fmt/format.h>

#include <string_view>

#include "app/base/atomic_file.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

namespace fs = std::filesystem;

/// The starter scene. It has the keys that most scenes need; those that are commented out are
/// valid.
constexpr std::string_view kStarterScene =
    R"(# Lengths in m, masses in kg, seconds; z is up, the still water at z = 0.
plimsoll: 1
title: {title}
duration: 10
step: 0.01

# Without this block there is no water.
water:
  density: 1025
  surface:                      # without it the water is flat
    waves:
      - {{amplitude: 0.25, wavelength: 14, heading_deg: 200}}
      # - {{amplitude: 0.1, period: 2, heading_deg: 120, phase_deg: 40}}
  # depth: 20                   # without it the waves are those of deep water
  # current: [0.5, 0, 0]

# A sea floor.
# ground: {{z: -4}}

# Coefficients of all bodies; each may have a `hydro` block of its own. Without it bodies that start
# afloat make waves, which take a solve before the first run.
# hydro: {{radiation: none}}      # no waves of the bodies: less damping, and no such solve

bodies:
  - name: buoy
    cylinder: {{radius: 0.6, height: 1.4, slices: 24, stacks: 6}}
    # mesh: {{file: hull.obj, scale: 1}}         # OBJ, STL or PLY in place of the cylinder
    mass: 700                   # or a density instead, as for the crate
    center_of_mass: [0, 0, -0.45]              # a low one, so that it floats upright
    start: equilibrium          # as it floats at rest, at the x and y of a position
    # position: [0, 0, 1.1]     # in place of start, as for the crate
    # orientation: {{euler_deg: [15, 10, 0]}}    # roll, pitch, yaw
    # linear_velocity: [1, 0, 0]
    # lock: [x, y, yaw]
    # forces: [{{force: [200, 0, 0], start: 2, end: 4}}]
    color: [0.85, 0.3, 0.2]
  - name: crate
    box: {{size: [0.8, 0.8, 0.5]}}
    density: 300
    position: [1.8, 0.6, 0.1]

# Joints tie two bodies to each other, or one to the `world`.
# joints:
#   - {{type: ball, bodies: [buoy, crate], anchor: [1, 0.3, 0.8]}}

log: {{every: 0.05}}              # forces: true also logs the loads on each body

render:
  every: 0.5
  camera: {{from: [3.6, -5.4, 2], to: [0.6, 0.1, 0.3]}}
)";

/// Puts a text into double quotes for YAML.
std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace

int new_scene(const fs::path& name) {
  fs::path file = name;
  if (file.extension() != ".yaml" && file.extension() != ".yml") file += ".yaml";
  if (file.stem().empty() || !file.has_filename())
    throw scene::InputError(file, "expected the name of a scene");
  if (fs::exists(fs::symlink_status(file)))
    throw scene::InputError(file, "is there already, and is left as it is");
  const std::string title = quoted(file.stem().string());
  write_whole(fs::absolute(file),
              fmt::format(fmt::runtime(kStarterScene), fmt::arg("title", title)));
  print(
      fmt::format("{0}: wrote a scene of a buoy and a crate in waves\n"
                  "Every key is in scenes/KEYS.md. Next: plimsoll run {0}\n",
                  file.string()));
  return kDone;
}

}  // namespace app

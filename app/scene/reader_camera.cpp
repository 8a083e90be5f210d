#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <numbers>

#include "app/scene/reader_blocks.h"

namespace scene {
namespace {

/// Smallest horizontal part of the view direction, relative to its length. A picture's up is the
/// world's up, so the camera cannot look along it.
constexpr double kLeastSideways = 1e-6;

void check_view(MapReader& map, const Camera& camera) {
  const Eigen::Vector3d view = *camera.to - *camera.from;
  if (view.isZero(0))
    map.fault("", "looks from a point to the same point, expected two different ones");
  else if (view.head<2>().stableNorm() <= kLeastSideways * view.stableNorm())
    map.fault("", "looks straight up or down, expected from and to to differ in x or y");
}

/// True if a name can be part of a file name.
bool is_camera_name(const std::string& name) {
  return !name.empty() && name.size() <= kLongestCameraName &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return (c < 0x80 && std::isalnum(c) != 0) || c == '-' || c == '_';
         });
}

std::string in_lower_case(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

/// Checks that names differ by more than case, which some file systems ignore.
void check_camera_names(MapReader& map, const std::vector<Camera>& cameras) {
  std::map<std::string, std::string> first_uses;
  for (const Camera& camera : cameras) {
    if (!is_camera_name(camera.name))
      map.fault(camera.name,
                fmt::format("found the name {}, expected 1 to {} letters without accents, digits, "
                            "- and _",
                            camera.name.empty() ? "\"\"" : camera.name, kLongestCameraName));
    const auto [first, is_new] = first_uses.emplace(in_lower_case(camera.name), camera.name);
    if (!is_new)
      map.fault(camera.name,
                fmt::format("differs from {} in case alone, expected another name", first->second));
  }
}

}  // namespace

void read(MapReader& map, Camera& camera) {
  map.optional("from", camera.from, number("m"));
  map.optional("to", camera.to, number("m"));
  map.optional("fov_deg", camera.field_of_view, degrees_between(1, 170));
  map.optional("follow", camera.follow, TextRule{"the name of a body"});
  map.optional("orbit", camera.orbit,
               NumberRule{.unit = "deg/s", .factor = std::numbers::pi / 180});
  if (camera.from && camera.to) check_view(map, camera);
}

void read(MapReader& map, std::vector<Camera>& cameras) {
  for (const std::string& name : map.names()) {
    Camera camera;
    map.block(name, camera);
    camera.name = name;
    cameras.push_back(camera);
  }
  if (cameras.empty()) map.fault("", "missing, expected at least one camera by its name");
  check_camera_names(map, cameras);
}

void check_followed_bodies(MapReader& map, const Scene& scene) {
  if (!scene.render) return;
  std::vector<std::string> known;
  for (const Body& body : scene.bodies) known.push_back(body.name);
  const auto check = [&](const Camera& camera, const std::string& key) {
    const std::string& name = camera.follow;
    if (name.empty() || std::find(known.begin(), known.end(), name) != known.end()) return;
    map.fault(key + ".follow",
              fmt::format("there is no body named {}{}", name, app::did_you_mean(name, known)));
  };
  check(scene.render->camera, "render.camera");
  for (const Camera& camera : scene.render->cameras) check(camera, "render.cameras." + camera.name);
}

}  // namespace scene

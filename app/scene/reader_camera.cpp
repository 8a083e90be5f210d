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

std::string in_lower_case(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

/// A name of a camera and the key in the block that has it.
struct NameAtKey {
  std::string key;
  std::string name;
};

/// Checks names, which must differ by more than case: some file systems ignore it.
void check_camera_names(MapReader& map, const std::vector<NameAtKey>& names) {
  std::map<std::string, std::string> first_uses;
  for (const auto& [key, name] : names) {
    if (!is_camera_name(name))
      map.fault(key,
                fmt::format("found the name {}, expected 1 to {} letters without accents, digits, "
                            "- and _",
                            name.empty() ? "\"\"" : name, kLongestCameraName));
    const auto [first, is_new] = first_uses.emplace(in_lower_case(name), name);
    if (is_new) continue;
    map.fault(key, first->second == name
                       ? fmt::format("found {}, which is the name of another camera", name)
                       : fmt::format("differs from {} in case alone, expected another name",
                                     first->second));
  }
}

/// A camera in a list, which has its name among its keys.
struct ListedCamera {
  Camera camera;
};

void read(MapReader& map, ListedCamera& listed) {
  map.required("name", listed.camera.name, NameRule{"cameras"});
  read(map, listed.camera);
}

/// Cameras whose names are the keys of a map.
struct NamedCameras {
  std::vector<Camera> cameras;
};

void read(MapReader& map, NamedCameras& named) {
  for (const std::string& name : map.names()) {
    Camera camera;
    map.block(name, camera);
    camera.name = name;
    named.cameras.push_back(camera);
  }
  if (named.cameras.empty()) map.fault("", "missing, expected at least one camera by its name");
  std::vector<NameAtKey> names;
  for (const Camera& camera : named.cameras) names.push_back({camera.name, camera.name});
  check_camera_names(map, names);
}

std::string path_in_list(std::size_t index) { return fmt::format("cameras[{}]", index); }

/// Returns the key path of one of a scene's cameras.
std::string path_of(MapReader& map, std::size_t index, const Camera& camera) {
  const std::string path = "render." + path_in_list(index);
  return map.reading().places.contains(path) ? path : "render.cameras." + camera.name;
}

}  // namespace

bool is_camera_name(const std::string& name) {
  return !name.empty() && name.size() <= kLongestCameraName &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return (c < 0x80 && std::isalnum(c) != 0) || c == '-' || c == '_';
         });
}

void read(MapReader& map, Camera& camera) {
  map.optional("from", camera.from, number("m"));
  map.optional("to", camera.to, number("m"));
  map.optional("fov_deg", camera.field_of_view, degrees_between(1, 170));
  map.optional("follow", camera.follow, TextRule{"the name of a body"});
  map.optional("orbit", camera.orbit,
               NumberRule{.unit = "deg/s", .factor = std::numbers::pi / 180});
  if (map.optional("on", camera.on, TextRule{"the name of a body"})) {
    for (const char* key : {"from", "to"})
      if (!map.has(key)) map.fault(key, "missing, expected a point of the body beside on");
    map.at_most_one_of({"on", "follow"});
  }
  map.note_condition("on", "", {"from", "to"}, {"follow"});
  if (camera.from && camera.to) check_view(map, camera);
}

void read_cameras(MapReader& map, std::vector<Camera>& cameras) {
  std::vector<ListedCamera> listed;
  std::optional<NamedCameras> named;
  map.blocks_or_block("cameras", listed, named);
  if (named) {
    cameras = named->cameras;
    return;
  }
  std::vector<NameAtKey> names;
  for (const ListedCamera& one : listed) {
    const std::string key = path_in_list(cameras.size()) + ".name";
    if (!one.camera.name.empty()) names.push_back({key, one.camera.name});  // Else it is a fault.
    cameras.push_back(one.camera);
  }
  check_camera_names(map, names);
}

void check_followed_bodies(MapReader& map, const Scene& scene) {
  if (!scene.render) return;
  std::vector<std::string> known;
  for (const Body& body : scene.bodies) known.push_back(body.name);
  const auto check = [&](const std::string& name, const std::string& key) {
    if (name.empty() || std::find(known.begin(), known.end(), name) != known.end()) return;
    map.fault(key,
              fmt::format("there is no body named {}{}", name, app::did_you_mean(name, known)));
  };
  const auto check_both = [&](const Camera& camera, const std::string& path) {
    check(camera.follow, path + ".follow");
    check(camera.on, path + ".on");
  };
  check_both(scene.render->camera, "render.camera");
  const std::vector<Camera>& cameras = scene.render->cameras;
  for (std::size_t i = 0; i < cameras.size(); ++i)
    check_both(cameras[i], path_of(map, i, cameras[i]));
}

}  // namespace scene

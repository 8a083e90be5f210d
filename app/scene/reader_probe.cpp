#include <fmt/format.h>

#include <algorithm>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

/// Distance from the still water to the bottom, as far as the scene file says it [m].
std::optional<double> depth_of_bottom(const Scene& scene) {
  std::optional<double> depth = scene.water->depth;
  if (const auto* plane = std::get_if<PlaneGround>(&scene.ground))
    depth = std::min(depth.value_or(scene.water->level - plane->z), scene.water->level - plane->z);
  return depth;
}

void check_gauge(MapReader& map, const Scene& scene, const Probe& probe, const std::string& path) {
  if (!scene.water) {
    if (!map.has("water")) map.fault(path + ".wave", "needs water, and the scene has none");
    return;
  }
  const std::optional<double> bottom = depth_of_bottom(scene);
  if (probe.depth && bottom && *probe.depth > *bottom)
    map.fault(path + ".depth",
              fmt::format("found {:g}, which is below the bottom; expected at most {:g} m",
                          *probe.depth, *bottom));
}

}  // namespace

void read(MapReader& map, Probe& probe) {
  map.required("name", probe.name, NameRule{"probes"});
  map.exactly_one_of({"wave", "body"});
  map.optional("wave", probe.wave, number("m"));
  map.optional("depth", probe.depth, not_negative("m"));
  map.optional("body", probe.body, TextRule{"the name of a body"});
  map.optional("at", probe.at, number("m"));
  map.note_condition("depth", "", {"wave"}, {});
  map.note_condition("at", "", {"body"}, {});
  if (map.has("depth") && !map.has("wave")) map.fault("depth", "is only used with wave");
  if (map.has("at") && !map.has("body")) map.fault("at", "is only used with body");
}

void check_probes(MapReader& map, const Scene& scene) {
  std::vector<std::string> known;
  for (const Body& body : scene.bodies) known.push_back(body.name);
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    const Probe& probe = scene.probes[i];
    const std::string path = fmt::format("log.probes[{}]", i);
    if (probe.wave) check_gauge(map, scene, probe, path);
    if (probe.body && std::find(known.begin(), known.end(), *probe.body) == known.end())
      map.fault(path + ".body", fmt::format("there is no body named {}{}", *probe.body,
                                            app::did_you_mean(*probe.body, known)));
  }
}

}  // namespace scene

#include "app/run/log_subject.h"

#include <algorithm>
#include <utility>

#include "app/logs/probes.h"
#include "app/logs/rig_log.h"

namespace app {

bool may_be_hollow(const engine::SimulationSpec& spec) {
  return spec.sea && std::any_of(spec.bodies.begin(), spec.bodies.end(), [](const auto& body) {
           return body.interior == engine::Interior::flooding;
         });
}

bool has_rig(const engine::SimulationSpec& spec) {
  return !spec.lines.empty() || !spec.joints.empty() || !spec.propellers.empty() ||
         !spec.foils.empty() || !spec.controls.empty();
}

LogSubject log_subject(const scene::Scene& scene, const assembly::BuiltScene& built) {
  std::vector<std::string> bodies;
  for (const engine::BodySpec& body : built.spec.bodies) bodies.push_back(body.name);
  std::vector<LogTable> tables = RigLog(built.spec, scene.log_forces).tables();
  if (!scene.probes.empty()) {
    tables.push_back({probes_layout(), {}});
    for (const scene::Probe& probe : scene.probes) tables.back().names.push_back(probe.name);
  }
  return {.bodies = std::move(bodies),
          .forces = scene.log_forces,
          .interiors = may_be_hollow(built.spec),
          .tables = std::move(tables),
          .scene = scene.file.string(),
          .title = scene.title};
}

}  // namespace app

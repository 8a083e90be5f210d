#include "app/report/page_data.h"

#include "app/pages/packing.h"
#include "app/pictures/cameras.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

Json page_camera(const scene::Scene& scene, const assembly::BuiltScene& built) {
  if (!scene.render) return nullptr;
  const render::Camera c = camera_at_start(cameras_of(*scene.render).front(), built);
  return {{"from", {c.from.x(), c.from.y(), c.from.z()}},
          {"to", {c.to.x(), c.to.y(), c.to.z()}},
          {"field_of_view", c.field_of_view}};
}

}  // namespace

Eigen::Vector3d replay_origin(const LoggedRun& run) {
  Eigen::Vector3d origin = run.built.spec.bodies.empty()
                               ? Eigen::Vector3d::Zero()
                               : run.built.spec.bodies[0].initial.position;
  if (run.built.spec.sea) origin.z() = run.built.spec.sea->level;
  return origin;
}

Json replay_data(const LoggedRun& run, const Eigen::Vector3d& origin, const PageLimits& limits) {
  const Shapes shapes = find_shapes(run.built.spec.bodies, limits.faces);
  return {{"origin", {origin.x(), origin.y(), origin.z()}},
          {"bodies", page_bodies(run, shapes)},
          {"shapes", page_shapes(shapes)},
          {"water", page_water(run.built.spec, limits)},
          {"ground", page_ground(run.built.spec.ground, limits)},
          {"camera", page_camera(run.scene, run.built)},
          {"poses", page_poses(run, origin, limits)},
          {"rigging", page_rigging(run, origin, limits)}};
}

Json page_data(const LoggedRun& run, const PageLimits& limits) {
  Json summary = run.summary;
  if (summary.is_object()) summary.erase("source");
  Json page = {
      {"program", PLIMSOLL_VERSION},
      {"title", run.scene.title},
      {"summary", summary},
      {"scene",
       {{"file", run.scene.file.string()}, {"text", run.scene.text}, {"overrides", run.overrides}}},
      {"gravity", run.scene.gravity},
      {"rows", run.rows},
      {"pressure", page_pressure(run)},
      {"series", page_series(run, limits)},
      {"analysis", page_analysis(run, limits)},
      {"frames", page_frames(run, limits)}};
  page.update(replay_data(run, replay_origin(run), limits));
  return page;
}

}  // namespace app

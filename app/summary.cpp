#include "app/summary.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/output_folder.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// The load kinds of a body that were not computed.
Json unused_loads(const engine::BodySpec& body) {
  Json unused = Json::array();
  if (!body.coefficients.buoyancy) unused.push_back("buoyancy");
  if (body.coefficients.pressure_drag.none()) unused.push_back("pressure_drag");
  if (body.coefficients.viscous_drag.none()) unused.push_back("viscous_drag");
  if (body.coefficients.lift == 0) unused.push_back("lift");
  return unused;
}

Json body_summary(const RunSummary& summary, std::size_t i) {
  const engine::BodySpec& body = summary.spec.bodies[i];
  return {{"triangles", body.mesh_B.face_count()},
          {"mass", body.mass},
          {"loads_not_computed", unused_loads(body)},
          {"steps_above_water", summary.skips.dry_steps[i]},
          {"steps_at_rest", summary.skips.resting_steps[i]},
          {"steps_with_stiff_drag", summary.stiff_steps[i]}};
}

Json to_json(const RunSummary& s) {
  Json bodies = Json::object();
  for (std::size_t i = 0; i < s.spec.bodies.size(); ++i)
    bodies[s.spec.bodies[i].name] = body_summary(s, i);
  Json json = {{"version", PLIMSOLL_VERSION},
               {"scene", s.scene.file.string()},
               {"title", s.scene.title},
               {"ended", s.ended}};
  if (!s.error.empty()) json["error"] = s.error;
  json.update(
      {{"steps", s.steps},
       {"simulated_seconds", s.simulated},
       {"real_time_factor", s.wall > 0 ? s.simulated / s.wall : 0},
       {"threads", s.spec.threads},
       {"wall_seconds",
        {{"total", s.wall},
         {"collision", s.timings.collision},
         {"hydro", s.timings.hydro},
         {"engine", s.timings.engine},
         {"render", s.wall_render},
         {"log", s.wall_log}}},
       {"skipped",
        {{"collision", s.skips.collision},
         {"water", s.skips.water},
         {"pictures", s.pictures_skipped.empty() ? Json(false) : Json(s.pictures_skipped)}}},
       {"bodies", bodies}});
  if (s.pictures)
    json["pictures"] = {{"device", s.pictures->device},
                        {"frames", s.pictures->frames},
                        {"pressure_max", s.pictures->pressure_max}};
  return json;
}

}  // namespace

void write_summary(const RunSummary& summary, const std::filesystem::path& file) {
  const std::filesystem::path draft = file.string() + ".part";
  std::ofstream stream(draft);
  // A file name may be no UTF-8; its odd bytes become U+FFFD.
  stream << to_json(summary).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(draft, file, error);
  if (!stream || error) throw OutputError(file.string() + ": cannot be written; is the disk full?");
}

}  // namespace app

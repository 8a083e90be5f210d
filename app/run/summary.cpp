#include "app/run/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "app/assembly/build_radiation.h"
#include "app/base/atomic_file.h"
#include "app/base/checked_file.h"
#include "app/base/json_rows.h"
#include "app/base/output_error.h"
#include "app/logs/run_source.h"
#include "hydro/added_mass/surface_added_mass.h"
#include "hydro/resistance/thin_ship.h"
#include "hydro/statics/equilibrium.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// Returns a digest of a mesh: of another mesh, or of the same in other body axes, it is another.
std::string digest_of(const hydro::TriMesh& mesh_B) {
  std::string bytes;
  append(bytes, mesh_B.vertices.data(), static_cast<std::size_t>(mesh_B.vertices.size()));
  append(bytes, mesh_B.faces.data(), static_cast<std::size_t>(mesh_B.faces.size()));
  return fmt::format("{:016x}", hash_of(bytes));
}

Json motion_summary(const engine::Counts& counts) {
  return {{"free_steps", counts.free},
          {"constrained_steps", counts.constrained},
          {"substeps", counts.substeps},
          {"implicit_substeps", counts.implicit},
          {"sweeps", counts.iterations},
          {"unconverged_substeps", counts.unconverged},
          {"clamped_substeps", counts.clamped},
          // The names of version 0.1, for one version more.
          {"pieces", counts.substeps},
          {"implicit_pieces", counts.implicit},
          {"constraint_solutions", counts.iterations},
          {"unconverged_pieces", counts.unconverged},
          {"braked_pieces", counts.clamped}};
}

/// Returns the added mass of the submerged body and its origin; null if there is none.
Json to_json(const std::optional<assembly::AddedMassReport>& report) {
  if (!report) return nullptr;
  if (report->surface)
    return {{"model", "surface"},
            {"matrix", json_rows(report->matrix)},
            {"solves", report->surface->solves()}};
  if (report->model == scene::AddedMass::Model::automatic)
    return {{"model", "mean pose"}, {"matrix", json_rows(report->matrix)}};
  if (!report->stored) return {{"model", "matrix"}, {"matrix", json_rows(report->matrix)}};
  const hydro::AddedMassSolution& solution = *report->stored->solution;
  return {{"model", "deep"},
          {"matrix", json_rows(report->matrix)},
          {"symmetry_error", solution.symmetry_error},
          {"error_estimate", solution.error_estimate},
          {"from_store", report->stored->from_store},
          {"solve_seconds", solution.seconds}};
}

/// Returns the origin of what is known of a body's waves, and the checks of it.
Json origin_of(const assembly::RadiationReport& report) {
  if (const auto& database = report.choice.database) {
    Json checks = Json::object();
    for (const databases::Check& check : database->found.checks) checks[check.name] = check.value;
    return {{"source", "file"},           {"file", database->file.string()},
            {"format", database->format}, {"body", database->body},
            {"checks", checks},           {"notes", database->found.notes}};
  }
  return {{"source", "solved"},
          {"from_store", report.stored->from_store},
          {"solve_seconds", report.stored->seconds},
          {"unknowns", report.stored->solution->unknowns},
          {"haskind_mismatch", report.stored->solution->mismatch}};
}

/// Returns what is known of the waves that a body makes, or why it makes none; null if the scene
/// says so.
Json to_json(const assembly::RadiationReport& report) {
  if (!report.model)
    return report.choice.reason.empty() ? Json() : Json{{"why_none", report.choice.reason}};
  const hydro::RadiationData& data = report.model->data();
  const hydro::RadiationMemory& memory = report.model->memory();
  const hydro::MeanPose& pose = data.pose;
  const Eigen::Vector3d angles = hydro::euler_angles(pose.orientation) * (180 / std::numbers::pi);
  const Json mean_pose = {{"height", pose.height},
                          {"draught", report.choice.draught},
                          {"roll_deg", angles[0] + 0.0},
                          {"pitch_deg", angles[1] + 0.0}};
  if (report.choice.simulated)
    return {{"source", "simulated water"},
            {"solve_seconds", report.sources_seconds},
            {"mean_pose", mean_pose},
            {"assumed", assembly::assumptions(data.water, true)}};
  Json json = origin_of(report);
  json.update({{"frequencies", data.frequencies},
               {"mean_pose", mean_pose},
               {"oscillators", memory.size()},
               {"fit_error_rms", memory.rms_error.maxCoeff()},
               {"fit_error_largest", memory.largest_error.maxCoeff()},
               {"assumed", assembly::assumptions(data.water, false)}});
  return json;
}

/// Returns the resistance along the motion; null if there is none.
Json to_json(const engine::BodySpec& body, const assembly::ResistanceReport& report) {
  if (!body.resistance) return nullptr;
  Json json = {{"source", report.ship ? "michell" : "file"},
               {"speeds", body.resistance->curve.speeds()},
               {"forces", body.resistance->curve.forces()}};
  if (report.ship)
    json.update({{"length", report.ship->length()},
                 {"bluntness", report.ship->bluntness()},
                 {"suction", body.resistance->suction},
                 {"from_store", report.from_store},
                 {"solve_seconds", report.seconds}});
  return json;
}

Json body_summary(const RunSummary& summary, std::size_t i) {
  const engine::BodySpec& body = summary.built.spec.bodies[i];
  Json motion = motion_summary(summary.errors.counts[i]);
  if (i < summary.errors.works.size())
    motion["clamped_work_share"] = summary.errors.works[i].clamped_share();
  return {{"triangles", body.mesh_B.face_count()},
          {"mass", body.mass},
          {"mesh_digest", digest_of(body.mesh_B)},
          {"loads_not_computed", unused_loads(body)},
          {"drag_shape", json_rows(body.coefficients.drag_shape)},
          {"steps_above_water", summary.errors.counts[i].dry},
          {"steps_at_rest", summary.errors.counts[i].resting},
          {"motion", std::move(motion)},
          {"added_mass", to_json(summary.built.added_mass[i])},
          {"radiation", to_json(summary.built.radiation[i])},
          {"resistance", to_json(body, summary.built.resistance[i])}};
}

Json to_json(const hydro::PeriodicSquare& square, const WaterEnergy& energy) {
  return {{"cells", square.cells},
          {"cell", square.cell},
          {"energy", energy.waves},
          {"absorbed", energy.absorbed}};
}

/// Returns the report of pictures; cameras are listed if there are several, videos if there are
/// any.
Json to_json(const PictureReport& pictures) {
  Json json = {{"device", pictures.device}, {"frames", pictures.frames}};
  if (pictures.pressure_max) json["pressure_max"] = *pictures.pressure_max;
  if (!pictures.cameras.empty()) json["cameras"] = pictures.cameras;
  for (const VideoReport& video : pictures.videos)
    json["videos"].push_back(
        {{"file", video.file.string()}, {"pictures", video.pictures}, {"fps", video.fps}});
  return json;
}

Json to_json(const hydro::ElevationFit& fit) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return {{"residual", fit.residual},
          {"lowest_frequency_hz", fit.lowest / kTurn},
          {"highest_frequency_hz", fit.highest / kTurn},
          {"energy_below", fit.below},
          {"energy_above", fit.above},
          {"energy_of_weak_waves", fit.dropped},
          {"energy_of_stopped_waves", fit.stopped},
          {"mean", fit.mean},
          {"jump", fit.jump}};
}

Json to_json(const assembly::IrregularSea& sea) {
  Json json = {{"significant_height", sea.significant_height},
               {"peak_period", sea.peak_period},
               {"waves", sea.waves}};
  if (sea.fit) json["elevation_fit"] = to_json(*sea.fit);
  return json;
}

/// Says whether moorings are at rest at every instant or have inertia; empty if there are none.
std::string model_of_moorings(const engine::SimulationSpec& spec) {
  const auto any = [&](bool dynamic) {
    return std::ranges::any_of(spec.lines, [&](const engine::LineSpec& line) {
      return line.kind == engine::LineSpec::Kind::mooring && line.inertia.has_value() == dynamic;
    });
  };
  if (any(false)) return any(true) ? "catenary and dynamic" : "catenary";
  return any(true) ? "dynamic" : "";
}

/// Returns the summaries of all bodies by their names. Each name is another, so that none is looked
/// for among those before, in a time that grows with the square of their number.
Json body_summaries(const RunSummary& summary) {
  const std::vector<engine::BodySpec>& bodies = summary.built.spec.bodies;
  Json::object_t summaries;
  summaries.reserve(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    summaries.emplace_back(bodies[i].name, body_summary(summary, i));
  return Json(std::move(summaries));
}

/// Returns the parts of the wall time, the added mass before the first step left out.
Json shares_of(const RunSummary& s) {
  const double wall = s.wall - s.built.added_mass_seconds;
  const auto share = [&](double seconds) { return wall > 0 ? seconds / wall : 0; };
  return {{"sea", share(s.timings.sea)},
          {"loads", share(s.timings.hydro)},
          {"collisions", share(s.timings.collision)},
          {"constraints", share(s.timings.constraints)},
          {"water", share(s.timings.water)},
          {"log", share(s.wall_log)}};
}

Json to_json(const RunSummary& s) {
  const engine::SimulationSpec& spec = s.built.spec;
  const double added_mass = s.built.added_mass_seconds;
  Json json = {{"version", PLIMSOLL_VERSION},
               {"scene", s.scene.file.string()},
               {"title", s.scene.title},
               {"ended", s.ended}};
  if (!s.error.empty()) json["error"] = s.error;
  json.update(
      {{"steps", s.steps},
       {"simulated_seconds", s.simulated},
       {"real_time_factor", s.wall > added_mass ? s.simulated / (s.wall - added_mass) : 0},
       {"threads", spec.threads},
       {"warnings", s.warnings},
       {"wall_seconds",
        {{"total", s.wall},
         {"added_mass", added_mass},
         {"collision", s.timings.collision},
         {"hydro", s.timings.hydro},
         {"engine", s.timings.engine},
         {"render", s.wall_render},
         {"log", s.wall_log}}},
       {"shares", shares_of(s)},
       {"skipped",
        {{"collision", s.skips.collision},
         {"water", s.skips.water},
         {"lines", spec.lines.empty()},
         {"machines", spec.propellers.empty() && spec.foils.empty()},
         {"controls", spec.controls.empty()},
         {"pictures", s.pictures_skipped.empty() ? Json(false) : Json(s.pictures_skipped)}}}});
  json["bodies"] = body_summaries(s);
  if (!s.skips.collision) json["overlaps"] = overlaps_summary(spec, s.errors.constraints);
  if (!spec.joints.empty()) {
    json["joints"] = joints_summary(spec, s.errors.constraints);
    for (std::size_t i = 0; i < spec.joints.size(); ++i)
      json["joints"][spec.joints[i].name].update(s.rig.joint(spec, i));
  }
  if (!spec.lines.empty()) json["lines"] = s.rig.lines(spec);
  if (const std::string moorings = model_of_moorings(spec); !moorings.empty())
    json["moorings"] = moorings;
  if (!spec.propellers.empty()) json["machines"] = s.rig.machines(spec);
  if (s.water) json["simulated_water"] = to_json(spec.water->square, *s.water);
  if (s.built.irregular_sea) json["irregular_sea"] = to_json(*s.built.irregular_sea);
  if (s.pictures) json["pictures"] = to_json(*s.pictures);
  json["source"] = to_json(run_source(s.scene, s.overrides));
  if (s.resumed_at) json["resumed_at_seconds"] = *s.resumed_at;
  return json;
}

}  // namespace

std::vector<std::string> unused_loads(const engine::BodySpec& body) {
  std::vector<std::string> unused;
  if (!body.coefficients.buoyancy) unused.emplace_back("buoyancy");
  if (body.coefficients.pressure_drag.none()) unused.emplace_back("pressure_drag");
  if (body.coefficients.viscous_drag.none()) unused.emplace_back("viscous_drag");
  if (body.coefficients.lift == 0) unused.emplace_back("lift");
  return unused;
}

void write_summary(const RunSummary& summary, const std::filesystem::path& file) {
  // A file name may be invalid UTF-8; its invalid bytes become U+FFFD.
  std::string text = to_json(summary).dump(2, ' ', false, Json::error_handler_t::replace);
  text += '\n';
  try {
    write_whole(file, text);
  } catch (const std::runtime_error& error) {
    throw OutputError(error.what());
  }
}

}  // namespace app

#include "app/assembly/build_radiation.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "hydro/radiation/diffraction_load.h"
#include "hydro/radiation/long_waves.h"

namespace assembly {
namespace {

using FloatingModel = std::shared_ptr<const hydro::FloatingBody>;

/// Models by their data, which bodies with equal meshes and mean poses share.
using FloatingModels = std::map<const hydro::RadiationData*, FloatingModel>;

FloatingModel floating_model(const hydro::TriMesh& mesh_B, const hydro::Sea& sea,
                             const hydro::RadiationData& data,
                             const hydro::RadiationMemory* stored) {
  const hydro::RadiationMemory memory = stored ? *stored : hydro::fit_memory(data);
  auto [load, momentum] = hydro::scattered_waves(hydro::balanced_diffraction(data, memory), sea);
  return std::make_shared<const hydro::FloatingBody>(mesh_B, data, memory, std::move(load),
                                                     std::move(momentum));
}

// Difference between the damping by the pressure on the hull and by the waves far away.
constexpr double kDoubtfulMismatch = 0.1;  ///< [-]
constexpr double kUselessMismatch = 0.3;   ///< [-]

}  // namespace

void check_mismatch(const std::string& name, double mismatch, app::Reporter& reporter) {
  const std::string text = fmt::format(
      "the damping by the pressure on the hull and by the waves far away differ by "
      "{:.0f} %, as on a hull too slender or too thin for its panels",
      100 * mismatch);
  if (mismatch > kUselessMismatch) throw std::invalid_argument("its solution is useless: " + text);
  if (mismatch > kDoubtfulMismatch)
    reporter.warning(fmt::format("radiation of {}: {}", name, text));
}

AddedMassReport added_mass_report(const hydro::FloatingBody& model, const hydro::Sea& sea) {
  const hydro::MeanPose& pose = model.data().pose;
  const hydro::Sea still{.density = sea.density, .gravity = sea.gravity};
  return {.model = scene::AddedMass::Model::automatic,
          .matrix = model.at({.position = {0, 0, pose.height}, .orientation = pose.orientation},
                             still, 0),
          .stored = {},
          .surface = {}};
}

RadiationProblem radiation_problem(const RadiationChoice& choice, const engine::BodySpec& body,
                                   const hydro::Sea& sea) {
  return {.mesh_B = radiating_mesh(choice, body),
          .pose = *choice.pose,
          .water = {.gravity = sea.gravity, .depth = sea.depth}};
}

void add_radiation(const scene::Scene& scene, BuiltScene& built, RadiationStore& store,
                   app::Reporter& reporter) {
  scene::Faults faults;
  FloatingModels models;
  for (std::size_t i = 0; i < built.radiation.size(); ++i) {
    RadiationReport& report = built.radiation[i];
    if (!report.choice.pose || report.choice.simulated) continue;
    engine::BodySpec& body = built.spec.bodies[i];
    const hydro::Sea& sea = *built.spec.sea;
    const hydro::TriMesh& mesh_B = radiating_mesh(report.choice, body);
    try {
      if (!report.choice.database)
        report.stored = solved_radiation(body.name, radiation_problem(report.choice, body, sea),
                                         store, reporter);
      if (report.stored) check_mismatch(body.name, report.stored->solution->mismatch, reporter);
      const hydro::RadiationData& data = report.choice.database ? report.choice.database->found.data
                                                                : report.stored->solution->data;
      FloatingModel& model = models[&data];
      if (!model)
        model = floating_model(mesh_B, sea, data,
                               report.stored ? report.stored->memory.get() : nullptr);
      report.model = model;
      body.radiation = model;
      body.added_mass = model;
      built.added_mass[i] = added_mass_report(*model, sea);
    } catch (const std::invalid_argument& error) {
      report.choice.pose.reset();
      report.choice.reason = error.what();
      if (report.choice.written)
        faults.add(scene.places, fmt::format("bodies[{}].hydro.radiation", i), error.what());
      else
        reporter.warning(fmt::format("{} has no radiation: {}", body.name, error.what()));
    }
  }
  faults.throw_if_any();
}

std::vector<std::string> assumptions(const hydro::LinearWater& water, bool simulated) {
  std::vector<std::string> list = {"small motions about the mean pose",
                                   std::isfinite(water.depth)
                                       ? fmt::format("water {:g} m deep everywhere", water.depth)
                                       : "deep water",
                                   "no forward speed in the water"};
  if (!simulated) list.emplace_back("no other body near");
  return list;
}

}  // namespace assembly

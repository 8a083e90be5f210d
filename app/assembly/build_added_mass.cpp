#include "app/assembly/build_added_mass.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <stdexcept>

#include "app/assembly/memory_need.h"
#include "app/assembly/solve_time.h"
#include "app/base/machine.h"
#include "app/base/progress.h"
#include "app/scene/diagnostics.h"
#include "engine/motion/locks.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/added_mass/deep_added_mass.h"
#include "hydro/added_mass/surface_added_mass.h"

namespace assembly {
namespace {

using Model = scene::AddedMass::Model;

/// Models of deep added mass; bodies with equal mesh and centre of mass share one.
class DeepModels {
 public:
  explicit DeepModels(const hydro::Sea* sea) : sea_(sea) {}

  std::shared_ptr<const hydro::DeepAddedMass> of(const engine::BodySpec& body,
                                                 const CenteredMesh& solid,
                                                 const StoredAddedMass& stored) {
    for (const Entry& entry : entries_)
      if (entry.solution == stored.solution && entry.com_C == solid.com_C) return entry.model;
    const bool moves = !solid.com_C.isZero(0);  // False for uniform density.
    auto model =
        moves
            ? std::make_shared<const hydro::DeepAddedMass>(
                  outside_B(body), hydro::moved_origin(*stored.solution, solid.com_C), sea_)
            : std::make_shared<const hydro::DeepAddedMass>(outside_B(body), *stored.solution, sea_);
    entries_.push_back({stored.solution, solid.com_C, model});
    return model;
  }

 private:
  struct Entry {
    std::shared_ptr<const hydro::AddedMassSolution> solution;
    Eigen::Vector3d com_C;
    std::shared_ptr<const hydro::DeepAddedMass> model;
  };
  const hydro::Sea* sea_;
  std::vector<Entry> entries_;
};

/// Models of `surface`; bodies with equal meshes about the centre of mass share one.
class SurfaceModels {
 public:
  std::shared_ptr<const hydro::SurfaceAddedMass> of(const engine::BodySpec& body,
                                                    const AddedMassStore& store,
                                                    app::Reporter& reporter) {
    for (const auto& [first, model] : entries_)
      if (hydro::same_mesh(outside_B(*first), outside_B(body))) return model;
    auto model = std::make_shared<const hydro::SurfaceAddedMass>(
        outside_B(body), store.find_nodes(outside_B(body), reporter));
    entries_.emplace_back(&body, model);
    return model;
  }

 private:
  std::vector<std::pair<const engine::BodySpec*, std::shared_ptr<const hydro::SurfaceAddedMass>>>
      entries_;
};

/// Sets the model `matrix` of a body and returns its report.
AddedMassReport add_matrix(const scene::AddedMass& added_mass, engine::BodySpec& body) {
  const auto model =
      std::make_shared<const hydro::ConstantAddedMass>(outside_B(body), added_mass.matrix);
  body.added_mass = model;
  return {.model = Model::matrix, .matrix = model->matrix(), .stored = {}, .surface = {}};
}

/// Sets the model `surface` of a body. The report has the body in unbounded fluid, which is one
/// solution; others follow during the simulation.
AddedMassReport add_surface(double density, const AddedMassStore& store, app::Reporter& reporter,
                            SurfaceModels& models, engine::BodySpec& body) {
  const auto model = models.of(body, store, reporter);
  body.added_mass = model;
  return {.model = Model::surface,
          .matrix = density * model->under(hydro::WaterPlane{}),
          .stored = {},
          .surface = model};
}

AddedMassReport add_deep(const CenteredMesh& solid, const StoredAddedMass& stored, double density,
                         DeepModels& models, engine::BodySpec& body) {
  const auto model = models.of(body, solid, stored);
  body.added_mass = model;
  return {
      .model = Model::deep, .matrix = density * model->whole(), .stored = stored, .surface = {}};
}

/// Warns of a solution that takes more memory than is free.
/// @throws InputError if it cannot be found so
void check_memory(const std::string& what, const hydro::TriMesh& mesh,
                  const hydro::AddedMassOptions& options, app::Reporter& reporter) {
  const auto triangles = static_cast<double>(mesh.face_count());
  const auto verdict =
      app::judged_need(added_mass_bytes(triangles, options), app::available_memory());
  if (!verdict) return;
  const std::string text = fmt::format("{} of {:.3g} triangles {}", what, triangles, verdict->text);
  if (verdict->fault)
    throw scene::InputError(
        {scene::Fault{{}, "", text + "; use a coarser mesh, or another model"}});
  reporter.warning(text);
}

}  // namespace

Model added_mass_model(const scene::Scene& scene, const BuiltScene& built, std::size_t body) {
  const auto radiates = [&](std::size_t i) { return built.radiation[i].choice.pose.has_value(); };
  const engine::BodySpec& spec = built.spec.bodies[body];
  // The hull that a body is a part of has the added mass of all of it.
  const std::optional<engine::BodyId>& lead = built.radiation[body].choice.lead;
  if (radiates(body) || (lead && radiates(static_cast<std::size_t>(*lead)))) return Model::none;
  if (!spec.wet || (engine::immovable(spec.locked) && !built.spec.record_work)) return Model::none;
  const Model model = scene.bodies[body].hydro.added_mass.model;
  return model == Model::automatic ? Model::deep : model;
}

StoredAddedMass solved_added_mass(const std::string& name, const hydro::TriMesh& mesh,
                                  const hydro::AddedMassOptions& options, AddedMassStore& store,
                                  app::Reporter& reporter) {
  const std::string what = "added mass of " + name;
  return found_or_solved(
      store.file_of(mesh, options), what, reporter,
      [&] { return store.find(mesh, options, reporter); },
      [&] {
        check_memory(what, mesh, options, reporter);
        const double expected = added_mass_seconds(static_cast<double>(mesh.face_count()),
                                                   tbb::this_task_arena::max_concurrency());
        reporter.working_on(fmt::format("{}: solving for {} triangles, once for this mesh: some {}",
                                        what, mesh.face_count(), app::rough_time(expected)));
        hydro::AddedMassSolution solution = hydro::solve_added_mass(mesh, options);
        reporter.done(fmt::format("{}: {:.1f} s", what, solution.seconds));
        return store.keep(mesh, options, std::move(solution), reporter);
      });
}

void add_added_mass(const scene::Scene& scene, BuiltScene& built, AddedMassStore& store,
                    app::Reporter& reporter) {
  if (built.spec.integrator.method == engine::Integrator::Method::ode) return;  // It has none.
  scene::Faults faults;
  DeepModels models(built.spec.sea ? &*built.spec.sea : nullptr);
  SurfaceModels surface_models;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    engine::BodySpec& body = built.spec.bodies[i];
    const scene::AddedMass& added_mass = scene.bodies[i].hydro.added_mass;
    const Model model = added_mass_model(scene, built, i);
    if (model == Model::matrix) built.added_mass[i] = add_matrix(added_mass, body);
    if (model == Model::surface)
      built.added_mass[i] =
          add_surface(built.spec.sea->density, store, reporter, surface_models, body);
    if (model != Model::deep) continue;
    const CenteredMesh& solid = built.solids[i];
    try {
      const StoredAddedMass stored = solved_added_mass(
          body.name, solid.mesh_C, {.tolerance = added_mass.tolerance}, store, reporter);
      built.added_mass[i] = add_deep(solid, stored, built.spec.sea->density, models, body);
    } catch (const scene::InputError& error) {
      faults.add(scene.places, fmt::format("bodies[{}].hydro.added_mass", i), error.what());
    } catch (const std::invalid_argument& error) {
      faults.add(scene.places, fmt::format("bodies[{}].hydro.added_mass", i), error.what());
    }
  }
  faults.throw_if_any();
}

}  // namespace assembly

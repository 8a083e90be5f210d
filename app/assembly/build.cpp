#include "app/assembly/build.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "app/assembly/build_added_mass.h"
#include "app/assembly/build_body.h"
#include "app/assembly/build_interior.h"
#include "app/assembly/build_radiation.h"
#include "app/assembly/build_resistance.h"
#include "app/assembly/build_rig.h"
#include "app/assembly/build_sea.h"
#include "app/assembly/build_shape.h"
#include "app/assembly/build_start.h"
#include "app/assembly/build_water.h"
#include "app/assembly/envelope.h"
#include "app/assembly/mesh_mending.h"
#include "app/assembly/radiation_database.h"
#include "app/assembly/rig_warnings.h"
#include "app/assembly/sea_warnings.h"
#include "app/assembly/start_warnings.h"
#include "app/base/schedule.h"
#include "app/base/wall_clock.h"
#include "engine/base/body_check.h"
#include "hydro/added_mass/surface_added_mass.h"
#include "hydro/mesh/terrain.h"

namespace assembly {
namespace {

std::string body_path(std::size_t i) { return fmt::format("bodies[{}]", i); }

engine::Ground build_ground(const scene::Ground& ground, BuildLog& log) {
  if (const auto* plane = std::get_if<scene::PlaneGround>(&ground))
    return engine::PlaneGround{plane->z};
  if (const auto* field = std::get_if<scene::HeightField>(&ground)) {
    try {
      return engine::MeshGround{
          hydro::terrain_mesh(height_field(*field, "ground.heightfield", log))};
    } catch (const std::invalid_argument& error) {
      log.faults.add(log.scene.places, "ground.heightfield", error.what());
    }
  }
  if (const auto* file = std::get_if<scene::Mesh>(&ground)) {
    hydro::TriMesh mesh = mesh_from_file(*file, "ground.mesh", log).first;
    if (asks_for_mending(file->mending))
      log.faults.add(log.scene.places, "ground.mesh",
                     "is a surface, and no solid is made of it: weld, cap, mirror, unite and "
                     "thickness are for bodies");
    if (make_sound(mesh, Soundness::surface, *file, "ground.mesh", log))
      return engine::MeshGround{std::move(mesh)};
  }
  return {};
}

/// Adds a fault for a body that the engine refuses, for example one that starts out of bounds.
void check_motion(const engine::BodySpec& spec, const std::string& path, BuildLog& log) {
  if (spec.mesh_B.vertex_count() == 0) return;  // Another fault has kept it from being made.
  try {
    engine::check_body(spec);
  } catch (const std::invalid_argument& error) {
    log.faults.add(log.scene.places, path, error.what());
  }
}

/// Refuses more than kMostSteps steps, which a mistyped step or duration may give.
void check_step_count(BuildLog& log) {
  const double steps = log.scene.duration / log.scene.step;
  if (!(steps <= app::kMostSteps))
    log.faults.add(log.scene.places, "duration",
                   fmt::format("{:g} s in steps of {:g} s are {:.3g} steps, expected at most {:g}",
                               log.scene.duration, log.scene.step, steps, app::kMostSteps));
}

/// Adds a fault for ground that the engine refuses because it lies out of bounds.
void check_ground(const engine::Ground& ground, BuildLog& log) {
  try {
    engine::check_ground(ground);
  } catch (const std::invalid_argument& error) {
    log.faults.add(log.scene.places, "ground", error.what());
  }
}

/// Returns a unit vector normal to `axis`, nearest to the world axis that is the least parallel to
/// it.
Eigen::Vector3d some_normal(const Eigen::Vector3d& axis) {
  Eigen::Index least;
  axis.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d e = Eigen::Vector3d::Unit(least);
  return (e - e.dot(axis) * axis).normalized();
}

engine::JointSpec::Type joint_type(scene::Joint::Type type) {
  using Type = engine::JointSpec::Type;
  switch (type) {
    case scene::Joint::Type::ball:
      return Type::ball;
    case scene::Joint::Type::hinge:
      return Type::hinge;
    case scene::Joint::Type::slider:
      return Type::slider;
    case scene::Joint::Type::fixed:
      return Type::fixed;
    case scene::Joint::Type::universal:
      return Type::universal;
  }
  throw std::logic_error("unknown type of joint");
}

engine::Integrator::Method integration_method(scene::Integrator::Method method) {
  switch (method) {
    case scene::Integrator::Method::split:
      return engine::Integrator::Method::split;
    case scene::Integrator::Method::ode:
      return engine::Integrator::Method::ode;
  }
  throw std::logic_error("unknown integration method");
}

engine::JointSpec build_joint(const scene::Scene& scene, const scene::Joint& joint) {
  engine::JointSpec spec{.name = joint.name,
                         .type = joint_type(joint.type),
                         .first = body_id(scene, joint.bodies[0]),
                         .second = body_id(scene, joint.bodies[1])};
  if (joint.anchor) spec.anchor_W = *joint.anchor;
  if (joint.axis) spec.axis_W = joint.axis->normalized();
  spec.axis2_W = some_normal(spec.axis_W);
  if (joint.axis2) {
    const Eigen::Vector3d& a = *joint.axis2;
    spec.axis2_W = (a - a.dot(spec.axis_W) * spec.axis_W).normalized();
  }
  return spec;
}

engine::ContactSpec build_contact(const scene::Scene& scene, const scene::Contact& contact) {
  return {.first = body_id(scene, contact.bodies[0]),
          .second = body_id(scene, contact.bodies[1]),
          .friction = contact.friction,
          .restitution = contact.restitution};
}

/// All but added mass, and the warning that counts it.
BuiltScene put_together(const scene::Scene& scene) {
  BuildLog log{.scene = scene};
  check_step_count(log);
  BuiltScene built;
  engine::SimulationSpec& spec = built.spec;
  spec.step = scene.step;
  spec.gravity = scene.gravity;
  spec.record_work = scene.log_forces;
  spec.integrator = {.method = integration_method(scene.integrator.method),
                     .tolerance = scene.integrator.tolerance.value_or(0)};
  if (scene.water) spec.sea = build_sea(*scene.water, scene.gravity, built.irregular_sea, log);
  if (spec.sea) spec.sea->air = scene.air;
  spec.ground = build_ground(scene.ground, log);
  check_ground(spec.ground, log);
  spec.ground_friction = scene.ground_friction;
  spec.ground_restitution = scene.ground_restitution;
  if (scene.suction)
    spec.suction =
        engine::BedSuction{.pressure = scene.suction->pressure, .time = scene.suction->time};
  build_bodies(built, log);
  for (const scene::Joint& joint : scene.joints) spec.joints.push_back(build_joint(scene, joint));
  put_afloat(built.centers_of_mass, spec, log);
  for (std::size_t i = 0; i < spec.bodies.size(); ++i)
    check_motion(spec.bodies[i], body_path(i), log);
  for (const scene::Contact& contact : scene.contacts)
    spec.contacts.push_back(build_contact(scene, contact));
  log.faults.throw_if_any();
  build_rig(built, log);
  log.faults.throw_if_any();
  put_to_rest(spec, log);
  heel_over(spec, log);
  std::vector<RadiationChoice> radiation = radiation_choices(scene, spec, log.faults);
  read_databases(scene, spec, radiation, log.faults);
  choose_resistances(scene, radiation, built, log);
  log.faults.throw_if_any();
  built.added_mass.resize(scene.bodies.size());
  built.notes = std::move(log.notes);
  built.warnings = std::move(log.warnings);
  for (std::string& warning : sea_warnings(scene, built))
    built.warnings.push_back(std::move(warning));
  for (std::string& warning : start_warnings(spec)) built.warnings.push_back(std::move(warning));
  for (std::string& warning : radiation_warnings(spec, radiation))
    built.warnings.push_back(std::move(warning));
  for (std::string& warning : interior_warnings(spec)) built.warnings.push_back(std::move(warning));
  for (std::string& warning : rig_warnings(scene, spec))
    built.warnings.push_back(std::move(warning));
  for (std::string& note : database_notes(spec, radiation)) built.notes.push_back(std::move(note));
  for (RadiationChoice& choice : radiation)
    built.radiation.push_back({.choice = std::move(choice)});
  return built;
}

void warn_of_envelope(BuiltScene& built) {
  if (auto warning = envelope_warning(built.spec)) built.warnings.push_back(std::move(*warning));
}

}  // namespace

BuiltScene build_without_added_mass(const scene::Scene& scene) {
  BuiltScene built = put_together(scene);
  warn_of_envelope(built);
  return built;
}

BuiltScene build(const scene::Scene& scene, AddedMassStore& store, app::Reporter& reporter) {
  BuiltScene built = put_together(scene);
  for (const std::string& note : built.notes)
    reporter.note(fmt::format("{}: note: {}", scene.file.string(), note));
  const app::WallClock clock;
  RadiationStore radiation_store(store.folder());
  add_simulated_water(scene, built, reporter);
  add_radiation(scene, built, radiation_store, reporter);
  add_added_mass(scene, built, store, reporter);
  solve_resistances(built, store.folder(), reporter);
  built.added_mass_seconds = clock.seconds();
  warn_of_envelope(built);
  return built;
}

BuiltScene build_on_threads(int threads, const scene::Scene& scene, AddedMassStore& store,
                            app::Reporter& reporter) {
  tbb::task_arena arena(threads);
  BuiltScene built = arena.execute([&] { return build(scene, store, reporter); });
  built.spec.threads = threads;
  return built;
}

void keep_solutions(const BuiltScene& built, const AddedMassStore& store, app::Reporter& reporter) {
  std::set<const hydro::SurfaceAddedMass*> kept;
  for (std::size_t i = 0; i < built.added_mass.size(); ++i) {
    const auto& report = built.added_mass[i];
    if (!report || !report->surface || report->surface->solves() == 0) continue;
    if (kept.insert(report->surface.get()).second)
      store.keep_nodes(engine::outside_B(built.spec.bodies[i]), report->surface->nodes(), reporter);
  }
}

}  // namespace assembly

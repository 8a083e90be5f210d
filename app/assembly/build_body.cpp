#include "app/assembly/build_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "app/assembly/build_interior.h"
#include "hydro/mesh/mass_properties.h"

namespace assembly {
namespace {

engine::CollisionShape collision_shape(const scene::Body& body) {
  switch (body.collision) {
    case scene::Collision::none:
      return engine::CollisionShape::none;
    case scene::Collision::mesh:
      return engine::CollisionShape::mesh;
    case scene::Collision::box:
      return engine::CollisionShape::box;
    case scene::Collision::sphere:
      return engine::CollisionShape::sphere;
    case scene::Collision::automatic:
      break;
  }
  if (std::holds_alternative<scene::Box>(body.shape)) return engine::CollisionShape::box;
  if (std::holds_alternative<scene::Sphere>(body.shape) ||
      std::holds_alternative<scene::Icosphere>(body.shape))
    return engine::CollisionShape::sphere;
  return engine::CollisionShape::mesh;
}

/// Mass, centre of mass (mesh frame) and inertia about it, body axes.
struct MassProperties {
  double mass = 0;
  Eigen::Vector3d center_of_mass = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
};

Eigen::Matrix3d to_matrix(const scene::Inertia& i) {
  Eigen::Matrix3d m;
  m << i.xx, i.xy, i.xz,  //
      i.xy, i.yy, i.yz,   //
      i.xz, i.yz, i.zz;
  return m;
}

/// Returns the mass properties that a scene gives a body, and for the rest those of a solid of
/// uniform density.
MassProperties mass_properties(const scene::Body& body, const hydro::SolidProperties& solid) {
  MassProperties p;
  p.mass = body.density ? *body.density * solid.volume : body.mass.value_or(0);
  p.center_of_mass = body.center_of_mass.value_or(solid.centroid);
  p.inertia = body.inertia ? to_matrix(*body.inertia)
                           : Eigen::Matrix3d(p.mass / solid.volume * solid.inertia);
  return p;
}

/// True if a closed mesh is needed, for the loads of the water or for a mass property that the
/// scene omits.
bool needs_solid(const scene::Body& body, bool wet) {
  return wet || body.density || !body.inertia || !body.center_of_mass;
}

/// Returns false and adds a fault for masses that double precision cannot carry through a step.
bool mass_is_usable(const MassProperties& p, const std::string& path, BuildLog& log) {
  const bool usable = std::isfinite(p.mass) && p.mass > 1e-30 && p.mass < 1e30 &&
                      p.inertia.allFinite() && p.inertia.diagonal().minCoeff() > 1e-60;
  if (!usable)
    log.faults.add(
        log.scene.places, path,
        fmt::format("its mass comes to {:.3g} kg and its least inertia to {:.3g} kg m^2; "
                    "expected a mesh and a density of a usable size",
                    p.mass, p.inertia.diagonal().minCoeff()));
  return usable;
}

engine::AppliedLoad applied_load(const scene::AppliedLoad& load, const Eigen::Vector3d& com_M) {
  engine::AppliedLoad applied{.force = load.force,
                              .torque = load.torque,
                              .in_body_frame = load.in_body_frame,
                              .at_B = load.at ? Eigen::Vector3d(*load.at - com_M)
                                              : Eigen::Vector3d(Eigen::Vector3d::Zero()),
                              .start = load.start,
                              .end = load.end};
  if (load.sine)
    applied.sine = engine::Sine{.frequency = load.sine->frequency, .phase = load.sine->phase};
  return applied;
}

/// Completes the coefficients from the mesh. A calibration takes the place of the shape's K.
hydro::Coefficients build_coefficients(const scene::Body& body, const hydro::TriMesh& mesh_B,
                                       const std::string& path, BuildLog& log) {
  const double viscosity = log.scene.water.value_or(scene::Water{}).viscosity;
  hydro::Coefficients coefficients = hydro::for_mesh(body.hydro, mesh_B, viscosity);
  if (!body.calibrated_drag) return coefficients;
  coefficients.drag_shape.setIdentity();
  try {
    coefficients.calibration =
        hydro::calibrate_drag(mesh_B, coefficients.pressure_drag, *body.calibrated_drag);
  } catch (const std::invalid_argument& error) {
    log.faults.add(log.scene.places, path + ".calibrate.drag", error.what());
  }
  return coefficients;
}

/// True if the water acts on a body.
bool feels_water(const scene::Body& body, const scene::Scene& scene) {
  using Added = scene::AddedMass::Model;
  const Added model = body.hydro.added_mass.model;
  const bool asks_for_added_mass = model != Added::automatic && model != Added::none;
  const bool resists = body.hydro.resistance.source != scene::Resistance::Source::none;
  return scene.water && (asks_for_added_mass || resists || !hydro::no_load(body.hydro));
}

/// The mesh of the added mass.
CenteredMesh centered_mesh(const hydro::TriMesh& mesh_B) {
  const Eigen::Vector3d centroid_B = hydro::solid_properties(mesh_B).centroid;
  return {hydro::translated(mesh_B, -centroid_B), -centroid_B};
}

/// Everything that follows from the shape and mass of a body, wherever it is.
struct MadeBody {
  engine::BodySpec spec;
  Eigen::Vector3d com_M = Eigen::Vector3d::Zero();
  CenteredMesh solid;               ///< Without vertices if the mesh is no solid.
  std::vector<MeshSource> sources;  ///< The files of its meshes.
};

/// Sets what the name, the place and the touch of a body give.
void place(const scene::Body& body, MadeBody& made) {
  engine::BodySpec& spec = made.spec;
  spec.name = body.name;
  spec.collision = collision_shape(body);
  spec.friction = body.friction;
  spec.restitution = body.restitution;
  spec.locked = body.locked;
  spec.initial = {.position = body.position + body.orientation * made.com_M,
                  .orientation = body.orientation,
                  .linear_velocity = body.linear_velocity,
                  .angular_velocity = body.angular_velocity};
  spec.loads.clear();
  for (const scene::AppliedLoad& load : body.forces)
    spec.loads.push_back(applied_load(load, made.com_M));
}

/// Makes the mesh and the mass of a body. @return false after a fault; there is no mesh then
bool make_solid(const scene::Body& body, const std::string& path, MadeBody& made, BuildLog& log) {
  const std::string shape_path = shape_key_path(body.shape, path);
  hydro::TriMesh mesh = shape_mesh(body.shape, path, log);
  made.sources = std::exchange(log.sources, {});
  const bool closed = needs_solid(body, made.spec.wet);
  if (!make_sound(mesh, closed ? Soundness::closed : Soundness::surface, body.shape, shape_path,
                  log))
    return false;
  const hydro::SolidProperties solid =
      closed ? hydro::solid_properties(mesh) : hydro::SolidProperties{};
  const MassProperties p = mass_properties(body, solid);
  if (!mass_is_usable(p, path, log)) return false;
  if (closed && std::holds_alternative<scene::Mesh>(body.shape))
    warn(made.sources.front().file, shape_path,
         density_warning(p.mass, solid.volume, made.sources.front()), log);
  made.com_M = p.center_of_mass;
  if (closed) made.solid = {hydro::translated(mesh, -solid.centroid), made.com_M - solid.centroid};
  made.spec.mesh_B = hydro::translated(std::move(mesh), -made.com_M);
  made.spec.mass = p.mass;
  made.spec.inertia_B = p.inertia;
  return true;
}

/// Closes the hollows of a body that is in its place, and completes its coefficients.
void make_outside(const scene::Body& body, const std::string& path, MadeBody& made, BuildLog& log) {
  engine::BodySpec& spec = made.spec;
  build_interior(body, spec);
  fill_interior(body, made.com_M, path, spec, log);
  spec.coefficients = build_coefficients(body, engine::outside_B(spec), path, log);
  if (made.solid.mesh_C.vertex_count() > 0 && spec.closed_mesh_B)
    made.solid = centered_mesh(engine::outside_B(spec));
}

/// True if the same is made of two bodies, up to what `place` sets and what their attitudes do to
/// hollows: of copies of a `repeat`, as a rule.
bool made_alike(const scene::Body& a, const scene::Body& b) {
  const auto holds_water = [](const scene::Body& body) {
    return body.air || !body.interior_water.empty() || !body.openings.empty() ||
           !body.pumps.empty();
  };
  const scene::Hydro &ha = a.hydro, &hb = b.hydro;
  return a.shape == b.shape && a.density == b.density && a.mass == b.mass &&
         a.center_of_mass == b.center_of_mass && a.inertia == b.inertia &&
         a.interior == b.interior && !holds_water(a) && !holds_water(b) &&
         a.calibrated_drag == b.calibrated_drag && ha.buoyancy == hb.buoyancy &&
         ha.pressure_drag == hb.pressure_drag && ha.lift == hb.lift &&
         ha.viscous_drag == hb.viscous_drag && ha.added_mass.model == hb.added_mass.model &&
         ha.wave_tolerance == hb.wave_tolerance;
}

MadeBody make_body(const scene::Body& body, const std::string& path, BuildLog& log) {
  MadeBody made;
  made.spec.wet = feels_water(body, log.scene);
  made.spec.summation.wave_tolerance = body.hydro.wave_tolerance;
  const bool sound = make_solid(body, path, made, log);
  place(body, made);
  if (sound) make_outside(body, path, made, log);
  return made;
}

/// Kinds of bodies with which one is compared: a scene of many bodies that all differ would be
/// built in the square of their number.
constexpr std::ptrdiff_t kMostCompared = 64;

/// The bodies of a scene, of which those that are alike are made once.
class Bodies {
 public:
  explicit Bodies(BuildLog& log) : bodies_(log.scene.bodies), log_(log) {}

  /// @param built   Has all bodies before this one.
  MadeBody make(std::size_t i, const BuiltScene& built) {
    const std::string path = fmt::format("bodies[{}]", i);
    const auto end = firsts_.rbegin() + std::min(kMostCompared, std::ssize(firsts_));
    const auto first = std::find_if(firsts_.rbegin(), end, [&](std::size_t k) {
      const bool hollow = built.spec.bodies[k].interior != engine::Interior::wet;
      const bool turned = bodies_[k].orientation.coeffs() != bodies_[i].orientation.coeffs();
      return made_alike(bodies_[k], bodies_[i]) && !(hollow && turned);
    });
    if (first != end) return copy(*first, i, path, built);
    MadeBody made = make_body(bodies_[i], path, log_);
    if (made.spec.mesh_B.vertex_count() > 0) firsts_.push_back(i);
    return made;
  }

 private:
  MadeBody copy(std::size_t first, std::size_t i, const std::string& path,
                const BuiltScene& built) {
    MadeBody made{.spec = built.spec.bodies[first],
                  .com_M = built.centers_of_mass[first],
                  .solid = built.solids[first],
                  .sources = built.mesh_sources[first]};
    if (!has_memory(static_cast<double>(made.spec.mesh_B.face_count()),
                    shape_key_path(bodies_[i].shape, path), log_))
      return {};
    place(bodies_[i], made);
    return made;
  }

  const std::vector<scene::Body>& bodies_;
  BuildLog& log_;
  std::vector<std::size_t> firsts_;  ///< One of each kind.
};

}  // namespace

void build_bodies(BuiltScene& built, BuildLog& log) {
  Bodies bodies(log);
  for (std::size_t i = 0; i < log.scene.bodies.size(); ++i) {
    MadeBody made = bodies.make(i, built);
    built.spec.bodies.push_back(std::move(made.spec));
    built.centers_of_mass.push_back(made.com_M);
    built.mesh_sources.push_back(std::move(made.sources));
    built.solids.push_back(std::move(made.solid));
  }
}

}  // namespace assembly

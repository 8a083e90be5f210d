#include "engine/base/body_check.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "engine/base/constants.h"
#include "engine/base/state_checks.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

[[noreturn]] void refuse(const BodySpec& spec, const std::string& what) {
  throw std::invalid_argument(fmt::format("body '{}': {}", spec.name, what));
}

bool within_bounds(const hydro::TriMesh& mesh) {
  return (mesh.vertices.array().abs() <= kLargestState).all();
}

void check_inertia(const BodySpec& spec) {
  const Eigen::Matrix3d& inertia = spec.inertia_B;
  if (!inertia.allFinite()) refuse(spec, "the inertia is not finite");
  const double size = inertia.cwiseAbs().maxCoeff();
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() > kInertiaTolerance * size)
    refuse(spec, "the inertia matrix is not symmetric");
  const Eigen::Vector3d moments = hydro::eigenvalues(inertia);
  if (!(moments[0] > 0))
    refuse(spec, fmt::format("a principal moment of inertia is {}, not positive", moments[0]));
  if (moments[2] > moments[0] + moments[1] + kInertiaTolerance * moments[2])
    refuse(spec, fmt::format("no solid has the principal moments of inertia {}, {}, {}: one is "
                             "above the sum of the others",
                             moments[0], moments[1], moments[2]));
}

}  // namespace

void check_initial_state(const BodySpec& spec, const hydro::BodyState& state) {
  if (const auto fault = state_fault(state)) refuse(spec, "initially, " + *fault);
  if (std::abs(state.orientation.norm() - 1) > kUnitTolerance)
    refuse(spec, "the initial orientation is not a unit quaternion");
}

void check_body(const BodySpec& spec) {
  if (!(spec.mass > 0 && std::isfinite(spec.mass)))
    refuse(spec, fmt::format("the mass is {} kg, not positive", spec.mass));
  check_inertia(spec);
  check_initial_state(spec, spec.initial);
  if (!spec.mesh_B.vertices.allFinite()) refuse(spec, "a vertex of its mesh is not finite");
  if (!within_bounds(spec.mesh_B)) refuse(spec, "its mesh reaches beyond all bounds");
  if (spec.radiation && !spec.added_mass)
    refuse(spec, "it makes waves but has no added mass, which radiation needs");
  if (spec.collision != CollisionShape::none && spec.mesh_B.face_count() == 0)
    refuse(spec, "it collides but its mesh has no triangles");
}

void check_ground(const Ground& ground) {
  const auto* plane = std::get_if<PlaneGround>(&ground);
  const auto* mesh = std::get_if<MeshGround>(&ground);
  const bool inside =
      (!plane || std::abs(plane->z) <= kLargestState) && (!mesh || within_bounds(mesh->mesh_W));
  if (!inside)
    throw std::invalid_argument(fmt::format(
        "the ground reaches beyond all bounds, expected coordinates within {:g} m", kLargestState));
}

}  // namespace engine

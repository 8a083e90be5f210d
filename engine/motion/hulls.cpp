#include "engine/motion/hulls.h"

#include <algorithm>

namespace engine {

const hydro::TriMesh& water_mesh(const BodySpec& spec) {
  return spec.interior == Interior::dry ? outside_B(spec) : spec.mesh_B;
}

std::shared_ptr<const hydro::Hull> Hulls::of(const BodySpec& spec) {
  if (spec.hull) return spec.hull;
  const hydro::TriMesh& mesh_B = water_mesh(spec);
  const auto same = std::find_if(hulls_.begin(), hulls_.end(), [&](const auto& hull) {
    return hydro::same_mesh(hull->mesh_B, mesh_B);
  });
  if (same != hulls_.end()) return *same;
  return hulls_.emplace_back(std::make_shared<const hydro::Hull>(hydro::make_hull(mesh_B)));
}

std::shared_ptr<const hydro::HullLift> Hulls::lift_of(const BodySpec& spec) {
  const hydro::TriMesh& mesh_B = outside_B(spec);
  const auto same = std::find_if(lifts_.begin(), lifts_.end(), [&](const Lift& lift) {
    return hydro::same_mesh(*lift.mesh_B, mesh_B);
  });
  if (same != lifts_.end()) return same->sections;
  auto sections = std::make_shared<const hydro::HullLift>(mesh_B);
  if (!sections->may_lift()) sections.reset();
  return lifts_.emplace_back(Lift{.mesh_B = &mesh_B, .sections = std::move(sections)}).sections;
}

std::shared_ptr<const WakeParts> Hulls::wake_of(const BodySpec& spec) {
  const hydro::TriMesh& mesh_B = outside_B(spec);
  const auto same = std::find_if(wakes_.begin(), wakes_.end(), [&](const Wake& wake) {
    return hydro::same_mesh(*wake.mesh_B, mesh_B);
  });
  if (same != wakes_.end()) return same->parts;
  auto parts = std::make_shared<const WakeParts>(
      WakeParts{.scale = hydro::wake_scale(mesh_B), .edges = hydro::EdgeDrag(mesh_B)});
  return wakes_.emplace_back(Wake{.mesh_B = &mesh_B, .parts = std::move(parts)}).parts;
}

void keep_hulls(SimulationSpec& spec, Hulls& hulls) {
  for (BodySpec& body : spec.bodies)
    if (body.wet && spec.sea) body.hull = hulls.of(body);
}

}  // namespace engine

#include "engine/motion/hulls.h"

#include <algorithm>

namespace engine {

const hydro::TriMesh& water_mesh(const BodySpec& spec) {
  return spec.interior == Interior::dry ? outside_B(spec) : spec.mesh_B;
}

template <class Part, class Make>
std::shared_ptr<const Part> Hulls::shared(std::vector<OfMesh<Part>>& parts,
                                          const hydro::TriMesh& mesh_B, Make&& make) {
  const auto same = std::find_if(parts.begin(), parts.end(), [&](const OfMesh<Part>& earlier) {
    return hydro::same_mesh(*earlier.mesh_B, mesh_B);
  });
  if (same != parts.end()) return same->part;
  return parts.emplace_back(OfMesh<Part>{&mesh_B, make()}).part;
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

std::shared_ptr<const hydro::kernel::FeltSea> Hulls::felt_sea(
    const std::shared_ptr<const hydro::Hull>& hull, const hydro::Sea& sea,
    const hydro::LoadAccuracy& how) {
  const auto same = std::find_if(felt_seas_.begin(), felt_seas_.end(), [&](const auto& earlier) {
    return earlier.hull == hull && earlier.wave_tolerance == how.wave_tolerance;
  });
  if (same != felt_seas_.end()) return same->sea;
  return felt_seas_
      .emplace_back(FeltByHull{hull, how.wave_tolerance, hydro::make_felt_sea(*hull, sea, how)})
      .sea;
}

std::shared_ptr<const hydro::HullLift> Hulls::lift_of(const BodySpec& spec) {
  const hydro::TriMesh& mesh_B = outside_B(spec);
  return shared(lifts_, mesh_B, [&] {
    auto sections = std::make_shared<const hydro::HullLift>(mesh_B);
    return sections->may_lift() ? sections : nullptr;
  });
}

std::shared_ptr<const WakeParts> Hulls::wake_of(const BodySpec& spec) {
  const hydro::TriMesh& mesh_B = outside_B(spec);
  return shared(wakes_, mesh_B, [&] {
    return std::make_shared<const WakeParts>(
        WakeParts{.scale = hydro::wake_scale(mesh_B), .edges = hydro::EdgeDrag(mesh_B)});
  });
}

void keep_hulls(SimulationSpec& spec, Hulls& hulls) {
  for (BodySpec& body : spec.bodies)
    if (body.wet && spec.sea) body.hull = hulls.of(body);
}

}  // namespace engine

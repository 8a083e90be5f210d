#include "engine/hollows/interior_water.h"

#include <algorithm>
#include <cmath>

#include "engine/motion/moving_body.h"

namespace engine {
namespace {

/// The lowest vertex of the sills of a pocket, in W; none for a void.
std::optional<Eigen::Vector3d> lowest_of_sill(const hydro::TriMesh& mesh_B,
                                              const hydro::Pockets& division, int pocket,
                                              const hydro::BodyState& state) {
  std::optional<Eigen::Vector3d> lowest;
  for (const hydro::SillEdge& edge : division.sills) {
    if (edge.pocket != pocket && edge.other != pocket) continue;
    for (const int v : {edge.from, edge.to}) {
      const Eigen::Vector3d p = state.position + state.orientation * mesh_B.vertices.col(v);
      if (!lowest || p.z() < lowest->z()) lowest = p;
    }
  }
  return lowest;
}

PocketState pocket_state(const MovingBody& moving, int pocket, double time) {
  const hydro::BodyState& state = moving.motion.state;
  const CarriedWater& carried = *moving.motion.carried_water;
  const PocketContent& content = carried.pockets[pocket];
  const hydro::Hull& hull = carried.interior->pockets[pocket];
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  PocketState report{.id = content.id,
                     .volume = content.volume,
                     .level = NAN,
                     .capacity = carried.interior->division.pockets[pocket].capacity,
                     .spill = HUGE_VAL,
                     .flooded = content.flooded,
                     .inflow = content.inflow,
                     .air = NAN,
                     .centroid_W = Eigen::Vector3d::Constant(NAN)};
  const auto sill =
      lowest_of_sill(moving.body.spec->mesh_B, carried.interior->division, pocket, state);
  if (sill) {
    report.spill = sill->z();
    report.capacity = hydro::water_up_to(hull, R_WB, sill->z() - state.position.z()).volume;
  } else if (moving.body.spec->air) {
    report.air = content.air / air_volume(content, report.capacity);
  }
  if (!content.holds()) return report;
  if (content.flooded) {
    const Eigen::Vector3d& p = sill.value_or(state.position);
    report.level = hydro::surface_height(*moving.body.environment.sea, p.x(), p.y(), time);
    report.centroid_W = state.position + R_WB * content.centre_B;
    return report;
  }
  const hydro::WaterInside water = hydro::water_of(hull, R_WB, content.volume, content.surface);
  report.level = state.position.z() + water.level;
  report.centroid_W = state.position + hydro::centroid_of(hull, R_WB, water);
  return report;
}

}  // namespace

InteriorState interior_state(const MovingBody& moving, double time) {
  InteriorState report;
  if (!moving.motion.carried_water) return report;
  report.interior = moving.motion.carried_water->interior;
  const int pockets = static_cast<int>(moving.motion.carried_water->pockets.size());
  for (int i = 0; i < pockets; ++i) report.pockets.push_back(pocket_state(moving, i, time));
  return report;
}

}  // namespace engine

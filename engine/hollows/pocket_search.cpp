#include "engine/hollows/pocket_search.h"

#include <algorithm>
#include <cmath>

#include "engine/base/constants.h"
#include "engine/motion/body.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

using hydro::kSea;

/// A face of a pocket at its lowest vertex in an attitude.
int lowest_face(const hydro::TriMesh& mesh_B, const hydro::Pocket& pocket,
                const Eigen::Vector3d& up_B) {
  int lowest = pocket.faces.front();
  double least = HUGE_VAL;
  for (const int f : pocket.faces)
    for (const int v : mesh_B.faces.col(f)) {
      const double height = up_B.dot(mesh_B.vertices.col(v));
      if (height >= least) continue;
      least = height;
      lowest = f;
    }
  return lowest;
}

/// Height of the lowest sill of each pocket, above the centre of mass.
std::vector<double> spill_heights(const hydro::TriMesh& mesh_B, const hydro::Pockets& division,
                                  const Eigen::Vector3d& up_B) {
  std::vector<double> spill(division.pockets.size(), HUGE_VAL);
  for (const hydro::SillEdge& edge : division.sills) {
    const double height =
        std::min(up_B.dot(mesh_B.vertices.col(edge.from)), up_B.dot(mesh_B.vertices.col(edge.to)));
    for (const int space : {edge.pocket, edge.other})
      if (space != kSea) spill[space] = std::min(spill[space], height);
  }
  return spill;
}

bool same_height(double a, double b, double error) {
  return a == b || std::abs(a - b) <= error;  // The heights of voids are infinite.
}

/// True if the pockets at hand are those that a search finds in an attitude.
bool agree(const Body& body, const hydro::Interior& interior, const hydro::Pockets& found,
           const Eigen::Vector3d& up_B) {
  const hydro::TriMesh& mesh_B = body.spec->mesh_B;
  const Eigen::Matrix3d R_WB =
      hydro::shortest_turn(up_B, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const std::vector<double> spill = spill_heights(mesh_B, interior.division, up_B);
  const double error = kKeptVolume * body.box_B.volume();
  std::vector<double> capacity(spill.size());
  for (std::size_t i = 0; i < spill.size(); ++i)
    capacity[i] = std::isfinite(spill[i])
                      ? hydro::water_up_to(interior.pockets[i], R_WB, spill[i]).volume
                      : interior.division.pockets[i].capacity;
  for (const hydro::Pocket& pocket : found.pockets) {
    const int own = interior.division.pocket_of_face[lowest_face(mesh_B, pocket, up_B)];
    if (own == kSea || !same_height(spill[own], pocket.spill, kKeptSpill * body.radius) ||
        std::abs(capacity[own] - pocket.capacity) > error)
      return false;
    capacity[own] = 0;
  }
  return std::all_of(capacity.begin(), capacity.end(), [&](double c) { return c <= error; });
}

/// Height of the sea above the centre of mass, over a vertex.
double sea_level(const Body& body, const hydro::BodyState& state, double time, int vertex) {
  const Eigen::Vector3d p = state.position + state.orientation.toRotationMatrix() *
                                                 body.spec->mesh_B.vertices.col(vertex);
  return hydro::surface_height(*body.environment.sea, p.x(), p.y(), time) - state.position.z();
}

/// Gives the pockets of a new division the water of the old one, and that of the sea where they
/// reach beyond it.
void take_over(const Body& body, const hydro::BodyState& state, double time,
               const CarriedWater& old, CarriedWater& carried) {
  const hydro::TriMesh& mesh_B = body.spec->mesh_B;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const Eigen::Vector3d up_B = R_WB.row(2);
  carried.next_id = old.next_id;
  const std::size_t count = carried.pockets.size();
  std::vector<double> sea(count), from_sea(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const hydro::Pocket& pocket = carried.interior->division.pockets[i];
    sea[i] = sea_level(body, state, time, pocket.lowest);
    if (sea[i] > pocket.floor)
      from_sea[i] = hydro::water_up_to(carried.interior->pockets[i], R_WB, sea[i]).volume;
  }
  std::vector<bool> known(count, false);
  for (std::size_t i = 0; i < old.pockets.size(); ++i) {
    const int face = lowest_face(mesh_B, old.interior->division.pockets[i], up_B);
    const int to = carried.interior ? carried.interior->division.pocket_of_face[face] : kSea;
    if (to == kSea) continue;
    PocketContent& content = carried.pockets[to];
    content.id = known[to] ? std::min(content.id, old.pockets[i].id) : old.pockets[i].id;
    known[to] = true;
    content.volume += old.pockets[i].volume;
    content.inflow += old.pockets[i].inflow;
    content.flooded = content.flooded || old.pockets[i].flooded;
    content.air += old.pockets[i].air;
    from_sea[to] -= hydro::water_up_to(old.interior->pockets[i], R_WB, sea[to]).volume;
  }
  for (std::size_t i = 0; i < count; ++i) {
    PocketContent& content = carried.pockets[i];
    const hydro::Pocket& pocket = carried.interior->division.pockets[i];
    const hydro::Hull& hull = carried.interior->pockets[i];
    if (!known[i]) {
      content.id = carried.next_id++;
      content.flooded = sea[i] > pocket.spill;
      content.air = air_at_rest(body, pocket, 0);
    }
    if (from_sea[i] > kKeptSpill * pocket.capacity) {
      content.volume += from_sea[i];
      content.inflow += from_sea[i];
    }
    if (content.flooded) {
      content.inflow += pocket.capacity - content.volume;
      content.volume = pocket.capacity;
    }
    if (!(content.volume > 0)) continue;
    const hydro::WaterInside water = hydro::water_of(hull, R_WB, content.volume);
    content.surface = {water.level, water.area};
    content.centre_B = R_WB.transpose() * hydro::centroid_of(hull, R_WB, water);
    content.up_B = up_B;
  }
  carried.inertia_B = water_inertia(carried.pockets, body.environment.sea->density);
}

/// True if a division makes no difference: all of the body is in the sea.
bool is_all_sea(const Body& body, const hydro::BodyState& state, const CarriedWater& carried) {
  const auto [lowest, height] = vertical_extent(body, state);
  return lowest + height < body.environment.lowest &&
         std::all_of(carried.pockets.begin(), carried.pockets.end(),
                     [](const PocketContent& p) { return p.flooded; });
}

/// True if no water can get to where a division would differ.
bool is_sheltered(const Body& body, const hydro::BodyState& state, const CarriedWater& carried) {
  return carried.has_all && !carried.holds() &&
         lowest_sill(body, carried, state) >= body.environment.highest;
}

/// True if a search in an attitude near this one has found the pockets at hand.
bool is_known(const CarriedWater& carried, const Eigen::Vector3d& up_B) {
  return std::any_of(
      carried.known_up_B.rbegin(), carried.known_up_B.rend(),
      [&](const Eigen::Vector3d& known) { return known.dot(up_B) > kKnownAttitude; });
}

/// The first vertical in B that is not known on the way between two states, of which the second one
/// is not; the second one if the first is not known either.
Eigen::Vector3d first_unknown(const CarriedWater& carried, const hydro::BodyState& before,
                              const hydro::BodyState& after) {
  const auto up_B = [&](double fraction) -> Eigen::Vector3d {
    return before.orientation.slerp(fraction, after.orientation).toRotationMatrix().row(2);
  };
  double known = 0, unknown = 1;
  if (!is_known(carried, up_B(known))) return up_B(unknown);
  for (int i = 0; i < kAttitudeBisections; ++i) {
    const double middle = (known + unknown) / 2;
    (is_known(carried, up_B(middle)) ? known : unknown) = middle;
  }
  return up_B(unknown);
}

/// The water with the pockets that a search in the attitude `up_B` finds: that at hand, if it is
/// right there, too.
std::shared_ptr<const CarriedWater> searched(const Body& body, const Eigen::Vector3d& up_B,
                                             const hydro::BodyState& state, double time,
                                             const std::shared_ptr<const CarriedWater>& carried) {
  const hydro::Pockets found = hydro::find_pockets(body.spec->mesh_B, up_B);
  const bool right =
      carried->interior ? agree(body, *carried->interior, found, up_B) : found.pockets.empty();
  std::shared_ptr<CarriedWater> next;
  if (right) {
    next = std::make_shared<CarriedWater>(*carried);
    next->known_up_B.push_back(up_B);
  } else {
    next = dry_pockets(body, up_B);
    take_over(body, state, time, *carried, *next);
  }
  return next;
}

}  // namespace

double lowest_sill(const Body& body, const CarriedWater& carried, const hydro::BodyState& state) {
  const Eigen::RowVector3d up_B = state.orientation.toRotationMatrix().row(2);
  double lowest = HUGE_VAL;
  if (!carried.interior) return lowest;
  for (const hydro::SillEdge& edge : carried.interior->division.sills)
    lowest = std::min({lowest, up_B.dot(body.spec->mesh_B.vertices.col(edge.from)),
                       up_B.dot(body.spec->mesh_B.vertices.col(edge.to))});
  return state.position.z() + lowest;
}

std::shared_ptr<const CarriedWater> divided_for(
    const Body& body, const hydro::BodyState& before, const hydro::BodyState& after, double time,
    const std::shared_ptr<const CarriedWater>& carried) {
  const Eigen::Vector3d last_B = after.orientation.toRotationMatrix().row(2);
  std::shared_ptr<const CarriedWater> water = carried;
  while (!is_known(*water, last_B) && !is_all_sea(body, after, *water) &&
         !is_sheltered(body, after, *water))
    water = searched(body, first_unknown(*water, before, after), after, time, water);
  return water;
}

}  // namespace engine

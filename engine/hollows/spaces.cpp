#include "engine/hollows/spaces.h"

#include <algorithm>
#include <utility>

#include "engine/base/constants.h"
#include "engine/hollows/streams.h"
#include "engine/hollows/trapped_air.h"
#include "engine/motion/body.h"
#include "hydro/airy_waves.h"

namespace engine {

using hydro::kSea;

Spaces::Spaces(const Body& body, const hydro::BodyState& state, double time, CarriedWater& carried)
    : body_(body),
      sea_(*body.environment.sea),
      state_(state),
      time_(time),
      R_WB_(state.orientation.toRotationMatrix()),
      division_(carried.interior->division),
      water_(carried) {}

bool Spaces::is_void(int space) const {
  return space != kSea && division_.pockets[static_cast<std::size_t>(space)].is_void();
}

Eigen::Vector3d Spaces::vertex(int i) const { return R_WB_ * body_.spec->mesh_B.vertices.col(i); }

double Spaces::sea_level(const Eigen::Vector3d& r) const {
  const Eigen::Vector3d p = state_.position + r;
  return sea_.level - state_.position.z() + hydro::surface_elevation(sea_, p.x(), p.y(), time_);
}

double Spaces::level(int space, const Eigen::Vector3d& r) const {
  if (is_sea(space)) return sea_level(r);
  const PocketContent& content = water_.pockets[space];
  return content.volume > 0 ? content.surface.level : -HUGE_VAL;
}

double Spaces::head(int space, const Eigen::Vector3d& r) const {
  const double depth = level(space, r) - r.z();
  if (!is_sea(space)) return std::max(depth, 0.0) + air_head(*this, space);
  if (!(depth > 0)) return 0;
  return std::max(0.0, hydro::AiryWaves(sea_, time_).at(state_.position + r, depth).head);
}

double Spaces::volume_up_to(int pocket, double level) const {
  return hydro::water_up_to(hull(pocket), R_WB_, level).volume;
}

double Spaces::spill_of(const std::vector<int>& group, bool into_sea) const {
  double spill = HUGE_VAL;
  for (const hydro::SillEdge& edge : division_.sills) {
    const auto in = [&](int space) {
      return std::find(group.begin(), group.end(), space) != group.end();
    };
    const int outside = in(edge.pocket) ? edge.other : edge.pocket;
    if (in(edge.pocket) != in(edge.other) && (is_sea(outside) || !into_sea))
      spill = std::min({spill, vertex(edge.from).z(), vertex(edge.to).z()});
  }
  return spill;
}

/// The volume that makes the levels of two spaces equal, or the higher one that of the sill.
double Spaces::equalising(int from, int to, const Stream& stream) const {
  const auto level_of = [&](int space) {
    return is_sea(space) ? stream.sea_level : water_.pockets[space].surface.level;
  };
  const bool filled = is_sea(to) || water_.pockets[to].volume > 0;
  const double high = level_of(from);
  const double low = std::max(stream.lowest, filled ? level_of(to) : -HUGE_VAL);
  const double lacking =
      is_sea(to) ? HUGE_VAL : std::max(0.0, volume_up_to(to, high) - water_.pockets[to].volume);
  const double spare = is_sea(from)
                           ? HUGE_VAL
                           : std::max(0.0, water_.pockets[from].volume - volume_up_to(from, low));
  if (low > stream.lowest && std::isfinite(lacking) && std::isfinite(spare) && lacking + spare > 0)
    return lacking * spare / (lacking + spare);
  return std::min(lacking, spare);
}

/// The same where water meets trapped air in one of them, linear about the state at hand: a volume
/// adds itself over the area to a level above the opening, and times the stiffness of the air to
/// its head. No more comes than there is room for, nor leaves than stands above the opening.
double Spaces::equalising_air(int from, int to, double stiffness, const Stream& stream) const {
  double rise = stiffness, most = HUGE_VAL;  // Head that comes with a volume [1/m^2].
  for (const int space : {from, to}) {
    if (is_sea(space)) continue;
    const PocketContent& content = water_.pockets[space];
    if (content.volume > 0 && content.surface.level > stream.lowest)
      rise += 1 / content.surface.area;
    if (space == from)
      most = std::min(most, content.volume - volume_up_to(from, stream.lowest));
    else if (is_void(to))
      most = std::min(most, capacity(to) - content.volume);
  }
  return std::max(0.0, std::min(most, stream.head / rise));
}

void Spaces::exchange(int first, int second, const Stream& stream, double h) {
  const int from = stream.rate > 0 ? second : first, to = stream.rate > 0 ? first : second;
  const double stiffness = air_stiffness(*this, from) + air_stiffness(*this, to);
  const double whole =
      stiffness > 0 ? equalising_air(from, to, stiffness, stream) : equalising(from, to, stream);
  const double volume = limited_flow(std::abs(stream.rate) * h, whole);
  if (volume > 0) bring(from, to, volume);
}

void Spaces::bring(int from, int to, double volume) {
  if (!is_sea(from)) set_volume(from, water_.pockets[from].volume - volume);
  if (!is_sea(to)) set_volume(to, water_.pockets[to].volume + volume);
}

void Spaces::set_volume(int pocket, double volume) {
  PocketContent& content = water_.pockets[pocket];
  const double before = content.volume;
  // A volume that runs out ever slower ends at nothing, and one below the round-off of a body's
  // volumes has no surface that could be found.
  const double size = std::max(capacity(pocket), std::pow(body_.radius, 3));
  if (volume <= kLastWater * size) volume = 0;
  content.inflow += volume - before;
  content.volume = volume;
  if (!(volume > 0)) return;
  const hydro::WaterInside water = hydro::water_of(hull(pocket), R_WB_, volume, content.surface);
  content.surface = {water.level, water.area};
  if (volume <= before) return;
  const Eigen::Vector3d come = R_WB_.transpose() * hydro::centroid_of(hull(pocket), R_WB_, water);
  content.centre_B = (before * content.centre_B + (volume - before) * come) / volume;
  if (before == 0) content.up_B = R_WB_.row(2);
}

}  // namespace engine

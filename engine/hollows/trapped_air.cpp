#include "engine/hollows/trapped_air.h"

#include <algorithm>

#include "engine/base/constants.h"
#include "engine/motion/body.h"

namespace engine {
namespace {

double air_volume(const Spaces& spaces, int pocket) {
  return air_volume(spaces.water().pockets[pocket], spaces.capacity(pocket));
}

/// ρ g [N/m^3]
double weight_density(const Spaces& spaces) { return spaces.sea().density * spaces.sea().gravity; }

Eigen::Vector3d place_of(const Spaces& spaces, std::size_t opening) {
  return spaces.R_WB() * spaces.body().spec->openings[opening].at_B;
}

/// Lets air pass through an opening at r between two spaces.
void pass_air(Spaces& spaces, int first, int second, const Eigen::Vector3d& r) {
  const double difference = spaces.head(first, r) - spaces.head(second, r);
  if (difference == 0) return;
  const int from = difference > 0 ? first : second, to = difference > 0 ? second : first;
  if (spaces.level(from, r) > r.z()) return;  // Water is at the opening.
  double change = 0;  // Of the difference by the pV that passes; the atmosphere has no end.
  for (const int space : {from, to})
    if (traps_air(spaces, space)) change += 1 / air_volume(spaces, space);
  if (change == 0) return;
  const double passed = weight_density(spaces) * std::abs(difference) / change;
  if (traps_air(spaces, from)) spaces.water().pockets[from].air -= passed;
  if (traps_air(spaces, to)) spaces.water().pockets[to].air += passed;
}

/// True if an opening lets the air of a void out to the atmosphere.
bool is_vented(const Spaces& spaces, int space) {
  const std::vector<std::array<int, 2>>& sides = spaces.water().openings;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto [first, second] = sides[i];
    if (first != space && second != space) continue;
    const int other = first == space ? second : first;
    const Eigen::Vector3d r = place_of(spaces, i);
    const bool in_air = std::max(spaces.level(space, r), spaces.level(other, r)) <= r.z();
    if (in_air && !traps_air(spaces, other)) return true;
  }
  return false;
}

}  // namespace

bool traps_air(const Spaces& spaces, int space) {
  return spaces.body().spec->air && spaces.is_void(space) && spaces.sea().gravity > 0;
}

double air_head(const Spaces& spaces, int pocket) {
  if (!traps_air(spaces, pocket)) return 0;
  const double pressure = spaces.water().pockets[pocket].air / air_volume(spaces, pocket);
  return (pressure - kAtmosphere) / weight_density(spaces);
}

double air_stiffness(const Spaces& spaces, int space) {
  if (!traps_air(spaces, space) || is_vented(spaces, space)) return 0;
  const double volume = air_volume(spaces, space);
  return spaces.water().pockets[space].air / (volume * volume * weight_density(spaces));
}

void pass_air(Spaces& spaces) {
  if (!spaces.body().spec->air) return;
  for (std::size_t i = 0; i < spaces.water().openings.size(); ++i) {
    const auto [first, second] = spaces.water().openings[i];
    if (first != second) pass_air(spaces, first, second, place_of(spaces, i));
  }
}

}  // namespace engine

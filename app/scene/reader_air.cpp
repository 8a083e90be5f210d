#include <fmt/format.h>

#include <cmath>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

/// The strongest wind that a scene may have [m/s]. The strongest gust ever measured had 113 m/s;
/// faster air is compressed by what it meets.
constexpr double kStrongestWind = 150;

enum class Profile { power, uniform };

/// The block `wind`.
struct WindBlock {
  double speed = 0;
  double heading = 0;  ///< [rad]
  double height = 10;
  Profile profile = Profile::power;
  double exponent = 0.11;
};

void read(MapReader& map, WindBlock& wind) {
  map.required("speed", wind.speed, between(0, kStrongestWind, "m/s"));
  map.optional("heading_deg", wind.heading, degrees());
  map.optional("height", wind.height, positive("m"));
  map.optional("profile", wind.profile,
               ChoiceRule<Profile>{{{"power", Profile::power}, {"uniform", Profile::uniform}}});
  map.optional("exponent", wind.exponent, between(0, 1));
  map.note_condition("profile", "uniform", {}, {"height", "exponent"});
  if (wind.profile != Profile::uniform) return;
  for (const char* key : {"height", "exponent"})
    if (map.has(key)) map.fault(key, "not used with a uniform profile, expected power with it");
}

hydro::Wind built(const WindBlock& block) {
  const Eigen::Vector3d direction(std::cos(block.heading), std::sin(block.heading), 0);
  return {.velocity = block.speed * direction,
          .height = block.height,
          .exponent = block.profile == Profile::power ? block.exponent : 0};
}

/// Reads `wind`: a velocity, uniform everywhere, or a block.
void read_wind(MapReader& map, hydro::Wind& wind) {
  const NumberRule rule = between(-kStrongestWind, kStrongestWind, "m/s");
  WindBlock block;
  const auto value =
      map.find_unless_block("wind", expectation(rule, false, 3) + ", the last 0, or a map",
                            "[0, 0, 0]", block, {shape(rule, false, 3)});
  if (!value) {
    wind = built(block);
    return;
  }
  std::array<double, 3> velocity = {};
  if (!read_numbers(*value, rule, velocity)) return;
  wind.velocity << velocity[0], velocity[1], velocity[2];
  if (velocity[2] != 0)
    value->item(2).fault(fmt::format("found {:g}, expected 0: wind is horizontal", velocity[2]));
  else if (wind.velocity.norm() > kStrongestWind)
    value->fault(fmt::format("found a speed of {:.4g} m/s, expected at most {:g} m/s",
                             wind.velocity.norm(), kStrongestWind));
}

}  // namespace

void read(MapReader& map, hydro::Air& air) {
  map.optional("density", air.density, positive("kg/m^3"));
  read_wind(map, air.wind);
}

}  // namespace scene

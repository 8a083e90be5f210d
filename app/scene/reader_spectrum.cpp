#include <fmt/format.h>

#include <cmath>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

/// Reads what says how high and long the waves are: a file, or the parameters of a formula.
/// @param known   The type is known, so that the keys must suit it.
void read_height_and_period(MapReader& map, Spectrum& spectrum, bool known) {
  const bool by_file = spectrum.type == Spectrum::Type::file;
  map.note_condition("type", "file", {"file"}, {"significant_height", "peak_period"});
  for (const char* type : {"jonswap", "pierson_moskowitz", "bretschneider", "tma"})
    map.note_condition("type", type, {"significant_height", "peak_period"}, {"file"});
  map.optional("file", spectrum.file, FileRule{});
  std::optional<double> height, period;
  map.optional("significant_height", height, positive("m"));
  map.optional("peak_period", period, positive("s"));
  spectrum.significant_height = height.value_or(0);
  spectrum.peak_period = period.value_or(0);
  if (!known) return;
  if (by_file && !map.has("file")) map.fault("file", "missing, expected a file with type: file");
  if (!by_file && map.has("file"))
    map.fault("file", "not used with this type, expected type: file");
  for (const auto& [key, unit] :
       {std::pair("significant_height", "m"), std::pair("peak_period", "s")}) {
    if (by_file && map.has(key)) map.fault(key, "not used with type: file, which has its own");
    if (!by_file && !map.has(key))
      map.fault(key, "missing, expected " + expectation(positive(unit), false, 0));
  }
}

/// Reads a number, or `auto` as none.
void read_gamma(MapReader& map, Spectrum& spectrum) {
  const NumberRule rule = between(1, 10);
  const std::string expected = expectation(rule, false, 0) + ", or auto";
  const auto value =
      map.find("gamma", expected, "3.3", {shape(rule, false, 0), words_shape({"auto"})});
  for (const char* type : {"pierson_moskowitz", "bretschneider", "file"})
    map.note_condition("type", type, {}, {"gamma"});
  if (!value) return;
  double gamma = 1;
  if (value->node.is_word("auto"))
    spectrum.gamma.reset();
  else if (read_number(*value, rule, expected, gamma))
    spectrum.gamma = gamma;
  using Type = Spectrum::Type;
  if (spectrum.type != Type::jonswap && spectrum.type != Type::tma)
    map.fault("gamma", "not used with this type, expected jonswap or tma with it");
}

}  // namespace

void read(MapReader& map, Spectrum& spectrum) {
  using Type = Spectrum::Type;
  const bool known = map.required("type", spectrum.type,
                                  ChoiceRule<Type>{{{"jonswap", Type::jonswap},
                                                    {"pierson_moskowitz", Type::pierson_moskowitz},
                                                    {"bretschneider", Type::bretschneider},
                                                    {"tma", Type::tma},
                                                    {"file", Type::file}}});
  read_height_and_period(map, spectrum, known);
  read_gamma(map, spectrum);
  map.optional("heading_deg", spectrum.heading, degrees());
  map.optional("spreading", spectrum.spreading, not_negative());
  map.optional("seed", spectrum.seed, number());
  map.optional("components", spectrum.components, between(1, 1024));
}

void read(MapReader& map, Elevation& elevation) {
  NumberRule hertz = positive("Hz");
  hertz.factor = 2 * M_PI;
  map.required("file", elevation.file, FileRule{});
  map.optional("at", elevation.at, number("m"));
  map.optional("heading_deg", elevation.heading, degrees());
  map.optional("start", elevation.start, number("s"));
  map.optional("lowest_frequency_hz", elevation.lowest, hertz);
  map.optional("highest_frequency_hz", elevation.highest, hertz);
  map.optional("components", elevation.components, between(1, 1024));
  if (elevation.lowest && elevation.highest && *elevation.lowest > *elevation.highest)
    map.fault("highest_frequency_hz",
              fmt::format("found {:g}, expected at least the lowest frequency of {:g} Hz",
                          *elevation.highest / hertz.factor, *elevation.lowest / hertz.factor));
}

}  // namespace scene

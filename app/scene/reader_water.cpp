#include <algorithm>
#include <cctype>
#include <string>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

/// Returns the extension of a file in lower case: `.png`.
std::string extension(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Checks `range`, which turns the grey levels of a picture into heights; a table has heights. A
/// file with another extension is classified by its content when it is loaded.
void check_format(MapReader& map, const HeightField& field) {
  const std::string format = extension(field.file);
  if (format == ".png" && !map.has("range"))
    map.fault("range", "missing, expected the heights of black and white [m] of the picture");
  if (format == ".csv" && map.has("range"))
    map.fault("range", "not used with a .csv file, which has heights in metres");
}

}  // namespace

void read(MapReader& map, Water& water) {
  map.optional("density", water.density, positive("kg/m^3"));
  map.optional("viscosity", water.viscosity, positive("m^2/s"));
  map.optional("level", water.level, number("m"));
  map.optional("current", water.current, number("m/s"));
  map.block("surface", water.surface);
}

void read(MapReader& map, Surface& surface) {
  map.exactly_one_of({"flat", "heightfield", "waves", "spectrum"});
  map.alternative<Flat>("flat", surface);
  map.alternative<HeightField>("heightfield", surface);
  std::vector<Wave> waves;
  if (map.blocks("waves", waves, {}, 1)) {
    if (waves.empty()) map.fault("waves", "found an empty list, expected at least one wave");
    surface = std::move(waves);
  }
  map.alternative<Spectrum>("spectrum", surface);
}

void read(MapReader&, Flat&) {}

void read(MapReader& map, HeightField& field) {
  const bool found = map.required("file", field.file, FileRule{});
  map.optional("cell", field.cell, positive("m"));
  map.optional("origin", field.origin, number("m"));
  if (map.optional("range", field.range, number("m")) && (*field.range)[0] >= (*field.range)[1])
    map.fault("range", "expected the lower height first: [lo, hi] with lo < hi");
  if (found) check_format(map, field);
}

void read(MapReader& map, Wave& wave) {
  map.required("amplitude", wave.amplitude, not_negative("m"));
  map.required("wavelength", wave.wavelength, positive("m"));
  map.optional("heading_deg", wave.heading, degrees());
  map.optional("phase_deg", wave.phase, degrees());
}

void read(MapReader& map, Spectrum& spectrum) {
  using Type = Spectrum::Type;
  map.required("type", spectrum.type, ChoiceRule<Type>{{{"jonswap", Type::jonswap}}});
  map.required("significant_height", spectrum.significant_height, positive("m"));
  map.required("peak_period", spectrum.peak_period, positive("s"));
  map.optional("gamma", spectrum.gamma, between(1, 10));
  map.optional("heading_deg", spectrum.heading, degrees());
  map.optional("spreading", spectrum.spreading, not_negative());
  map.optional("seed", spectrum.seed, number());
  map.optional("components", spectrum.components, between(1, 1024));
}

void read(MapReader& map, Ground& ground) {
  map.exactly_one_of({"z", "heightfield", "mesh"});
  std::optional<double> z;
  if (map.optional("z", z, number("m"))) ground = PlaneGround{*z};
  map.alternative<HeightField>("heightfield", ground);
  map.alternative<Mesh>("mesh", ground);
}

}  // namespace scene

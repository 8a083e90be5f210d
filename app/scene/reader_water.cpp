#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

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

/// The block `surface`: its shape, the model of the water below waves, and their ramp.
struct SurfaceBlock {
  Surface shape;
  hydro::Kinematics kinematics = hydro::Kinematics::airy;
  double ramp = 0;
};

/// Refuses a key that says something of waves alone beside a surface without waves.
void check_needs_waves(MapReader& map, const std::string& key) {
  map.note_condition(key, "", {}, {"flat", "heightfield"});
  if (!map.has(key)) return;
  if (map.has("heightfield"))
    map.fault(key,
              "given beside heightfield, expected waves, spectrum or elevation with it; a height "
              "field is fixed, and under it the pressure is always hydrostatic");
  else if (map.has("flat"))
    map.fault(key,
              "given beside flat, expected waves, spectrum or elevation with it; still water has "
              "no waves");
}

void read(MapReader& map, SurfaceBlock& surface) {
  map.exactly_one_of({"flat", "heightfield", "waves", "spectrum", "elevation"});
  map.alternative<Flat>("flat", surface.shape);
  map.alternative<HeightField>("heightfield", surface.shape);
  std::vector<Wave> waves;
  if (map.blocks("waves", waves, {}, 1)) {
    if (waves.empty()) map.fault("waves", "found an empty list, expected at least one wave");
    surface.shape = std::move(waves);
  }
  map.alternative<Spectrum>("spectrum", surface.shape);
  map.alternative<Elevation>("elevation", surface.shape);
  using hydro::Kinematics;
  map.optional("kinematics", surface.kinematics,
               ChoiceRule<Kinematics>{
                   {{"airy", Kinematics::airy}, {"hydrostatic", Kinematics::hydrostatic}}});
  check_needs_waves(map, "kinematics");
  map.optional("ramp", surface.ramp, not_negative("s"));
  check_needs_waves(map, "ramp");
}

/// Refuses a spectrum that its depth does not fit.
void check_depth(MapReader& map, const std::optional<double>& depth, const Spectrum& spectrum) {
  if (!depth && spectrum.type == Spectrum::Type::tma)
    map.fault("surface.spectrum.type",
              "tma needs water.depth; on deep water the same sea is of type jonswap");
  if (depth && !spectrum.file && spectrum.significant_height >= *depth)
    map.fault("surface.spectrum.significant_height",
              fmt::format("found {:g}, expected less than the depth of {:g} m",
                          spectrum.significant_height, *depth));
}

/// Refuses waves whose troughs reach the bottom.
void check_depth(MapReader& map, double depth, const std::vector<Wave>& waves) {
  double sum = 0;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const double before = std::exchange(sum, sum + waves[i].amplitude);
    if (before >= depth || sum < depth) continue;
    const std::string others =
        before > 0 ? fmt::format(" and {:g} of the waves before it", before) : "";
    map.fault(fmt::format("surface.waves[{}].amplitude", i),
              fmt::format("found {:g}{}, expected less than the depth of {:g} m",
                          waves[i].amplitude, others, depth));
  }
}

/// Refuses a table of the current where the water has no motion but a uniform one.
void check_current(MapReader& map, const Water& water) {
  const bool grid = std::holds_alternative<HeightField>(water.surface);
  if (water.current_profile.empty() || (!grid && water.kinematics == hydro::Kinematics::airy))
    return;
  map.fault("current",
            fmt::format("found a table, expected a list of 3 numbers [m/s]: {} has one velocity of "
                        "the water at all depths",
                        grid ? "water under a height field" : "kinematics hydrostatic"));
}

using Simulation = SimulatedWater::Kind;

/// Reads `none`, `picture`, or a block.
void read_simulated(MapReader& map, SimulatedWater& simulated) {
  const std::string expected =
      "none, picture, or {}, with the keys size, spacing and edge if need be";
  const std::string before = simulated.kind == Simulation::none      ? "none"
                             : simulated.kind == Simulation::picture ? "picture"
                                                                     : "{}";
  const auto value = map.find_unless_block("simulated", expected, before, simulated,
                                           {words_shape({"none", "picture"})});
  if (!value) return;
  if (value->node.is_word("none"))
    simulated = {};
  else if (value->node.is_word("picture"))
    simulated = {.kind = Simulation::picture, .size = {}, .spacing = {}, .edge = {}};
  else
    value->refuse(expected);
}

constexpr int kFewestCells = 64, kMostCells = 2048;

}  // namespace

void read(MapReader& map, SimulatedWater& simulated) {
  simulated = {.kind = Simulation::felt, .size = {}, .spacing = {}, .edge = {}};
  if (map.optional("size", simulated.size, between(kFewestCells, kMostCells))) {
    const auto [columns, rows] = *simulated.size;
    if (columns != rows || (columns & (columns - 1)) != 0)
      map.fault("size", fmt::format("found [{}, {}], expected two equal powers of two, such as "
                                    "[256, 256]",
                                    columns, rows));
  }
  map.optional("spacing", simulated.spacing, positive("m"));
  map.optional("edge", simulated.edge, positive("m"));
}

void read(MapReader& map, Water& water) {
  map.optional("density", water.density, positive("kg/m^3"));
  map.optional("viscosity", water.viscosity, positive("m^2/s"));
  map.optional("level", water.level, number("m"));
  map.optional("depth", water.depth, positive("m"));
  read_current(map, water);
  SurfaceBlock surface;
  map.block("surface", surface);
  water.surface = std::move(surface.shape);
  water.kinematics = surface.kinematics;
  water.ramp = surface.ramp;
  read_simulated(map, water.simulated);
  check_current(map, water);
  if (const auto* waves = std::get_if<std::vector<Wave>>(&water.surface); waves && water.depth)
    check_depth(map, *water.depth, *waves);
  if (const auto* spectrum = std::get_if<Spectrum>(&water.surface))
    check_depth(map, water.depth, *spectrum);
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
  map.optional("wavelength", wave.wavelength, positive("m"));
  map.optional("period", wave.period, positive("s"));
  map.exactly_one_of({"wavelength", "period"});
  map.optional("heading_deg", wave.heading, degrees());
  map.optional("phase_deg", wave.phase, degrees());
}

void read(MapReader& map, Ground& ground) {
  map.exactly_one_of({"z", "heightfield", "mesh"});
  std::optional<double> z;
  if (map.optional("z", z, number("m"))) ground = PlaneGround{*z};
  map.alternative<HeightField>("heightfield", ground);
  map.alternative<Mesh>("mesh", ground);
}

}  // namespace scene

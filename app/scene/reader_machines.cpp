#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

/// Largest angle by which the chord may deviate from a right angle to the span [rad]; it covers
/// rounding to three digits.
constexpr double kSquareChord = 2e-3;

/// Reads a list of numbers of any length. @param least   Least length.
bool read_series(MapReader& map, const std::string& key, const NumberRule& rule, std::size_t least,
                 std::vector<double>& series) {
  const std::string unit = rule.unit.empty() ? "" : " [" + rule.unit + "]";
  const std::string expected = fmt::format("a list of at least {} numbers{}", least, unit);
  ValueShape list = list_shape(shape(rule, false, 0), 0);
  list.least = least;
  const auto value = map.find(key, expected, "required", {list});
  if (!value) return false;
  if (!value->node.is(YamlNode::Kind::list) || value->node.items.size() < least)
    return value->refuse(expected);
  for (std::size_t i = 0; i < value->node.items.size(); ++i) {
    double number = 0;
    if (!read_number(value->item(i), rule, expectation(rule, false, 0), number)) return false;
    series.push_back(number);
  }
  return true;
}

/// A table of two quantities over a rising one.
struct Series {
  const char* key;
  NumberRule rule;
  std::vector<double>* values;
};

/// Reads three columns of equal length, of which the first one rises.
void read_table(MapReader& map, const std::array<Series, 3>& columns) {
  constexpr std::size_t kFewestRows = 2;
  bool all = true;
  for (const Series& column : columns)
    all = read_series(map, column.key, column.rule, kFewestRows, *column.values) && all;
  if (!all) return;
  const std::vector<double>& first = *columns[0].values;
  for (std::size_t i = 1; i < first.size(); ++i)
    if (!(first[i] > first[i - 1]))
      map.fault(
          fmt::format("{}[{}]", columns[0].key, i),
          fmt::format("found {:g} after {:g}, expected rising values",
                      first[i] / columns[0].rule.factor, first[i - 1] / columns[0].rule.factor));
  for (const Series& column : {columns[1], columns[2]})
    if (column.values->size() != first.size())
      map.fault(column.key, fmt::format("found {} numbers, expected {}, one for each of {}",
                                        column.values->size(), first.size(), columns[0].key));
}

/// The block `model`.
struct ScrewModel {
  hydro::PropellerModel model;
};

void read(MapReader& map, ScrewModel& screw) {
  map.exactly_one_of({"wageningen", "open_water", "four_quadrant"});
  map.alternative<hydro::WageningenB>("wageningen", screw.model);
  map.alternative<hydro::OpenWaterTable>("open_water", screw.model);
  map.alternative<hydro::FourQuadrantTable>("four_quadrant", screw.model);
}

const ChoiceRule<bool> kHands = {{{"right", true}, {"left", false}}};

using FoilLaw = hydro::Foil::Law;

const ChoiceRule<FoilLaw> kFoilLaws = {{{"whicker_fehlner", FoilLaw::whicker_fehlner},
                                        {"soding", FoilLaw::soding},
                                        {"fujii", FoilLaw::fujii},
                                        {"table", FoilLaw::table}}};

/// Makes the chord exactly normal to the span.
void square_chord(MapReader& map, Foil& foil) {
  const double cosine = std::clamp(foil.axis.dot(foil.chord_axis), -1.0, 1.0);
  if (std::abs(std::acos(cosine) - std::numbers::pi / 2) > kSquareChord)
    map.fault(map.has("chord_axis") ? "chord_axis" : "axis",
              fmt::format("makes an angle of {:.1f} deg between axis and chord_axis, expected a "
                          "perpendicular one",
                          std::acos(cosine) * 180 / std::numbers::pi));
  else
    foil.chord_axis = (foil.chord_axis - cosine * foil.axis).normalized();
}

/// Refuses the keys that the law of a foil does not have.
void check_law(MapReader& map, FoilLaw law) {
  if (law != FoilLaw::table) {
    if (map.has("table")) map.fault("table", "is only used with law: table");
    return;
  }
  if (!map.has("table")) map.fault("table", "missing, expected a table with law: table");
  for (const char* key : {"drag", "stall_deg"})
    if (map.has(key)) map.fault(key, "not used by law: table, which has its own");
}

void read_foil(MapReader& map, Foil& foil, const char* among) {
  map.required("name", foil.name, NameRule{among, false});
  map.required("body", foil.body, TextRule{"the name of a body"});
  map.required("at", foil.at, number("m"));
  map.required("span", foil.foil.span, positive("m"));
  map.required("chord", foil.foil.chord, positive("m"));
  read_direction(map, "axis", foil.axis);
  read_direction(map, "chord_axis", foil.chord_axis);
  square_chord(map, foil);
  map.optional("angle_deg", foil.angle, degrees());
  map.optional("law", foil.foil.law, kFoilLaws);
  std::optional<double> aspect_ratio;
  map.optional("aspect_ratio", aspect_ratio, positive());
  foil.foil.aspect_ratio = aspect_ratio.value_or(0);
  map.optional("drag", foil.foil.drag_zero, not_negative());
  map.optional("stall_deg", foil.foil.stall, degrees_between(0, 74));
  map.block("table", foil.foil.table);
  map.note_condition("law", "table", {"table"}, {"drag", "stall_deg"});
  check_law(map, foil.foil.law);
}

}  // namespace

void read(MapReader& map, hydro::WageningenB& screw) {
  map.optional("blades", screw.blades, between(2, 7));
  map.optional("area_ratio", screw.area_ratio, between(0.3, 1.05));
  map.optional("pitch_ratio", screw.pitch_ratio, between(0.5, 1.4));
}

void read(MapReader& map, hydro::OpenWaterTable& table) {
  read_table(map, {{{"advance", number(), &table.advance_ratio},
                    {"kt", number(), &table.thrust_coefficient},
                    {"kq", number(), &table.torque_coefficient}}});
  map.optional("area_ratio", table.area_ratio, positive());
  if (!table.advance_ratio.empty() && table.advance_ratio.front() > 0)
    map.fault("advance", fmt::format("found {:g} first, expected a table from 0 or less on",
                                     table.advance_ratio.front()));
  const std::vector<double>& kt = table.thrust_coefficient;
  if (kt.size() > 1 && kt.back() >= kt[kt.size() - 2])
    map.fault("kt", "does not fall in its last interval, expected the thrust to fall there");
}

void read(MapReader& map, hydro::FourQuadrantTable& table) {
  read_table(map, {{{"beta_deg", degrees_between(-180, 180), &table.beta},
                    {"ct", number(), &table.thrust},
                    {"cq", number(), &table.torque}}});
}

void read(MapReader& map, hydro::Foil::Table& table) {
  read_table(map, {{{"angle_deg", degrees_between(-180, 180), &table.angle},
                    {"lift", number(), &table.lift},
                    {"drag", not_negative(), &table.drag}}});
}

void read(MapReader& map, Propeller& propeller) {
  map.required("name", propeller.name, NameRule{"propellers", false});
  map.required("body", propeller.body, TextRule{"the name of a body"});
  map.required("at", propeller.at, number("m"));
  read_direction(map, "axis", propeller.axis);
  hydro::Propeller& screw = propeller.screw;
  map.required("diameter", screw.diameter, positive("m"));
  ScrewModel model;
  const bool modelled = map.block("model", model);
  if (!modelled && !map.has("model"))
    map.fault("model", "missing, expected wageningen, open_water or four_quadrant in it");
  screw.model = std::move(model.model);
  map.optional("speed_rps", propeller.speed, number("1/s"));
  map.optional("wake", screw.wake, between(-0.9, 0.9));
  map.optional("deduction", screw.deduction, between(-0.9, 0.9));
  map.optional("rotative_efficiency", screw.rotative_efficiency, positive());
  map.optional("reverse", screw.reverse, positive());
  map.optional("hand", propeller.right_handed, kHands);
  map.optional("azimuth_deg", propeller.azimuth, degrees());
  read_direction(map, "pivot", propeller.pivot);
  map.optional("inertia", propeller.inertia, not_negative("kg m^2"));
}

void read(MapReader& map, Rudder& rudder) {
  read_foil(map, rudder, "rudders");
  map.optional("behind", rudder.behind, TextRule{"the name of a propeller"});
}

void read(MapReader& map, Sail& sail) { read_foil(map, sail, "sails"); }

}  // namespace scene

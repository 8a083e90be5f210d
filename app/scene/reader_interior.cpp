#include "app/scene/reader_blocks.h"

namespace scene {
namespace {

const ChoiceRule<Interior> kInteriors = {
    {{"flooding", Interior::flooding}, {"dry", Interior::dry}, {"wet", Interior::wet}}};

/// Reads `to`: a point, or `sea`.
void read_outlet(MapReader& map, std::optional<Eigen::Vector3d>& to) {
  const NumberRule rule = number("m");
  const std::string expected = "sea or a list of 3 numbers [m]";
  const auto value = map.find("to", expected, "sea", {words_shape({"sea"}), shape(rule, false, 3)});
  if (!value || value->node.is_word("sea")) return;
  if (!value->node.is(YamlNode::Kind::list)) {
    value->refuse(expected);
    return;
  }
  Eigen::Vector3d point;
  if (read_numbers(*value, rule, {point.data(), 3})) to = point;
}

}  // namespace

void read_interior(MapReader& map, Body& body) {
  map.optional("interior", body.interior, kInteriors);
  map.optional("air", body.air, TruthRule{});
  map.blocks("interior_water", body.interior_water);
  map.blocks("openings", body.openings);
  map.blocks("pumps", body.pumps);
  if (body.interior == Interior::flooding) return;
  const std::string needed = "needs interior: flooding, with which hollows take up water";
  if (body.air) map.fault("air", needed);
  if (!body.interior_water.empty()) map.fault("interior_water", needed);
  if (!body.openings.empty()) map.fault("openings", needed);
  if (!body.pumps.empty()) map.fault("pumps", needed);
}

void read(MapReader& map, InteriorWater& water) {
  map.required("at", water.at, number("m"));
  map.exactly_one_of({"volume", "level"});
  map.optional("volume", water.volume, positive("m^3"));
  map.optional("level", water.level, number("m"));
}

void read(MapReader& map, Opening& opening) {
  map.required("at", opening.at, number("m"));
  map.required("area", opening.area, positive("m^2"));
  map.optional("discharge", opening.discharge, positive());
}

void read(MapReader& map, Pump& pump) {
  map.required("name", pump.name, NameRule{"pumps", false});
  map.required("from", pump.from, number("m"));
  read_outlet(map, pump.to);
  map.required("rate", pump.rate, not_negative("m^3/s"));
  map.optional("head", pump.head, positive("m"));
}

}  // namespace scene

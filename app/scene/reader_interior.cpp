#include "app/scene/reader_blocks.h"

namespace scene {
namespace {

const ChoiceRule<Interior> kInteriors = {
    {{"flooding", Interior::flooding}, {"dry", Interior::dry}, {"wet", Interior::wet}}};

}  // namespace

void read_interior(MapReader& map, Body& body) {
  map.optional("interior", body.interior, kInteriors);
  map.blocks("interior_water", body.interior_water);
  map.blocks("openings", body.openings);
  if (body.interior == Interior::flooding) return;
  const std::string needed = "needs interior: flooding, with which hollows take up water";
  if (!body.interior_water.empty()) map.fault("interior_water", needed);
  if (!body.openings.empty()) map.fault("openings", needed);
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

}  // namespace scene

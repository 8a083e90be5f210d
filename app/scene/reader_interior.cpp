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
  for (const char* key : {"interior_water", "openings"})
    if (map.has(key)) map.fault(key, "needs interior: flooding, by which water is kept inside");
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

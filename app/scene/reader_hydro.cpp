#include "app/scene/reader_blocks.h"

namespace app {

namespace {

using Law = hydro::ViscousDrag::Law;

/// A coefficient, or `false` to switch its load off.
void read_coefficient(MapReader& map, const std::string& key, double& coefficient) {
  const std::string expected = "a number >= 0, or false";
  const auto value = map.find(key, expected, number_text(coefficient));
  if (!value) return;
  if (value->node.is_word("false"))
    coefficient = 0;
  else
    read_number(*value, not_negative(), expected, coefficient);
}

std::string law_text(const hydro::ViscousDrag& drag) {
  if (drag.law == Law::constant) return number_text(drag.coefficient);
  return drag.law == Law::thesis ? "thesis" : "false";
}

void read_viscous_drag(MapReader& map, hydro::ViscousDrag& drag) {
  const std::string expected = "a number >= 0, false or thesis";
  const auto value = map.find("viscous_drag", expected, law_text(drag));
  if (!value) return;
  double coefficient = 0;
  if (value->node.is_word("thesis"))
    drag = {.law = Law::thesis, .coefficient = 0};
  else if (value->node.is_word("false"))
    drag = {.law = Law::none, .coefficient = 0};
  else if (read_number(*value, not_negative(), expected, coefficient))
    drag = {.law = coefficient > 0 ? Law::constant : Law::none, .coefficient = coefficient};
}

void read_added_mass(MapReader& map) {
  const auto value = map.find("added_mass", "none", "none");
  if (!value || value->node.is_word("none")) return;
  if (value->node.is_word("deep") || value->node.find("matrix") != nullptr)
    value->fault("found " + describe(value->node) +
                 ", but this version computes no added mass; expected none");
  else
    value->refuse("none");
}

}  // namespace

void read(MapReader& map, hydro::Coefficients& coefficients) {
  map.optional("buoyancy", coefficients.buoyancy, TruthRule{});
  read_coefficient(map, "pressure_drag", coefficients.pressure_drag);
  read_coefficient(map, "lift", coefficients.lift);
  read_viscous_drag(map, coefficients.viscous_drag);
  read_added_mass(map);
}

}  // namespace app

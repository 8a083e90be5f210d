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

std::string drag_text(const hydro::PressureDrag& drag) {
  if (drag.front == drag.back) return number_text(drag.front);
  return "{front: " + number_text(drag.front) + ", back: " + number_text(drag.back) + "}";
}

/// One C_p, `false`, or one for each side.
void read_pressure_drag(MapReader& map, hydro::PressureDrag& drag) {
  const std::string expected = "a number >= 0, false, or {front, back}";
  const auto value = map.find_unless_block("pressure_drag", expected, drag_text(drag), drag);
  if (!value) return;
  double coefficient = 0;
  if (value->node.is_word("false"))
    drag = {0, 0};
  else if (read_number(*value, not_negative(), expected, coefficient))
    drag = {coefficient, coefficient};
}

std::string law_text(const hydro::ViscousDrag& drag) {
  switch (drag.law) {
    case Law::none:
      return "false";
    case Law::constant:
      return number_text(drag.coefficient);
    case Law::thesis:
      return "thesis";
    case Law::ittc57:
      return "ittc57";
  }
  return "";
}

void read_viscous_drag(MapReader& map, hydro::ViscousDrag& drag) {
  const std::string expected = "a number >= 0, false, thesis or ittc57";
  const auto value = map.find("viscous_drag", expected, law_text(drag));
  if (!value) return;
  double coefficient = 0;
  if (value->node.is_word("thesis"))
    drag.law = Law::thesis;
  else if (value->node.is_word("ittc57"))
    drag.law = Law::ittc57;
  else if (value->node.is_word("false"))
    drag.law = Law::none;
  else if (read_number(*value, not_negative(), expected, coefficient))
    drag.law = Law::constant;
  drag.coefficient = coefficient;
}

/// The length of the friction line.
void read_length(MapReader& map, hydro::ViscousDrag& drag) {
  std::optional<double> length;
  if (map.optional("length", length, positive("m"))) drag.length = *length;
  if (map.has("length") && drag.law != Law::ittc57)
    map.fault("length", "is only used with viscous_drag: ittc57");
}

enum class Preset { fitted, thesis };
const ChoiceRule<Preset> kPresets = {{{"fitted", Preset::fitted}, {"thesis", Preset::thesis}}};

void read_preset(MapReader& map, hydro::Coefficients& coefficients) {
  Preset preset = Preset::fitted;
  if (!map.optional("preset", preset, kPresets)) return;
  coefficients = preset == Preset::thesis ? hydro::thesis_coefficients() : hydro::Coefficients{};
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

void read(MapReader& map, hydro::PressureDrag& drag) {
  map.optional("front", drag.front, not_negative());
  map.optional("back", drag.back, not_negative());
}

void read(MapReader& map, hydro::Coefficients& coefficients) {
  read_preset(map, coefficients);
  map.optional("buoyancy", coefficients.buoyancy, TruthRule{});
  read_pressure_drag(map, coefficients.pressure_drag);
  read_coefficient(map, "lift", coefficients.lift);
  read_viscous_drag(map, coefficients.viscous_drag);
  read_length(map, coefficients.viscous_drag);
  read_added_mass(map);
}

}  // namespace app

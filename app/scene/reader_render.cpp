#include <fmt/format.h>

#include "app/base/words.h"
#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

/// Reads a number or how the end is found. Without the key, or after a fault, `end` is unchanged.
void read_end(MapReader& map, const char* key, const char* fallback, ScaleEnd& end) {
  const std::string expected = "a number [Pa], auto or drawn";
  const auto value = map.find(key, expected, fallback,
                              {shape(number("Pa"), false, 0), words_shape({"auto", "drawn"})});
  if (!value) return;
  double pressure = 0;
  if (value->node.is_word("auto"))
    end = {.found = ScaleEnd::Found::scene};
  else if (value->node.is_word("drawn"))
    end = {.found = ScaleEnd::Found::pictures};
  else if (read_number(*value, number("Pa"), expected, pressure))
    end = {.found = ScaleEnd::Found::given, .pressure = pressure};
}

/// The block of the colour scale.
struct PressureBlock {
  bool shown = true;
  ScaleEnd min = {ScaleEnd::Found::given, 0}, max;
  Colors colors = Colors::turbo;
  ShownPressure shows = ShownPressure::total;
};

void read(MapReader& map, PressureBlock& pressure) {
  const ChoiceRule<ShownPressure> what{{{"total", ShownPressure::total},
                                        {"hydrostatic", ShownPressure::hydrostatic},
                                        {"dynamic", ShownPressure::dynamic}}};
  const ChoiceRule<Colors> scales{{{"turbo", Colors::turbo},
                                   {"viridis", Colors::viridis},
                                   {"cividis", Colors::cividis},
                                   {"coolwarm", Colors::coolwarm},
                                   {"gray", Colors::gray},
                                   {"thesis", Colors::thesis}}};
  map.optional("shows", pressure.shows, what);
  // Dynamic pressure is negative where a surface recedes from the water.
  if (pressure.shows == ShownPressure::dynamic) pressure.colors = Colors::coolwarm;
  map.optional("colors", pressure.colors, scales);
  if (pressure.shows == ShownPressure::dynamic || diverges(pressure.colors)) pressure.min = {};
  read_end(map, "min", "0; auto if shows is dynamic or colors is coolwarm", pressure.min);
  read_end(map, "max", "auto", pressure.max);
  const bool given =
      pressure.min.found == ScaleEnd::Found::given && pressure.max.found == ScaleEnd::Found::given;
  if (given && pressure.max.pressure <= pressure.min.pressure)
    map.fault("max", fmt::format("found {:g}, expected more than min ({:g}) [Pa]",
                                 pressure.max.pressure, pressure.min.pressure));
}

/// Reads `none` or a block.
void read_pressure(MapReader& map, Render& render) {
  const std::string expected = "none, or a map";
  PressureBlock block;
  const auto value =
      map.find_unless_block("pressure", expected, "", block, {words_shape({"none"})});
  if (value && value->node.is_word("none"))
    block.shown = false;
  else if (value)
    value->refuse(expected);
  render.pressure_shown = block.shown;
  render.pressure_min = block.min;
  render.pressure_max = block.max;
  render.colors = block.colors;
  render.shows = block.shows;
}

const std::vector<std::pair<std::string, bool Show::*>> kShown = {
    {"forces", &Show::forces},       {"centres", &Show::centres}, {"waterline", &Show::waterline},
    {"wireframe", &Show::wireframe}, {"joints", &Show::joints},   {"trail", &Show::trail}};

void read_shown(MapReader& map, Show& show) {
  std::vector<std::string> words;
  for (const auto& [word, field] : kShown) words.push_back(word);
  const std::string expected = "a list of " + app::enumerate(words, "and");
  ValueShape list = list_shape(words_shape(words), 0);
  list.distinct = true;
  const auto value = map.find("show", expected, "[]", {list});
  if (!value) return;
  if (!value->node.is(YamlNode::Kind::list)) {
    value->refuse(expected);
    return;
  }
  for (std::size_t i = 0; i < value->node.items.size(); ++i) {
    std::size_t index = 0;
    const Value item = value->item(i);
    if (!read_word(item, words, index)) continue;
    bool& shown = show.*kShown[index].second;
    if (shown) item.fault(fmt::format("found {}, which is there already", item.node.text));
    shown = true;
  }
}

/// The block `sheet`, the layout of all pictures on a page.
struct SheetBlock {
  std::optional<int> columns;
};

void read(MapReader& map, SheetBlock& sheet) {
  map.optional("columns", sheet.columns, between(1, 24));
}

}  // namespace

void read(MapReader& map, Render& render) {
  map.optional("size", render.size, between(16, 8192, "px"));
  map.optional("every", render.every, positive("s"));
  map.block("camera", render.camera);
  read_cameras(map, render.cameras);
  map.at_most_one_of({"camera", "cameras"});
  map.note_condition("cameras", "", {}, {"camera"});
  SheetBlock sheet;
  map.block("sheet", sheet);
  render.sheet_columns = sheet.columns;
  read_shown(map, render.show);
  map.optional("overlay", render.overlay, TruthRule{});
  map.optional("grid", render.grid, TruthRule{});
  read_pressure(map, render);
}

}  // namespace scene

#include <fmt/format.h>

#include "app/scene/reader_blocks.h"
#include "app/scene/reader_nearest.h"

namespace app {

namespace {

/// A number, or `auto`: none. Left as it is without the key, and after a fault.
void read_end(MapReader& map, const char* key, const char* fallback, std::optional<double>& end) {
  const std::string expected = "a number [Pa], or auto";
  const auto value =
      map.find(key, expected, fallback, {shape(number("Pa"), false, 0), words_shape({"auto"})});
  if (!value) return;
  double number_of_it = 0;
  if (value->node.is_word("auto"))
    end.reset();
  else if (read_number(*value, number("Pa"), expected, number_of_it))
    end = number_of_it;
}

/// The colour scale.
struct PressureBlock {
  std::optional<double> min = 0, max;
  render::ColorMap colors = render::ColorMap::turbo;
  render::Pressure shows = render::Pressure::total;
};

void read(MapReader& map, PressureBlock& pressure) {
  using render::Pressure;
  const ChoiceRule<Pressure> what{{{"total", Pressure::total},
                                   {"hydrostatic", Pressure::hydrostatic},
                                   {"dynamic", Pressure::dynamic}}};
  map.optional("shows", pressure.shows, what);
  map.optional("colors", pressure.colors, ChoiceRule<render::ColorMap>{render::color_maps()});
  // Dynamic pressure is below that of the still water where a surface leaves it.
  if (pressure.shows == Pressure::dynamic) pressure.min.reset();
  read_end(map, "min", "0; auto if shows is dynamic", pressure.min);
  read_end(map, "max", "auto", pressure.max);
  if (pressure.min && pressure.max && *pressure.max <= *pressure.min)
    map.fault("max", fmt::format("found {:g}, expected more than min ({:g}) [Pa]", *pressure.max,
                                 *pressure.min));
}

const std::vector<std::pair<std::string, bool ShowScene::*>> kShown = {
    {"forces", &ShowScene::forces},
    {"centres", &ShowScene::centres},
    {"waterline", &ShowScene::waterline},
    {"wireframe", &ShowScene::wireframe}};

void read_shown(MapReader& map, ShowScene& show) {
  std::vector<std::string> words;
  for (const auto& [word, field] : kShown) words.push_back(word);
  const std::string expected = "a list of " + enumerate(words, "and");
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

/// Up in a picture is the world's up, so the camera cannot look along it. The smallest slope that
/// still tells sideways from round-off.
constexpr double kLeastSideways = 1e-6;

void check_view(MapReader& map, const CameraScene& camera) {
  const Eigen::Vector3d view = camera.to - camera.from;
  if (view.isZero(0))
    map.fault("", "looks from a point to the same point, expected two different ones");
  else if (view.head<2>().stableNorm() <= kLeastSideways * view.stableNorm())
    map.fault("", "looks straight up or down, expected from and to to differ in x or y");
}

}  // namespace

void read(MapReader& map, CameraScene& camera) {
  const bool from = map.optional("from", camera.from, number("m")) || !map.has("from");
  const bool to = map.optional("to", camera.to, number("m")) || !map.has("to");
  map.optional("fov_deg", camera.field_of_view, degrees_between(1, 170));
  if (from && to) check_view(map, camera);
}

void read(MapReader& map, RenderScene& render) {
  map.optional("size", render.size, between(16, 8192, "px"));
  map.optional("every", render.every, positive("s"));
  map.block("camera", render.camera);
  read_shown(map, render.show);
  PressureBlock pressure;
  map.block("pressure", pressure);
  render.pressure_min = pressure.min;
  render.pressure_max = pressure.max;
  render.colors = pressure.colors;
  render.shows = pressure.shows;
}

}  // namespace app

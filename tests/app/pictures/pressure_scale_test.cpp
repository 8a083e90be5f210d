#include <gtest/gtest.h>

#include "app/pictures/pressure_range.h"
#include "app/scene/reader.h"

namespace {

scene::Render read_render(const std::string& pressure) {
  const std::string text = "plimsoll: 1\nduration: 0\nrender: {pressure: " + pressure + "}\n";
  return *scene::parse(text, "scene.yaml", {}).render;
}

TEST(PressureScale, HasTheColorsThatTheSceneNames) {
  for (const auto& [name, map] : render::color_maps()) {
    const scene::Render look = read_render("{colors: " + name + "}");
    EXPECT_EQ(app::pressure_scale(look, app::PressureRange{}).colors, map) << name;
  }
}

TEST(PressureScale, ShowsThePartOfThePressureThatTheSceneNames) {
  using render::Pressure;
  const std::pair<std::string, Pressure> parts[] = {{"total", Pressure::total},
                                                    {"hydrostatic", Pressure::hydrostatic},
                                                    {"dynamic", Pressure::dynamic}};
  for (const auto& [name, part] : parts) {
    const scene::Render look = read_render("{shows: " + name + "}");
    EXPECT_EQ(app::pressure_scale(look, app::PressureRange{}).shows, part) << name;
  }
}

}  // namespace

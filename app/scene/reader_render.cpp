#include <fmt/format.h>

#include "app/scene/reader_blocks.h"

namespace app {

namespace {

/// The ends of the colour scale.
struct PressureBlock {
  double min = 0;
  std::optional<double> max;
};

void read(MapReader& map, PressureBlock& pressure) {
  const bool min_is_right = map.optional("min", pressure.min, number("Pa")) || !map.has("min");
  const std::string expected = "a number [Pa], or auto";
  const auto value =
      map.find("max", expected, "auto", {shape(number("Pa"), false, 0), words_shape({"auto"})});
  double max = 0;
  if (!value || value->node.is_word("auto") || !read_number(*value, number("Pa"), expected, max))
    return;
  if (min_is_right && max <= pressure.min)
    value->fault(fmt::format("found {:g}, expected more than min ({:g}) [Pa]", max, pressure.min));
  pressure.max = max;
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
  PressureBlock pressure;
  map.block("pressure", pressure);
  render.pressure_min = pressure.min;
  render.pressure_max = pressure.max;
}

}  // namespace app

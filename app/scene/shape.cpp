#include "app/scene/shape.h"

#include <fmt/format.h>

#include <cmath>

namespace scene {

const std::vector<std::pair<std::string, UpAxis>>& up_axes() {
  static const std::vector<std::pair<std::string, UpAxis>> axes = {
      {"x", UpAxis::x},        {"y", UpAxis::y},        {"z", UpAxis::z},
      {"-x", UpAxis::minus_x}, {"-y", UpAxis::minus_y}, {"-z", UpAxis::minus_z}};
  return axes;
}

const std::vector<std::pair<std::string, int>>& mirror_axes() {
  static const std::vector<std::pair<std::string, int>> axes = {{"x", 0}, {"y", 1}, {"z", 2}};
  return axes;
}

const std::vector<std::pair<std::string, double>>& length_units() {
  static const std::vector<std::pair<std::string, double>> units = {
      {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}, {"in", 0.0254}, {"ft", 0.3048}};
  return units;
}

std::string name_of(UpAxis up) {
  for (const auto& [word, axis] : up_axes())
    if (axis == up) return word;
  return "";
}

std::string name_of_unit(double unit) {
  for (const auto& [word, length] : length_units())
    if (std::abs(length - unit) <= 1e-6 * length) return word;
  return fmt::format("{:.6g} m", unit);
}

Shape as_shape(const SingleShape& shape) {
  return std::visit([](const auto& single) { return Shape(single); }, shape);
}

}  // namespace scene

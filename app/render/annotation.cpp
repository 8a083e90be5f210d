#include "app/render/annotation.h"

#include <algorithm>
#include <cmath>

#include "app/render/text.h"

namespace render {
namespace {

using Eigen::Vector2d;

/// Width of the pale outline that makes arrows and marks visible on any background [px].
constexpr double kHalo = 1.5;

/// Unit of lengths on a picture that is too small for text [px].
constexpr int kSmallUnit = 11;

double distance_to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double part = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0;
  return (p - a - part * along).norm();
}

/// Distance to a triangle, negative inside.
double distance_to_triangle(const Vector2d& p, const Vector2d (&corner)[3]) {
  double edge = HUGE_VAL;
  bool left = true, right = true;
  for (int i = 0; i < 3; ++i) {
    const Vector2d &a = corner[i], &b = corner[(i + 1) % 3];
    edge = std::min(edge, distance_to_segment(p, a, b));
    const double side = (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
    left = left && side >= 0;
    right = right && side <= 0;
  }
  return left || right ? -edge : edge;
}

/// Mixes a colour into the pixels of a box, weighted by the part of each pixel that a shape covers.
/// @param distance   Distance of a point from the shape, negative inside [px].
template <class Distance>
void fill_shape(Image& image, Vector2d low, Vector2d high, Rgb color, double weight,
                Distance&& distance) {
  const auto held = [](double value, int most) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
  };
  const int right = held(std::ceil(high.x() + 1), image.width);
  const int bottom = held(std::ceil(high.y() + 1), image.height);
  for (int y = held(std::floor(low.y() - 1), image.height); y < bottom; ++y)
    for (int x = held(std::floor(low.x() - 1), image.width); x < right; ++x) {
      const double cover = std::clamp(0.5 - distance(Vector2d(x + 0.5, y + 0.5)), 0.0, 1.0);
      if (cover > 0) blend(image, x, y, color, weight * cover);
    }
}

/// Draws a shaft and a head that is at most as long as the arrow.
void draw_arrow(Image& image, const Vector2d& from, const Vector2d& to, double size, Rgb color) {
  const double length = (to - from).norm();
  if (length < 1) return;
  const Vector2d along = (to - from) / length, across(-along.y(), along.x());
  const double head = std::min(0.75 * size, length), half_width = 0.11 * size;
  const Vector2d neck = to - head * along;
  const Vector2d corners[3] = {to, neck + 0.42 * head * across, neck - 0.42 * head * across};
  const Vector2d shaft_end = neck + 0.2 * head * along;
  const Vector2d low = from.cwiseMin(to).array() - size, high = from.cwiseMax(to).array() + size;
  const auto distance = [&](const Vector2d& p) {
    return std::min(distance_to_segment(p, from, shaft_end) - half_width,
                    distance_to_triangle(p, corners));
  };
  fill_shape(image, low, high, kPaper, 0.8, [&](const Vector2d& p) { return distance(p) - kHalo; });
  fill_shape(image, low, high, color, 1, distance);
}

/// Width of the bar of a ramp in the legend over the text size.
constexpr double kRampWidth = 4;

/// Draws a bar of the ramp's colours with its name; (left, y) is the middle of its left end.
void draw_ramp(Image& image, const LegendRamp& ramp, double left, double y, double size,
               const Font& font) {
  const double width = std::round(kRampWidth * size), height = std::round(0.5 * size);
  left = std::round(left);
  const double top = std::round(y - height / 2);
  fill(image, {left - 1, top - 1, width + 2, height + 2, 2}, kInk, 0.75);
  for (int i = 0; i < static_cast<int>(width); ++i) {
    const double place = (i + 0.5) / width * static_cast<double>(ramp.colors.size());
    fill(image, {left + i, top, 1, height, 0}, ramp.colors[static_cast<std::size_t>(place)]);
  }
  font.write(image, ramp.name, left + width + 0.6 * size, y + font.cap_height() / 2);
}

void draw_mark(Image& image, const Vector2d& at, const Mark& mark, double size, const Font& font) {
  const double radius = 0.32 * size;
  const Vector2d reach = Vector2d::Constant(radius + 2);
  const auto disc = [&](double r) {
    return [&at, r](const Vector2d& p) { return (p - at).norm() - r; };
  };
  fill_shape(image, at - reach, at + reach, kPaper, 0.9, disc(radius + kHalo));
  fill_shape(image, at - reach, at + reach, mark.color, 1, disc(radius));
  // Two pale quarters make the symbol of a centre of gravity.
  fill_shape(image, at - reach, at + reach, kPaper, 1, [&](const Vector2d& p) {
    const Vector2d d = p - at;
    return std::max(d.norm() - radius + 1.2, -d.x() * d.y() > 0 ? -0.5 : 0.5);
  });
  const double off = radius + 0.3 * size;
  const double x = at.x() + (mark.letter_left ? -off : off), y = at.y() + font.cap_height() / 2;
  const Align align = mark.letter_left ? Align::right : Align::left;
  for (const double dx : {-1.0, 0.0, 1.0})
    for (const double dy : {-1.0, 0.0, 1.0})
      font.write(image, mark.letter, x + dx, y + dy, align, kPaper);
  font.write(image, mark.letter, x, y, align, mark.color);
}

}  // namespace

std::optional<Vector2d> pixel_of(const View& view, const Image& image, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d d = p_W - view.eye_W;
  const double depth = d.dot(view.forward_W);
  if (depth < view.near) return std::nullopt;
  const double x = d.dot(view.right_W) / (depth * view.half_width);
  const double y = d.dot(view.up_W) / (depth * view.half_height);
  return Vector2d(0.5 * (1 + x) * image.width, 0.5 * (1 - y) * image.height);
}

void draw_line(Image& image, const Vector2d& from, const Vector2d& to, double width, Rgb color,
               double weight) {
  const double half = width / 2;
  fill_shape(image, from.cwiseMin(to).array() - half, from.cwiseMax(to).array() + half, color,
             weight, [&](const Vector2d& p) { return distance_to_segment(p, from, to) - half; });
}

void annotate(Image& image, const View& view, const Annotations& notes) {
  if (notes.arrows.empty() && notes.marks.empty()) return;
  const int size = std::max(kSmallUnit, text_size_on(image));
  const Font font(size);
  for (const Arrow& arrow : notes.arrows) {
    const auto from = pixel_of(view, image, arrow.from_W), to = pixel_of(view, image, arrow.to_W);
    if (from && to) draw_arrow(image, *from, *to, size, arrow.color);
  }
  for (const Mark& mark : notes.marks)
    if (const auto at = pixel_of(view, image, mark.at_W)) draw_mark(image, *at, mark, size, font);
}

void add_legend(Image& image, const View& view, const Annotations& notes) {
  const int size = text_size_on(image);
  if ((notes.legend.empty() && !notes.ramp) || size == 0) return;
  const Font font(size);
  const double arrow = notes.scale_length * image.height / (2 * view.half_height * view.distance);
  const bool scaled = !notes.scale_name.empty();
  double width = scaled ? arrow + 0.7 * size + font.width(notes.scale_name) : 0;
  for (const LegendLine& line : notes.legend)
    width = std::max(width, 1.7 * size + font.width(line.name));
  if (notes.ramp) width = std::max(width, (kRampWidth + 0.6) * size + font.width(notes.ramp->name));
  const double step = 1.5 * size;
  const double rows =
      static_cast<double>(notes.legend.size()) + (notes.ramp ? 1 : 0) + (scaled ? 1.2 : 0);
  const Panel panel = {0.8 * size, image.height - (rows * step + 1.8 * size), width + 1.2 * size,
                       rows * step + size, 0.3 * size};
  fill(image, panel, kPaper, kPaperWeight);
  const double left = panel.left + 0.6 * size;
  double y = panel.top + 1.25 * size;
  for (const LegendLine& line : notes.legend) {
    draw_line(image, {left + 0.1 * size, y}, {left + 1.1 * size, y}, 0.35 * size, line.color);
    font.write(image, line.name, left + 1.7 * size, y + font.cap_height() / 2);
    y += step;
  }
  if (notes.ramp) {
    draw_ramp(image, *notes.ramp, left, y, size, font);
    y += step;
  }
  if (!scaled) return;
  y += 0.2 * step;
  draw_arrow(image, {left, y}, {left + arrow, y}, size, kInk);
  font.write(image, notes.scale_name, left + arrow + 0.7 * size, y + font.cap_height() / 2);
}

}  // namespace render

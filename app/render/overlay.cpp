#include "app/render/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/render/text.h"

namespace render {
namespace {

/// Rectangle of a colour bar [px]; colours run upward if it is standing, else to the right.
struct Bar {
  double left, top, width, height;
  bool standing;
};

void draw_colors(Image& image, const Bar& bar, ColorMap colors) {
  fill(image, {bar.left - 1, bar.top - 1, bar.width + 2, bar.height + 2, 2}, kInk, 0.75);
  const double length = bar.standing ? bar.height : bar.width;
  const int pixels = static_cast<int>(length);
  for (int i = 0; i < pixels; ++i) {
    const auto index = static_cast<std::size_t>((i + 0.5) / pixels * kScaleColors);
    const Panel line = bar.standing ? Panel{bar.left, bar.top + length - 1 - i, bar.width, 1, 0}
                                    : Panel{bar.left + i, bar.top, 1, bar.height, 0};
    fill(image, line, scale_colors(colors)[index]);
  }
}

/// Returns the coordinate of a tick along the bar [px].
double tick_place(const Bar& bar, const Tick& tick) {
  return bar.standing ? std::round(bar.top + (1 - tick.place) * (bar.height - 1))
                      : std::round(bar.left + tick.place * (bar.width - 1));
}

double widest(const Font& font, const std::vector<Tick>& ticks) {
  double width = 0;
  for (const Tick& tick : ticks) width = std::max(width, font.width(tick.label));
  return width;
}

void add_lines(Image& image, const Font& font, double size, const std::vector<std::string>& lines,
               bool right) {
  const double step = font.cap_height() + 0.7 * size;
  double width = 0;
  for (const std::string& line : lines) width = std::max(width, font.width(line));
  const double height = step * static_cast<double>(lines.size()) + 0.4 * size;
  const double left = right ? image.width - width - 2 * size : 0.8 * size;
  const Panel panel = {left, 0.8 * size, width + 1.2 * size, height, 0.3 * size};
  fill(image, panel, kPaper, kPaperWeight);
  double y = panel.top + 0.55 * size + font.cap_height();
  for (const std::string& line : lines) {
    font.write(image, line, panel.left + 0.6 * size, y);
    y += step;
  }
}

void add_scale(Image& image, const Font& font, double size, const PressureScale& scale) {
  const std::vector<Tick> ticks = round_ticks(scale);
  const double labels = std::max(widest(font, ticks), font.width("kPa") - size);
  const double bar_width = std::round(0.9 * size);
  const double bar_height = std::round(std::min(0.34 * image.height, 13.6 * size));
  Panel panel;
  panel.width = std::round(bar_width + labels + 2.0 * size);
  panel.height = std::round(bar_height + 3.4 * size);
  panel.left = std::round(image.width - panel.width - 0.8 * size);
  panel.top = std::round(image.height - panel.height - 0.8 * size);
  panel.corner = 0.3 * size;
  fill(image, panel, kPaper, kPaperWeight);
  font.write(image, "kPa", panel.left + 0.6 * size, panel.top + 0.6 * size + font.cap_height());
  const Bar bar = {panel.left + std::round(0.6 * size), panel.top + std::round(2.4 * size),
                   bar_width, bar_height, true};
  draw_colors(image, bar, scale.colors);
  for (const Tick& tick : ticks) {
    const double y = tick_place(bar, tick);
    fill(image, {bar.left + bar.width + 1, y, std::round(0.3 * size), 1, 0}, kInk);
    font.write(image, tick.label, bar.left + bar.width + 0.55 * size + labels,
               y + font.cap_height() / 2, Align::right);
  }
}

}  // namespace

std::string time_label(double time) { return fmt::format("t = {:.2f} s", time); }

void add_lines_right(Image& image, const std::vector<std::string>& lines) {
  const int size = text_size_on(image);
  if (size > 0) add_lines(image, Font(size), size, lines, true);
}

void add_overlay(Image& image, const std::optional<PressureScale>& scale, double time, double grid,
                 const std::vector<std::string>& more) {
  const int size = text_size_on(image);
  if (size == 0) return;
  const Font font(size);
  std::vector<std::string> lines = {time_label(time)};
  if (grid > 0) lines.push_back(fmt::format("grid {:g} m", grid));
  lines.insert(lines.end(), more.begin(), more.end());
  add_lines(image, font, size, lines, false);
  if (scale) add_scale(image, font, size, *scale);
}

Image lying_scale(const PressureScale& scale, int width, int text_size) {
  const Font font(text_size);
  const double size = text_size;
  Image image = filled_image(width, static_cast<int>(3.6 * size), kPaper);
  const std::string name = scale_name(scale.shows) + " [kPa]";
  const double bar_width = std::round(std::min(0.45 * width, 40 * size));
  const double gap = size;
  const double left = std::round((width - bar_width - gap - font.width(name)) / 2);
  const Bar bar = {left + std::round(font.width(name) + gap), std::round(0.6 * size), bar_width,
                   std::round(0.95 * size), false};
  draw_colors(image, bar, scale.colors);
  font.write(image, name, left, bar.top + (bar.height + font.cap_height()) / 2);
  for (const Tick& tick : round_ticks(scale)) {
    const double x = tick_place(bar, tick);
    fill(image, {x, bar.top + bar.height + 1, 1, std::round(0.3 * size), 0}, kInk);
    font.write(image, tick.label, x, bar.top + bar.height + 0.6 * size + font.cap_height(),
               Align::center);
  }
  return image;
}

}  // namespace render

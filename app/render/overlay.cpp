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

void draw_frame(Image& image, const Bar& bar) {
  fill(image, {bar.left - 1, bar.top - 1, bar.width + 2, bar.height + 2, 2}, kInk, 0.75);
}

/// Returns the square that lies beyond an end of a bar.
Bar cap_of(const Bar& bar, bool high) {
  // The label of the cap stands clear of that of the bar's end.
  const double side = bar.standing ? bar.width : bar.height;
  Bar cap = {bar.left, bar.top, side, side, bar.standing};
  const double gap = std::round(0.5 * side);
  if (bar.standing)
    cap.top += high ? -side - gap : bar.height + gap;
  else
    cap.left += high ? bar.width + gap : -side - gap;
  return cap;
}

/// Draws what marks pressures beyond an end, striped as they are in the picture (pressure.frag).
void draw_cap(Image& image, const Bar& cap, ColorMap colors, bool high) {
  draw_frame(image, cap);
  const Rgb end = high ? scale_colors(colors).back() : scale_colors(colors).front();
  const Rgb other = high ? Rgb{255, 255, 255} : Rgb{0, 0, 0};
  const int left = static_cast<int>(cap.left), top = static_cast<int>(cap.top);
  const int period = std::max(4, static_cast<int>(cap.width) / 2);
  for (int y = 0; y < static_cast<int>(cap.height); ++y)
    for (int x = 0; x < static_cast<int>(cap.width); ++x) {
      const int across = (x - y + 1024 * period) % period;
      blend(image, left + x, top + y, 2 * across < period ? end : other, 1);
    }
}

/// Returns what stands at a cap: `> 10`.
std::string cap_label(const PressureScale& scale, bool high) {
  return high ? fmt::format("> {:g}", scale.max / 1000) : fmt::format("< {:g}", scale.min / 1000);
}

void draw_colors(Image& image, const Bar& bar, ColorMap colors) {
  draw_frame(image, bar);
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
  double labels = std::max(widest(font, ticks), font.width("kPa") - size);
  for (const bool high : {false, true})
    if (high ? scale.above : scale.below)
      labels = std::max(labels, font.width(cap_label(scale, high)));
  const double bar_width = std::round(0.9 * size);
  const double cap = std::round(1.6 * size);
  const double bar_height = std::round(std::min(0.34 * image.height, 13.6 * size));
  Panel panel;
  panel.width = std::round(bar_width + labels + 2.0 * size);
  panel.height = std::round(bar_height + 3.4 * size) + cap * (scale.above + scale.below);
  panel.left = std::round(image.width - panel.width - 0.8 * size);
  panel.top = std::round(image.height - panel.height - 0.8 * size);
  panel.corner = 0.3 * size;
  fill(image, panel, kPaper, kPaperWeight);
  font.write(image, "kPa", panel.left + 0.6 * size, panel.top + 0.6 * size + font.cap_height());
  const Bar bar = {panel.left + std::round(0.6 * size),
                   panel.top + std::round(2.4 * size) + cap * scale.above, bar_width, bar_height,
                   true};
  draw_colors(image, bar, scale.colors);
  for (const bool high : {false, true}) {
    if (!(high ? scale.above : scale.below)) continue;
    const Bar square = cap_of(bar, high);
    draw_cap(image, square, scale.colors, high);
    font.write(image, cap_label(scale, high), bar.left + bar.width + 0.55 * size + labels,
               square.top + (square.height + font.cap_height()) / 2, Align::right);
  }
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
  // The cap of the low end stands between the name and the bar.
  const double gap = scale.below ? std::round(2.6 * size) : size;
  const double left = std::round((width - bar_width - gap - font.width(name)) / 2);
  const Bar bar = {left + std::round(font.width(name) + gap), std::round(0.6 * size), bar_width,
                   std::round(0.95 * size), false};
  draw_colors(image, bar, scale.colors);
  font.write(image, name, left, bar.top + (bar.height + font.cap_height()) / 2);
  for (const bool high : {false, true}) {
    if (!(high ? scale.above : scale.below)) continue;
    const Bar square = cap_of(bar, high);
    draw_cap(image, square, scale.colors, high);
    if (high)
      font.write(image, cap_label(scale, high), square.left + square.width + 0.4 * size,
                 bar.top + (bar.height + font.cap_height()) / 2);
  }
  for (const Tick& tick : round_ticks(scale)) {
    const double x = tick_place(bar, tick);
    fill(image, {x, bar.top + bar.height + 1, 1, std::round(0.3 * size), 0}, kInk);
    font.write(image, tick.label, x, bar.top + bar.height + 0.6 * size + font.cap_height(),
               Align::center);
  }
  return image;
}

}  // namespace render

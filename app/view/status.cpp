#include "app/view/status.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "app/render/text.h"

namespace app {
namespace {

constexpr double kPaperWeight = 0.78;

/// A key or gesture and what it does.
struct Line {
  const char* key;
  const char* meaning;
};

constexpr std::array<Line, 11> kHelp = {{
    {"drag", "turn about the point looked at"},
    {"right drag, Shift+drag", "move the scene"},
    {"wheel", "nearer, farther"},
    {"Ctrl+drag, middle drag", "pull a body"},
    {"Space", "pause, go on"},
    {"Right, .", "one step while paused"},
    {"+ -, Up Down", "twice, half the speed"},
    {"r", "back to the start"},
    {"c", "the scene's camera"},
    {"h", "show or hide this"},
    {"q, Esc", "quit"},
}};
constexpr const char* kShortHelp = "h: help   Space: pause   q: quit";

/// The text's size and what follows from it.
struct Type {
  explicit Type(int em) : font(em), size(em), line(1.6 * em) {}

  render::Font font;
  double size;  ///< [px]
  double line;  ///< From one line to the next [px].

  double padding() const { return 0.6 * size; }
  double margin() const { return 0.8 * size; }
  /// Of a panel with so many lines.
  double height(std::size_t lines) const {
    return font.cap_height() + 1.1 * size + static_cast<double>(lines - 1) * line;
  }
  double baseline(double top, std::size_t index) const {
    return top + 0.55 * size + font.cap_height() + static_cast<double>(index) * line;
  }
};

void fill_panel(render::Image& image, const Type& type, double top, double width,
                std::size_t lines) {
  render::fill(
      image, {type.margin(), top, width + 2 * type.padding(), type.height(lines), 0.3 * type.size},
      render::kPaper, kPaperWeight);
}

void add_line(render::Image& image, const Type& type, const std::string& text, double top) {
  fill_panel(image, type, top, type.font.width(text), 1);
  type.font.write(image, text, type.margin() + type.padding(), type.baseline(top, 0));
}

void add_help(render::Image& image, const Type& type) {
  double keys = 0, meanings = 0;
  for (const Line& line : kHelp) {
    keys = std::max(keys, type.font.width(line.key) + 1.5 * type.size);
    meanings = std::max(meanings, type.font.width(line.meaning));
  }
  const double top = image.height - type.margin() - type.height(kHelp.size());
  fill_panel(image, type, top, keys + meanings, kHelp.size());
  const double left = type.margin() + type.padding();
  for (std::size_t i = 0; i < kHelp.size(); ++i) {
    type.font.write(image, kHelp[i].key, left, type.baseline(top, i));
    type.font.write(image, kHelp[i].meaning, left + keys, type.baseline(top, i));
  }
}

/// A power of two: `1/8` … `16`.
std::string speed_text(double speed) {
  return speed < 1 ? fmt::format("1/{:g}", 1 / speed) : fmt::format("{:g}", speed);
}

}  // namespace

std::string pace_text(const Pace& pace) {
  const std::string speed = "speed " + speed_text(pace.speed());
  if (pace.paused()) return speed + ", paused";
  return pace.reached() > 0 ? fmt::format("{}, reached {:.2f}", speed, pace.reached()) : speed;
}

void add_status(render::Image& image, const Pace& pace, bool help) {
  const int extent = std::min(image.width, image.height);
  if (extent < render::kLeastExtent) return;
  const Type type(std::max(11, extent / 40));
  // Below the time, which is as high.
  add_line(image, type, pace_text(pace), type.margin() + type.height(1) + 0.4 * type.size);
  if (help)
    add_help(image, type);
  else
    add_line(image, type, kShortHelp, image.height - type.margin() - type.height(1));
}

}  // namespace app

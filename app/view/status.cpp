#include "app/view/status.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/render/overlay.h"
#include "app/render/text.h"

namespace app {
namespace {

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

void add_table(render::Image& image, int size) {
  const render::Font font(size);
  double keys = 0, meanings = 0;
  for (const Line& line : kHelp) {
    keys = std::max(keys, font.width(line.key) + 1.5 * size);
    meanings = std::max(meanings, font.width(line.meaning));
  }
  const double step = 1.6 * size, height = step * kHelp.size() + 0.4 * size;
  const double width = keys + meanings + 1.2 * size;
  const render::Panel panel = {image.width - width - 0.8 * size, 0.8 * size, width, height,
                               0.3 * size};
  render::fill(image, panel, render::kPaper, render::kPaperWeight);
  const double left = panel.left + 0.6 * size;
  double y = panel.top + 0.55 * size + font.cap_height();
  for (const Line& line : kHelp) {
    font.write(image, line.key, left, y);
    font.write(image, line.meaning, left + keys, y);
    y += step;
  }
}

/// Returns a power of two as `1/8` … `16`.
std::string speed_text(double speed) {
  return speed < 1 ? fmt::format("1/{:g}", 1 / speed) : fmt::format("{:g}", speed);
}

}  // namespace

std::string playback_text(const PlaybackClock& playback) {
  const std::string speed = "speed " + speed_text(playback.speed());
  if (playback.paused()) return speed + ", paused";
  return playback.reached() > 0 ? fmt::format("{}, reached {:.2f}", speed, playback.reached())
                                : speed;
}

void add_help(render::Image& image, bool whole) {
  const int size = render::text_size_on(image);
  if (size == 0) return;
  if (whole)
    add_table(image, size);
  else
    render::add_lines_right(image, {kShortHelp});
}

}  // namespace app

#include "app/base/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/base/quoting.h"

namespace app {
namespace {

/// Returns the columns of the terminal; 0 if they are unknown.
std::size_t screen_width() {
  winsize size = {};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace

std::string rough_time(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 2 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

std::string progress_text(const std::string& name, double time, double duration, double wall) {
  const double done = time / duration;
  return fmt::format("{}: {:.2f} of {:g} s  {:3.0f} %  {:.3g} x real time  {} left", name, time,
                     duration, 100 * done, time / wall,
                     rough_time(std::max(0.0, wall / done - wall)));
}

ProgressLine::ProgressLine(bool quiet)
    : enabled_(!quiet && ::isatty(STDERR_FILENO)), next_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const std::string& text) {
  if (!enabled_) return;
  next_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
  // A line wider than the terminal would wrap into a second line, which nothing erases. The last
  // column stays free.
  const std::size_t width = screen_width();
  const std::string safe = shown(text);
  const std::string line = width > 1 ? safe.substr(0, width - 1) : safe;
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
  shown_ = true;
}

void ProgressLine::clear() {
  if (!shown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace app

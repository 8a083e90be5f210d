#include "app/run/run_need.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/base/machine.h"
#include "app/logs/force_log.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// Bytes of a number: in CSV with its comma, and in HDF5, where compression takes some off.
constexpr double kCsvNumber = 17, kHdf5Number = 6;

/// Part of the numbers of a row of forces that is not 0: few bodies have every load.
constexpr double kForcesThere = 0.7;

/// Numbers of a row of the trajectory.
constexpr double kStateNumbers = 13;

/// Bytes per pixel of the framebuffers, with four samples of colour and depth, and of the pictures
/// that are drawn and wait: 58 were measured at 4096 × 4096 pixels, 67 at 2048 × 2048.
constexpr double kPixelBytes = 60;

/// Bytes of a row with so many numbers.
double row_bytes(const std::string& name, double numbers, LogFormat format) {
  // In CSV a row repeats the time and the name.
  if (format == LogFormat::csv) return 8 + static_cast<double>(name.size()) + kCsvNumber * numbers;
  return kHdf5Number * numbers;
}

}  // namespace

double log_bytes(const LogSubject& subject, double times, LogFormat format) {
  double bytes = 0;
  for (const std::string& body : subject.bodies) {
    bytes += row_bytes(body, kStateNumbers, format);
    if (subject.forces)
      bytes += row_bytes(body, kForcesThere * static_cast<double>(force_columns().size()), format);
  }
  for (const LogTable& table : subject.tables)
    for (const std::string& name : table.names)
      bytes += row_bytes(name, static_cast<double>(table.layout.width()), format);
  return bytes * times;
}

double logged_times(const scene::Scene& scene) {
  return 1 + scene.duration / std::max(scene.step, scene.log_every.value_or(0));
}

double picture_bytes(const std::array<int, 2>& size) { return kPixelBytes * size[0] * size[1]; }

std::optional<std::string> log_warning(double bytes, const std::optional<double>& available) {
  if (!available || bytes <= *available) return std::nullopt;
  return fmt::format(
      "the log comes to about {} GB, and the disk has {} GB free; a larger log.every makes "
      "it smaller",
      gigabytes(bytes / 1e9), gigabytes(*available / 1e9));
}

std::optional<std::string> picture_warning(const scene::Scene& scene) {
  if (!scene.render) return std::nullopt;
  const std::array<int, 2>& size = scene.render->size;
  const auto verdict = judged_need(picture_bytes(size), available_memory());
  if (!verdict) return std::nullopt;
  const std::string text =
      fmt::format("drawing {} x {} pixels {}", size[0], size[1], verdict->text);
  if (verdict->fault) {
    scene::Faults faults;
    faults.add(scene.places, "render.size", text);
    faults.throw_if_any();
  }
  return "render.size: " + text;
}

std::vector<std::string> run_warnings(const scene::Scene& scene, const LogSubject& subject,
                                      LogFormat format, const std::filesystem::path& out,
                                      bool draws) {
  std::vector<std::string> warnings;
  const double bytes = log_bytes(subject, logged_times(scene), format);
  if (auto warning = log_warning(bytes, available_disk(out)))
    warnings.push_back(std::move(*warning));
  if (!draws) return warnings;
  if (auto warning = picture_warning(scene)) warnings.push_back(std::move(*warning));
  return warnings;
}

}  // namespace app

#include "app/logs/interior_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "app/logs/log_rows.h"

namespace app {
namespace {

constexpr std::string_view kInteriorHeader =
    "time,body,pocket,volume,level,capacity,spill,flooded,inflow,x,y,z,air_pressure";

/// Numbers of a row after the body's name.
constexpr std::size_t kNumbers = 11;

std::array<double, kNumbers> numbers_of(const engine::PocketState& p) {
  return {static_cast<double>(p.id),
          p.volume,
          p.level,
          p.capacity,
          p.spill,
          p.flooded ? 1.0 : 0.0,
          p.inflow,
          p.centroid_W.x(),
          p.centroid_W.y(),
          p.centroid_W.z(),
          p.air};
}

/// Returns the id of a pocket. @throws InputError if the number is none
int id_from(double number, const std::filesystem::path& file, int line) {
  constexpr int kMost = 1'000'000;
  // NaN, an empty field, fails every comparison.
  if (!(number >= 0 && number <= kMost && number == std::floor(number)))
    refuse_row(
        file, line,
        fmt::format("the pocket is {:g}, expected a whole number from 0 to {}", number, kMost));
  return static_cast<int>(number);
}

}  // namespace

InteriorWriter::InteriorWriter(std::filesystem::path file, std::vector<std::string> names,
                               const std::optional<FilePosition>& kept)
    : file_(std::move(file)), names_(std::move(names)) {
  if (kept && kept->bytes > 0)
    rows_.emplace(file_, kInteriorHeader, kept);
  else
    std::filesystem::remove(file_);
}

void InteriorWriter::add(double time, const std::vector<engine::InteriorState>& interiors) {
  fmt::memory_buffer rows;
  const auto to = std::back_inserter(rows);
  for (std::size_t i = 0; i < interiors.size(); ++i)
    for (const engine::PocketState& pocket : interiors[i].pockets) {
      fmt::format_to(to, "{},{}", time, names_[i]);
      for (const double number : numbers_of(pocket)) {
        rows.push_back(',');
        if (std::isfinite(number)) fmt::format_to(to, "{}", number == 0 ? 0 : number);
      }
      rows.push_back('\n');
    }
  if (rows.size() == 0) return;
  if (!rows_) rows_.emplace(file_, kInteriorHeader, std::nullopt);
  rows_->add(rows);
}

InteriorLog read_interior_csv(const std::filesystem::path& file) {
  InteriorLog log;
  std::array<double, kNumbers> n{};
  n.back() = NAN;  // A log that lacks it knows no trapped air.
  const std::string header = written_header(file, kInteriorHeader);
  const auto given = static_cast<std::size_t>(std::ranges::count(header, ',')) - 1;
  read_rows(file, header, "a log of the water inside", [&](std::string_view text, int line) {
    const LogRow row =
        read_log_row(text, file, line, std::span(n).first(given), LogField::may_be_empty);
    std::vector<InteriorRows>& rows = log[std::string(row.body)];
    if (rows.empty() || rows.back().time != row.time)
      rows.push_back({.time = row.time, .pockets = {}});
    rows.back().pockets.push_back({.id = id_from(n[0], file, line),
                                   .volume = n[1],
                                   .level = n[2],
                                   .capacity = n[3],
                                   .spill = n[4],
                                   .flooded = n[5] != 0,
                                   .inflow = n[6],
                                   .centroid = {n[7], n[8], n[9]},
                                   .air = n[10]});
  });
  return log;
}

}  // namespace app

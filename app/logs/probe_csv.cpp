#include "app/logs/probe_csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>
#include <utility>

namespace app {

ProbeWriter::ProbeWriter(const std::filesystem::path& file, std::vector<std::string> names,
                         const std::optional<std::uint64_t>& kept)
    : names_(std::move(names)),
      file_(file, fmt::format("time,probe,{}", fmt::join(kProbeColumnNames, ",")), kept) {}

void ProbeWriter::add(double time, const std::vector<ProbeReading>& readings) {
  fmt::memory_buffer rows;
  const auto to = std::back_inserter(rows);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    fmt::format_to(to, "{},{}", time, names_[i]);
    for (const double number : readings[i]) {
      rows.push_back(',');
      if (!std::isnan(number)) fmt::format_to(to, "{}", number);
    }
    rows.push_back('\n');
  }
  file_.add(rows);
}

}  // namespace app

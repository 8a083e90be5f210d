#include "app/base/machine.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>

namespace app {
namespace {

namespace fs = std::filesystem;

/// Reads a file that holds one number; none if there is no such file, or `max` in it.
std::optional<double> number_in(const fs::path& file) {
  std::ifstream in(file);
  double number = 0;
  if (in >> number) return number;
  return std::nullopt;
}

/// Returns the value of a line `KEY VALUE` or `KEY: VALUE`.
std::optional<double> value_of(const fs::path& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key + ":") || line.starts_with(key + " "))
      return std::stod(line.substr(key.size() + 1));
  return std::nullopt;
}

/// Returns what a control group leaves of its limit; pages of files that it can drop do not count.
std::optional<double> left_in_group(const fs::path& group) {
  const auto limit = number_in(group / "memory.max");
  const auto used = number_in(group / "memory.current");
  if (!limit || !used) return std::nullopt;
  const double dropped = value_of(group / "memory.stat", "inactive_file").value_or(0);
  return std::max(0.0, *limit - (*used - dropped));
}

/// Returns what is left of the limit of this process's address space (`ulimit -v`).
std::optional<double> left_of_address_space() {
  rlimit limit = {};
  double pages = 0;
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ||
      !(std::ifstream("/proc/self/statm") >> pages))
    return std::nullopt;
  const double used = pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

}  // namespace

std::optional<double> available_memory() {
  constexpr double kKibibyte = 1024;
  std::optional<double> least = value_of("/proc/meminfo", "MemAvailable");
  if (least) *least *= kKibibyte;
  if (const auto left = left_of_address_space()) least = std::min(least.value_or(*left), *left);
  // The line of version 2 reads `0::/user.slice/…`.
  std::ifstream in("/proc/self/cgroup");
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("0::/")) continue;
    const fs::path root = "/sys/fs/cgroup";
    for (fs::path group = root / line.substr(4);; group = group.parent_path()) {
      if (const auto left = left_in_group(group)) least = std::min(least.value_or(*left), *left);
      if (group == root || !group.has_relative_path()) break;
    }
  }
  return least;
}

std::optional<double> available_disk(const fs::path& folder) {
  std::error_code error;
  fs::path existing = fs::absolute(folder, error);
  while (!error && !fs::exists(existing, error) && existing.has_relative_path())
    existing = existing.parent_path();
  const fs::space_info space = fs::space(existing, error);
  if (error) return std::nullopt;
  return static_cast<double>(space.available);
}

std::string gigabytes(double number) {
  return number < 10 ? fmt::format("{:.2g}", number) : fmt::format("{:.0f}", number);
}

std::optional<MemoryVerdict> judged_need(double bytes, const std::optional<double>& available) {
  if (!available || bytes <= *available) return std::nullopt;
  constexpr double kGibibyte = 1024.0 * 1024 * 1024;
  return MemoryVerdict{
      .fault = bytes > 2 * *available,
      .text = fmt::format("needs about {} GiB of memory, and this machine has {} GiB free",
                          gigabytes(bytes / kGibibyte), gigabytes(*available / kGibibyte))};
}

}  // namespace app

#include "app/cli/number_series.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "app/scene/diagnostics.h"

namespace app {
namespace {

constexpr double kMostNumbers = 1000;

/// Part of a step by which the last number may miss the end [-].
constexpr double kStepRoundOff = 1e-9;

/// The finite numbers between separators; none if a part is something else.
std::vector<double> split(const std::string& text, char separator) {
  std::vector<double> numbers;
  const char* at = text.c_str();
  while (true) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end == at || !std::isfinite(number)) return {};
    numbers.push_back(number);
    if (*end == '\0') return numbers;
    if (*end != separator) return {};
    at = end + 1;
  }
}

}  // namespace

std::vector<double> parse_series(const std::string& option, const std::string& argument) {
  const auto refuse = [&](const std::string& expected) {
    throw scene::InputError(option, fmt::format("found {}, expected {}", argument, expected));
  };
  if (argument.find(':') == std::string::npos) {
    std::vector<double> numbers = split(argument, ',');
    if (numbers.empty()) refuse("FIRST:LAST:STEP or A,B,…");
    for (std::size_t i = 1; i < numbers.size(); ++i)
      if (!(numbers[i] > numbers[i - 1])) refuse("numbers that ascend");
    return numbers;
  }
  const std::vector<double> range = split(argument, ':');
  if (range.size() != 3) refuse("FIRST:LAST:STEP or A,B,…");
  const double first = range[0], last = range[1], step = range[2];
  if (!(first <= last && step > 0)) refuse("FIRST <= LAST and STEP > 0");
  const double steps = std::floor((last - first) / step + kStepRoundOff);
  if (!(steps < kMostNumbers)) refuse(fmt::format("at most {:g} numbers", kMostNumbers));
  std::vector<double> numbers;
  for (double i = 0; i <= steps; ++i) numbers.push_back(first + i * step);
  return numbers;
}

}  // namespace app

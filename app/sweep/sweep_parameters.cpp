#include "app/sweep/sweep_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <string_view>
#include <utility>

#include "app/scene/diagnostics.h"
#include "app/scene/reader.h"

namespace app {
namespace {

/// Tolerance for the rounding of (last − first)/step, in steps.
constexpr double kStepSlack = 1e-9;

/// Largest number of decimal places that is free of a double's rounding.
constexpr int kMostPlaces = 15;

[[noreturn]] void refuse_values(const std::string& key_path, const std::string& found,
                                const std::string& expected) {
  throw scene::InputError({scene::Fault{
      {kVaryPlace}, key_path, fmt::format("found {}, expected {}", found, expected)}});
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_whole = end == text.data() + text.size() && !text.empty();
  if (error != std::errc() || !is_whole || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Splits `a:b:c` into a, b, c.
std::vector<std::string> split_at_colons(const std::string& text) {
  std::vector<std::string> parts = {""};
  for (const char c : text)
    if (c == ':')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Splits YAML at the commas outside brackets, braces and quotes.
std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts = {""};
  int depth = 0;
  char quote = '\0';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == ',' && depth == 0 && quote == '\0') {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
    if (quote == '"' && c == '\\' && i + 1 < text.size()) {
      parts.back() += text[++i];
    } else if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

/// Returns the decimal places with which a number is written: 2 for `0.25`, 3 for `1e-3`.
int decimal_places(const std::string& number) {
  const std::size_t exponent_at = number.find_first_of("eE");
  const std::string mantissa = number.substr(0, exponent_at);
  const std::size_t point = mantissa.find('.');
  const std::size_t places = point == std::string::npos ? 0 : mantissa.size() - point - 1;
  const double exponent = exponent_at == std::string::npos
                              ? 0
                              : finite_number(number.substr(exponent_at + 1)).value_or(0);
  return static_cast<int>(std::clamp(static_cast<double>(places) - exponent, 0.0, 1000.0));
}

/// Returns a number with at most `places` decimal places, so that the third value of 0:1:0.1 is 0.2
/// and the fourth 0.3.
std::string rounded_text(double value, int places) {
  if (places > kMostPlaces) return fmt::format("{}", value);
  std::string text = fmt::format("{:.{}f}", value, places);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

/// Returns the values of `FIRST:LAST:STEP`, given as three texts.
std::vector<std::string> stepped_values(const std::string& key_path, const std::string& text,
                                        const std::vector<std::string>& parts) {
  const double first = *finite_number(parts[0]);
  const double last = *finite_number(parts[1]);
  const double step = *finite_number(parts[2]);
  const double steps = (last - first) / step;  // NaN or infinite for a step of 0
  if (!(steps >= 0 && steps < static_cast<double>(kMostRuns)))
    refuse_values(key_path, text,
                  fmt::format("FIRST:LAST:STEP with steps that lead from the first to the last in "
                              "fewer than {}",
                              kMostRuns));
  const int places = std::max(decimal_places(parts[0]), decimal_places(parts[2]));
  std::vector<std::string> values;
  const long count = std::lround(std::floor(steps + kStepSlack));
  for (long i = 0; i <= count; ++i)
    values.push_back(rounded_text(first + static_cast<double>(i) * step, places));
  return values;
}

/// Returns a uniformly distributed integer in 0 … count − 1.
std::uint64_t below(std::uint64_t count, std::mt19937_64& engine) {
  // The last 2^64 mod count numbers are rejected, since they would favour small results.
  const std::uint64_t excess = (std::mt19937_64::max() % count + 1) % count;
  for (;;) {
    const std::uint64_t number = engine();
    if (number <= std::mt19937_64::max() - excess) return number % count;
  }
}

/// Returns a uniformly distributed number in [0, 1), a multiple of 2^−53.
double unit_number(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

/// Returns 0 … count − 1 in random order (Fisher, Yates).
std::vector<std::size_t> permutation(std::size_t count, std::mt19937_64& engine) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[below(i, engine)]);
  return order;
}

/// Returns a value in part number `part` of `samples` equal parts of the parameter's values.
std::string value_in_part(const SweepParameter& parameter, std::size_t part, std::size_t samples,
                          std::mt19937_64& engine) {
  if (!parameter.values.empty()) return parameter.values[part * parameter.values.size() / samples];
  const double fraction =
      (static_cast<double>(part) + unit_number(engine)) / static_cast<double>(samples);
  return fmt::format("{}", parameter.first + fraction * (parameter.last - parameter.first));
}

}  // namespace

SweepParameter parse_sweep_parameter(const std::string& argument) {
  scene::Override split;
  try {
    split = scene::parse_override(argument);
  } catch (const scene::InputError&) {
    refuse_values("", argument.empty() ? "nothing" : argument,
                  "KEY.PATH=FIRST:LAST:STEP or KEY.PATH=VALUE,VALUE,…, as in "
                  "bodies[0].density=200:1000:100");
  }
  SweepParameter parameter;
  parameter.key_path = split.key_path;
  const std::vector<std::string> parts = split_at_colons(split.value);
  const bool is_range = parts.size() >= 2 && parts.size() <= 3 &&
                        std::all_of(parts.begin(), parts.end(),
                                    [](const std::string& part) { return finite_number(part); });
  if (is_range && parts.size() == 3) {
    parameter.values = stepped_values(split.key_path, split.value, parts);
  } else if (is_range) {
    parameter.first = *finite_number(parts[0]);
    parameter.last = *finite_number(parts[1]);
  } else {
    parameter.values = split_at_commas(split.value);
    if (std::find(parameter.values.begin(), parameter.values.end(), "") != parameter.values.end())
      refuse_values(split.key_path, split.value.empty() ? "nothing" : split.value,
                    "a value before and after each comma, or a range FIRST:LAST:STEP of numbers");
  }
  return parameter;
}

std::vector<SweepPoint> grid(const std::vector<SweepParameter>& parameters) {
  std::vector<SweepPoint> points = {{}};
  for (const SweepParameter& parameter : parameters) {
    if (parameter.values.empty())
      refuse_values(parameter.key_path, "a range without steps",
                    "FIRST:LAST:STEP, or --samples to draw numbers from it");
    if (points.size() > kMostRuns / parameter.values.size())
      throw scene::InputError(kVaryPlace, fmt::format("more than {} combinations", kMostRuns));
    std::vector<SweepPoint> longer;
    for (const SweepPoint& point : points)
      for (const std::string& value : parameter.values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    points = std::move(longer);
  }
  return points;
}

std::vector<SweepPoint> latin_hypercube(const std::vector<SweepParameter>& parameters,
                                        std::size_t samples, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::vector<SweepPoint> points(samples);
  for (const SweepParameter& parameter : parameters) {
    const std::vector<std::size_t> parts = permutation(samples, engine);
    for (std::size_t i = 0; i < samples; ++i)
      points[i].push_back(value_in_part(parameter, parts[i], samples, engine));
  }
  return points;
}

}  // namespace app

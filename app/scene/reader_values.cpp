#include "app/scene/reader_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

#include "app/base/utf8.h"

namespace scene {

namespace {

/// Parses a decimal number with an optional point and exponent. Leading zeros have no meaning.
template <class T>
std::errc parse(const YamlNode& node, T& target) {
  if (!node.is(YamlNode::Kind::scalar) || node.quoted) return std::errc::invalid_argument;
  const char* first = node.text.data();
  const char* last = first + node.text.size();
  const bool plus = node.text.starts_with('+');
  if (plus) ++first;  // from_chars accepts no plus
  const char* digits = !plus && node.text.starts_with('-') ? first + 1 : first;
  if (digits == last || (*digits != '.' && (*digits < '0' || *digits > '9')))
    return std::errc::invalid_argument;
  const auto [end, error] = std::from_chars(first, last, target);
  return end == last ? error : std::errc::invalid_argument;
}

bool within(const NumberRule& rule, double value) {
  return rule.above_lo ? value > rule.lo && value <= rule.hi : value >= rule.lo && value <= rule.hi;
}

/// Refuses a value that `parse` did not accept or the rule does not allow.
bool accept(const Value& value, std::errc error, bool allowed, const std::string& expected) {
  if (error == std::errc::result_out_of_range) {
    value.fault(
        fmt::format("found {}, which is too large or too small to compute with; expected {}",
                    describe(value.node), expected));
    return false;
  }
  return (error == std::errc{} && allowed) || value.refuse(expected);
}

bool is_name(std::string_view text, const NameRule& rule) {
  if (text.find_first_of(rule.brackets ? ",\"" : ",\"[]") != std::string_view::npos) return false;
  for (std::size_t length = 0; !text.empty(); text.remove_prefix(length)) {
    length = app::utf8_length(text);
    if (length == 0 || app::is_control(text.substr(0, length))) return false;
  }
  return true;
}

std::string range_text(const NumberRule& rule) {
  const bool bounded = std::isfinite(rule.hi);
  if (bounded) return fmt::format(" from {:g} to {:g}", rule.lo, rule.hi);
  if (std::isfinite(rule.lo) && !rule.above_lo) return fmt::format(" >= {:g}", rule.lo);
  return "";
}

template <class T, class ReadOne>
bool read_list(const Value& value, std::span<T> target, const std::string& expected,
               const ReadOne& read_one) {
  if (!value.node.is(YamlNode::Kind::list) || value.node.items.size() != target.size())
    return value.refuse(expected);
  std::vector<T> numbers(target.size());
  bool all = true;
  for (std::size_t i = 0; i < numbers.size(); ++i) all = read_one(value.item(i), numbers[i]) && all;
  if (all) std::copy(numbers.begin(), numbers.end(), target.begin());
  return all;
}

}  // namespace

std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 40;
  std::string line;
  for (const char c : text.substr(0, kLongest)) line += c == '\n' || c == '\r' ? ' ' : c;
  while (!line.empty() && text.size() > kLongest && (line.back() & 0x80) != 0) line.pop_back();
  return text.size() > kLongest ? line + "…" : line;
}

std::optional<double> plain_number(const YamlNode& node) {
  double number = 0;
  return parse(node, number) == std::errc{} ? std::optional(number) : std::nullopt;
}

Place Reading::place(const Mark& mark) const {
  if (mark.line == 0) return {kOverridePlace};
  return {mark.file ? *mark.file : file, mark.line, mark.column};
}

void Reading::fault(const std::string& key_path, const std::string& message) {
  faults.add({place_of(places, key_path), key_path, message});
}

void Value::fault(const std::string& message) const {
  reading.faults.add({reading.place(node.mark), path, message});
}

bool Value::refuse(const std::string& expected) const {
  fault(fmt::format("found {}, expected {}", describe(node), expected));
  return false;
}

Value Value::item(std::size_t index) const {
  return {node.items[index], fmt::format("{}[{}]", path, index), reading};
}

std::string describe(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::null:
      return "nothing";
    case YamlNode::Kind::list:
      return node.items.empty() ? "an empty list" : fmt::format("a list of {}", node.items.size());
    case YamlNode::Kind::map:
      return "a map";
    case YamlNode::Kind::scalar:
      break;
  }
  return node.quoted ? fmt::format("\"{}\"", shortened(node.text)) : shortened(node.text);
}

NumberRule number(const std::string& unit) { return {.unit = unit}; }
NumberRule positive(const std::string& unit) { return {.unit = unit, .lo = 0, .above_lo = true}; }
NumberRule not_negative(const std::string& unit) { return {.unit = unit, .lo = 0}; }
NumberRule between(double lo, double hi, const std::string& unit) {
  return {.unit = unit, .lo = lo, .hi = hi};
}
NumberRule degrees() { return {.unit = "deg", .factor = std::numbers::pi / 180}; }
NumberRule degrees_between(double lo, double hi) {
  return {.unit = "deg", .lo = lo, .hi = hi, .factor = std::numbers::pi / 180};
}

ValueShape words_shape(const std::vector<std::string>& words) {
  return {.kind = ValueShape::Kind::word, .words = words};
}

ValueShape list_shape(const ValueShape& item, std::size_t count) {
  return {.kind = ValueShape::Kind::list, .item = {item}, .count = count};
}

ValueShape shape(const NumberRule& rule, bool whole, std::size_t count) {
  const ValueShape one = {.kind = whole ? ValueShape::Kind::whole : ValueShape::Kind::number,
                          .lo = rule.lo,
                          .hi = rule.hi,
                          .above_lo = rule.above_lo};
  return count == 0 ? one : list_shape(one, count);
}

std::string expectation(const NumberRule& rule, bool whole, std::size_t count) {
  std::string kind = rule.above_lo ? "positive " : "";
  kind += whole ? "whole number" : "number";
  const std::string tail = range_text(rule) + (rule.unit.empty() ? "" : " [" + rule.unit + "]");
  if (count == 0) return fmt::format("a {}{}", kind, tail);
  return fmt::format("a list of {} {}s{}", count, kind, tail);
}

bool read_number(const Value& value, const NumberRule& rule, const std::string& expected,
                 double& target) {
  double parsed = 0;
  const std::errc error = parse(value.node, parsed);
  if (!accept(value, error, within(rule, parsed), expected)) return false;
  target = parsed * rule.factor;
  return true;
}

bool read_whole(const Value& value, const NumberRule& rule, const std::string& expected,
                int& target) {
  int parsed = 0;
  const std::errc error = parse(value.node, parsed);
  if (!accept(value, error, within(rule, parsed), expected)) return false;
  target = parsed;
  return true;
}

bool read_numbers(const Value& value, const NumberRule& rule, std::span<double> target) {
  return read_list(value, target, expectation(rule, false, target.size()),
                   [&](const Value& item, double& number) {
                     return read_number(item, rule, expectation(rule, false, 0), number);
                   });
}

bool read_wholes(const Value& value, const NumberRule& rule, std::span<int> target) {
  return read_list(value, target, expectation(rule, true, target.size()),
                   [&](const Value& item, int& number) {
                     return read_whole(item, rule, expectation(rule, true, 0), number);
                   });
}

bool read_word(const Value& value, const std::vector<std::string>& words, std::size_t& index) {
  const auto found = std::find(words.begin(), words.end(), value.node.text);
  if (!value.node.is(YamlNode::Kind::scalar) || found == words.end())
    return value.refuse(app::enumerate(words, "or") + app::did_you_mean(value.node.text, words));
  index = static_cast<std::size_t>(found - words.begin());
  return true;
}

std::string number_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

std::string exact_text(double value) { return fmt::format("{}", value); }

std::string list_text(std::span<const double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number_text(value);
  return "[" + text + "]";
}

bool Field<TextRule, std::string>::read(const Value& value, const TextRule& rule,
                                        std::string& target) {
  if (!value.node.is(YamlNode::Kind::scalar) || value.node.text.empty())
    return value.refuse(rule.expected);
  target = value.node.text;
  return true;
}

bool Field<NameRule, std::string>::read(const Value& value, const NameRule& rule,
                                        std::string& target) {
  // A refused name is kept, so that what refers to it is no fault of its own.
  if (!Field<TextRule, std::string>::read(value, {expected(rule)}, target)) return false;
  if (is_name(target, rule)) return true;
  value.fault(
      fmt::format("expected a name without commas, double quotes, {}line breaks and other "
                  "control characters",
                  rule.brackets ? "" : "brackets, "));
  return false;
}

bool Field<TruthRule, bool>::read(const Value& value, const TruthRule& rule, bool& target) {
  if (!value.node.is_truth(true) && !value.node.is_truth(false))
    return value.refuse(expected(rule));
  target = value.node.text == "true";
  return true;
}

bool Field<FileRule, std::filesystem::path>::read(const Value& value, const FileRule& rule,
                                                  std::filesystem::path& target) {
  if (!value.node.is(YamlNode::Kind::scalar) || value.node.text.empty())
    return value.refuse(expected(rule));
  // The system takes a path to its first NUL.
  if (value.node.text.find('\0') != std::string::npos) return value.refuse(expected(rule));
  const auto path = (value.reading.file.parent_path() / value.node.text).lexically_normal();
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return value.refuse("a file; there is none of this name (relative to the scene's folder)");
  target = path;
  return true;
}

}  // namespace scene

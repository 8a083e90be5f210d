#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/base/words.h"
#include "app/scene/diagnostics.h"
#include "app/scene/key_catalogue.h"
#include "app/scene/scene.h"
#include "app/scene/yaml_reader.h"

/// @file
/// Conversion of a YAML value to a field of a scene. A rule defines and describes the valid values;
/// the type of the field sets the count of numbers and whether they are whole.

namespace scene {

/// A key that no reader asked for, and the keys that its block may have.
struct UnknownKey {
  Place place;
  std::string block_path;  ///< Path of the map that holds the key.
  std::string key;
  std::vector<std::string> known;
};

/// The data that the readers of a scene's blocks share.
struct Reading {
  std::filesystem::path file;
  std::string joined;  ///< The text with all files that it includes; empty if it has none.
  Places places;       ///< The place of every key.
  Faults faults;
  std::vector<UnknownKey> unknown_keys;
  KeyCatalogue catalogue;  ///< Every key that was asked for, if keys are listed.

  Place place(const Mark& mark) const;
  /// Adds a fault of one key, at the place of the key or of the block around it.
  void fault(const std::string& key_path, const std::string& message);
};

/// A value and its key path.
struct Value {
  const YamlNode& node;
  std::string path;
  Reading& reading;

  /// Adds the fault `found …, expected …` and returns false.
  bool refuse(const std::string& expected) const;
  void fault(const std::string& message) const;
  Value item(std::size_t index) const;
};

/// Cuts a text so that its fault stays one short line.
std::string shortened(const std::string& text);
/// Returns a decimal number without quotes; none if the value is none.
std::optional<double> plain_number(const YamlNode& node);

/// Describes the value for a fault: `-5`, `"5"`, `a list of 3`.
std::string describe(const YamlNode& node);

/// Numbers from `lo` to `hi`, in the scene file's unit.
struct NumberRule {
  std::string unit;  ///< Unit in the scene file; empty for a pure number.
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  bool above_lo = false;  ///< `lo` itself is refused.
  double factor = 1;      ///< Factor from the scene file's unit to SI.
};
NumberRule number(const std::string& unit = "");
NumberRule positive(const std::string& unit = "");
NumberRule not_negative(const std::string& unit = "");
NumberRule between(double lo, double hi, const std::string& unit = "");
/// An angle in degrees, stored in radians.
NumberRule degrees();
NumberRule degrees_between(double lo, double hi);

/// A text that is not empty.
struct TextRule {
  std::string expected = "a text";
};
/// A name of an entry of a list. It is a cell of tables and a word in messages, and so a text
/// without commas, double quotes and control characters.
struct NameRule {
  std::string list;      ///< Key of the list, within which the name is unique.
  bool brackets = true;  ///< Brackets are allowed.
};
/// `true` or `false`
struct TruthRule {};
/// A file that exists, relative to the scene's folder.
struct FileRule {};
/// One of several words, each with its meaning.
template <class T>
struct ChoiceRule {
  std::vector<std::pair<std::string, T>> choices;

  std::vector<std::string> words() const {
    std::vector<std::string> all;
    for (const auto& choice : choices) all.push_back(choice.first);
    return all;
  }
};

/// Returns the shape of a number, or of a list of `count` numbers if that is not 0.
ValueShape shape(const NumberRule& rule, bool whole, std::size_t count);
/// Describes that shape: `a positive number [kg]`, `a list of 3 numbers [m]`.
std::string expectation(const NumberRule& rule, bool whole, std::size_t count);
/// Reads a decimal number within the rule and converts it to SI. @return false after a fault
bool read_number(const Value& value, const NumberRule& rule, const std::string& expected,
                 double& target);
bool read_whole(const Value& value, const NumberRule& rule, const std::string& expected,
                int& target);
bool read_numbers(const Value& value, const NumberRule& rule, std::span<double> target);
bool read_wholes(const Value& value, const NumberRule& rule, std::span<int> target);
bool read_word(const Value& value, const std::vector<std::string>& words, std::size_t& index);
/// Returns a number with six digits, as documents show it.
std::string number_text(double value);
/// Returns a number with as many digits as it takes to read the same number back.
std::string exact_text(double value);
std::string list_text(std::span<const double> values);

/// Applies a rule to a field of some type: `read` (false after a fault), `expected` in words,
/// `shape`, and `text` of the field's value.
template <class Rule, class T>
struct Field;

template <>
struct Field<NumberRule, double> {
  static std::string expected(const NumberRule& rule) { return expectation(rule, false, 0); }
  static ValueShape shape(const NumberRule& rule) { return scene::shape(rule, false, 0); }
  static std::string text(const NumberRule& rule, double v) { return number_text(v / rule.factor); }
  static bool read(const Value& value, const NumberRule& rule, double& target) {
    return read_number(value, rule, expected(rule), target);
  }
};

template <>
struct Field<NumberRule, int> {
  static std::string expected(const NumberRule& rule) { return expectation(rule, true, 0); }
  static ValueShape shape(const NumberRule& rule) { return scene::shape(rule, true, 0); }
  static std::string text(const NumberRule&, int v) { return std::to_string(v); }
  static bool read(const Value& value, const NumberRule& rule, int& target) {
    return read_whole(value, rule, expected(rule), target);
  }
};

template <int N>
struct Field<NumberRule, Eigen::Matrix<double, N, 1>> {
  using Vector = Eigen::Matrix<double, N, 1>;
  static std::string expected(const NumberRule& rule) { return expectation(rule, false, N); }
  static ValueShape shape(const NumberRule& rule) { return scene::shape(rule, false, N); }
  static std::string text(const NumberRule&, const Vector& v) { return list_text({v.data(), N}); }
  static bool read(const Value& value, const NumberRule& rule, Vector& target) {
    return read_numbers(value, rule, {target.data(), N});
  }
};

template <std::size_t N>
struct Field<NumberRule, std::array<double, N>> {
  static std::string expected(const NumberRule& rule) { return expectation(rule, false, N); }
  static ValueShape shape(const NumberRule& rule) { return scene::shape(rule, false, N); }
  static std::string text(const NumberRule&, const std::array<double, N>& v) {
    return list_text(v);
  }
  static bool read(const Value& value, const NumberRule& rule, std::array<double, N>& target) {
    return read_numbers(value, rule, target);
  }
};

template <std::size_t N>
struct Field<NumberRule, std::array<int, N>> {
  static std::string expected(const NumberRule& rule) { return expectation(rule, true, N); }
  static ValueShape shape(const NumberRule& rule) { return scene::shape(rule, true, N); }
  static std::string text(const NumberRule&, const std::array<int, N>& v) {
    const std::vector<double> numbers(v.begin(), v.end());
    return list_text(numbers);
  }
  static bool read(const Value& value, const NumberRule& rule, std::array<int, N>& target) {
    return read_wholes(value, rule, target);
  }
};

template <>
struct Field<TextRule, std::string> {
  static std::string expected(const TextRule& rule) { return rule.expected; }
  static ValueShape shape(const TextRule&) { return {.kind = ValueShape::Kind::text}; }
  static std::string text(const TextRule&, const std::string& v) { return v; }
  static bool read(const Value& value, const TextRule& rule, std::string& target);
};

template <>
struct Field<NameRule, std::string> {
  static std::string expected(const NameRule& rule) {
    return "a text, unique among the " + rule.list;
  }
  static ValueShape shape(const NameRule&) { return {.kind = ValueShape::Kind::text}; }
  static std::string text(const NameRule&, const std::string& v) { return v; }
  static bool read(const Value& value, const NameRule& rule, std::string& target);
};

template <>
struct Field<TruthRule, bool> {
  static std::string expected(const TruthRule&) { return "true or false"; }
  static ValueShape shape(const TruthRule&) { return {.kind = ValueShape::Kind::truth}; }
  static std::string text(const TruthRule&, bool v) { return v ? "true" : "false"; }
  static bool read(const Value& value, const TruthRule& rule, bool& target);
};

template <>
struct Field<FileRule, std::filesystem::path> {
  static std::string expected(const FileRule&) { return "a file"; }
  static ValueShape shape(const FileRule&) { return {.kind = ValueShape::Kind::file}; }
  static std::string text(const FileRule&, const std::filesystem::path& v) { return v.string(); }
  static bool read(const Value& value, const FileRule& rule, std::filesystem::path& target);
};

template <class T>
struct Field<ChoiceRule<T>, T> {
  static std::string expected(const ChoiceRule<T>& rule) {
    return app::enumerate(rule.words(), "or");
  }
  static ValueShape shape(const ChoiceRule<T>& rule) { return words_shape(rule.words()); }
  static std::string text(const ChoiceRule<T>& rule, const T& v) {
    for (const auto& [word, meaning] : rule.choices)
      if (meaning == v) return word;
    return "";
  }
  static bool read(const Value& value, const ChoiceRule<T>& rule, T& target) {
    std::size_t index = 0;
    if (!read_word(value, rule.words(), index)) return false;
    target = rule.choices[index].second;
    return true;
  }
};

/// A field that stays empty without its key.
template <class Rule, class T>
struct Field<Rule, std::optional<T>> {
  static std::string expected(const Rule& rule) { return Field<Rule, T>::expected(rule); }
  static ValueShape shape(const Rule& rule) { return Field<Rule, T>::shape(rule); }
  static std::string text(const Rule& rule, const std::optional<T>& v) {
    return v ? Field<Rule, T>::text(rule, *v) : "";
  }
  static bool read(const Value& value, const Rule& rule, std::optional<T>& target) {
    T read_value{};
    if (!Field<Rule, T>::read(value, rule, read_value)) return false;
    target = std::move(read_value);
    return true;
  }
};

}  // namespace scene

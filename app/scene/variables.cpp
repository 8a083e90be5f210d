#include "app/scene/variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <vector>

#include "app/base/words.h"
#include "app/scene/formula.h"
#include "app/scene/reader_values.h"

namespace scene {
namespace {

bool is_name(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c != '_' && !(i == 0 ? std::isalpha(c) : std::isalnum(c))) return false;
  }
  return !text.empty();
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// True if a name stands in an expression.
bool names(const std::string& expression, const std::string& name) {
  const auto in_name = [&](std::size_t i) {
    return i < expression.size() &&
           (std::isalnum(static_cast<unsigned char>(expression[i])) || expression[i] == '_');
  };
  for (std::size_t at = expression.find(name); at != std::string::npos;
       at = expression.find(name, at + 1))
    if (!(at > 0 && in_name(at - 1)) && !in_name(at + name.size())) return true;
  return false;
}

/// Returns the value of what stands between the braces.
YamlNode value_of(const Variables& variables, const std::string& expression, const Mark& mark) {
  const std::string text = trimmed(expression);
  YamlNode value;
  if (const auto found = variables.texts.find(text); found != variables.texts.end()) {
    value = found->second;
  } else {
    const auto fail = [&](const std::string& why) -> VariableFault {
      std::vector<std::string> known;
      for (const auto& [name, of] : variables.texts) known.push_back(name);
      for (const auto& [name, of] : variables.numbers) known.push_back(name);
      const bool unknown = is_name(text) && std::ranges::find(known, text) == known.end();
      for (const auto& [name, of] : variables.texts)
        if (names(text, name))
          return {mark, fmt::format("${{{}}}: {} is the text {}, expected a number",
                                    shortened(text), name, shortened(of.text))};
      return {mark, unknown ? fmt::format("there is no variable {}{}", text,
                                          app::did_you_mean(text, known))
                            : fmt::format("${{{}}}: {}", shortened(text), why)};
    };
    try {
      const double number = evaluated(text, variables.numbers);
      if (!std::isfinite(number)) throw fail("is not finite");
      value.text = exact_text(number);
    } catch (const FormulaError& error) {
      throw fail(error.what());
    }
  }
  value.kind = YamlNode::Kind::scalar;
  value.mark = mark;
  return value;
}

}  // namespace

bool has_variables(const std::string& text) { return text.find("${") != std::string::npos; }

void substitute(const Variables& variables, YamlNode& scalar, std::size_t most) {
  if (!has_variables(scalar.text)) return;
  const std::string text = scalar.text;
  std::string result;
  const auto check_length = [&](std::size_t length) {
    if (length > most)
      throw VariableFault{scalar.mark, fmt::format("with its variables the scene has more than {} "
                                                   "MiB of text",
                                                   kMostText >> 20)};
  };
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, 3, "$${") == 0) {
      result += "${";
      i += 3;
      continue;
    }
    if (text.compare(i, 2, "${") != 0) {
      result += text[i++];
      continue;
    }
    const std::size_t end = text.find('}', i);
    if (end == std::string::npos) throw VariableFault{scalar.mark, "has a ${ without its }"};
    YamlNode value = value_of(variables, text.substr(i + 2, end - i - 2), scalar.mark);
    check_length(result.size() + value.text.size());
    if (i == 0 && end + 1 == text.size()) {
      scalar = std::move(value);
      return;
    }
    result += value.text;
    i = end + 1;
  }
  scalar.text = result;
}

Variables read_variables(const YamlNode& map) {
  if (!map.is(YamlNode::Kind::map))
    throw VariableFault{map.mark, "expected a map of names with numbers and texts"};
  Variables variables;
  std::size_t left = kMostText;
  for (const YamlEntry& entry : map.entries) {
    if (!is_name(entry.key))
      throw VariableFault{entry.mark,
                          fmt::format("found the name {}, expected letters, digits and _, the "
                                      "first no digit",
                                      shortened(entry.key)),
                          entry.key};
    if (is_formula_name(entry.key))
      throw VariableFault{entry.mark, entry.key + " is a name in formulas, expected another",
                          entry.key};
    YamlNode value = entry.value;
    if (!value.is(YamlNode::Kind::scalar))
      throw VariableFault{value.mark.line > 0 ? value.mark : entry.mark,
                          fmt::format("found {}, expected a number or a text; anchors repeat "
                                      "anything else",
                                      describe(value)),
                          entry.key};
    try {
      substitute(variables, value, left);
    } catch (const VariableFault& fault) {
      throw VariableFault{fault.mark, fault.message, entry.key};
    }
    left -= std::min(left, value.text.size());
    const std::optional<double> number = plain_number(value);
    variables.texts.erase(entry.key);
    variables.numbers.erase(entry.key);
    if (number)
      variables.numbers[entry.key] = *number;
    else
      variables.texts[entry.key] = value;
  }
  return variables;
}

}  // namespace scene

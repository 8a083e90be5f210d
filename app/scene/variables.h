#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "app/scene/yaml_reader.h"

/// @file
/// Variables of a scene: `variables: {side: 1.2}`, used as `${side}` and `${2*side}` in values.

namespace scene {

/// Variables with their values.
struct Variables {
  std::map<std::string, double> numbers;
  std::map<std::string, YamlNode> texts;  ///< Texts and truth values, as they were written.
};

/// Fault of a value that has variables.
struct VariableFault {
  Mark mark;
  std::string message;
  std::string name = "";  ///< The variable whose own value it is.
};

/// True if the text has a `${`.
bool has_variables(const std::string& text);

/// Replaces each `${…}` of a scalar by its value: the variable of that name, or what the expression
/// of numbers gives (formula.h, without the time). A scalar that is one `${…}` and nothing else
/// becomes what that is, number, text or truth value, even in quotes; otherwise the values become
/// parts of the text. `$${` stands for `${`.
/// @param most   Longest text to make [bytes].
/// @throws VariableFault
void substitute(const Variables& variables, YamlNode& scalar, std::size_t most = kMostText);

/// Reads the map of variables in its order; each may use those before it.
/// @throws VariableFault, also if all texts together are longer than kMostText
Variables read_variables(const YamlNode& map);

}  // namespace scene

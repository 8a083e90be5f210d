#pragma once

#include <optional>
#include <string>
#include <vector>

/// @file
/// The text of an input file of MoorDyn v2: sections, each under a line with `---` and its name, of
/// which OPTIONS has a value and a name in each line.

namespace engine {

/// An option and the value that it is to have.
struct MoorDynOption {
  std::string name;                 ///< As MoorDyn spells it.
  std::vector<std::string> others;  ///< Its other names, in small letters.
  std::string value;
};

/// The text with options in place of those of the same names, case aside. They end its section of
/// options, which is added where there is none.
std::string with_options(const std::string& text, const std::vector<MoorDynOption>& options);

/// The last value of an option, case aside; none if the text does not give it.
std::optional<std::string> option_of(const std::string& text, const std::string& name);

/// True if a section has this word, in capital letters, in its name.
bool has_section(const std::string& text, const std::string& word);

}  // namespace engine

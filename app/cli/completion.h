#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// @file
/// Shell completion of the program's command lines, based on the description that parses them and
/// on the catalogue of a scene's keys.

namespace app {

/// A word that a command accepts: an option, with or without a value, or an argument.
struct CompletedOption {
  enum class Value { none, any, file, folder, override, choice };
  std::vector<std::string> names;  ///< `--out`; empty for an argument.
  std::string description;
  Value value = Value::none;
  std::vector<std::string> choices;  ///< Choices of `choice`.
  bool repeated = false;             ///< The word may be given several times.
};

struct CompletedCommand {
  std::string name;
  std::string description;
  std::vector<CompletedOption> options;
  std::vector<CompletedOption> arguments;
};

/// Returns the program itself, as a command without a name, and its commands.
std::vector<CompletedCommand> completed_commands(const CLI::App& program);

/// A key that an override may set, such as `bodies[].hydro.lift`, and the words that it accepts.
struct CompletedKey {
  std::string path;
  std::vector<std::string> words;
};
std::vector<CompletedKey> completed_keys();

/// Prints the completion script of a shell, `bash` or `zsh`. @return the exit code
int completion(const CLI::App& program, const std::string& shell);

std::string bash_completion(const CLI::App& program);
std::string zsh_completion(const CLI::App& program);

}  // namespace app

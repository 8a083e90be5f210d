#include "app/cli/usage_faults.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "app/base/console.h"
#include "app/base/words.h"

namespace app {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

/// Long options of a command, with dashes.
std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// Returns the name of an option without the value after a =.
std::string name_of(const std::string& word) { return word.substr(0, word.find('=')); }

bool has_option(const CLI::App& command, const std::string& name) {
  const std::vector<std::string> names = options_of(command);
  return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void refuse(const std::string& text) {
  throw CLI::ParseError(text, CLI::ExitCodes::ExtrasError);
}

/// Refuses an option that stands before a command which has it.
void refuse_before_command(const CLI::App& program, const std::vector<std::string>& words) {
  const std::string option = name_of(words.front());
  for (const CLI::App* command : commands_of(program))
    if (std::find(words.begin(), words.end(), command->get_name()) != words.end() &&
        has_option(*command, option))
      refuse(fmt::format("found {} before the command, expected plimsoll {} {}", option,
                         command->get_name(), option));
}

/// Returns the argument of an error's list that is at fault: the first option, or else the last
/// one.
std::string unexpected_in(const std::string& text) {
  std::istringstream list(text.substr(text.find(": ") + 2));
  std::string word;
  while (list >> word)
    if (word.starts_with("-")) break;
  return word;
}

}  // namespace

void check_command(const CLI::App& program, const std::vector<std::string>& words) {
  const std::string word = words.empty() ? "" : words.front();
  if (word.starts_with('-')) {
    refuse_before_command(program, words);
    return;
  }
  std::vector<std::string> known;
  for (const CLI::App* command : commands_of(program)) known.push_back(command->get_name());
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  std::string hint = did_you_mean(word, known);
  if (word.ends_with(".yaml")) hint = fmt::format("; did you mean plimsoll run {}?", word);
  std::string all;
  for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
  refuse(fmt::format("{}, expected a command: {}{}",
                     word.empty() ? "found nothing" : "found " + word, all, hint));
}

void say_unexpected(const CLI::App& program, const CLI::ExtrasError& error) {
  std::vector<std::string> known;
  std::string command = "plimsoll";
  for (const CLI::App* used : program.get_subcommands()) {
    command += " " + used->get_name();
    for (const std::string& name : options_of(*used)) known.push_back(name);
  }
  const std::string text = error.what();
  const std::string found = name_of(unexpected_in(text));
  std::vector<std::string> owners;
  for (const CLI::App* other : commands_of(program))
    if (has_option(*other, found)) owners.push_back(other->get_name());
  const std::string near = found.starts_with("-") ? did_you_mean(found, known) : "";
  if (!owners.empty())
    say(fmt::format("{} has no option {}; it is one of {}", command, found,
                    enumerate(owners, "and")));
  else
    say(near.empty() ? text : fmt::format("{} has no option {}{}", command, found, near));
  say(fmt::format("Run {} --help for more information.", command));
}

}  // namespace app

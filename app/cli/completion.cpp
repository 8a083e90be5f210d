#include "app/cli/completion.h"

#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/scene/key_catalogue.h"

namespace app {
namespace {

using Completes = CompletedOption::Value;

/// Returns the words of a choice, which the parser names `TEXT:{galerkin,constant}`.
std::vector<std::string> choices_in(const std::string& type) {
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::vector<std::string> choices;
  for (std::string word : CLI::detail::split(type.substr(begin + 1, end - begin - 1), ','))
    choices.push_back(word.substr(0, word.find("->")));
  return choices;
}

Completes what_completes(const std::string& type) {
  // `compare` names its trajectories or folders of runs A and B.
  for (const char* file : {"FILE", "SCENE", "A", "B"})
    if (type == file) return Completes::file;
  if (type == "DIR") return Completes::folder;
  if (type == "KEY.PATH=VALUE") return Completes::override;
  return choices_in(type).empty() ? Completes::any : Completes::choice;
}

CompletedOption described(const CLI::Option& option) {
  CompletedOption completed;
  for (const std::string& name : option.get_snames()) completed.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) completed.names.push_back("--" + name);
  completed.description = option.get_description();
  if (option.get_items_expected_max() == 0) return completed;
  const std::string type = option.get_type_name();
  completed.value = what_completes(type);
  completed.choices = choices_in(type);
  completed.repeated = option.get_items_expected_max() > option.get_type_size_max();
  return completed;
}

CompletedCommand described(const CLI::App& app) {
  CompletedCommand command = {.name = app.get_name(), .description = app.get_description()};
  for (const CLI::Option* option : app.get_options())
    (option->get_positional() ? command.arguments : command.options).push_back(described(*option));
  return command;
}

}  // namespace

std::vector<CompletedCommand> completed_commands(const CLI::App& program) {
  std::vector<CompletedCommand> commands = {described(program)};
  commands.front().name = "";
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(described(*command));
  return commands;
}

std::vector<CompletedKey> completed_keys() {
  using Kind = scene::ValueShape::Kind;
  std::vector<CompletedKey> keys;
  for (const scene::KeyDescription& key : scene::key_catalogue().keys) {
    CompletedKey completed = {.path = key.path};
    bool block = true;
    for (const scene::ValueShape& shape : key.shapes) {
      block = block && (shape.kind == Kind::map ||
                        (shape.kind == Kind::list && shape.item.front().kind == Kind::map));
      std::vector<std::string>& words = completed.words;
      words.insert(words.end(), shape.words.begin(), shape.words.end());
      if (shape.kind == Kind::truth) words.insert(words.end(), {"true", "false"});
      if (shape.kind == Kind::off) words.emplace_back("false");
    }
    if (!block) keys.push_back(completed);
  }
  return keys;
}

int completion(const CLI::App& program, const std::string& shell) {
  print(shell == "bash" ? bash_completion(program) : zsh_completion(program));
  return kDone;
}

}  // namespace app

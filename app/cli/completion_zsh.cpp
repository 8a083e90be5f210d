#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "app/cli/completion.h"

namespace app {
namespace {

using Completes = CompletedOption::Value;

/// The part that does not depend on the commands.
constexpr std::string_view kOverrides = R"(
# Completes KEY.PATH=VALUE: the path step by step, then the words that a key may have. Entries of
# lists are named as they are typed, or else by index 0; cameras as they are typed.
_plimsoll_override()
{
    local typed=${(Q)PREFIX} key pattern rest
    local -a found
    pattern=$(sed -E 's/\[[^]]*\]/[]/g; s/\[[^]]+$/[/; s/^(render\.cameras\.)[^.]+/\1NAME/' <<< "${typed%%=*}")
    for key in $_plimsoll_keys; do
        if [[ $typed == *=* ]]; then
            [[ ${key%%=*} == "$pattern" ]] || continue
            for rest in ${=key#*=}; do found+=("${typed%%=*}=$rest"); done
        elif [[ $key == "$pattern"* ]]; then
            rest=${${key%%=*}#"$pattern"}=
            [[ $rest == *.* ]] && rest=${rest%%.*}.
            [[ $typed == *\[ ]] && rest=0$rest
            found+=("$typed${rest//\[\]/[0]}")
        fi
    done
    [[ $typed == *=* ]] && compadd -- $found || compadd -S '' -- ${(u)found}
}
)";

/// Puts a text into single quotes.
std::string zsh_quoted(const std::string& text) {
  std::string quoted;
  for (const char c : text) {
    if (c == '\'')
      quoted += "'\\'";
    else if (c == '[' || c == ']' || c == ':')
      quoted += '\\';
    quoted += c;
  }
  return quoted;
}

std::string zsh_action(const CompletedOption& option) {
  switch (option.value) {
    case Completes::none:
      return "";
    case Completes::any:
      return ":value: ";
    case Completes::file:
      return ":file:_files";
    case Completes::folder:
      return ":folder:_files -/";
    case Completes::override:
      return ":key:_plimsoll_override";
    case Completes::choice:
      return fmt::format(":value:({})", fmt::join(option.choices, " "));
  }
  return "";
}

/// Returns a specification per name of an option, `'--out=[Folder]:folder:_files -/'`, or that of
/// an argument, `':file:_files'`.
std::string zsh_specification(const CompletedOption& option) {
  std::string text;
  for (const std::string& name : option.names)
    text += fmt::format(" \\\n                '{}{}{}[{}]{}'", option.repeated ? "*" : "", name,
                        option.value == Completes::none ? "" : "=", zsh_quoted(option.description),
                        zsh_action(option));
  if (option.names.empty())
    text =
        fmt::format(" \\\n                '{}{}'", option.repeated ? "*" : "", zsh_action(option));
  return text;
}

std::string zsh_branch(const CompletedCommand& command) {
  std::string text = fmt::format("        {})\n            _arguments -S", command.name);
  for (const CompletedOption& option : command.options) text += zsh_specification(option);
  for (const CompletedOption& argument : command.arguments) text += zsh_specification(argument);
  return text + " ;;\n";
}

}  // namespace

std::string zsh_completion(const CLI::App& program) {
  const std::vector<CompletedCommand> commands = completed_commands(program);
  std::string text =
      "#compdef plimsoll\n# Completion of plimsoll for zsh, as `plimsoll completion zsh` prints "
      "it.\n\n"
      "typeset -ga _plimsoll_keys=(\n";
  for (const CompletedKey& key : completed_keys())
    text += fmt::format("    '{}={}'\n", key.path, fmt::join(key.words, " "));
  text += ")\n" + std::string(kOverrides) + "\n_plimsoll()\n{\n    local -a commands=(\n";
  for (std::size_t i = 1; i < commands.size(); ++i)
    text += fmt::format("        '{}:{}'\n", commands[i].name, zsh_quoted(commands[i].description));
  text +=
      "    )\n"
      "    if ((CURRENT == 2)) && [[ $PREFIX != -* ]]; then\n"
      "        _describe command commands\n"
      "        return\n"
      "    fi\n"
      "    local command=\n"
      "    if ((CURRENT > 2)); then\n"
      "        command=$words[2]\n"
      "        shift words\n"
      "        ((CURRENT--))\n"
      "    fi\n"
      "    case $command in\n";
  for (const CompletedCommand& command : commands)
    text +=
        zsh_branch(command.name.empty() ? CompletedCommand{.name = "''", .options = command.options}
                                        : command);
  return text +
         "    esac\n}\n\nif [[ $funcstack[1] == _plimsoll ]]; then\n    _plimsoll \"$@\"\nelse\n"
         "    compdef _plimsoll plimsoll\nfi\n";
}

}  // namespace app

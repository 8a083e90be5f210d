#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "app/cli/completion.h"

namespace app {
namespace {

using Completes = CompletedOption::Value;

/// The part that does not depend on the commands.
constexpr std::string_view kFunctions = R"(
# Adds the names of files, or of folders (-d), that begin with a word.
_plimsoll_files()
{
    local names
    mapfile -t names < <(compgen "$1" -- "$2")
    COMPREPLY+=("${names[@]}")
    compopt -o filenames 2> /dev/null
}

# Adds the words of a list that begin with a word.
_plimsoll_words()
{
    local word
    for word in $1; do
        [[ $word == "$2"* ]] && COMPREPLY+=("$word")
    done
}

# Completes KEY.PATH=VALUE: the path step by step, then the words that a key may have. Entries of
# lists are named as they are typed, or else by index 0; cameras as they are typed.
_plimsoll_override()
{
    local typed=$1 path key rest
    path=$(sed -E 's/\[[^]]*\]/[]/g; s/\[[^]]+$/[/; s/^(render\.cameras\.)[^.]+/\1NAME/' <<< "${typed%%=*}")
    for key in "${_plimsoll_keys[@]}"; do
        if [[ $typed == *=* ]]; then
            [[ ${key%%=*} == "$path" ]] || continue
            _plimsoll_words "${key#*=}" "${typed#*=}"
            COMPREPLY=("${COMPREPLY[@]/#/"${typed%%=*}="}")
        elif [[ $key == "$path"* ]]; then
            rest=${key%%=*}=
            rest=${rest:${#path}}
            [[ $rest == *.* ]] && rest=${rest%%.*}.
            [[ $typed == *\[ ]] && rest=0$rest
            rest=$typed${rest//'[]'/'[0]'}
            [[ " ${COMPREPLY[*]} " == *" $rest "* ]] || COMPREPLY+=("$rest")
            compopt -o nospace 2> /dev/null
        fi
    done
}

_plimsoll()
{
    # The shell takes words apart at an equals sign: they are put together again.
    local -a words=()
    local i glue=
    for ((i = 0; i <= COMP_CWORD; ++i)); do
        if [[ -n $glue || ${COMP_WORDS[i]} == '=' ]]; then
            words[-1]+=${COMP_WORDS[i]}
        else
            words+=("${COMP_WORDS[i]}")
        fi
        [[ ${COMP_WORDS[i]} == '=' ]] && glue=1 || glue=
    done
    local word=${words[-1]} option= head=
    local command=${words[1]}
    if [[ $word == --*=* ]]; then
        option=${word%%=*} head=${word%%=*}= word=${word#*=}
    elif ((${#words[@]} > 2)); then
        option=${words[-2]}
    fi
    ((${#words[@]} == 2)) && command=
    COMPREPLY=()
    _plimsoll_complete "$command" "$option" "$word"
    COMPREPLY=("${COMPREPLY[@]/#/"$head"}")
    # What stands before the last equals sign is on the line already.
    local part=$head$word
    if [[ $COMP_WORDBREAKS == *=* && $part == *=* ]]; then
        part=${part%=*}=
        COMPREPLY=("${COMPREPLY[@]#"$part"}")
    fi
}

complete -F _plimsoll plimsoll
)";

std::string bash_action(const CompletedOption& option) {
  switch (option.value) {
    case Completes::file:
      return "_plimsoll_files -f \"$word\"";
    case Completes::folder:
      return "_plimsoll_files -d \"$word\"";
    case Completes::override:
      return "_plimsoll_override \"$word\"";
    case Completes::choice:
      return fmt::format("_plimsoll_words '{}' \"$word\"", fmt::join(option.choices, " "));
    case Completes::none:
    case Completes::any:
      return ":";
  }
  return ":";
}

/// Returns the branch of a command: `run)` and the completion of its words.
std::string bash_branch(const CompletedCommand& command, const std::string& arguments) {
  std::string names, values;
  for (const CompletedOption& option : command.options) {
    names += fmt::format("{}{}", names.empty() ? "" : " ", fmt::join(option.names, " "));
    if (option.value != Completes::none)
      values += fmt::format("                {}) {}; return ;;\n", fmt::join(option.names, "|"),
                            bash_action(option));
  }
  return fmt::format(
      "        '{}')\n"
      "            case $option in\n{}            esac\n"
      "            if [[ $word == -* ]]; then\n"
      "                _plimsoll_words '{}' \"$word\"\n"
      "            else\n"
      "                {}\n"
      "            fi ;;\n",
      command.name, values, names, arguments);
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  const std::vector<CompletedCommand> commands = completed_commands(program);
  std::string text =
      "# Completion of plimsoll for bash, as `plimsoll completion bash` prints it.\n\n";
  text += "_plimsoll_keys=(\n";
  for (const CompletedKey& key : completed_keys())
    text += fmt::format("    '{}={}'\n", key.path, fmt::join(key.words, " "));
  text += ")\n\n# After a command, empty for none, and an option.\n_plimsoll_complete()\n{\n";
  text += "    local option=$2 word=$3\n    case $1 in\n";
  std::string names;
  for (const CompletedCommand& command : commands) names += " " + command.name;
  for (const CompletedCommand& command : commands) {
    const bool has_arguments = !command.arguments.empty();
    const std::string arguments =
        command.name.empty() ? fmt::format("_plimsoll_words '{}' \"$word\"", names.substr(1))
        : has_arguments      ? bash_action(command.arguments.front())
                             : ":";
    text += bash_branch(command, arguments);
  }
  return text + "    esac\n}\n" + std::string(kFunctions);
}

}  // namespace app

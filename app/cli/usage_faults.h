#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ExtrasError;
}  // namespace CLI

/// @file
/// Messages about a command line that the program does not understand.

namespace app {

/// Checks that a command stands first, or an option of the program itself.
/// @param words   Words of the command line, without the program's name.
/// @throws CLI::ParseError that lists the commands, and names the nearest one or the place of an
///     option before the command
void check_command(const CLI::App& program, const std::vector<std::string>& words);

/// Says which argument a command does not have, and which command has it or which option is nearest
/// to it.
void say_unexpected(const CLI::App& program, const CLI::ExtrasError& error);

}  // namespace app

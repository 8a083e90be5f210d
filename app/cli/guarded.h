#pragma once

#include <functional>
#include <string>

namespace app {

/// Runs a command and prints the errors that it throws on standard error.
/// @param name   Name of the command.
/// @return its exit code, or that of the exception
int guarded(const std::string& name, const std::function<int()>& command);

}  // namespace app

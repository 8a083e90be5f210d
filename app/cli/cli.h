#pragma once

namespace app {

/// Parses the command line and runs the command. Returns the exit code.
int command_line(int argc, char** argv);

}  // namespace app

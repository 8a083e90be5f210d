#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace app {

/// Returns the path of a program found through PATH; empty if there is none.
std::filesystem::path find_program(const std::string& name);

/// Child process that processes its standard input. The input closes when this process ends, and
/// Ctrl-C does not reach the child.
class PipedProgram {
 public:
  /// Starts the program. @throws std::runtime_error if it cannot be started
  PipedProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  /// Kills the program if it still runs.
  ~PipedProgram();
  PipedProgram(const PipedProgram&) = delete;
  PipedProgram& operator=(const PipedProgram&) = delete;

  /// Writes to the program's input; blocks while its buffer is full. @return false if the program
  /// has closed it
  bool write(std::span<const std::uint8_t> bytes) const;

  /// Closes the input and waits for the program's end. @return true if its exit code is 0
  bool finish();

  /// Returns the lines that the program has written to standard error.
  std::vector<std::string> messages() const;

 private:
  pid_t process_ = 0;  ///< 0 once it has ended.
  int input_ = -1;     ///< This process's end of the program's standard input.
  int messages_ = -1;  ///< Anonymous file that receives the program's standard error.
};

}  // namespace app

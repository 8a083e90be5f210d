#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace app {

/// The file of a program that the environment's PATH leads to; empty if there is none.
std::filesystem::path find_program(const std::string& name);

/// A program that works on what it is given on its standard input. It ends by itself if this
/// process does, and Ctrl-C is not for it.
class PipedProgram {
 public:
  /// Starts it. @throws std::runtime_error if that is not possible
  PipedProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  /// Ends it.
  ~PipedProgram();
  PipedProgram(const PipedProgram&) = delete;
  PipedProgram& operator=(const PipedProgram&) = delete;

  /// Waits while it is behind. @return false if it takes no more
  bool write(std::span<const std::uint8_t> bytes) const;

  /// Tells it that this was all, and waits for its end. @return whether it has ended well
  bool finish();

  /// The lines that it has said on standard error.
  std::vector<std::string> messages() const;

 private:
  pid_t process_ = 0;  ///< 0 once it has ended.
  int input_ = -1;     ///< The near end of its standard input.
  int messages_ = -1;  ///< A file without a name that holds what it says.
};

}  // namespace app

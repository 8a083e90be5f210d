#pragma once

#include <signal.h>
#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// The file of this program.
std::string program_path();

/// How a child process ended.
struct EndedProcess {
  /// Added to the number of a signal that ended a process, as shells do.
  static constexpr int kSignalBase = 128;

  pid_t process = 0;
  int code = 0;  ///< Exit code; with kSignalBase the number of the signal.
};

/// Child processes that run this program. While it lives, ends of children are waited for rather
/// than signalled. To be used by one thread.
class ChildProcesses {
 public:
  ChildProcesses();
  ~ChildProcesses();
  ChildProcesses(const ChildProcesses&) = delete;
  ChildProcesses& operator=(const ChildProcesses&) = delete;

  /// Starts the program. The child is killed when this process ends before it.
  /// @param messages   File descriptor for what the child says.
  /// @throws std::runtime_error if there can be no more processes
  pid_t start(const std::vector<std::string>& arguments, int messages) const;

  /// A child that has ended; none if the time passes or a signal comes before.
  std::optional<EndedProcess> wait(std::chrono::milliseconds longest) const;

 private:
  sigset_t before_;  ///< Signals that were blocked.
};

}  // namespace app

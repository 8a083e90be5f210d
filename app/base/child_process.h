#pragma once

#include <signal.h>
#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// Returns the path of this program's executable.
std::string program_path();

/// The end of a child process.
struct EndedProcess {
  /// Offset added to the number of a signal that ended a process, as in shells.
  static constexpr int kSignalBase = 128;

  pid_t process = 0;
  int code = 0;  ///< Exit code, or kSignalBase plus the number of the signal.
};

/// Child processes that run this program. While the object lives, SIGCHLD is blocked so that `wait`
/// can wait for it. Only one thread may use the object.
class ChildProcesses {
 public:
  ChildProcesses();
  ~ChildProcesses();
  ChildProcesses(const ChildProcesses&) = delete;
  ChildProcesses& operator=(const ChildProcesses&) = delete;

  /// Starts the program. The child is killed when this process ends before it.
  /// @param messages   File descriptor of the child's standard output and error.
  /// @throws std::runtime_error if no process can be created
  pid_t start(const std::vector<std::string>& arguments, int messages) const;

  /// Waits until a child ends; none if `longest` passes or another signal arrives first.
  std::optional<EndedProcess> wait(std::chrono::milliseconds longest) const;

 private:
  sigset_t before_;  ///< Signals that were blocked before.
};

}  // namespace app

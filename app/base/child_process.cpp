#include "app/base/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace app {
namespace {

/// Exit code of a child that could not execute the program, as in shells.
constexpr int kCannotExecute = 127;

std::optional<EndedProcess> ended_child() {
  int status = 0;
  const pid_t process = ::waitpid(-1, &status, WNOHANG);
  if (process <= 0) return std::nullopt;
  const int code =
      WIFEXITED(status) ? WEXITSTATUS(status) : EndedProcess::kSignalBase + WTERMSIG(status);
  return EndedProcess{process, code};
}

/// Executes the program in the child. It must not allocate: another thread of the parent may have
/// held the allocator's lock during the fork.
[[noreturn]] void become_program(const char* program, char* const* arguments, int messages,
                                 pid_t parent, const sigset_t& signals) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kCannotExecute);  // the parent has ended
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(messages, STDOUT_FILENO);
  ::dup2(messages, STDERR_FILENO);
  ::sigprocmask(SIG_SETMASK, &signals, nullptr);
  ::execv(program, arguments);
  ::_exit(kCannotExecute);
}

sigset_t child_signal() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGCHLD);
  return signals;
}

}  // namespace

std::string program_path() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

ChildProcesses::ChildProcesses() {
  const sigset_t signals = child_signal();
  ::sigprocmask(SIG_BLOCK, &signals, &before_);
}

ChildProcesses::~ChildProcesses() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }

pid_t ChildProcesses::start(const std::vector<std::string>& arguments, int messages) const {
  // This path leads to the running program even if its file has been replaced.
  const char* const program = "/proc/self/exe";
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), "plimsoll");
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become_program(program, pointers.data(), messages, parent, before_);
  if (child < 0)
    throw std::runtime_error(fmt::format("no process can be started: {}", std::strerror(errno)));
  return child;
}

std::optional<EndedProcess> ChildProcesses::wait(std::chrono::milliseconds longest) const {
  if (const auto ended = ended_child()) return ended;
  constexpr long kNanoseconds = 1'000'000;
  const timespec time = {longest.count() / 1000, longest.count() % 1000 * kNanoseconds};
  const sigset_t signals = child_signal();
  ::sigtimedwait(&signals, nullptr, &time);
  return ended_child();
}

}  // namespace app

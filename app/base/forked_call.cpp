#include "app/base/forked_call.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

namespace app {
namespace {

using Clock = std::chrono::steady_clock;

/// Exit code of a child that has used up its memory.
constexpr int kOutOfMemory = 81;

/// The last bytes of a complete result. They count instead of the exit code, which is lost where
/// the program around the module for Python ignores SIGCHLD.
constexpr std::string_view kComplete = "\x06THE END";

/// The shadow memory of the sanitizers takes terabytes of address space.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

/// Returns the present size of the address space [bytes].
std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// State of the threads other than the caller, as the kernel has it.
struct OtherThreads {
  bool asleep = true;    ///< whether each sleeps, not waiting for memory
  std::string switches;  ///< how often each has begun and ceased to run; the same if none has run
};

OtherThreads other_threads() {
  OtherThreads threads;
  std::error_code vanished;  // A thread may end while it is looked at.
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", vanished)) {
    if (thread.path().filename() == std::to_string(::gettid())) continue;
    std::ifstream status(thread.path() / "status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("State:")) threads.asleep &= line.starts_with("State:\tS");
      if (line.find("ctxt_switches:") != std::string::npos) threads.switches += line;
    }
  }
  return threads;
}

/// Waits until the other threads sleep, for five seconds at most. The allocators of the sanitizers,
/// unlike that of glibc, keep a child waiting for ever where another thread was at work in them.
/// One look at each thread in turn is not enough: one that was seen asleep may have been woken by
/// the next. Where none has run from the first to the second of two looks, all slept at one time.
void let_other_threads_finish() {
  constexpr auto kPause = std::chrono::milliseconds(2);
  OtherThreads before = other_threads();
  for (int i = 0; i < 2500; ++i) {
    std::this_thread::sleep_for(kPause);
    OtherThreads now = other_threads();
    if (before.asleep && now.asleep && before.switches == now.switches) return;
    before = std::move(now);
  }
}

void limit(__rlimit_resource_t resource, rlim_t value) {
  // Where the limit of computing time is also the largest that may be set, the signal is SIGKILL.
  const rlimit limits = {value, resource == RLIMIT_CPU ? value + 1 : value};
  ::setrlimit(resource, &limits);
}

/// Gives every signal its default action but SIGINT, which the parent answers for both.
void reset_signals() {
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_DFL);
  ::signal(SIGINT, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// Leaves /dev/null and the descriptor of the result open, nothing else.
void close_files(int result) {
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, stream);
  if (result > 3) ::close_range(3, static_cast<unsigned>(result) - 1, 0);
  ::close_range(static_cast<unsigned>(result) + 1, ~0U, 0);
}

/// Lets the kernel end the child first where the machine has no memory left.
void volunteer_to_be_killed() {
  const Descriptor file(::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC));
  constexpr std::string_view kFirst = "1000";
  if (file.number() >= 0 && ::write(file.number(), kFirst.data(), kFirst.size()) < 0) return;
}

void write_all(int descriptor, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) ::_exit(1);  // nobody reads it
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

/// An exception of the function ends the process, and must not reach the callers of the parent.
[[noreturn]] void act_as_child(const std::function<void(const CallOutput&)>& work,
                               const CallLimits& limits, std::size_t size, pid_t parent,
                               int result) noexcept {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // the parent has ended
  reset_signals();
  volunteer_to_be_killed();
  close_files(result);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu_seconds));
  if (!kSanitized) limit(RLIMIT_AS, size + limits.memory);
  std::set_new_handler([] { ::_exit(kOutOfMemory); });
  try {
    work([&](std::span<const char> bytes) { write_all(result, bytes); });
  } catch (const std::bad_alloc&) {
    ::_exit(kOutOfMemory);
  }
  write_all(result, kComplete);
  ::_exit(0);
}

/// Reads until the other end closes or `deadline` passes. @return false if it has passed
bool read_until(Clock::time_point deadline, int descriptor, std::string& bytes) {
  std::array<char, 1 << 16> part;
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    pollfd readable = {.fd = descriptor, .events = POLLIN, .revents = 0};
    // A wait that a signal ends is begun anew.
    if (::poll(&readable, 1, static_cast<int>(std::min<long long>(left, 1000))) <= 0) continue;
    const ssize_t size = ::read(descriptor, part.data(), part.size());
    if (size == 0) return true;
    if (size > 0) bytes.append(part.data(), static_cast<std::size_t>(size));
  }
}

/// Waits for the child. @return its status; 0 where it is not known
int status_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return 0;
  }
  return status;
}

std::string name_of(int signal) {
  std::string name = ::strsignal(signal);
  if (!name.empty()) name[0] = static_cast<char>(std::tolower(name[0]));
  return name;
}

CallResult result_of(std::string bytes, bool in_time, int status) {
  using End = CallResult::End;
  if (!in_time) return {.end = End::too_slow};
  if (bytes.ends_with(kComplete)) {
    bytes.resize(bytes.size() - kComplete.size());
    return {.bytes = std::move(bytes)};
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory) return {.end = End::out_of_memory};
  if (WIFEXITED(status))
    return {.end = End::ended, .cause = fmt::format("exit code {}", WEXITSTATUS(status))};
  // The kernel ends the process by SIGKILL where the machine has no memory left.
  if (WTERMSIG(status) == SIGXCPU) return {.end = End::too_slow};
  if (WTERMSIG(status) == SIGKILL) return {.end = End::out_of_memory};
  return {.end = End::ended, .cause = name_of(WTERMSIG(status))};
}

}  // namespace

CallResult forked_call(const std::function<void(const CallOutput&)>& work,
                       const CallLimits& limits) {
  std::array<int, 2> ends = {-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::runtime_error(fmt::format("no pipe can be made: {}", std::strerror(errno)));
  const Descriptor output(ends[0]);
  Descriptor input(ends[1]);
  const std::size_t size = address_space();
  if (kSanitized) let_other_threads_finish();
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(limits.wall_seconds));
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) act_as_child(work, limits, size, parent, input.number());
  if (child < 0)
    throw std::runtime_error(fmt::format("no process can be started: {}", std::strerror(errno)));
  input.close();
  std::string bytes;
  bool in_time = false;
  try {
    in_time = read_until(deadline, output.number(), bytes);
  } catch (const std::bad_alloc&) {
    ::kill(child, SIGKILL);
    status_of(child);
    throw;
  }
  if (!in_time) ::kill(child, SIGKILL);
  return result_of(std::move(bytes), in_time, status_of(child));
}

}  // namespace app

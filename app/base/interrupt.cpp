#include "app/base/interrupt.h"

#include <time.h>

#include <atomic>
#include <csignal>
#include <cstdint>

namespace app {
namespace {

/// True after a signal, which any thread may receive.
std::atomic<bool> noted = false;
/// When it came, by the monotonic clock [ns].
std::atomic<std::int64_t> noted_at = 0;
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t nanoseconds() {
  timespec now;  // A handler of signals may call clock_gettime().
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

extern "C" void note_signal(int number) {
  noted_at = nanoseconds();
  noted = true;
  std::signal(number, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  noted = false;
  // Signals that the caller ignores, as a shell does for background jobs, stay ignored.
  for (const int number : kSignals)
    if (std::signal(number, note_signal) == SIG_IGN) std::signal(number, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
  for (const int number : kSignals)
    if (std::signal(number, SIG_DFL) == SIG_IGN) std::signal(number, SIG_IGN);
}

bool InterruptGuard::interrupted() const { return noted; }

bool InterruptGuard::overdue() const {
  return noted && static_cast<double>(nanoseconds() - noted_at) > 1e9 * kStepPatience;
}

}  // namespace app

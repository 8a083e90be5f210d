#include "app/base/interrupt.h"

#include <atomic>
#include <csignal>

namespace app {
namespace {

/// Any thread may be the one that takes the signal.
std::atomic<bool> noted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr int kSignals[] = {SIGINT, SIGTERM};

extern "C" void note_signal(int number) {
  noted = true;
  std::signal(number, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  noted = false;
  // What the caller has switched off, as a shell does for a job in the background, stays off.
  for (const int number : kSignals)
    if (std::signal(number, note_signal) == SIG_IGN) std::signal(number, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
  for (const int number : kSignals)
    if (std::signal(number, SIG_DFL) == SIG_IGN) std::signal(number, SIG_IGN);
}

bool InterruptGuard::interrupted() const { return noted; }

}  // namespace app

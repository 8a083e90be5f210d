#include "app/base/interrupt.h"

#include <atomic>
#include <csignal>

namespace app {
namespace {

/// True after a signal, which any thread may receive.
std::atomic<bool> noted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

extern "C" void note_signal(int number) {
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

}  // namespace app

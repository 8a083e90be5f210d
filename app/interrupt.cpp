#include "app/interrupt.h"

#include <csignal>

namespace app {
namespace {

volatile std::sig_atomic_t noted = 0;

extern "C" void note_signal(int number) {
  noted = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  noted = 0;
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::interrupted() const { return noted != 0; }

}  // namespace app

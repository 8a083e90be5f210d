#include "app/python/unlocked.h"

#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace python {
namespace {

namespace py = pybind11;

/// The work of all threads without the GIL.
struct Works {
  std::mutex mutex;
  std::condition_variable ended;
  int count = 0;
  std::optional<std::thread::id> ender;  ///< Thread in which Python ends; none before.
};

/// Is never freed, since threads may wait in it until the process ends. The copy of a process has
/// none of the others' threads, and so works of its own.
Works* works = [] {
  ::pthread_atfork(nullptr, nullptr, [] { works = new Works; });
  return new Works;
}();

bool overtaken() { return works->ender && *works->ender != std::this_thread::get_id(); }

[[noreturn]] void wait_for_the_end() {
  while (true) ::pause();
}

/// Waits for all work. It is called with the GIL, when Python begins to end.
void end() {
  constexpr std::chrono::milliseconds kBetweenSignals(50);
  std::unique_lock lock(works->mutex);
  works->ender = std::this_thread::get_id();
  while (works->count > 0) {
    PyThreadState* const state = PyEval_SaveThread();
    works->ended.wait_for(lock, kBetweenSignals);
    lock.unlock();
    PyEval_RestoreThread(state);
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    lock.lock();
  }
}

}  // namespace

Unlocked::Unlocked() : state_(PyEval_SaveThread()) {
  std::unique_lock lock(works->mutex);
  if (overtaken()) {
    lock.unlock();
    wait_for_the_end();
  }
  ++works->count;
}

bool Unlocked::will_return() {
  const std::lock_guard lock(works->mutex);
  if (!std::exchange(decided_, true)) returns_ = !overtaken();
  return returns_;
}

Unlocked::~Unlocked() {
  const bool returns = will_return();
  if (returns) PyEval_RestoreThread(state_);
  {
    const std::lock_guard lock(works->mutex);
    --works->count;
  }
  works->ended.notify_all();
  if (!returns) wait_for_the_end();
}

bool is_overtaken() {
  const std::lock_guard lock(works->mutex);
  return overtaken();
}

void bind_end(py::module_&) {
  py::module_::import("atexit").attr("register")(py::cpp_function(&end));
}

}  // namespace python

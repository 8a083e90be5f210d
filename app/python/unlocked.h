#pragma once

#include <pybind11/pybind11.h>

/// @file
/// Work without Python's lock (the GIL), also in threads that Python's end overtakes. Python before
/// 3.14 ends a daemon thread that takes the GIL after that by an exception through C++, which
/// aborts the process. Such a thread waits here for the process to end instead, and Python's end
/// waits for work in progress: a step, or a solution for a scene.

namespace python {

/// Releases the GIL while it lives.
class Unlocked {
 public:
  Unlocked();
  /// Takes the GIL again; in a thread that Python's end has overtaken it does not return.
  ~Unlocked();
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

  /// Decides whether the destructor will return. If it will not, locks that others need are to be
  /// given back before.
  bool will_return();

 private:
  PyThreadState* state_;
  bool decided_ = false;
  bool returns_ = true;
};

/// True in a thread that Python's end has overtaken. Long work then stops, as nobody waits for it.
bool is_overtaken();

/// Has Python's end wait for work without the GIL.
void bind_end(pybind11::module_& module);

}  // namespace python

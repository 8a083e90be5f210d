#include "engine/contacts/ode_handles.h"

#include <ode/ode.h>

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <utility>

namespace engine {
namespace {

static_assert(sizeof(dReal) == sizeof(double), "the double precision build of ODE is needed");

thread_local std::string last_warning;

std::string formatted(const char* format, va_list arguments) {
  std::array<char, 512> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  return text.data();
}

// Closing the library after a call that did not return would fail its assertions again.
std::atomic<bool> faulted = false;

[[noreturn]] void throw_fault(int /*number*/, const char* format, va_list arguments) {
  faulted = true;
  throw OdeFault("ODE: " + formatted(format, arguments));
}

void keep_warning(int /*number*/, const char* format, va_list arguments) {
  last_warning = formatted(format, arguments);
}

/// Opens the library, and closes it, once.
class LibrarySession {
 public:
  LibrarySession() {
    if (dInitODE2(0) == 0) throw OdeFault("ODE: the library could not be initialised");
    dSetErrorHandler(throw_fault);
    dSetDebugHandler(throw_fault);
    dSetMessageHandler(keep_warning);
  }
  ~LibrarySession() {
    if (!faulted) dCloseODE();
  }
  LibrarySession(const LibrarySession&) = delete;
  LibrarySession& operator=(const LibrarySession&) = delete;
};

}  // namespace

void open_ode() {
  static const LibrarySession session;
  // ODE keeps collision caches per thread.
  thread_local const bool ready = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  if (!ready) throw OdeFault("ODE: no memory for the calling thread");
}

std::string take_ode_warning() { return std::exchange(last_warning, {}); }

void OdeDeleter::operator()(dxWorld* world) const { dWorldDestroy(world); }
void OdeDeleter::operator()(dxSpace* space) const { dSpaceDestroy(space); }
void OdeDeleter::operator()(dxJointGroup* group) const { dJointGroupDestroy(group); }
void OdeDeleter::operator()(dxTriMeshData* data) const { dGeomTriMeshDataDestroy(data); }

std::array<double, 12> to_ode(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), 0, m(1, 0), m(1, 1), m(1, 2), 0, m(2, 0), m(2, 1), m(2, 2), 0};
}

std::array<double, 4> to_ode(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

Eigen::Vector3d vector_from_ode(const double* v) { return {v[0], v[1], v[2]}; }

Eigen::Quaterniond quaternion_from_ode(const double* q) { return {q[0], q[1], q[2], q[3]}; }

}  // namespace engine

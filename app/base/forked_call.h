#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

/// @file
/// Calls of code that may crash, hang or fill the memory, in a process of their own.
///
/// The child is a fork of this process without exec, which costs about a millisecond and needs no
/// program on disk, so that the module for Python can use it as well. It has only the thread that
/// called: the function must need no other thread and no lock that one of them may hold, as those
/// of a thread pool. The allocator of glibc is safe in this respect. The function's destructors of
/// static objects do not run and its buffered output is dropped.
///
/// The child sees no open file of this process, has /dev/null as its streams, can write no file,
/// and dies with the thread that called.

namespace app {

/// Limits of a call. All are greater than 0.
struct CallLimits {
  std::size_t memory = 0;   ///< Largest growth of the address space [bytes].
  int cpu_seconds = 0;      ///< Longest computation [s].
  double wall_seconds = 0;  ///< Longest wait for the end [s].
};

/// Receives the result of a call piece by piece.
using CallOutput = std::function<void(std::span<const char>)>;

/// The end of a call.
struct CallResult {
  enum class End {
    returned,  ///< The function has returned and `bytes` are complete.
    ended,     ///< A signal or an exit has ended the process.
    too_slow,  ///< The process took more time than it may.
    out_of_memory
  };
  End end = End::returned;
  std::string bytes;  ///< All that the function has written.
  std::string cause;  ///< Reason why the process ended: `segmentation fault`.
};

/// Runs a function in a process of its own and waits for its end.
/// @param work   Writes its result to the argument.
/// @throws std::runtime_error if no process can be started
CallResult forked_call(const std::function<void(const CallOutput&)>& work,
                       const CallLimits& limits);

}  // namespace app

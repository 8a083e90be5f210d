#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace app {

/// Runs tasks one at a time, in the order of `put`, on a separate thread, so that files are written
/// while the caller continues. One thread puts all tasks. A task owns its data, or uses data that
/// nothing else touches before `finish`.
///
/// No task runs after one that has thrown, as if the caller had run them all.
class Background {
 public:
  using Task = std::function<void()>;

  /// @param threads   Number of threads that the caller may use; with 1, `put` runs the task.
  /// @param most      Largest number of waiting tasks, at least 1; it bounds their memory.
  Background(int threads, std::size_t most);

  /// Runs the waiting tasks and drops their errors, which `finish` would report.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Queues a task; blocks while the queue is full.
  /// @throws the exception of a task; every later call throws it again
  void put(Task task);

  /// Waits until all tasks are done. More may be put after it.
  /// @throws the exception of a task; every later call throws it again
  void finish();

 private:
  void work();
  void wait_for_tasks(std::unique_lock<std::mutex>& lock);
  bool is_urgent() const;
  void rethrow() const;

  const std::size_t most_;
  std::mutex mutex_;  ///< Guards all members below except `thread_`.
  std::condition_variable more_;
  std::condition_variable fewer_;
  std::deque<Task> waiting_;
  bool busy_ = false;
  bool resting_ = false;
  bool finishing_ = false;
  bool ending_ = false;
  std::exception_ptr error_;
  std::thread thread_;
};

}  // namespace app

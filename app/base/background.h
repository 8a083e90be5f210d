#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace app {

/// Does tasks in the order in which they are put, one at a time, on a thread of its own: files are
/// written while the caller goes on. Tasks are put by one thread, and own what they work on or work
/// on what nobody else touches before `finish`.
///
/// After a task that throws no other is done, as if the caller had done them all itself.
class Background {
 public:
  using Task = std::function<void()>;

  /// @param threads   That the caller may use: with 1 there is no other, and `put` does the task.
  /// @param most      Tasks that may wait, at least 1: so much memory they take at most.
  Background(int threads, std::size_t most);

  /// Does what waits; call `finish` to learn whether it could be done.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Hands over a task; waits while too many wait.
  /// @throws what a task has thrown, from then on always
  void put(Task task);

  /// Waits until all tasks are done. More may be put after it.
  /// @throws what a task has thrown, from then on always
  void finish();

 private:
  void work();
  void wait_for_tasks(std::unique_lock<std::mutex>& lock);
  bool is_urgent() const;
  void rethrow() const;

  const std::size_t most_;
  std::mutex mutex_;  ///< Guards all below but the thread.
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

#include "app/base/background.h"

#include <cassert>
#include <chrono>
#include <utility>

namespace app {
namespace {

/// Time for which tasks collect before they wake the thread: waking it takes longer than writing a
/// row.
constexpr std::chrono::milliseconds kRest(2);

/// Runs and destroys the task. @return its exception; null if it threw none
std::exception_ptr error_of(Background::Task task) {
  try {
    task();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

Background::Background(int threads, std::size_t most) : most_(most) {
  assert(most > 0);
  if (threads > 1) thread_ = std::thread([this] { work(); });
}

Background::~Background() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    finishing_ = ending_ = true;
  }
  more_.notify_one();
  thread_.join();
}

void Background::rethrow() const {
  if (error_) std::rethrow_exception(error_);
}

void Background::put(Task task) {
  std::unique_lock lock(mutex_);
  fewer_.wait(lock, [this] { return waiting_.size() < most_; });
  rethrow();
  if (thread_.joinable()) {
    waiting_.push_back(std::move(task));
    if (!resting_ || is_urgent()) more_.notify_one();
  } else {
    error_ = error_of(std::move(task));
    rethrow();
  }
}

void Background::finish() {
  std::unique_lock lock(mutex_);
  finishing_ = true;
  more_.notify_one();
  fewer_.wait(lock, [this] { return waiting_.empty() && !busy_; });
  finishing_ = false;
  rethrow();
}

bool Background::is_urgent() const { return finishing_ || 2 * waiting_.size() >= most_; }

void Background::wait_for_tasks(std::unique_lock<std::mutex>& lock) {
  resting_ = true;
  more_.wait_for(lock, kRest, [this] { return is_urgent(); });
  resting_ = false;
  more_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
}

void Background::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (waiting_.empty()) wait_for_tasks(lock);
    if (waiting_.empty()) return;
    Task task = std::move(waiting_.front());
    waiting_.pop_front();
    busy_ = true;
    fewer_.notify_one();
    lock.unlock();
    std::exception_ptr error = error_of(std::move(task));
    lock.lock();
    busy_ = false;
    if (error) waiting_.clear();
    error_ = std::move(error);
    fewer_.notify_one();
  }
}

}  // namespace app

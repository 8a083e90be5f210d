#include "app/python/threads.h"

#include <map>
#include <mutex>

#include "app/base/thread_count.h"

namespace python {

tbb::task_arena& shared_threads(int threads) {
  static std::mutex one_at_a_time;
  static std::map<int, tbb::task_arena> arenas;
  const std::lock_guard lock(one_at_a_time);
  const int count = app::thread_count(threads);
  return arenas.try_emplace(count, count).first->second;
}

}  // namespace python

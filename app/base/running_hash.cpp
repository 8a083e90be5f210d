#include "app/base/running_hash.h"

#include <algorithm>
#include <cstring>

namespace app {

void RunningHash::add(std::span<const char> bytes) {
  while (!bytes.empty()) {
    const std::size_t filled = size_ % sizeof word_;
    const std::size_t taken = std::min(sizeof word_ - filled, bytes.size());
    std::memcpy(reinterpret_cast<char*>(&word_) + filled, bytes.data(), taken);
    size_ += taken;
    bytes = bytes.subspan(taken);
    if (filled + taken < sizeof word_) continue;
    hash_ = mixed(hash_, word_);
    word_ = 0;
  }
}

}  // namespace app

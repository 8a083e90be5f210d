#include "app/pages/thinning.h"

#include <algorithm>
#include <cassert>

namespace app {

Thinning::Thinning(std::size_t rows, std::size_t most) : rows_(rows) {
  assert(most >= 4);
  if (rows > most) buckets_ = (most - 2) / 2;
}

std::size_t Thinning::start(std::size_t bucket) const {
  return 1 + bucket * (rows_ - 2) / buckets_;
}

std::vector<double> Thinning::times(const std::vector<double>& all) const {
  if (!thins()) return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(rows_)};
  std::vector<double> kept = {all[0]};
  for (std::size_t i = 0; i < buckets_; ++i) {
    kept.push_back(all[start(i)]);
    kept.push_back(all[(start(i) + start(i + 1)) / 2]);
  }
  kept.push_back(all[rows_ - 1]);
  return kept;
}

std::vector<double> Thinning::values(const std::vector<double>& all) const {
  if (!thins()) return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(rows_)};
  std::vector<double> kept = {all[0]};
  for (std::size_t i = 0; i < buckets_; ++i) {
    const auto [least, largest] =
        std::minmax_element(all.begin() + static_cast<std::ptrdiff_t>(start(i)),
                            all.begin() + static_cast<std::ptrdiff_t>(start(i + 1)));
    kept.push_back(*std::min(least, largest));
    kept.push_back(*std::max(least, largest));
  }
  kept.push_back(all[rows_ - 1]);
  return kept;
}

std::vector<std::size_t> spread_rows(std::size_t rows, std::size_t most) {
  const std::size_t count = std::min(rows, most);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < count; ++i)
    kept.push_back(count == 1 ? 0 : i * (rows - 1) / (count - 1));
  return kept;
}

}  // namespace app

#include "app/databases/bad_ends.h"

#include <algorithm>
#include <utility>

namespace databases {
namespace {

/// Number of entries of the bad end that begins with the first entry; `at` gives the order.
template <class At>
std::size_t length_of_end(std::size_t count, const At& at) {
  std::size_t length = 0, found = 0;
  for (std::size_t i = 0; 3 * (i + 1) <= count; ++i) {
    if (!at(i)) continue;
    ++found;
    if (2 * found >= i + 1) length = i + 1;
  }
  return length;
}

}  // namespace

std::vector<bool> bad_ends(const std::vector<bool>& bad) {
  const std::size_t count = bad.size();
  const std::size_t low = length_of_end(count, [&](std::size_t i) { return bad[i]; });
  const std::size_t high = length_of_end(count, [&](std::size_t i) { return bad[count - 1 - i]; });
  std::vector<bool> ends(count, false);
  for (std::size_t i = 0; i < low; ++i) ends[i] = true;
  for (std::size_t i = 0; i < high; ++i) ends[count - 1 - i] = true;
  return ends;
}

KeptEntries without_bad(const std::vector<bool>& bad) {
  std::vector<bool> kept = bad_ends(bad);
  const bool at_ends =
      std::ranges::equal(bad, kept, [](bool is_bad, bool in_end) { return !is_bad || in_end; });
  if (!at_ends) kept = bad;
  kept.flip();
  const auto dropped = static_cast<std::size_t>(std::ranges::count(kept, false));
  return {.kept = std::move(kept), .dropped = dropped, .at_ends = at_ends};
}

}  // namespace databases

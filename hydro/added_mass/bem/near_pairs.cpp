#include "hydro/added_mass/bem/near_pairs.h"

#include <algorithm>
#include <cassert>

#include "hydro/parallel.h"

namespace hydro::bem {

namespace {

/// Corners that two faces have in common, in the form that pair_integrals takes.
std::array<int, 3> shared_corners(const Surface& surface, std::size_t a, std::size_t b) {
  std::array<int, 3> shared = {-1, -1, -1};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      if (surface.vertex(a, i) == surface.vertex(b, j)) shared[i] = static_cast<int>(j);
  }
  return shared;
}

}  // namespace

PairIntegrals near_integrals(const Surface& surface, std::size_t a, std::size_t b) {
  const std::size_t low = std::min(a, b), high = std::max(a, b);
  const PairIntegrals pair = pair_integrals(surface.elements[low], surface.elements[high],
                                            shared_corners(surface, low, high));
  return a <= b ? pair : turned(pair);
}

NearPairs::NearPairs(const Surface& surface) {
  const std::vector<Element>& elements = surface.elements;
  std::vector<std::vector<std::size_t>> near(elements.size());
  parallel_for(elements.size(), [&](std::size_t a) {
    for (std::size_t b = 0; b < elements.size(); ++b)
      if (!is_beyond(kNear, elements[a], elements[b])) near[a].push_back(b);
  });
  starts_.push_back(0);
  for (const auto& row : near) starts_.push_back(starts_.back() + row.size());
  near_.resize(starts_.back());
  // Each pair is integrated once. `mirror` holds its place in the later element's row; rows are
  // visited in order, so the earlier elements are in order there, too.
  std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
  std::vector<std::size_t> mirror(starts_.back());
  for (std::size_t a = 0; a < near.size(); ++a)
    for (std::size_t k = 0; k < near[a].size(); ++k)
      if (near[a][k] >= a) mirror[starts_[a] + k] = next[near[a][k]]++;
  parallel_for(elements.size(), [&](std::size_t a) {
    for (std::size_t k = 0; k < near[a].size(); ++k) {
      const std::size_t b = near[a][k], here = starts_[a] + k;
      if (b < a) continue;
      near_[here] = {b, near_integrals(surface, a, b)};
      if (b > a) near_[mirror[here]] = {a, turned(near_[here].integrals)};
    }
  });
  assert(all_sorted());
}

bool NearPairs::all_sorted() const {
  for (std::size_t a = 0; a + 1 < starts_.size(); ++a) {
    const auto row = of(a);
    if (!std::is_sorted(row.begin(), row.end(), [](const auto& one, const auto& other) {
          return one.element < other.element;
        }))
      return false;
  }
  return true;
}

}  // namespace hydro::bem

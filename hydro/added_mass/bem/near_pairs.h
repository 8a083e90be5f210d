#pragma once

#include <span>
#include <vector>

#include "hydro/added_mass/bem/pair.h"
#include "hydro/added_mass/bem/surface.h"

/// @file
/// The pairs of elements that are too near for quadrature points on both.

namespace hydro::bem {

/// An element near another one, with the integrals over the pair; x is on the other one.
struct NearElement {
  std::size_t element;
  PairIntegrals integrals;
};

class NearPairs {
 public:
  explicit NearPairs(const Surface& surface);

  /// Elements near element a, itself included, in ascending order.
  std::span<const NearElement> of(std::size_t a) const {
    return std::span(near_).subspan(starts_[a], starts_[a + 1] - starts_[a]);
  }

 private:
  bool all_sorted() const;

  std::vector<std::size_t> starts_;
  std::vector<NearElement> near_;
};

/// Returns the integrals over a near pair; (a, b) and (b, a) agree to the last digit.
PairIntegrals near_integrals(const Surface& surface, std::size_t a, std::size_t b);

}  // namespace hydro::bem

#include "hydro/added_mass/bem/column_sums.h"

#include <algorithm>

#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/added_mass/bem/column_sums.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "hydro/added_mass/bem/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hydro::bem::HWY_NAMESPACE {

/// Columns whose sums the registers hold beside what they are added from.
constexpr Index kAtOnce = kWide;

/// Rows that stay in a processor's nearest memory while all columns are taken.
constexpr Index kStrip = 128;

/// Calls f(first row, end, first column) for strips of rows and for as many columns as fit.
template <class Function>
HWY_INLINE void by_strips(Index rows, Function f) {
  for (Index first = 0; first < rows; first += kStrip)
    for (Index c = 0; c < kColumns; c += kAtOnce) f(first, std::min(first + kStrip, rows), c);
}

/// Adds to `sums` the products of some columns of a strip with x, and to y the columns times
/// `factors`.
template <bool kDots, bool kAdds>
HWY_INLINE void take(const EightColumns& columns, Index first, Index end, Index c, const Row* x,
                     Row* y, const Row* factors, Row* sums) {
  const double* entry[kAtOnce];
  V sum[kAtOnce][kParts], factor[kAtOnce][kParts];
  for (Index j = 0; j < kAtOnce; ++j) {
    entry[j] = columns.first + (c + j) * columns.stride;
    for (Index k = 0; k < kParts; ++k) {
      if constexpr (kDots) sum[j][k] = load(sums[c + j].lanes, k);
      if constexpr (kAdds) factor[j][k] = load(factors[c + j].lanes, k);
    }
  }
  for (Index i = first; i < end; ++i) {
    V here[kParts], other[kParts];
    for (Index k = 0; k < kParts; ++k) {
      if constexpr (kDots) here[k] = load(x[i].lanes, k);
      if constexpr (kAdds) other[k] = load(y[i].lanes, k);
    }
    for (Index j = 0; j < kAtOnce; ++j) {
      const V number = all(entry[j][i]);
      for (Index k = 0; k < kParts; ++k) {
        if constexpr (kDots) sum[j][k] = sum[j][k] + number * here[k];
        if constexpr (kAdds) other[k] = other[k] + number * factor[j][k];
      }
    }
    if constexpr (kAdds)
      for (Index k = 0; k < kParts; ++k) store(other[k], y[i].lanes, k);
  }
  if constexpr (kDots)
    for (Index j = 0; j < kAtOnce; ++j)
      for (Index k = 0; k < kParts; ++k) store(sum[j][k], sums[c + j].lanes, k);
}

void dot_here(const EightColumns& columns, const Row* x, Row* sums) {
  by_strips(columns.rows, [&](Index first, Index end, Index c) HWY_ATTR {
    take<true, false>(columns, first, end, c, x, nullptr, nullptr, sums);
  });
}

void add_here(const EightColumns& columns, const Row* factors, Row* y) {
  by_strips(columns.rows, [&](Index first, Index end, Index c) HWY_ATTR {
    take<false, true>(columns, first, end, c, nullptr, y, factors, nullptr);
  });
}

void dot_and_add_here(const EightColumns& columns, const Row* x, Row* y, const Row* factors,
                      Row* sums) {
  by_strips(columns.rows, [&](Index first, Index end, Index c) HWY_ATTR {
    take<true, true>(columns, first, end, c, x, y, factors, sums);
  });
}

}  // namespace hydro::bem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro::bem {

HWY_EXPORT(dot_here);
HWY_EXPORT(add_here);
HWY_EXPORT(dot_and_add_here);

void dot_columns(const EightColumns& columns, const Row* x, Row* sums) {
  std::fill_n(sums, kColumns, Row());
  HWY_DYNAMIC_DISPATCH(dot_here)(columns, x, sums);
}

void add_columns(const EightColumns& columns, const Row* factors, Row* y) {
  HWY_DYNAMIC_DISPATCH(add_here)(columns, factors, y);
}

void dot_and_add_columns(const EightColumns& columns, const Row* x, Row* y, const Row* factors,
                         Row* sums) {
  std::fill_n(sums, kColumns, Row());
  HWY_DYNAMIC_DISPATCH(dot_and_add_here)(columns, x, y, factors, sums);
}

}  // namespace hydro::bem
#endif

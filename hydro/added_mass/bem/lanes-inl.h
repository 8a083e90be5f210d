// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_BEM_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_BEM_LANES
#undef PLIMSOLL_BEM_LANES
#else
#define PLIMSOLL_BEM_LANES
#endif

#include <hwy/highway.h>

#include "hydro/added_mass/bem/lanes.h"

/// @file
/// Eight lanes in the registers of a processor: in one, or in parts.

HWY_BEFORE_NAMESPACE();
namespace hydro::bem::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, kLanes>;
using V = hn::Vec<D>;
using Eigen::Index;

/// Numbers in a register, and registers that eight lanes take.
constexpr Index kWide = hn::MaxLanes(D());
constexpr Index kParts = static_cast<Index>(kLanes) / kWide;

HWY_INLINE V all(double value) { return hn::Set(D(), value); }
HWY_INLINE V zero() { return hn::Zero(D()); }

HWY_INLINE V load(const Lanes& lanes, Index part) {
  return hn::Load(D(), reinterpret_cast<const double*>(&lanes) + part * kWide);
}
HWY_INLINE void store(V value, Lanes& lanes, Index part) {
  hn::Store(value, D(), reinterpret_cast<double*>(&lanes) + part * kWide);
}

}  // namespace hydro::bem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

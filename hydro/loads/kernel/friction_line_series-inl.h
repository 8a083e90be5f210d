// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_LINE_ABOUT_POLE) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_LINE_ABOUT_POLE
#undef PLIMSOLL_KERNEL_LINE_ABOUT_POLE
#else
#define PLIMSOLL_KERNEL_LINE_ABOUT_POLE
#endif

#include <hwy/contrib/math/math-inl.h>

#include "hydro/loads/kernel/friction_means.h"
#include "hydro/loads/kernel/lanes-inl.h"

/// @file
/// The ITTC line over triangles on which the velocity changes much: on or beside the pole where it
/// vanishes (rotary_drag.h). With s and d = |s| from the pole, the speed |ω| d and the means (1) of
/// friction_means.h,
///
///     C_v d s = ∇(⅓ d³ C_3),      C_v d³ = ∇·(⅕ d³ C_5 s),
///
/// so that both integrals over a triangle are sums over its edges. At the distance h from the pole,
/// with t along the edge and d² = h² + t²,
///
///     ∫ C_v d s dA = Σ out ∫ ⅓ d³ C_3 dt,      ∫ C_v d³ dA = Σ h ∫ ⅕ d³ C_5 dt.             (1)
///
/// Gauss' rule of five points takes each edge in up to four parts: from the point nearest to the
/// pole and from where the line is no longer held, its integrands are smooth. The error is below
/// 1e-6 of the triangle's largest load.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// ∫ C_v d s dA and ∫ C_v d³ dA.
struct PoleMoments {
  V2 first;
  V third;
};

HWY_INLINE PoleMoments operator+(const PoleMoments& a, const PoleMoments& b) {
  return {{a.first.x + b.first.x, a.first.y + b.first.y}, a.third + b.third};
}

/// ∫ d³ C_3 dt and ∫ d³ C_5 dt.
struct PartMoments {
  V third, fifth;
};

/// The means (2) of friction_means.h at a distance from the pole, without K.
/// @param reynolds   Re/100 per distance [1/m].
HWY_INLINE PartMoments means_at(const FrictionMeans& means, V reynolds, V distance) {
  const V re =
      hn::Min(hn::Max(reynolds * distance, all(kLeastReynolds / 100)), all(kMostReynolds / 100));
  const V z = all(1) / hn::Log(D(), re);
  const V s = (z - all(means.middle)) * all(1 / means.half);
  V third = all(means.third[kMeanTerms - 1]), fifth = all(means.fifth[kMeanTerms - 1]);
  for (int i = kMeanTerms - 2; i >= 0; --i) {
    third = hn::MulAdd(third, s, all(means.third[i]));
    fifth = hn::MulAdd(fifth, s, all(means.fifth[i]));
  }
  const V zz = z * z;
  return {zz * third, zz * fifth};
}

/// Adds a part of an edge, from t0 to t1.
inline HWY_NOINLINE void add_part(const FrictionMeans& means, V reynolds, V hh, V t0, V t1,
                                  PartMoments& sum) {
  const V half = all(0.5) * (t1 - t0), middle = all(0.5) * (t1 + t0);
  for (int i = -2; i <= 2; ++i) {
    const int k = i < 0 ? -i : i;
    const V t = hn::MulAdd(half, all(i < 0 ? -kGaussAt[k] : kGaussAt[k]), middle);
    const V dd = hn::MulAdd(t, t, hh), d = hn::Sqrt(dd);
    const V cube = half * all(kGaussWeight[k]) * dd * d;
    const PartMoments at = means_at(means, reynolds, d);
    sum.third = hn::MulAdd(cube, at.third, sum.third);
    sum.fifth = hn::MulAdd(cube, at.fifth, sum.fifth);
  }
}

/// The terms of (1) of an edge.
/// @param reynolds   Re/100 per distance from the pole [1/m].
/// @param s0         One end, from the pole.
inline HWY_NOINLINE PoleMoments line_moments(const FrictionMeans& means, V reynolds, const V2& s0,
                                             const V2& s1) {
  const D d;
  const V2 edge = {s1.x - s0.x, s1.y - s0.y};
  const V size = hn::Sqrt(hn::MulAdd(edge.x, edge.x, edge.y * edge.y));
  const V inverse = hn::IfThenElseZero(size > zero(), all(1) / size);
  const V2 along = {edge.x * inverse, edge.y * inverse};
  const V2 out = {along.y, zero() - along.x};
  const V h = hn::MulAdd(out.x, s0.x, out.y * s0.y), hh = h * h;
  const V t0 = hn::MulAdd(along.x, s0.x, along.y * s0.y), t1 = t0 + size;
  const V held = all(kLeastReynolds / 100) / reynolds;
  const V half_chord = hn::Sqrt(hn::Max(zero(), hn::NegMulAdd(h, h, held * held)));
  const V foot = hn::Min(hn::Max(zero(), t0), t1);
  const V ends[] = {t0, hn::Min(hn::Max(zero() - half_chord, t0), foot), foot,
                    hn::Max(hn::Min(half_chord, t1), foot), t1};
  PartMoments sum = {zero(), zero()};
  for (int i = 0; i < 4; ++i)
    if (!hn::AllTrue(d, ends[i + 1] <= ends[i]))
      add_part(means, reynolds, hh, ends[i], ends[i + 1], sum);
  const V first = all(means.K / 3) * sum.third;
  return {{first * out.x, first * out.y}, all(means.K / 5) * h * sum.fifth};
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

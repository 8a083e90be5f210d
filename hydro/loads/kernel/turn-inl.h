// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_TURN) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_TURN
#undef PLIMSOLL_KERNEL_TURN
#else
#define PLIMSOLL_KERNEL_TURN
#endif

#include "hydro/loads/kernel/lanes-inl.h"

/// @file
/// Cosine and sine of one angle in lanes. They share the reduction to a quadrant, and together take
/// 0.4 of the time of Highway's two functions.
///
/// With n the nearest integer to 2x/π, x − n π/2 is taken with π/2 in three parts, of which the
/// first two have 33 bits: the products are exact for |n| < 2^20 (Cody and Waite, Software Manual
/// for the Elementary Functions, 1980). On |x| ≤ π/4 sine and cosine are their Taylor series to
/// x^17 and x^18: the first terms left out are below 1e-17 and 1e-18.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

struct Turn {
  V cosine, sine;
};

/// Σ c_i z^i with the coefficients in falling order.
template <int kTerms>
HWY_INLINE V power_series(V z, const double (&c)[kTerms]) {
  V sum = all(c[0]);
  for (int i = 1; i < kTerms; ++i) sum = hn::MulAdd(sum, z, all(c[i]));
  return sum;
}

/// Cosine and sine of x [rad]. Their error is below 2e-16 for |x| < 1e6.
HWY_INLINE Turn turn_of(V x) {
  constexpr double kToInteger = 6755399441055744.0;  // 1.5 · 2^52: its last bits are an integer's.
  const V shifted = hn::MulAdd(x, all(2 / M_PI), all(kToInteger));
  const V n = shifted - all(kToInteger);
  V r = hn::NegMulAdd(n, all(1.57079632673412561417), x);
  r = hn::NegMulAdd(n, all(6.07710050630396597660e-11), r);
  r = hn::NegMulAdd(n, all(2.02226624879595063154e-21), r);
  const V z = r * r;
  constexpr double kSine[] = {
      1.0 / 355687428096000, -1.0 / 1307674368000, 1.0 / 6227020800, -1.0 / 39916800,
      1.0 / 362880,          -1.0 / 5040,          1.0 / 120,        -1.0 / 6};
  constexpr double kCosine[] = {
      -1.0 / 6402373705728000, 1.0 / 20922789888000, -1.0 / 87178291200, 1.0 / 479001600,
      -1.0 / 3628800,          1.0 / 40320,          -1.0 / 720,         1.0 / 24};
  const V sine = hn::MulAdd(r * z, power_series(z, kSine), r);
  const V cosine = hn::MulAdd(z * z, power_series(z, kCosine), hn::NegMulAdd(all(0.5), z, all(1)));
  // cos(r + nπ/2) is cos r, −sin r, −cos r, sin r for n = 0, 1, 2, 3, and so on.
  const VI quadrant = hn::BitCast(DI(), shifted);
  const VI one = hn::Set(DI(), 1);
  const M odd = hn::RebindMask(D(), hn::And(quadrant, one) == one);
  const V sine_sign = hn::BitCast(D(), hn::ShiftLeft<62>(hn::And(quadrant, hn::Set(DI(), 2))));
  const V cosine_sign =
      hn::BitCast(D(), hn::ShiftLeft<62>(hn::And(quadrant + one, hn::Set(DI(), 2))));
  return {hn::Xor(hn::IfThenElse(odd, sine, cosine), cosine_sign),
          hn::Xor(hn::IfThenElse(odd, cosine, sine), sine_sign)};
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

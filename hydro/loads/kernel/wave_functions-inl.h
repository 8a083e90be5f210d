// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_WAVE_FUNCTIONS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_WAVE_FUNCTIONS
#undef PLIMSOLL_KERNEL_WAVE_FUNCTIONS
#else
#define PLIMSOLL_KERNEL_WAVE_FUNCTIONS
#endif

#include "hydro/loads/kernel/lanes-inl.h"

/// @file
/// Cosine, sine and exponential in lanes, as sums of waves need them. Cosine and sine of one angle
/// share the reduction to a quadrant. Highway's functions hold for all numbers and take longer: the
/// loads under 64 waves take 1.3 times as long with them.
///
/// A constant c is taken off n times in parts, of which the first have so few bits that their
/// products with n are exact (Cody and Waite, Software Manual for the Elementary Functions, 1980).

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

/// A number and the nearest integer n, which the last bits of `shifted` hold.
struct Rounded {
  V n, shifted;
};

HWY_INLINE Rounded nearest(V x) {
  constexpr double kToInteger = 6755399441055744.0;  // 1.5 · 2^52
  const V shifted = x + all(kToInteger);
  return {shifted - all(kToInteger), shifted};
}

/// Cosine and sine of x [rad]: their errors are below 3e-16 for |x| < 1e6. On |x| ≤ π/4 they are
/// the Taylor series to x^15 and x^16, whose first terms left out are below 5e-17 and 3e-18.
HWY_INLINE Turn turn_of(V x) {
  const auto [n, shifted] = nearest(x * all(2 / M_PI));
  V r = hn::NegMulAdd(n, all(1.57079632673412561417), x);
  r = hn::NegMulAdd(n, all(6.07710050630396597660e-11), r);
  r = hn::NegMulAdd(n, all(2.02226624879595063154e-21), r);
  const V z = r * r;
  constexpr double kSine[] = {-1.0 / 1307674368000, 1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880,
                              -1.0 / 5040,          1.0 / 120,        -1.0 / 6};
  constexpr double kCosine[] = {
      1.0 / 20922789888000, -1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800,
      1.0 / 40320,          -1.0 / 720,         1.0 / 24};
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

/// e^x for x < 700, below −700 e^−700. On |x| ≤ ½ ln 2 it is the Taylor series to x^12, whose first
/// term left out is below 2e-16.
HWY_INLINE V exponential(V x) {
  x = hn::Max(x, all(-700));
  const auto [n, shifted] = nearest(x * all(M_LOG2E));
  V r = hn::NegMulAdd(n, all(6.93147180369123816490e-01), x);
  r = hn::NegMulAdd(n, all(1.90821492927058770002e-10), r);
  constexpr double kTerms[] = {1.0 / 479001600,
                               1.0 / 39916800,
                               1.0 / 3628800,
                               1.0 / 362880,
                               1.0 / 40320,
                               1.0 / 5040,
                               1.0 / 720,
                               1.0 / 120,
                               1.0 / 24,
                               1.0 / 6,
                               0.5,
                               1.0,
                               1.0};
  const VI power = hn::ShiftLeft<52>(hn::BitCast(DI(), shifted));
  return hn::BitCast(D(), hn::BitCast(DI(), power_series(r, kTerms)) + power);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

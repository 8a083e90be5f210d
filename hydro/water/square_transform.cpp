#include "hydro/water/square_transform.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/water/square_transform.cpp"
#include <hwy/aligned_allocator.h>
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hydro::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Rows that are transformed at a time.
constexpr std::size_t kRows = 16;
using D = hn::CappedTag<float, kRows>;
using V = hn::Vec<D>;

/// A complex number in each lane.
struct Complex {
  V re, im;
};

HWY_INLINE Complex operator+(const Complex& a, const Complex& b) {
  return {a.re + b.re, a.im + b.im};
}
HWY_INLINE Complex operator-(const Complex& a, const Complex& b) {
  return {a.re - b.re, a.im - b.im};
}
HWY_INLINE Complex times(const Complex& a, V cosine, V sine) {
  return {a.re * cosine - a.im * sine, a.re * sine + a.im * cosine};
}
/// −i a
HWY_INLINE Complex turned(const Complex& a) { return {a.im, hn::Neg(a.re)}; }

/// Real and imaginary parts of sixteen rows, column by column.
struct Lines {
  float* re;
  float* im;

  HWY_INLINE Complex load(std::size_t at) const {
    return {hn::Load(D(), re + at), hn::Load(D(), im + at)};
  }
  HWY_INLINE void store(std::size_t at, const Complex& value) const {
    hn::Store(value.re, D(), re + at);
    hn::Store(value.im, D(), im + at);
  }
};

/// One pass of Stockham's algorithm: `length` numbers stand `stride` apart.
HWY_INLINE void quarter(const Lines& from, const Lines& to, std::size_t length, std::size_t stride,
                        std::size_t side, const float* cosines, const float* sines) {
  const D d;
  const std::size_t quarter = length / 4, step = side / length;
  for (std::size_t p = 0; p < quarter; ++p) {
    const V c1 = hn::Set(d, cosines[p * step]), s1 = hn::Set(d, sines[p * step]);
    const V c2 = hn::Set(d, cosines[2 * p * step]), s2 = hn::Set(d, sines[2 * p * step]);
    const V c3 = hn::Set(d, cosines[3 * p * step]), s3 = hn::Set(d, sines[3 * p * step]);
    for (std::size_t q = 0; q < stride; ++q)
      for (std::size_t lane = 0; lane < kRows; lane += hn::Lanes(d)) {
        const auto at = [&](std::size_t k) {
          return kRows * (q + stride * (p + k * quarter)) + lane;
        };
        const Complex a = from.load(at(0)), b = from.load(at(1)), c = from.load(at(2)),
                      e = from.load(at(3));
        const Complex even = a + c, odd = b + e, other = a - c, side_on = turned(b - e);
        const auto out = [&](std::size_t k) { return kRows * (q + stride * (4 * p + k)) + lane; };
        to.store(out(0), even + odd);
        to.store(out(1), times(other + side_on, c1, s1));
        to.store(out(2), times(even - odd, c2, s2));
        to.store(out(3), times(other - side_on, c3, s3));
      }
  }
}

HWY_INLINE void half(const Lines& from, const Lines& to, std::size_t stride) {
  for (std::size_t q = 0; q < kRows * stride; q += hn::Lanes(D())) {
    const Complex a = from.load(q), b = from.load(q + kRows * stride);
    to.store(q, a + b);
    to.store(q + kRows * stride, a - b);
  }
}

/// Transforms the lines, forwards. @return where the result is: `first` or `second`
HWY_INLINE Lines transform_lines(Lines first, Lines second, std::size_t side, const float* cosines,
                                 const float* sines) {
  std::size_t length = side, stride = 1;
  for (; length >= 4; length /= 4, stride *= 4) {
    quarter(first, second, length, stride, side, cosines, sines);
    std::swap(first, second);
  }
  if (length == 2) {
    half(first, second, stride);
    std::swap(first, second);
  }
  return first;
}

/// Transforms all rows and writes them as columns, times a factor.
/// @param backward   Real and imaginary parts change places before and after: the inverse.
void pass(const std::complex<float>* from, std::complex<float>* to, std::size_t side,
          const float* cosines, const float* sines, bool backward, float factor) {
  const D d;
  const auto buffer = hwy::AllocateAligned<float>(4 * kRows * side);
  const Lines first{buffer.get(), buffer.get() + kRows * side};
  const Lines second{first.im + kRows * side, first.im + 2 * kRows * side};
  const Lines in = backward ? Lines{first.im, first.re} : first;
  for (std::size_t row = 0; row < side; row += kRows) {
    V any = hn::Zero(d);
    for (std::size_t column = 0; column < side; ++column)
      for (std::size_t lane = 0; lane < kRows; lane += hn::Lanes(d)) {
        V re, im;
        hn::LoadInterleaved2(d, reinterpret_cast<const float*>(from + column * side + row + lane),
                             re, im);
        in.store(kRows * column + lane, {re, im});
        any = hn::Or(any, hn::Or(re, im));
      }
    if (hn::AllTrue(d, any == hn::Zero(d))) {  // As most rows of sources are.
      std::fill_n(to + row * side, kRows * side, std::complex<float>(0));
      continue;
    }
    const Lines done = transform_lines(first, second, side, cosines, sines);
    const Lines out = backward ? Lines{done.im, done.re} : done;
    for (std::size_t line = 0; line < kRows; ++line) {
      std::complex<float>* column = to + (row + line) * side;
      for (std::size_t k = 0; k < side; ++k)
        column[k] = {factor * out.re[kRows * k + line], factor * out.im[kRows * k + line]};
    }
  }
}

}  // namespace hydro::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro {

HWY_EXPORT(pass);

SquareTransform::SquareTransform(Eigen::Index side) : side_(side) {
  for (Eigen::Index j = 0; j < side; ++j) {
    const double angle = -2 * M_PI * static_cast<double>(j) / static_cast<double>(side);
    cosines_.push_back(static_cast<float>(std::cos(angle)));
    sines_.push_back(static_cast<float>(std::sin(angle)));
  }
}

void SquareTransform::forward(Eigen::MatrixXcf& field, Eigen::MatrixXcf& other) const {
  other.resize(side_, side_);
  const auto pass = HWY_DYNAMIC_DISPATCH(pass);
  const auto side = static_cast<std::size_t>(side_);
  pass(field.data(), other.data(), side, cosines_.data(), sines_.data(), false, 1);
  pass(other.data(), field.data(), side, cosines_.data(), sines_.data(), false, 1);
}

void SquareTransform::inverse(Eigen::MatrixXcf& field, Eigen::MatrixXcf& other) const {
  other.resize(side_, side_);
  const auto pass = HWY_DYNAMIC_DISPATCH(pass);
  const auto side = static_cast<std::size_t>(side_);
  const float part = 1 / static_cast<float>(side_);
  pass(field.data(), other.data(), side, cosines_.data(), sines_.data(), true, part);
  pass(other.data(), field.data(), side, cosines_.data(), sines_.data(), true, part);
}

}  // namespace hydro
#endif

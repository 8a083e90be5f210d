#include "hydro/lines/catenary.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "hydro/lines/catenary_span.h"
#include "hydro/require.h"

namespace hydro {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Form = CatenarySolution::Form;

/// Below this wL/EA a line is a spring without weight: its sag is beyond double precision.
constexpr double kWeightless = 1e-25;

/// Spans that are smaller in units of L are as good as zero.
constexpr double kVertical = 1e-15;

/// No h is sought below: it would change x by less than its last digit.
constexpr double kLeastLogH = -92;

/// Newton's error falls with the square of the step, so after one this small it is round-off.
constexpr double kLastStep = 1e-8;

/// Residuals that are smaller, in units of the lengths, are round-off if they fall no further.
constexpr double kLengthRoundOff = 1e-13;

constexpr int kMostCatenarySteps = 60;
constexpr int kMostStepHalvings = 10;

/// The inverse of the derivatives, made symmetric and kept positive semi-definite.
Matrix2d stiffness_of(const CatenarySpan& span) {
  const double most = std::sqrt(span.x_h) * std::sqrt(span.z_v);
  const double coupling = std::clamp(-0.5 * (span.x_v + span.z_h), -most, most);
  Matrix2d k;
  k << span.z_v, coupling, coupling, span.x_h;
  return k / span.determinant;
}

/// (h, v) of a line that touches nothing: a parabola, or its chord's stretch.
Vector2d suspended_start(const ScaledLine& line, const Vector2d& wanted) {
  const double x = wanted[0], z = wanted[1];
  const double chord = std::hypot(x, z);
  const double sagging = std::cbrt(1 / (24 * line.e));
  if (chord >= 1) {
    const double tension = (chord - 1) / line.e + sagging;
    return {tension * x / chord, 0.5 + tension * z / chord};
  }
  const double lambda = std::sqrt(3 * (1 - chord) * (1 + chord)) / x;
  const double h = std::min(0.5 / std::max(lambda / x, 1e-30), sagging * x / chord);
  const double slope = z / std::tanh(std::max(lambda, 0.2));
  return {h, 0.5 * (1 + slope)};
}

/// (h, v) of a line that does not stretch, or of one that lies on the bottom.
Vector2d resting_start(const ScaledLine& line, const Vector2d& wanted) {
  const double x = wanted[0], z = wanted[1];
  const double spare = 1 - x;
  double h = 0, v = 0;
  if (spare > 0) {
    h = 2.0 / 9 * std::max(z - spare, 1e-3 * z) * (z / spare) * (z / spare);
    v = std::sqrt(z * (z + 2 * h));
  } else {
    h = -spare / line.e + std::cbrt(z / line.e);
    v = std::sqrt(2 * z / (1 / h + line.e));
  }
  if (v < 1) return {h, v};
  Vector2d start = suspended_start(line, wanted);
  start[1] = std::max(start[1], 0.5);
  return start;
}

bool is_usable(const ScaledLine& line, const Vector2d& hv) {
  return std::isfinite(hv[0]) && std::isfinite(hv[1]) && hv[0] > std::exp(kLeastLogH) &&
         (!line.bottom || hv[1] > 0);
}

/// An estimate of (log h, v) and its span.
struct Estimate {
  double log_h = 0, v = 0;
  CatenarySpan span;
  double error = 0;

  double h() const { return std::exp(log_h); }
};

Estimate estimate_at(const ScaledLine& line, const Vector2d& wanted, double log_h, double v) {
  Estimate out{std::max(log_h, kLeastLogH), v, {}, 0};
  out.span = catenary_span(line, out.h(), v);
  out.error = out.span.error(wanted);
  return out;
}

/// Newton's step in (log h, v), not above a factor e² in h, nor to a v without sense.
Vector2d newton_step(const ScaledLine& line, const Vector2d& wanted, const Estimate& at) {
  const CatenarySpan& s = at.span;
  const double dx = wanted[0] - s.x;
  const double dz = wanted[1] - s.z;
  Vector2d step = Vector2d(s.z_v * dx - s.x_v * dz, s.x_h * dz - s.z_h * dx) / s.determinant;
  step[0] /= at.h();
  double share = std::min(1.0, 2 / std::abs(step[0]));
  if (line.bottom && step[1] < 0) share = std::min(share, -0.8 * at.v / step[1]);
  return share * step;
}

/// Newton's method with shorter steps where the error would grow.
///
/// @return  Whether it converged; `at` is the best estimate.
bool newton(const ScaledLine& line, const Vector2d& wanted, Estimate& at) {
  const double round_off = kLengthRoundOff * (1 + wanted.cwiseAbs().sum());
  for (int i = 0; i < kMostCatenarySteps; ++i) {
    Vector2d step = newton_step(line, wanted, at);
    if (!step.allFinite()) return false;
    const bool last = std::abs(step[0]) < kLastStep && std::abs(step[1]) < kLastStep * at.v;
    Estimate next = estimate_at(line, wanted, at.log_h + step[0], at.v + step[1]);
    if (at.error < round_off) {
      if (!(next.error < at.error)) return true;
    } else {
      for (int j = 0; !(next.error < at.error); ++j) {
        if (j == kMostStepHalvings) return false;
        step *= 0.5;
        next = estimate_at(line, wanted, at.log_h + step[0], at.v + step[1]);
      }
    }
    at = next;
    if (last) return true;
  }
  return at.error < round_off;
}

/// Where an increasing function is zero between two arguments, to the last digit.
template <class Function>
double bisect(double low, double high, Function&& function) {
  for (int i = 0; i < 2000; ++i) {
    const double middle = std::midpoint(low, high);
    if (!(middle > low && middle < high)) break;
    (function(middle) < 0 ? low : high) = middle;
  }
  return high;
}

/// v that belongs to h and z.
double vertical_at(const ScaledLine& line, double h, double z) {
  const auto miss = [&](double v) { return catenary_span(line, h, v).z - z; };
  double high = 1, low = line.bottom ? 0 : -1;
  while (miss(high) < 0 && high < 1e200) high *= 4;
  while (!line.bottom && miss(low) > 0 && low > -1e200) low *= 4;
  return bisect(low, high, miss);
}

/// One bisection within another; slow, and sure.
Estimate bisected(const ScaledLine& line, const Vector2d& wanted) {
  const auto miss = [&](double log_h) {
    const double h = std::exp(log_h);
    return catenary_span(line, h, vertical_at(line, h, wanted[1])).x - wanted[0];
  };
  double high = 1;
  while (miss(high) < 0 && high < 400) high += 4;
  const double log_h = bisect(kLeastLogH, high, miss);
  return estimate_at(line, wanted, log_h, vertical_at(line, std::exp(log_h), wanted[1]));
}

/// The solution in units of the line.
CatenarySolution solved(const ScaledLine& line, double h, double v, const Matrix2d& stiffness,
                        Form form) {
  CatenarySolution out;
  out.horizontal = h;
  out.vertical = v;
  out.resting = line.bottom ? std::max(0.0, 1 - v) : 0;
  out.anchor_horizontal = std::max(0.0, h - line.friction * out.resting);
  out.anchor_vertical = line.bottom ? std::max(0.0, v - 1) : v - 1;
  out.stiffness = stiffness;
  out.form = form;
  return out;
}

Matrix2d diagonal(double xx, double zz) { return Vector2d(xx, zz).asDiagonal(); }

/// HangingPart straight down onto the bottom, with the length `hung` in the water.
CatenarySolution slack(const ScaledLine& line, double hung) {
  const double zz = hung > 0 ? 1 / (1 + line.e * hung) : 0;
  return solved(line, 0, hung, diagonal(0, zz), Form::slack);
}

/// All of it on the bottom, z = 0, and longer than 1.
CatenarySolution lying(const ScaledLine& line, double x) {
  const double pull = (x - 1) / line.e;
  const double root = std::sqrt(2 * line.friction * pull);
  const double h = root < line.friction ? root : pull + 0.5 * line.friction;
  const double xx = 1 / (line.e * pulled_length(line, h, 1));
  return solved(line, h, 0, diagonal(xx, 0), Form::on_bottom);
}

/// Ends above each other: a loop, or a vertical bar.
CatenarySolution vertical(const ScaledLine& line, double x, double z) {
  const double loop = 1 + 0.5 * line.e;  // of the straight line under its own weight
  if (std::abs(z) <= loop)
    return solved(line, 0, 0.5 + 0.5 * z / loop, diagonal(0, 0.5 / loop), Form::suspended);
  const double v = 0.5 + std::copysign((std::abs(z) - 1) / line.e, z);
  const double ends = std::abs(std::log(std::abs(v / (v - 1))));
  const double xx = 1 / (ends + line.e);
  return solved(line, xx * x, v, diagonal(xx, 1 / line.e), Form::taut);
}

CatenarySolution general(const ScaledLine& line, const Vector2d& wanted,
                         const std::optional<Vector2d>& start) {
  const bool warm = start && is_usable(line, *start);
  Vector2d from = warm          ? *start
                  : line.bottom ? resting_start(line, wanted)
                                : suspended_start(line, wanted);
  Estimate at = estimate_at(line, wanted, std::log(from[0]), from[1]);
  if (!newton(line, wanted, at)) {
    at = bisected(line, wanted);
    newton(line, wanted, at);
  }
  const bool rests = line.bottom && at.v < 1;
  const Form form = rests ? Form::on_bottom : wanted.norm() > 1 ? Form::taut : Form::suspended;
  return solved(line, at.h(), at.v, stiffness_of(at.span), form);
}

/// Any case of a line with weight, in units of its own.
CatenarySolution in_own_units(const ScaledLine& line, double x, double z,
                              const std::optional<Vector2d>& start) {
  if (line.bottom) {
    if (z == 0) return x <= 1 ? slack(line, 0) : lying(line, x);
    const double hung = 2 * z / (1 + std::sqrt(1 + 2 * line.e * z));
    if (hung <= 1 && x <= 1 - hung) return slack(line, hung);
  }
  if (x <= kVertical) return vertical(line, x, z);
  return general(line, {x, z}, start);
}

/// A straight spring that cannot push.
CatenarySolution weightless(const CatenaryLine& line, double x, double z) {
  const double distance = std::hypot(x, z);
  CatenarySolution out;
  if (distance <= line.length) return out;
  const Vector2d along = Vector2d(x, z) / distance;
  const double tension = line.stiffness * (distance - line.length) / line.length;
  const Matrix2d outer = along * along.transpose();
  out.horizontal = out.anchor_horizontal = tension * along[0];
  out.vertical = out.anchor_vertical = tension * along[1];
  out.stiffness =
      line.stiffness / line.length * outer + tension / distance * (Matrix2d::Identity() - outer);
  out.form = Form::taut;
  return out;
}

bool is_weightless(const CatenaryLine& line) {
  return line.weight * line.length < kWeightless * line.stiffness;
}

void check(const CatenaryLine& line, double x, double z) {
  const double most = std::numeric_limits<double>::max();
  require(line.length > 0 && line.length <= most, "length of a mooring line", line.length,
          "a positive number");
  require(line.weight >= 0 && line.weight <= most, "weight of a mooring line", line.weight,
          "0 or more");
  require(line.stiffness > 0 && line.stiffness <= most, "stiffness of a mooring line",
          line.stiffness, "a positive number");
  require(line.friction >= 0 && line.friction <= most, "friction of a mooring line", line.friction,
          "0 or more");
  require(x >= 0 && x <= most, "horizontal span of a mooring line", x, "0 or more");
  require(std::abs(z) <= most, "height of a mooring line", z, "a finite number");
}

/// Position, in units of the line, at the unstretched distance s from the anchor.
Vector2d point_at(const ScaledLine& line, const CatenarySolution& own, double x, double s) {
  const double rests = own.resting;
  const double on_bottom = std::min(s, rests);
  Vector2d p(0, 0);
  if (own.form == Form::slack) {
    p[0] = rests > 0 ? x * on_bottom / rests : x;
  } else {
    const double m = pulled_length(line, own.horizontal, rests);
    const double pulled = std::max(0.0, on_bottom - (rests - m));
    const double least = own.horizontal - line.friction * m;
    p[0] = on_bottom + line.e * (least + 0.5 * line.friction * pulled) * pulled;
  }
  const double part = s - on_bottom;
  if (part <= 0) return p;
  const double low = own.vertical - (1 - rests);
  const HangingPart hanging = hanging_part(own.horizontal, low, part);
  if (own.horizontal > 0) p[0] += own.horizontal * (hanging.ell + line.e * part);
  p[1] += hanging.rise + line.e * part * (low + 0.5 * part);
  return p;
}

}  // namespace

CatenarySolution solve_catenary(const CatenaryLine& line, double x, double z, bool bottom,
                                const std::optional<Vector2d>& start) {
  check(line, x, z);
  if (bottom) z = std::max(z, 0.0);
  if (is_weightless(line)) return weightless(line, x, z);
  const double unit = line.weight * line.length;
  const ScaledLine own{unit / line.stiffness, line.friction, bottom};
  std::optional<Vector2d> own_start;
  if (start) own_start = *start / unit;
  CatenarySolution out = in_own_units(own, x / line.length, z / line.length, own_start);
  out.horizontal *= unit;
  out.vertical *= unit;
  out.anchor_horizontal *= unit;
  out.anchor_vertical *= unit;
  out.resting *= line.length;
  out.stiffness *= line.weight;
  return out;
}

std::vector<Vector2d> catenary_shape(const CatenaryLine& line, const CatenarySolution& solution,
                                     double x, double z, int count) {
  assert(count >= 2);
  std::vector<Vector2d> points(count, Vector2d(0, 0));
  const double unit = line.weight * line.length;
  const ScaledLine own{unit / line.stiffness, line.friction, solution.resting > 0};
  CatenarySolution scaled = solution;
  scaled.horizontal /= unit;
  scaled.vertical /= unit;
  scaled.resting /= line.length;
  for (int i = 1; i + 1 < count; ++i) {
    const double s = static_cast<double>(i) / (count - 1);
    points[i] = is_weightless(line) ? s * Vector2d(x, z)
                                    : line.length * point_at(own, scaled, x / line.length, s);
  }
  points.back() = {x, z};
  return points;
}

}  // namespace hydro

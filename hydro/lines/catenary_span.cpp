#include "hydro/lines/catenary_span.h"

#include <algorithm>
#include <cmath>

namespace hydro {
namespace {

/// 2 artanh(part/S), also where v and v_a have unlike signs and part/S is nearly 1.
double log_of_part(double h, double low, double high, double low_t, double high_t) {
  const double r = (high - low) / (low_t + high_t);
  if (r < 0.5) return 2 * std::atanh(r);
  const double above = (high_t + high) + (low_t - low);
  const double under = (high > 0 ? h * h / (high_t + high) : high_t - high) +
                       (low < 0 ? h * h / (low_t - low) : low_t + low);
  return std::log(above / under);
}

}  // namespace

HangingPart hanging_part(double h, double low, double part) {
  const double high = low + part;
  const double a = std::sqrt(h * h + low * low);
  const double t = std::sqrt(h * h + high * high);
  const double sum = a + t;
  const double product = a * t;
  HangingPart out;
  out.ell = log_of_part(h, low, high, a, t);
  out.rise = part * (low + high) / sum;
  out.cosine = h * out.rise / product;
  // v/T − v_a/T_a, without cancellation where both have one sign.
  out.sine = low * high > 0 ? h / product * h * part * (low + high) / (high * a + low * t)
                            : (high * a - low * t) / product;
  const double r = part / sum;
  // In a short part the four integrals cancel to nothing in double precision.
  out.gram = r < 1e-4 ? h / product * h / product * std::pow(part, 4) / (3 * sum * sum)
                      : std::max(0.0, (out.ell - out.sine) * out.sine - out.cosine * out.cosine);
  return out;
}

double pulled_length(const ScaledLine& line, double h, double resting) {
  return line.friction * resting <= h ? resting : h / line.friction;
}

CatenarySpan catenary_span(const ScaledLine& line, double h, double v) {
  const double resting = line.bottom ? std::max(0.0, 1 - v) : 0;
  const double part = 1 - resting;
  const double low = resting > 0 ? 0 : v - 1;
  const HangingPart hanging = hanging_part(h, low, resting > 0 ? v : 1);
  const double m = pulled_length(line, h, resting);
  const double along = line.e * (part + m);
  const double up = line.e * part;
  const double drag = line.friction * line.e * m;
  const double bend = std::max(0.0, hanging.ell - hanging.sine);
  CatenarySpan out;
  out.x = resting + line.e * (h - 0.5 * line.friction * m) * m + h * (hanging.ell + up);
  out.z = hanging.rise + 0.5 * up * (v + low);
  out.x_h = bend + along;
  out.z_v = hanging.sine + up;
  out.z_h = -hanging.cosine;
  out.x_v = -hanging.cosine + drag;
  out.determinant = hanging.gram + bend * up + along * (hanging.sine + up) + hanging.cosine * drag;
  return out;
}

}  // namespace hydro

#include "hydro/loads/rotary_drag.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace hydro {
namespace {

constexpr int kMostPieces = 3;

/// A ring about the pole where C_v = a + b·d, with G and H of (3) and (4) in it: G = g + a ρ⁴/4 + b
/// ρ⁵/5,  H = h + a ρ⁵/5 + b ρ⁶/6.
struct Ring {
  double inner = 0;  ///< [m]
  double a = 0, b = 0, g = 0, h = 0;

  double G(double r) const { return g + r * r * r * r * (a / 4 + b * r / 5); }
  double H(double r) const { return h + r * r * r * r * r * (a / 5 + b * r / 6); }
};

struct Rings {
  std::array<Ring, kMostPieces> ring;
  int count = 0;
};

/// Rings of the drag law about the pole: the speed v occurs at the distance v/spin. G and H are
/// continuous.
Rings rings_of(std::span<const DragPiece> law, double spin) {
  Rings rings;
  for (const DragPiece& piece : law) {
    Ring ring{piece.from / spin, piece.constant, piece.slope * spin};
    if (rings.count > 0) {
      const Ring& last = rings.ring[rings.count - 1];
      ring.g = last.G(ring.inner) - ring.G(ring.inner);
      ring.h = last.H(ring.inner) - ring.H(ring.inner);
    }
    rings.ring[rings.count++] = ring;
  }
  return rings;
}

/// The line of an edge: unit vectors along it and normal to it out of the panel, and its signed
/// distance from the pole, positive if the pole is on the panel's side.
struct Line {
  Eigen::Vector3d along, out;
  double h;
};

/// The integrals (3) and (4).
struct Moments {
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  double third = 0;

  Moments& operator+=(const Moments& other) {
    first += other.first;
    third += other.third;
    return *this;
  }
};

/// A part of an edge within one ring, from t0 to t1, at the distances r0 and r1 from the pole.
struct EdgePart {
  const Line& line;
  double t0, t1, r0, r1;
};

/// The terms with a, from
///     ∫ ρ dt = ½([tρ] + h² ∫ dt/ρ),  ∫ dt/ρ = 2 artanh((t1 − t0)/(ρ0 + ρ1)),
///     ∫ tρ dt = [ρ³]/3,              ∫ ρ³ dt = ¼[tρ³] + ¾ h² ∫ ρ dt.
Moments constant_terms(const EdgePart& p, double a) {
  const double h = p.line.h;
  const double cube0 = p.r0 * p.r0 * p.r0;
  const double cube1 = p.r1 * p.r1 * p.r1;
  const double ratio = (p.t1 - p.t0) / (p.r0 + p.r1);
  const double log = ratio < 1 ? 2 * std::atanh(ratio) : 0;  // through the pole: h² = 0
  const double rho = 0.5 * (p.t1 * p.r1 - p.t0 * p.r0 + h * h * log);
  const double rho3 = 0.25 * (p.t1 * cube1 - p.t0 * cube0) + 0.75 * h * h * rho;
  return {a / 4 * h * (h * rho * p.line.out + (cube1 - cube0) / 3 * p.line.along),
          a / 5 * h * rho3};
}

/// The terms with b, whose integrands are polynomials.
Moments linear_terms(const EdgePart& p, double b) {
  const double h = p.line.h;
  const double hh = h * h;
  const auto rho2 = [&](double t) { return t * (hh + t * t / 3); };
  const auto rho4 = [&](double t) { return t * (hh * hh + t * t * (hh / 1.5 + t * t / 5)); };
  const double fourth = p.r1 * p.r1 * p.r1 * p.r1 - p.r0 * p.r0 * p.r0 * p.r0;
  return {b / 5 * h * (h * (rho2(p.t1) - rho2(p.t0)) * p.line.out + fourth / 4 * p.line.along),
          b / 6 * h * (rho4(p.t1) - rho4(p.t0))};
}

/// The terms with g and h, ∮ e dθ and ∮ dθ; they occur outside the first ring, away from the pole.
Moments inner_terms(const EdgePart& p, const Ring& ring) {
  const double h = p.line.h;
  return {ring.g *
              ((p.t1 / p.r1 - p.t0 / p.r0) * p.line.out + h * (1 / p.r0 - 1 / p.r1) * p.line.along),
          ring.h * std::atan2(h * (p.t1 - p.t0), h * h + p.t0 * p.t1)};
}

Moments moments_of_part(const Line& line, double t0, double t1, const Ring& ring) {
  const double hh = line.h * line.h;
  const EdgePart part{line, t0, t1, std::sqrt(hh + t0 * t0), std::sqrt(hh + t1 * t1)};
  Moments sum;
  if (ring.a != 0) sum += constant_terms(part, ring.a);
  if (ring.b != 0) sum += linear_terms(part, ring.b);
  if (ring.inner > 0) sum += inner_terms(part, ring);
  return sum;
}

/// Moments of an edge, cut at the borders of rings: outermost, …, innermost, …, outermost.
Moments moments_of_edge(const Line& line, double t0, double t1, const Rings& rings) {
  const int last = rings.count - 1;
  Moments sum;
  double from = t0;
  for (int i = -last; i <= last && from < t1; ++i) {
    const double border = rings.ring[i < 0 ? -i : std::min(i + 1, last)].inner;
    const double half_chord = std::sqrt(std::max(0.0, border * border - line.h * line.h));
    const double end = i == last ? t1 : std::min(t1, i < 0 ? -half_chord : half_chord);
    if (end <= from) continue;
    sum += moments_of_part(line, from, end, rings.ring[std::abs(i)]);
    from = end;
  }
  return sum;
}

}  // namespace

Wrench rotary_drag(const Panel& panel, const Eigen::Vector3d& normal, const Twist& motion,
                   std::span<const DragPiece> law) {
  const double omega = motion.angular.dot(normal);
  const double spin = std::abs(omega);
  const Rings rings = rings_of(law, spin);
  const Eigen::Vector3d center = (panel[0] + panel[1] + panel[2]) / 3;
  const Eigen::Vector3d pole = center + normal.cross(motion.at(center)) / omega;
  Moments sum;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d start = panel[i] - pole;
    const Eigen::Vector3d edge = panel[(i + 1) % 3] - panel[i];
    const double length = edge.norm();
    if (length == 0) continue;
    const Eigen::Vector3d along = edge / length;
    const Eigen::Vector3d out = along.cross(normal);
    const double t0 = along.dot(start);
    sum += moments_of_edge({along, out, out.dot(start)}, t0, t0 + length, rings);
  }
  const Eigen::Vector3d force = spin * omega * normal.cross(sum.first);
  return {force, pole.cross(force) + spin * omega * sum.third * normal};
}

}  // namespace hydro

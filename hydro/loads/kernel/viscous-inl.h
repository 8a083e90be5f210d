// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_VISCOUS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_VISCOUS
#undef PLIMSOLL_KERNEL_VISCOUS
#else
#define PLIMSOLL_KERNEL_VISCOUS
#endif

#include <hwy/contrib/math/math-inl.h>

#include "hydro/loads/kernel/friction_line_series-inl.h"
#include "hydro/loads/kernel/lanes-inl.h"
#include "hydro/loads/kernel/plain_viscous.h"

/// @file
/// Viscous drag in lanes: `viscous_drag.h` in plane coordinates.
///
/// With the ratio of the velocity's change over a triangle to the velocity, a triangle is taken
///   - by the rule of three points below kFlat, of four below kGentle, of seven below kSmooth,
///     on one side of all kinks;
///   - by seven points on each quarter below 2 kSmooth, if C_v is the ITTC line;
///   - cut at the one kink of C_v that lies on it, and then by seven points, below kStraight;
///   - by the closed form of `rotary_drag.h` where C_v is linear in the speed all over it;
///   - by sums over its edges of means of the ITTC line (`friction_line_series-inl.h`);
///   - by `viscous_drag_load` otherwise: a few triangles of the thesis's law, with a kink.
/// The errors are those told there, below 1e-6 of a panel's largest load.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The first term that three points miss in the force is of third order, in the moment of second
/// order with a factor 1/60: 1.5e-7.
inline constexpr double kFlat = 3e-3;
/// Four points miss the third order in the moment: 5e-7 of the load times the triangle's size.
inline constexpr double kGentle = 0.03;
inline constexpr double kSmooth = 0.2;     ///< The first term missed is of sixth order: 1e-7.
inline constexpr double kStraight = 0.03;  ///< Error of third order at the cut: 2e-6.

/// Triangles that slide.
struct Sliding {
  const Plane& plane;
  const Flow& flow;
  const Triangle& t;
  V area;    ///< 0 where a lane does not count.
  V middle;  ///< Speed at the centre [m/s].
};

HWY_INLINE V2 velocity(const Flow& flow, const V2& r) {
  return {flow.along1(r.y), flow.along2(r.x)};
}
HWY_INLINE V length(const V2& v) { return hn::Sqrt(hn::MulAdd(v.x, v.x, v.y * v.y)); }

/// ∫ C_v |v_t| v_t dA in the plane and its moment about the centroid along n.
struct Friction {
  V2 force;
  V moment;
};

HWY_INLINE Friction operator+(const Friction& a, const Friction& b) {
  return {{a.force.x + b.force.x, a.force.y + b.force.y}, a.moment + b.moment};
}

/// Terms of a series in the change of speed: `kFewTerms` hold to 1e-7 where the speed at the points
/// of a rule changes by kGentle or less, `kAllTerms` to 2e-6 where the vertices' does by kSmooth.
inline constexpr int kFewTerms = 4, kAllTerms = 6;

/// C_v about a speed: constant + slope·v for pieces of the law, a series for the ITTC line.
struct Branch {
  V constant, slope;
  bool is_line;             ///< C_v is the series.
  V inverse, c[kAllTerms];  ///< C_v = Σ c_i δ^i, δ = v·inverse − 1.
};

/// The Taylor series of the ITTC line about a speed: with a = 1/ln(Re/100) the line is
/// C_0 (1 + a ln(1 + δ))^−2.
template <int kTerms>
HWY_INLINE Branch line_about(const ViscousDrag& law, V inside) {
  const V reynolds = inside * all(law.reynolds_per_speed);
  const V log = hn::Log(D(), all(0.01) * hn::Max(reynolds, all(kLeastReynolds)));
  const V speed = hn::Max(inside, all(1e-300));
  const V both = all(1) / (log * speed);  // Divisions are slow: one gives both reciprocals.
  const V a = both * speed;
  const V C_0 = all(0.075 * M_LN10 * M_LN10) * a * a;
  const V Ca = hn::IfThenZeroElse(reynolds < all(kLeastReynolds), C_0 * a);
  const auto times = [&](V x, double constant) HWY_ATTR { return hn::MulAdd(a, x, all(constant)); };
  Branch line;
  line.constant = all(kHeldCoefficient);  // For the closed form, which takes held lanes alone.
  line.slope = zero();
  line.is_line = true;
  line.inverse = both * log;
  line.c[0] = C_0;
  line.c[1] = all(-2) * Ca;
  line.c[2] = Ca * times(all(3), 1);
  line.c[3] = Ca * times(times(all(-4), -3), -2.0 / 3);
  if constexpr (kTerms == kAllTerms) {
    line.c[4] = Ca * times(times(times(all(5), 6), 2.75), 0.5);
    line.c[5] = Ca * times(times(times(times(all(-6), -10), -7), -2.5), -0.4);
  }
  return line;
}

template <int kTerms>
HWY_INLINE Branch branch_at(const ViscousDrag& law, V inside) {
  if (law.law == ViscousDrag::Law::ittc57) return line_about<kTerms>(law, inside);
  Branch branch;
  branch.is_line = false;
  if (law.law == ViscousDrag::Law::constant) {
    branch.constant = all(law.coefficient);
    branch.slope = zero();
  } else {
    const M slow = inside < all(1), middle = inside < all(2);
    branch.constant = hn::IfThenElse(slow, all(0.1), hn::IfThenElseZero(middle, all(0.2)));
    branch.slope = hn::IfThenElseZero(hn::AndNot(slow, middle), all(-0.1));
  }
  return branch;
}

template <int kTerms>
HWY_INLINE V coefficient(const Branch& branch, V speed) {
  if (!branch.is_line) return hn::MulAdd(branch.slope, speed, branch.constant);
  // Lanes that do not count may have any speed: the limit keeps them finite.
  const V delta = hn::Min(hn::MulSub(speed, branch.inverse, all(1)), all(1));
  V sum = branch.c[kTerms - 1];
  for (int i = kTerms - 2; i >= 0; --i) sum = hn::MulAdd(sum, delta, branch.c[i]);
  return sum;
}

/// Adds factor·v, with its moment, to a sum of means.
HWY_INLINE void add_traction(const V2& at, const V2& v, V factor, Friction& sum) {
  const V2 f = {factor * v.x, factor * v.y};
  sum.force.x = sum.force.x + f.x;
  sum.force.y = sum.force.y + f.y;
  sum.moment = sum.moment + hn::MulSub(at.x, f.y, at.y * f.x);
}

/// Adds the traction at a point, with a weight, to a sum of means.
template <int kTerms>
HWY_INLINE void add_point(const Sliding& s, const Branch& branch, const V2& at, double weight,
                          Friction& sum) {
  const V2 v = velocity(s.flow, at);
  const V speed = length(v);
  add_traction(at, v, all(weight) * coefficient<kTerms>(branch, speed) * speed, sum);
}

/// Adds the traction at the centre, of which the speed is known.
HWY_INLINE void add_centre(const Sliding& s, const Branch& branch, const V2& centre, double weight,
                           Friction& sum) {
  const V c_v = branch.is_line ? branch.c[0] : hn::MulAdd(branch.slope, s.middle, branch.constant);
  add_traction(centre, velocity(s.flow, centre), all(weight) * c_v * s.middle, sum);
}

HWY_INLINE V2 centre_of(const Triangle& t) {
  return {all(1.0 / 3) * (t.a.x + t.b.x + t.c.x), all(1.0 / 3) * (t.a.y + t.b.y + t.c.y)};
}

/// Three points on the lines from the centre to the vertices: centre + part·(vertex − centre).
template <int kTerms>
HWY_INLINE void add_star(const Sliding& s, const Branch& branch, const V2& centre, double part,
                         double weight, Friction& sum) {
  add_point<kTerms>(s, branch, between(centre, s.t.a, all(part)), weight, sum);
  add_point<kTerms>(s, branch, between(centre, s.t.b, all(part)), weight, sum);
  add_point<kTerms>(s, branch, between(centre, s.t.c, all(part)), weight, sum);
}

HWY_INLINE Friction scaled(V factor, const Friction& f) {
  return {{factor * f.force.x, factor * f.force.y}, factor * f.moment};
}

/// The rule of degree 2.
HWY_INLINE Friction three_points(const Sliding& s, const ViscousDrag& law) {
  const V2 centre = centre_of(s.t);
  const Branch branch = branch_at<kFewTerms>(law, s.middle);
  Friction mean{{zero(), zero()}, zero()};
  add_star<kFewTerms>(s, branch, centre, 0.5, 1.0 / 3, mean);
  return scaled(s.area, mean);
}

/// The rule of degree 3.
inline HWY_NOINLINE Friction four_points(const Sliding& s, const ViscousDrag& law) {
  const V2 centre = centre_of(s.t);
  const Branch branch = branch_at<kFewTerms>(law, s.middle);
  Friction mean{{zero(), zero()}, zero()};
  add_centre(s, branch, centre, -9.0 / 16, mean);
  add_star<kFewTerms>(s, branch, centre, 0.4, 25.0 / 48, mean);
  return scaled(s.area, mean);
}

/// Radon's rule of degree 5: its points lie (1 ± √15·…)/7 of the way to the vertices.
inline HWY_NOINLINE Friction seven_points(const Sliding& s, const ViscousDrag& law) {
  constexpr double kRoot = 3.872983346207417;  // √15
  const V2 centre = centre_of(s.t);
  const Branch branch = branch_at<kAllTerms>(law, s.middle);
  Friction mean{{zero(), zero()}, zero()};
  add_centre(s, branch, centre, 9.0 / 40, mean);
  add_star<kAllTerms>(s, branch, centre, (1 + kRoot) / 7, (155 - kRoot) / 1200, mean);
  add_star<kAllTerms>(s, branch, centre, (1 - kRoot) / 7, (155 + kRoot) / 1200, mean);
  return scaled(s.area, mean);
}

/// Seven points on each quarter of triangles, over which the velocity changes half as much.
inline HWY_NOINLINE Friction in_quarters(const Sliding& s, const ViscousDrag& law) {
  const V2 ab = between(s.t.a, s.t.b, all(0.5)), bc = between(s.t.b, s.t.c, all(0.5));
  const V2 ca = between(s.t.c, s.t.a, all(0.5));
  const auto friction = [&](const Triangle& part) HWY_ATTR {
    const V middle = length(velocity(s.flow, centre_of(part)));
    return seven_points({s.plane, s.flow, part, all(0.25) * s.area, middle}, law);
  };
  return friction({s.t.a, ab, ca}) + friction({ab, s.t.b, bc}) + friction({ca, bc, s.t.c}) +
         friction({ab, bc, ca});
}

/// Cut where the speed, taken as linear, is that of the kink.
inline HWY_NOINLINE Friction cut_at_kink(const Sliding& s, const ViscousDrag& law, V kink) {
  const auto excess_at = [&](const V2& r) HWY_ATTR { return length(velocity(s.flow, r)) - kink; };
  const Values excess = {excess_at(s.t.a), excess_at(s.t.b), excess_at(s.t.c)};
  const M crosses = hn::And(lowest(excess) < zero(), highest(excess) > zero());
  const Cut cut = cut_at_zero(s.t, excess, crosses);
  const M counts = s.area > zero();
  const auto friction = [&](const Triangle& part) HWY_ATTR {
    const V area = hn::IfThenElseZero(counts, area_of(part));
    const V middle = length(velocity(s.flow, centre_of(part)));
    return seven_points({s.plane, s.flow, part, area, middle}, law);
  };
  return friction(cut.corner) + friction(cut.near) + friction(cut.far);
}

/// The terms of equations (3) and (4) of rotary_drag.h for one edge from s0 to s1, seen from the
/// pole, with C_v = a + b d.
inline HWY_NOINLINE PoleMoments edge_moments(const V2& s0, const V2& s1, V a, V b) {
  const V2 edge = {s1.x - s0.x, s1.y - s0.y};
  const V size = length(edge);
  const V inverse = hn::IfThenElseZero(size > zero(), all(1) / size);
  const V2 along = {edge.x * inverse, edge.y * inverse};
  const V2 out = {along.y, zero() - along.x};
  const V h = hn::MulAdd(out.x, s0.x, out.y * s0.y), hh = h * h;
  const V t0 = hn::MulAdd(along.x, s0.x, along.y * s0.y), t1 = t0 + size;
  const V r0 = hn::Sqrt(hn::MulAdd(t0, t0, hh)), r1 = hn::Sqrt(hn::MulAdd(t1, t1, hh));
  const V cube0 = r0 * r0 * r0, cube1 = r1 * r1 * r1;
  const V around = r0 + r1;
  const M proper = size < around;  // Else the pole is on the edge's line, and h = 0.
  const V twice_artanh =
      hn::Log1p(D(), hn::IfThenElseZero(proper, (size + size) / (around - size)));
  const V rho = all(0.5) * (hn::MulSub(t1, r1, t0 * r0) + hh * twice_artanh);
  const V rho3 = hn::MulAdd(all(0.75) * hh, rho, all(0.25) * hn::MulSub(t1, cube1, t0 * cube0));
  const auto rho2_to = [&](V t) HWY_ATTR { return t * hn::MulAdd(t * t, all(1.0 / 3), hh); };
  const auto rho4_to = [&](V t) HWY_ATTR {
    const V tt = t * t;
    return t * hn::MulAdd(tt, hn::MulAdd(tt, all(0.2), hh * all(1 / 1.5)), hh * hh);
  };
  const V a4 = a * all(0.25) * h, a5 = a * all(0.2) * h;
  const V b5 = b * all(0.2) * h, b6 = b * all(1.0 / 6) * h;
  const V outward = h * hn::MulAdd(a4, rho, b5 * (rho2_to(t1) - rho2_to(t0)));
  const V onward =
      hn::MulAdd(a4 * all(1.0 / 3), cube1 - cube0, b5 * all(0.25) * (cube1 * r1 - cube0 * r0));
  return {
      {hn::MulAdd(outward, out.x, onward * along.x), hn::MulAdd(outward, out.y, onward * along.y)},
      hn::MulAdd(a5, rho3, b6 * (rho4_to(t1) - rho4_to(t0)))};
}

/// Friction by integrals over the edges, seen from the pole; `moments_of` gives those of an edge.
template <class MomentsOf>
HWY_INLINE Friction about_pole(const Sliding& s, M which, const MomentsOf& moments_of) {
  const V omega = hn::IfThenElse(which, s.flow.spin, all(1)), spin = hn::Abs(omega);
  const V2 pole = {(zero() - s.flow.b) / omega, s.flow.a / omega};
  const auto edge = [&](const V2& from, const V2& to) HWY_ATTR {
    return moments_of(spin, V2{from.x - pole.x, from.y - pole.y}, V2{to.x - pole.x, to.y - pole.y});
  };
  const PoleMoments sum = edge(s.t.a, s.t.b) + edge(s.t.b, s.t.c) + edge(s.t.c, s.t.a);
  const V factor = spin * omega;
  const V2 force = {zero() - factor * sum.first.y, factor * sum.first.x};
  const V moment = hn::MulAdd(factor, sum.third, hn::MulSub(pole.x, force.y, pole.y * force.x));
  return {{hn::IfThenElseZero(which, force.x), hn::IfThenElseZero(which, force.y)},
          hn::IfThenElseZero(which, moment)};
}

/// The closed form where C_v is linear in the speed all over the triangle.
inline HWY_NOINLINE Friction linear_about_pole(const Sliding& s, const ViscousDrag& law, M which) {
  const Branch branch = branch_at<kAllTerms>(law, s.middle);
  return about_pole(s, which, [&](V spin, const V2& from, const V2& to) HWY_ATTR {
    return edge_moments(from, to, branch.constant, branch.slope * spin);
  });
}

/// The ITTC line, held or not.
inline HWY_NOINLINE Friction line_about_pole(const Sliding& s, const ViscousDrag& law, M which) {
  const FrictionMeans& means = friction_means();
  return about_pole(s, which, [&](V spin, const V2& from, const V2& to) HWY_ATTR {
    return line_moments(means, all(law.reynolds_per_speed / 100) * spin, from, to);
  });
}

HWY_INLINE void add_friction(Sums& sums, const Plane& p, V factor, const Friction& f) {
  const V fx = factor * f.force.x, fy = factor * f.force.y, mz = factor * f.moment;
  const V3 force = {hn::MulAdd(fx, p.e1.x, fy * p.e2.x), hn::MulAdd(fx, p.e1.y, fy * p.e2.y),
                    hn::MulAdd(fx, p.e1.z, fy * p.e2.z)};
  add(sums, kViscousDrag, force);
  const V3 arm = cross(p.c, force);
  add(sums, kViscousDrag + 3,
      V3{hn::MulAdd(mz, p.n.x, arm.x), hn::MulAdd(mz, p.n.y, arm.y), hn::MulAdd(mz, p.n.z, arm.z)});
}

/// Hands lanes to the plain version.
inline HWY_NOINLINE void add_lane_by_lane(Sums& sums, const LoadInputs& in, const Sliding& s,
                                          M which) {
  // The motion in the plane: v = linear + spin n × r.
  const auto store = [](const V3& v, double(&to)[3][kMostLanes]) HWY_ATTR {
    hn::Store(v.x, D(), to[0]);
    hn::Store(v.y, D(), to[1]);
    hn::Store(v.z, D(), to[2]);
  };
  const D d;
  PlainPanels panels;
  const Plane& p = s.plane;
  const auto corner = [&](const V2& r, double(&to)[3][kMostLanes]) HWY_ATTR {
    hn::Store(hn::MulAdd(p.e1.x, r.x, hn::MulAdd(p.e2.x, r.y, p.c.x)), d, to[0]);
    hn::Store(hn::MulAdd(p.e1.y, r.x, hn::MulAdd(p.e2.y, r.y, p.c.y)), d, to[1]);
    hn::Store(hn::MulAdd(p.e1.z, r.x, hn::MulAdd(p.e2.z, r.y, p.c.z)), d, to[2]);
  };
  corner(s.t.a, panels.r[0]);
  corner(s.t.b, panels.r[1]);
  corner(s.t.c, panels.r[2]);
  const V a = s.flow.a, b = s.flow.b, spin = s.flow.spin;
  const V3 around = cross(p.n, p.c);
  const auto linear = [&](V e1, V e2, V n_cross_c) HWY_ATTR {
    return hn::MulAdd(a, e1, hn::NegMulAdd(spin, n_cross_c, b * e2));
  };
  store({linear(p.e1.x, p.e2.x, around.x), linear(p.e1.y, p.e2.y, around.y),
         linear(p.e1.z, p.e2.z, around.z)},
        panels.linear);
  hn::Store(spin, d, panels.spin);
  store(p.n, panels.n);
  hn::Store(hn::IfThenElseZero(which, all(1)), d, panels.counts);
  add_plain_viscous(in, panels, static_cast<int>(hn::Lanes(d)), sums);
}

/// Viscous drag on triangles that are wet all over.
/// @param area   0 where a lane does not count.
inline HWY_NOINLINE void add_viscous(Sums& sums, const LoadInputs& in, const Plane& plane,
                                     const Flow& flow, const Triangle& t, V area) {
  const D d;
  const ViscousDrag& law = *in.viscous;
  const bool thesis = law.law == ViscousDrag::Law::thesis;
  const bool ittc = law.law == ViscousDrag::Law::ittc57;
  const V2 centre = centre_of(t);
  const V middle = length(velocity(flow, centre));
  const Sliding s{plane, flow, t, area, middle};
  const auto distance2 = [&](const V2& r) HWY_ATTR {
    const V x = r.x - centre.x, y = r.y - centre.y;
    return hn::MulAdd(x, x, y * y);
  };
  const V size2 = highest({distance2(s.t.a), distance2(s.t.b), distance2(s.t.c)});
  const V change = hn::Abs(s.flow.spin) * hn::Sqrt(size2);
  const V low = hn::Max(zero(), middle - change), high = middle + change;
  M counts = hn::And(s.area > zero(), high > zero());
  if (thesis) counts = hn::And(counts, low < all(2));
  if (hn::AllFalse(d, counts)) return;

  const V first_kink = all(thesis ? 1 : ittc ? kLeastReynolds / law.reynolds_per_speed : -1);
  const V last_kink = thesis ? all(2) : first_kink;
  const M at_first = hn::And(low < first_kink, first_kink < high);
  const M kink = hn::And(counts, hn::Or(at_first, hn::And(low < last_kink, last_kink < high)));
  const M smooth = hn::AndNot(kink, hn::And(counts, change <= all(kSmooth) * low));
  const M flat = hn::And(smooth, change <= all(kFlat) * low);
  const M gentle = hn::And(smooth, change <= all(kGentle) * low);
  const M straight = hn::And(kink, change <= all(kStraight) * low);
  const M turning = hn::AndNot(hn::Or(smooth, straight), counts);
  const M held = high <= first_kink;
  const M linear = hn::AndNot(kink, ittc ? hn::And(held, turning) : turning);
  M quartered = hn::FirstN(d, 0), line = quartered;
  if (ittc) {
    quartered =
        hn::AndNot(hn::Or(kink, linear), hn::And(turning, change <= all(2 * kSmooth) * low));
    line = hn::AndNot(hn::Or(linear, quartered), turning);
  }

  Friction sum{{zero(), zero()}, zero()};
  const auto only = [&](M which) HWY_ATTR { return hn::IfThenElseZero(which, s.area); };
  if (hn::AllTrue(d, hn::Or(flat, hn::Not(smooth))))
    sum = three_points({s.plane, s.flow, s.t, only(flat), middle}, law);
  else if (hn::AllTrue(d, hn::Or(gentle, hn::Not(smooth))))
    sum = four_points({s.plane, s.flow, s.t, only(gentle), middle}, law);
  else
    sum = seven_points({s.plane, s.flow, s.t, only(smooth), middle}, law);
  if (!hn::AllFalse(d, straight)) {
    const V at = hn::IfThenElse(at_first, first_kink, last_kink);
    sum = sum + cut_at_kink({s.plane, s.flow, s.t, only(straight), middle}, law, at);
  }
  if (!hn::AllFalse(d, quartered))
    sum = sum + in_quarters({s.plane, s.flow, s.t, only(quartered), middle}, law);
  if (!hn::AllFalse(d, linear)) sum = sum + linear_about_pole(s, law, linear);
  if (!hn::AllFalse(d, line)) sum = sum + line_about_pole(s, law, line);
  add_friction(sums, s.plane, all(-in.half_density), sum);
  const M others = hn::AndNot(hn::Or(hn::Or(linear, line), quartered), turning);
  if (!hn::AllFalse(d, others)) add_lane_by_lane(sums, in, s, others);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

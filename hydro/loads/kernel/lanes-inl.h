// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_LANES
#undef PLIMSOLL_KERNEL_LANES
#else
#define PLIMSOLL_KERNEL_LANES
#endif

#include <hwy/highway.h>

#include "hydro/loads/kernel/load_inputs.h"
#include "hydro/loads/kernel/panels.h"
#include "hydro/loads/point_rules.h"

/// @file
/// Faces in the lanes of a vector unit: their planes, the flow along them, and the closed forms of
/// `panel_loads.h` in plane coordinates.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, kMostLanes>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

HWY_INLINE V all(double value) { return hn::Set(D(), value); }
HWY_INLINE V zero() { return hn::Zero(D()); }

struct V3 {
  V x, y, z;
};

HWY_INLINE V3 all3(const double (&v)[3]) { return {all(v[0]), all(v[1]), all(v[2])}; }
HWY_INLINE V dot(const V3& a, const V3& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, a.z * b.z));
}
HWY_INLINE V3 cross(const V3& a, const V3& b) {
  return {hn::MulSub(a.y, b.z, a.z * b.y), hn::MulSub(a.z, b.x, a.x * b.z),
          hn::MulSub(a.x, b.y, a.y * b.x)};
}
HWY_INLINE V3 operator+(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// The planes of some faces: r = c + x e1 + y e2.
struct Plane {
  V3 c, n, e1, e2;
};

/// A point in a plane, or a vector [m].
struct V2 {
  V x, y;
};

HWY_INLINE V3 point_on(const Plane& p, const V2& r) {
  return {hn::MulAdd(p.e1.x, r.x, hn::MulAdd(p.e2.x, r.y, p.c.x)),
          hn::MulAdd(p.e1.y, r.x, hn::MulAdd(p.e2.y, r.y, p.c.y)),
          hn::MulAdd(p.e1.z, r.x, hn::MulAdd(p.e2.z, r.y, p.c.z))};
}

/// Triangles in plane coordinates, counter-clockwise. The compiler keeps fields in registers; an
/// array it would not.
struct Triangle {
  V2 a, b, c;
};

/// The values of a linear function at the vertices of triangles.
struct Values {
  V a, b, c;
};

HWY_INLINE V lowest(const Values& f) { return hn::Min(f.a, hn::Min(f.b, f.c)); }
HWY_INLINE V highest(const Values& f) { return hn::Max(f.a, hn::Max(f.b, f.c)); }

/// The area [m^2].
HWY_INLINE V area_of(const Triangle& t) {
  return all(0.5) * hn::MulSub(t.b.x - t.a.x, t.c.y - t.a.y, (t.c.x - t.a.x) * (t.b.y - t.a.y));
}

/// Velocity over a plane, relative to the water: v·n = normal + normal_x x + normal_y y as pressure
/// drag sees it, v·e1 = a − spin y and v·e2 = b + spin x [m/s].
struct Flow {
  V normal, normal_x, normal_y, a, b, spin;

  HWY_INLINE V normal_at(const V2& r) const {
    return hn::MulAdd(normal_x, r.x, hn::MulAdd(normal_y, r.y, normal));
  }
  HWY_INLINE V along1(V y) const { return hn::NegMulAdd(spin, y, a); }
  HWY_INLINE V along2(V x) const { return hn::MulAdd(spin, x, b); }
};

HWY_INLINE Flow flow_over(const Plane& p, const LoadInputs& in) {
  const V3 omega = all3(in.angular);
  const V3 turning = cross(omega, p.c);
  const V3 v = all3(in.linear) + turning;
  return {dot(all3(in.drag_linear) + turning, p.n),
          zero() - dot(omega, p.e2),
          dot(omega, p.e1),
          dot(v, p.e1),
          dot(v, p.e2),
          dot(omega, p.n)};
}

/// K n: pressure drag sees v·Kn of a velocity v.
HWY_INLINE V3 drag_normal(const LoadInputs& in, const V3& n) {
  if (!in.slender) return n;
  return {dot(all3(in.shape[0]), n), dot(all3(in.shape[1]), n), dot(all3(in.shape[2]), n)};
}

/// ∫ q dA, ∫ q x dA and ∫ q y dA of a traction q along the normal.
struct Traction {
  V q, qx, qy;
};

/// Σ w r over the vertices.
HWY_INLINE V2 weighted(const Triangle& t, const Values& w) {
  return {hn::MulAdd(w.a, t.a.x, hn::MulAdd(w.b, t.b.x, w.c * t.c.x)),
          hn::MulAdd(w.a, t.a.y, hn::MulAdd(w.b, t.b.y, w.c * t.c.y))};
}

/// Equation (1) of panel_loads.h for a linear f.
HWY_INLINE Traction linear_on(const Triangle& t, V area, const Values& f) {
  const V sum = f.a + f.b + f.c;
  const V2 first = weighted(t, {sum + f.a, sum + f.b, sum + f.c});
  const V twelfth = area * all(1.0 / 12);
  return {area * sum * all(1.0 / 3), twelfth * first.x, twelfth * first.y};
}

/// Equations (2) and (3) there for f²: with S = Σ f_i and B = ½ (S² + Σ f_i²) its weights are
/// 30 w_i = B + f_i (f_i + S). `scale` is a factor on the result, the area among it.
HWY_INLINE Traction square_on(const Triangle& t, V scale, const Values& f) {
  const V sum = f.a + f.b + f.c;
  const V squares = hn::MulAdd(f.a, f.a, hn::MulAdd(f.b, f.b, f.c * f.c));
  const V b = all(0.5) * hn::MulAdd(sum, sum, squares);
  const V2 first = weighted(t, {hn::MulAdd(f.a, f.a + sum, b), hn::MulAdd(f.b, f.b + sum, b),
                                hn::MulAdd(f.c, f.c + sum, b)});
  const V thirtieth = scale * all(1.0 / 30);
  return {scale * b * all(1.0 / 6), thirtieth * first.x, thirtieth * first.y};
}

/// A part of a traction at one point.
HWY_INLINE Traction traction_at(V q, const V2& at) { return {q, q * at.x, q * at.y}; }

HWY_INLINE V2 point_of(const Triangle& t, const TrianglePoint& point) {
  const V a = all(point.at[0]), b = all(point.at[1]), c = all(point.at[2]);
  return {hn::MulAdd(a, t.a.x, hn::MulAdd(b, t.b.x, c * t.c.x)),
          hn::MulAdd(a, t.a.y, hn::MulAdd(b, t.b.y, c * t.c.y))};
}

HWY_INLINE Traction operator+(const Traction& a, const Traction& b) {
  return {a.q + b.q, a.qx + b.qx, a.qy + b.qy};
}

template <int kCount>
HWY_INLINE void add(LaneSums<kCount>& sums, int which, V value) {
  double* to = sums.lane[which];
  hn::Store(hn::Load(D(), to) + value, D(), to);
}
template <int kCount>
HWY_INLINE void add(LaneSums<kCount>& sums, int which, const V3& value) {
  add(sums, which, value.x);
  add(sums, which + 1, value.y);
  add(sums, which + 2, value.z);
}

/// Adds −∫ q n dA and its moment −∫ r × n q dA, with e1 × n = −e2 and e2 × n = e1.
template <int kCount>
HWY_INLINE void add_normal(LaneSums<kCount>& sums, int which, const Plane& p, const V3& c_cross_n,
                           const Traction& t) {
  const auto along = [&](V n, V cn, V e1, V e2, int i) HWY_ATTR {
    add(sums, which + i, zero() - t.q * n);
    add(sums, which + 3 + i, hn::MulSub(t.qx, e2, hn::MulAdd(t.q, cn, t.qy * e1)));
  };
  along(p.n.x, c_cross_n.x, p.e1.x, p.e2.x, 0);
  along(p.n.y, c_cross_n.y, p.e1.y, p.e2.y, 1);
  along(p.n.z, c_cross_n.z, p.e1.z, p.e2.z, 2);
}

/// Triangles cut where a linear function is zero: `corner` at the vertex that is alone on its side,
/// `near` and `far` for the trapezium beside it; with the function's values there.
struct Cut {
  Triangle corner, near, far;
  Values at_corner, at_near, at_far;
  M alone_positive;  ///< The corner is where the function is positive.
};

/// Selects one of three values: the first, unless a mask selects another.
HWY_INLINE V chosen(M second, M third, V a, V b, V c) {
  return hn::IfThenElse(second, b, hn::IfThenElse(third, c, a));
}
HWY_INLINE V2 chosen(M second, M third, const V2& a, const V2& b, const V2& c) {
  return {chosen(second, third, a.x, b.x, c.x), chosen(second, third, a.y, b.y, c.y)};
}

HWY_INLINE V2 between(const V2& from, const V2& to, V part) {
  return {hn::MulAdd(part, to.x - from.x, from.x), hn::MulAdd(part, to.y - from.y, from.y)};
}

/// Where `cut` is false all of the triangle goes to `near` and the others have no area.
HWY_INLINE Cut cut_at_zero(const Triangle& t, const Values& f, M cut) {
  const M pa = f.a > zero(), pb = f.b > zero(), pc = f.c > zero();
  const M one = hn::AndNot(hn::And(pa, hn::And(pb, pc)), hn::Xor(pa, hn::Xor(pb, pc)));
  const M second = hn::And(cut, hn::Not(hn::Xor(pb, one)));
  const M third = hn::And(cut, hn::Not(hn::Xor(pc, one)));
  const V2 alone = chosen(second, third, t.a, t.b, t.c);
  const V2 next = chosen(second, third, t.b, t.c, t.a);
  const V2 last = chosen(second, third, t.c, t.a, t.b);
  const V f_alone = chosen(second, third, f.a, f.b, f.c);
  const V f_next = chosen(second, third, f.b, f.c, f.a);
  const V f_last = chosen(second, third, f.c, f.a, f.b);
  const V2 on_next = between(alone, next, hn::IfThenElseZero(cut, f_alone / (f_alone - f_next)));
  const V2 on_last = between(alone, last, hn::IfThenElseZero(cut, f_alone / (f_alone - f_last)));
  const V at_cut = hn::IfThenZeroElse(cut, f_alone);
  return {{alone, on_next, on_last},     {on_next, next, last},    {on_next, last, on_last},
          {f_alone, at_cut, at_cut},     {at_cut, f_next, f_last}, {at_cut, f_last, at_cut},
          hn::And(cut, f_alone > zero())};
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

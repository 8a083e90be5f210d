// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_AIRY_BRANCH) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_AIRY_BRANCH
#undef PLIMSOLL_KERNEL_AIRY_BRANCH
#else
#define PLIMSOLL_KERNEL_AIRY_BRANCH
#endif

#include "hydro/loads/kernel/local_sea-inl.h"
#include "hydro/loads/kernel/tree-inl.h"

/// @file
/// The water under Airy waves over a branch as quadratic polynomials of the place. The velocity of
/// a sheared current has to be linear over it.
///
/// They pass through samples. With h the half sides of the branch's box, δ the place from its
/// middle, t_i = δ_i/h_i, and f_i, f_−i, f_ij the values at h_i, −h_i and h_i + h_j from the
/// middle,
///
///     f = f_0 + ½ Σ_i t_i (f_i − f_−i) + ½ Σ_i t_i² (f_i − 2f_0 + f_−i)
///             + ½ Σ_i<j t_i t_j (f_ij + f_−i−j − f_i − f_−i − f_j − f_−j + 2f_0),             (1)
///
/// which is exact for quadratic functions. Where f departs from its Taylor series of second order
/// by T |δ|³ at most, (1) departs from f by less than 1.5 T |h|³ in the mean over the box.
///
/// A wave's phase changes by α = k·δ, and the stretched height z*(ξ(δ), z + up·δ) by ζ₁ + ζ₂ + …,
/// of first and second order in δ. With |α + ikζ₁| ≤ k p |δ|, |ζ₂| ≤ q |δ|² and |ζ₃| ≤ t |δ|³ the
/// head has
///
///     T = Σ a C (⅙ k³p³ + k² p q + k t),                                                      (2)
///
/// and the velocity the same with a √2 (g/σ) k in place of a, the acceleration with a √2 g k. C is
/// taken at the highest z* of the branch.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// p, q and t of (2).
struct StretchBounds {
  double p, q, t;
};

inline StretchBounds stretch_bounds(const WaveField& w) {
  const double e = w.bends[0], curvature = w.bends[1], third = w.bends[2];  // Bounds of ξ.
  if (w.deep) return {1 + e, curvature / 2, third / 6};
  const double h = w.water_depth, part = std::min(w.height / h, 0.9), m = 1 / (1 - part);
  const double by_rise = m * m * (1 + part);
  return {m + by_rise * e, by_rise * curvature / 2 + m * by_rise / h * e * e + m * m / h * e,
          by_rise * third / 6 + m * m * by_rise / (h * h) * e * e * e +
              m * m * m / (h * h) * e * e + m * by_rise / h * e * curvature +
              m * m / h * curvature / 2};
}

/// Rows from a value, gradient and second derivatives xx, yy, zz, xy, yz, zx at c.
inline void set_rows(double value, const double (&g)[3], const double (&h)[6], const double* c,
                     double (&rows)[kNormal]) {
  const double hc[3] = {h[0] * c[0] + h[3] * c[1] + h[5] * c[2],
                        h[3] * c[0] + h[1] * c[1] + h[4] * c[2],
                        h[5] * c[0] + h[4] * c[1] + h[2] * c[2]};
  rows[kOne] = value;
  for (int a = 0; a < 3; ++a) {
    rows[kOne] += (0.5 * hc[a] - g[a]) * c[a];
    rows[kPlace + a] = g[a] - hc[a];
    rows[kSquare + a] = 0.5 * h[a];
    rows[kSquare + 3 + a] = h[3 + a];
  }
}

/// The water over a branch: rows of factors, as its moments have them.
struct BranchWater {
  double depth[kNormal];  ///< Below the surface [m].
  double head[kNormal];
  double u[3][kNormal];  ///< `Water::u`.
};

/// Largest distance from the middle of a branch's box [m].
inline double size_of(const Node& node) {
  return std::sqrt(node.half[0] * node.half[0] + node.half[1] * node.half[1] +
                   node.half[2] * node.half[2]);
}

/// The bound of C over a branch.
inline double largest_decay(const Node& node, const LoadInputs& in) {
  const WaveField& waves = in.surface->waves;
  double top = in.below + in.surface->hidden_depth - waves.height;
  for (int a = 0; a < 3; ++a) top -= in.up[a] * node.centre[a] + std::abs(in.up[a]) * node.half[a];
  const double h = waves.water_depth;
  const double rate = waves.least_number * (waves.deep ? 1 : h / (h + waves.height));
  return (waves.deep ? 1 : 2) * std::exp(-rate * std::max(0.0, top));
}

/// T of (2) but for C. @param sums   Σ a k^n for n = 1, 2, 3.
inline double third_order(const StretchBounds& b, const double* sums) {
  return b.p * b.p * b.p / 6 * sums[2] + b.p * b.q * sums[1] + b.t * sums[0];
}

/// A flat box has room for the samples of (1), too.
inline double least_half(const Node& node) { return 1e-3 * size_of(node); }

/// True if the current is linear over a branch's box and over the samples of (1).
inline bool in_straight_current(const Node& node, const LoadInputs& in) {
  double middle = 0, half = 0;
  for (int a = 0; a < 3; ++a) {
    middle += in.up[a] * node.centre[a];
    half += std::abs(in.up[a]) * std::max(node.half[a], least_half(node));
  }
  return in.surface->shear.straight(middle - half, middle + half);
}

/// True if the polynomials miss no more of head and of `Water::u` than the errors allowed, and if
/// u is linear over the faces within its error.
template <Ask kAsk>
inline bool fits(const Node& node, const LoadInputs& in, double error_of_u) {
  const WaveField& waves = in.surface->waves;
  const StretchBounds b = stretch_bounds(waves);
  const double size = size_of(node), decay = largest_decay(node, in);
  const double volume = 1.5 * decay * size * size * size;
  const bool velocity = kAsk == Ask::velocity;
  if (velocity && in.surface->shear.moves && !in_straight_current(node, in)) return false;
  const double unit = M_SQRT2 * (velocity ? 1 : in.surface->gravity);
  const double* sums = velocity ? waves.flow : waves.bends;
  if (unit * volume * third_order(b, sums + 1) > error_of_u) return false;
  const double sag = b.p * b.p * sums[2] * decay * size * size / 2;
  if (in.surface->bends && unit * sag > error_of_u) return false;
  return !velocity || volume * third_order(b, waves.bends) <= in.wave_error;
}

/// The samples of (1): the middle, the faces' middles x, −x, y, …, and the edges' xy, −x−y, yz, ….
constexpr int kSamples = 13;

/// Rows of (1).
inline void fit(const double* f, const Node& node, const double (&h)[3], double (&rows)[kNormal]) {
  double g[3], bend[6];
  for (int a = 0; a < 3; ++a) {
    const double plus = f[1 + 2 * a], minus = f[2 + 2 * a];
    g[a] = (plus - minus) / (2 * h[a]);
    bend[a] = (plus - 2 * f[0] + minus) / (h[a] * h[a]);
  }
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    const double ends = f[1 + 2 * a] + f[2 + 2 * a] + f[1 + 2 * b] + f[2 + 2 * b];
    bend[3 + a] = (f[7 + 2 * a] + f[8 + 2 * a] - ends + 2 * f[0]) / (2 * h[a] * h[b]);
  }
  set_rows(f[0], g, bend, node.centre, rows);
}

/// The water over a branch that is wet all over.
template <Ask kAsk>
inline HWY_NOINLINE void find_branch_water(const Node& node, const LoadInputs& in, LocalSea& sea,
                                           BranchWater& water) {
  constexpr int kRoom = (kSamples + kMostLanes - 1) / kMostLanes * kMostLanes;
  double h[3];
  alignas(64) double r[3][kRoom], f[5][kRoom];
  for (int a = 0; a < 3; ++a) {
    h[a] = std::max(node.half[a], least_half(node));
    std::fill_n(r[a], kRoom, node.centre[a]);
  }
  for (int a = 0; a < 3; ++a)
    for (int side = 0; side < 2; ++side) {
      const double step = side == 0 ? h[a] : -h[a];
      const int next = (a + 2) % 3;
      r[a][1 + 2 * a + side] += step;
      r[a][7 + 2 * a + side] += step;
      r[a][7 + 2 * next + side] += step;
    }
  for (int i = 0; i < kRoom; i += static_cast<int>(hn::Lanes(D()))) {
    const V3 at = {hn::Load(D(), r[0] + i), hn::Load(D(), r[1] + i), hn::Load(D(), r[2] + i)};
    const V rise = rise_at(in, sea, at), depth = depth_below(in, rise, at);
    const Water here = water_around<kAsk>(in, at, depth, rise, sea);
    hn::Store(depth, D(), f[0] + i);
    hn::Store(here.head, D(), f[1] + i);
    hn::Store(here.u.x, D(), f[2] + i);
    hn::Store(here.u.y, D(), f[3] + i);
    hn::Store(here.u.z, D(), f[4] + i);
  }
  fit(f[0], node, h, water.depth);
  fit(f[1], node, h, water.head);
  for (int a = 0; a < 3; ++a) fit(f[2 + a], node, h, water.u[a]);
}

/// A polynomial at places in lanes.
HWY_INLINE V value_at(const double (&rows)[kNormal], const V3& r) {
  const auto row = [&](int i) HWY_ATTR { return all(rows[i]); };
  const V x = hn::MulAdd(row(kSquare), r.x, hn::MulAdd(row(kSquare + 3), r.y, row(kPlace)));
  const V y = hn::MulAdd(row(kSquare + 1), r.y, hn::MulAdd(row(kSquare + 4), r.z, row(kPlace + 1)));
  const V z = hn::MulAdd(row(kSquare + 2), r.z, hn::MulAdd(row(kSquare + 5), r.x, row(kPlace + 2)));
  return hn::MulAdd(x, r.x, hn::MulAdd(y, r.y, hn::MulAdd(z, r.z, row(kOne))));
}

/// `Water::u` alone at the corners of faces.
HWY_INLINE MovingWater flow_at_corners(const BranchWater& water, const Plane& p,
                                       const Triangle& t) {
  const auto at = [&](const V2& corner) HWY_ATTR {
    const V3 r = point_on(p, corner);
    return V3{value_at(water.u[0], r), value_at(water.u[1], r), value_at(water.u[2], r)};
  };
  const Values none = {zero(), zero(), zero()};
  return {none, none, at(t.a), at(t.b), at(t.c)};
}

/// `Water::u` in the middle of a branch. Returns how much it changes to the sides at most.
inline double middle_flow(const Node& node, const BranchWater& water, double (&middle)[3]) {
  double change2 = 0;
  const double *c = node.centre, *h = node.half;
  for (int x = 0; x < 3; ++x) {
    const double(&rows)[kNormal] = water.u[x];
    double change = 0;
    middle[x] = rows[kOne];
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, e = (a + 2) % 3;
      const double square = rows[kSquare + a], mixed = rows[kSquare + 3 + a];
      const double slope =
          rows[kPlace + a] + 2 * square * c[a] + mixed * c[b] + rows[kSquare + 3 + e] * c[e];
      middle[x] += c[a] * (rows[kPlace + a] + square * c[a] + mixed * c[b]);
      change += h[a] * (std::abs(slope) + std::abs(square) * h[a] + std::abs(mixed) * h[b]);
    }
    change2 += change * change;
  }
  return std::sqrt(change2);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

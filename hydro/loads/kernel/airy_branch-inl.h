// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_AIRY_BRANCH) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_AIRY_BRANCH
#undef PLIMSOLL_KERNEL_AIRY_BRANCH
#else
#define PLIMSOLL_KERNEL_AIRY_BRANCH
#endif

#include "hydro/loads/kernel/airy-inl.h"
#include "hydro/loads/kernel/tree-inl.h"

/// @file
/// The water under Airy waves over a whole branch: the head as a polynomial of second order of the
/// place, the velocity as constant.
///
/// With δ the place from the middle of the branch, a wave's phase changes by α = k·δ, and the
/// stretched height z*(ξ(δ), z + up·δ) by ζ = ζ₁ + ζ₂ + …, of first and second order in δ. Then
///
///     C(z*) e^{iθ}  becomes  Σ of (C + k S ζ + ½k² C ζ² …) (1 + iα − ½α² …) e^{iθ}.           (1)
///
/// With |α + ikζ₁| ≤ k p |δ|, |ζ₂| ≤ q |δ|² and |ζ₃| ≤ t |δ|³ the third order that is left out is
/// below
///
///     Σ a C (⅙ k³p³ + k² p q + k t) |δ|³.                                                     (2)
///
/// The velocity changes by less than Σ a (g/σ) √2 k² C p |δ|. C is taken at the highest z* of the
/// branch.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// Wheeler's z*(ξ, z) and its derivatives at a point.
struct Stretch {
  double height;                            ///< z* <= 0 [m].
  double by_z, by_rise, rise_rise, z_rise;  ///< Derivatives by z and ξ.
};

inline Stretch stretch_at(const WaveField& waves, double z, double rise) {
  if (waves.deep) return {z - rise, 1, -1, 0, 0};
  const double h = waves.water_depth, total = std::max(h + rise, 1e-3 * h);
  const double part = h / total;
  return {part * (z - rise), part, -part * (h + z) / total, 2 * part * (h + z) / (total * total),
          -part / total};
}

/// p, q and t of (2).
struct StretchBounds {
  double p, q, t;
};

inline StretchBounds stretch_bounds(const WaveField& w) {
  if (w.deep) return {1 + w.slope, w.curvature / 2, w.third / 6};
  const double h = w.water_depth, part = std::min(w.height / h, 0.9), m = 1 / (1 - part);
  const double by_rise = m * m * (1 + part), e = w.slope;
  return {m + by_rise * e, by_rise * w.curvature / 2 + m * by_rise / h * e * e + m * m / h * e,
          by_rise * w.third / 6 + m * m * by_rise / (h * h) * e * e * e +
              m * m * m / (h * h) * e * e + m * by_rise / h * e * w.curvature +
              m * m / h * w.curvature / 2};
}

/// The water over a branch.
struct BranchWater {
  double depth[kNormal];  ///< Rows of the depth below the surface.
  double head[kNormal];   ///< Rows of the head.
  double velocity[3];     ///< In the middle, relative to the current; body axes [m/s].
  double velocity_error;  ///< Bound of its change over the branch [m/s].
};

/// Sums over the waves at the middle of a branch.
struct WaveSums {
  double rise, rise_g[3], rise_h[6];       ///< ξ, its gradient and second derivatives.
  double head, head_g[3], head_h[6];       ///< Φ and its derivatives at a given z*.
  double along_z, along_z_g[3], along_zz;  ///< ∂Φ/∂z*, its gradient, ∂²Φ/∂z*².
  double velocity[3], upward;              ///< u, but for `upward` times the vertical.
  double third, shear;                     ///< Bound (2) over |δ|³, that of u over |δ|.
  double bend;                             ///< Bound of the change of ∇Φ over |δ| [1/m].
};

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

/// The sums over the waves that depend on z*, in vectors of waves.
inline HWY_NOINLINE void sum_waves(const WaveField& waves, const double* c, double height,
                                   double highest, const StretchBounds& b, WaveSums& sums) {
  V head = zero(), along_z = zero(), along_zz = zero(), upward = zero(), third = zero(),
    shear = zero(), bend = zero(), head_g[3], head_h[6], along_z_g[3], velocity[3];
  for (V& v : head_g) v = zero();
  for (V& v : head_h) v = zero();
  for (V& v : along_z_g) v = zero();
  for (V& v : velocity) v = zero();
  const double p = b.p;
  for (int i = 0; i < waves.count; i += static_cast<int>(hn::Lanes(D()))) {
    const V a = row(waves, WaveField::kAmplitude, i), k = row(waves, WaveField::kNumber, i);
    const V weight = row(waves, WaveField::kWeight, i);
    const V scale = row(waves, WaveField::kVelocity, i);
    const Turn turn = turn_of(phases(waves, c, i));
    const V cosine = a * turn.cosine, sine = a * turn.sine;
    const auto [C, S] = depth_functions(waves, k, weight, all(-height));
    const V top = hn::Abs(a) * depth_functions(waves, k, weight, all(-highest)).C;
    const V Cc = C * cosine, Cs = C * sine, kSc = k * S * cosine, kSs = k * S * sine;
    head = head + Cc;
    along_z = along_z + kSc;
    along_zz = hn::MulAdd(k * k, Cc, along_zz);
    upward = hn::MulAdd(scale, kSs, upward);
    third = hn::MulAdd(top * k,
                       hn::MulAdd(k * k, all(p * p * p / 6), hn::MulAdd(k, all(p * b.q), all(b.t))),
                       third);
    const V second = top * k * k * all(M_SQRT2 * p);
    shear = hn::MulAdd(second, scale, shear);
    bend = bend + second;
    for (int x = 0; x < 3; ++x) {
      const V kx = row(waves, WaveField::kVector + x, i);
      const V ky = row(waves, WaveField::kVector + (x + 1) % 3, i);
      head_g[x] = hn::NegMulAdd(Cs, kx, head_g[x]);
      along_z_g[x] = hn::NegMulAdd(kSs, kx, along_z_g[x]);
      head_h[x] = hn::NegMulAdd(Cc * kx, kx, head_h[x]);
      head_h[3 + x] = hn::NegMulAdd(Cc * kx, ky, head_h[3 + x]);
      velocity[x] = hn::MulAdd(scale * Cc, kx, velocity[x]);
    }
  }
  sums.head = total(head);
  sums.along_z = total(along_z);
  sums.along_zz = total(along_zz);
  sums.upward = total(upward);
  sums.third = total(third);
  sums.shear = total(shear);
  sums.bend = total(bend);
  for (int x = 0; x < 3; ++x) {
    sums.head_g[x] = total(head_g[x]);
    sums.along_z_g[x] = total(along_z_g[x]);
    sums.head_h[x] = total(head_h[x]);
    sums.head_h[3 + x] = total(head_h[3 + x]);
    sums.velocity[x] = total(velocity[x]);
  }
}

/// Rows of head and depth, and the velocity.
inline void set_branch_water(const Node& node, const LoadInputs& in, const WaveSums& s,
                             const Stretch& at, double size, BranchWater& water) {
  const double* up = in.up;
  double g[3], h[6], down[3], rise_h[6];
  for (int a = 0; a < 3; ++a) {
    const double zeta = at.by_z * up[a] + at.by_rise * s.rise_g[a];
    g[a] = s.head_g[a] + s.along_z * zeta - up[a];
    down[a] = s.rise_g[a] - up[a];
  }
  for (int i = 0; i < 6; ++i) {
    const int a = i % 3, b = i < 3 ? a : (a + 1) % 3;
    const double za = at.by_z * up[a] + at.by_rise * s.rise_g[a];
    const double zb = at.by_z * up[b] + at.by_rise * s.rise_g[b];
    const double bend = at.by_rise * s.rise_h[i] + at.rise_rise * s.rise_g[a] * s.rise_g[b] +
                        at.z_rise * (up[a] * s.rise_g[b] + up[b] * s.rise_g[a]);
    h[i] = s.head_h[i] + s.along_z_g[a] * zb + s.along_z_g[b] * za + s.along_zz * za * zb +
           s.along_z * bend;
    rise_h[i] = s.rise_h[i];
  }
  const double* c = node.centre;
  const double still = in.below - (up[0] * c[0] + up[1] * c[1] + up[2] * c[2]);
  set_rows(still + s.head, g, h, c, water.head);
  set_rows(still + s.rise, down, rise_h, c, water.depth);
  for (int a = 0; a < 3; ++a) water.velocity[a] = s.velocity[a] + s.upward * up[a];
  water.velocity_error = s.shear * size;
}

/// Largest distance from the middle of a branch's box [m].
inline double size_of(const Node& node) {
  return std::sqrt(node.half[0] * node.half[0] + node.half[1] * node.half[1] +
                   node.half[2] * node.half[2]);
}

struct BranchSums {
  WaveSums sums;
  Stretch at;
};

/// The sums over the waves for a branch of the given size.
inline BranchSums sum_over_branch(const Node& node, const LoadInputs& in, double size) {
  const WaveField& waves = in.surface->waves;
  BranchSums result;
  WaveSums& sums = result.sums;
  expand_waves(waves, node.centre, sums.rise, sums.rise_g, sums.rise_h);
  double z = -(in.below + in.surface->hidden_depth);
  for (int a = 0; a < 3; ++a) z += in.up[a] * node.centre[a];
  const Stretch at = result.at = stretch_at(waves, z, sums.rise);
  const StretchBounds bounds = stretch_bounds(waves);
  const double highest = std::min(0.0, at.height + bounds.p * size);
  sum_waves(waves, node.centre, std::min(0.0, at.height), highest, bounds, sums);
  return result;
}

/// The water over a branch that is wet all over.
/// @return false if the head is not quadratic within the error allowed
inline bool find_branch_water(const Node& node, const LoadInputs& in, BranchWater& water) {
  const double size = size_of(node);
  const BranchSums at = sum_over_branch(node, in, size);
  // The mean over a plane patch is off by no more than a quarter of what its ends are.
  if (at.sums.third * size * size * size / 4 > in.wave_error) return false;
  set_branch_water(node, in, at.sums, at.at, size, water);
  return true;
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

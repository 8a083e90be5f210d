// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_TREE) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_TREE
#undef PLIMSOLL_KERNEL_TREE
#else
#define PLIMSOLL_KERNEL_TREE
#endif

#include "hydro/loads/kernel/lanes-inl.h"
#include "hydro/loads/kernel/tree.h"

/// @file
/// The loads on whole branches follow from the moments of `tree.h`.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The factors of the moments. They are the same for all branches.
struct Factors {
  double depth[kNormal];              ///< The factors of the rows before kNormal in ∫ h J dS.
  double speed[kNormal];              ///< The factors of the same rows in ∫ |v|² J dS.
  double normal[kMoments - kNormal];  ///< The factors of the rows from kNormal on in ∫ (v·n)² J dS.
  double drag[kMoments - kNormal];  ///< The same for the motion that pressure drag sees.
};

/// Sets the factors of (v·n)² for a twist.
inline void set_normal_factors(const double* v, const double* w,
                               double (&factors)[kMoments - kNormal]) {
  const double twist[6] = {v[0], v[1], v[2], w[0], w[1], w[2]};
  int row = 0;
  for (int b = 0; b < 6; ++b)
    for (int c = b; c < 6; ++c) factors[row++] = (b == c ? 1 : 2) * twist[b] * twist[c];
}

inline Factors factors_of(const LoadInputs& in) {
  const double* v = in.linear;
  const double* w = in.angular;
  Factors f = {{in.below, -in.up[0], -in.up[1], -in.up[2], 0, 0, 0, 0, 0, 0}, {}, {}, {}};
  f.speed[kOne] = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    f.speed[kPlace + i] = 2 * (v[j] * w[k] - v[k] * w[j]);
    f.speed[kSquare + i] = w[j] * w[j] + w[k] * w[k];
    f.speed[kSquare + 3 + i] = -2 * w[i] * w[j];
  }
  set_normal_factors(in.linear, w, f.normal);
  set_normal_factors(in.drag_linear, w, f.drag);
  return f;
}

/// The sum of rows [from, to) of a node's moments times their factors, for the lanes from `a` on.
HWY_INLINE V moment_product(const Node& node, const double* factor, int from, int to, int a) {
  const D d;
  V even = zero(), odd = zero();  // The adders work on two sums at once.
  int k = from;
  for (; k + 1 < to; k += 2) {
    even = hn::MulAdd(all(factor[k - from]), hn::Load(d, node.moment[k] + a), even);
    odd = hn::MulAdd(all(factor[k + 1 - from]), hn::Load(d, node.moment[k + 1] + a), odd);
  }
  if (k < to) even = hn::MulAdd(all(factor[k - from]), hn::Load(d, node.moment[k] + a), even);
  return even + odd;
}

// The lanes are components here. Each goes to lane 0 of its sum.

/// Adds the buoyancy of a branch that is wet all over.
/// @param head   Factors of the rows of the head.
HWY_INLINE void add_branch_buoyancy(const Node& node, const double (&head)[kNormal],
                                    const LoadInputs& in, Sums& sums) {
  alignas(64) double load[kMostLanes];
  for (int a = 0; a < kMostLanes; a += static_cast<int>(hn::Lanes(D())))
    hn::Store(moment_product(node, head, kOne, in.surface ? kNormal : kSquare, a), D(), load + a);
  for (int a = 0; a < 6; ++a) sums.lane[kBuoyancy + a][0] -= load[a];
}

/// Adds the volume below the surface.
/// @param depth   Factors of the rows of the depth.
HWY_INLINE void add_branch_volume(const Node& node, const double (&depth)[kNormal],
                                  const LoadInputs& in, Sums& sums) {
  alignas(64) double load[kMostLanes];
  for (int a = 0; a < kMostLanes; a += static_cast<int>(hn::Lanes(D())))
    hn::Store(moment_product(node, depth, kOne, kNormal, a), D(), load + a);
  for (int a = 0; a < 3; ++a) sums.lane[kVolume][0] -= in.up[a] * load[a];
}

/// Adds the area of a branch that is wet all over and the loads of its motion; `drag` is ½ρC_p with
/// the sign of v·n.
HWY_INLINE void add_branch_motion(const Node& node, const Factors& f, const LoadInputs& in,
                                  double drag, Sums& sums) {
  sums.lane[kArea][0] += node.moment[kOne][kAreaLane];
  if (!in.moving) return;
  alignas(64) double load[2][kMostLanes];
  for (int a = 0; a < kMostLanes; a += static_cast<int>(hn::Lanes(D()))) {
    V normal = moment_product(node, f.drag, kNormal, kMoments, a);
    hn::Store(all(-drag) * normal, D(), load[0] + a);
    if (in.lift == 0) continue;
    if (in.slender) normal = moment_product(node, f.normal, kNormal, kMoments, a);
    const V whole = moment_product(node, f.speed, kOne, kNormal, a);
    hn::Store(all(in.lift) * (normal - whole), D(), load[1] + a);
  }
  for (int a = 0; a < 6; ++a) {
    sums.lane[kPressureDrag + a][0] += load[0][a];
    if (in.lift != 0) sums.lane[kLift + a][0] += load[1][a];
  }
}

struct Range {
  double low, high;
};

/// The range of a linear function with the given gradient over a box.
inline Range range_over(const double* centre, const double* half, const double* gradient, int n,
                        double constant) {
  double middle = constant, reach = 0;
  for (int i = 0; i < n; ++i) {
    middle += gradient[i] * centre[i];
    reach += std::abs(gradient[i]) * half[i];
  }
  return {middle - reach, middle + reach};
}

inline Range depth_range(const Node& node, const LoadInputs& in) {
  const double down[3] = {-in.up[0], -in.up[1], -in.up[2]};
  return range_over(node.centre, node.half, down, 3, in.below);
}

/// The range of v·n over a branch, with the angular velocity of `in`.
inline Range normal_speed_range(const Node& node, const double (&linear)[3], const LoadInputs& in) {
  const double twist[6] = {linear[0],     linear[1],     linear[2],
                           in.angular[0], in.angular[1], in.angular[2]};
  return range_over(node.j_centre, node.j_half, twist, 6, 0);
}

/// True if all faces of a branch move into the water, or all out of it, as pressure drag sees them;
/// then `drag` is ½ρC_p with the sign of the motion.
/// @param error   Error that the motion relative to the water may have [m/s].
HWY_INLINE bool of_one_sign(const Node& node, const LoadInputs& in, double error, double& drag) {
  drag = 0;
  if (!in.moving || (in.drag_front == 0 && in.drag_back == 0)) return true;
  const Range normal = normal_speed_range(node, in.drag_linear, in);
  drag = normal.high > 0 ? in.drag_front : -in.drag_back;
  return normal.low >= error || normal.high <= -error;
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

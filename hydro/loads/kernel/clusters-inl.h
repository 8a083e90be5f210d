// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_CLUSTERS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_CLUSTERS
#undef PLIMSOLL_KERNEL_CLUSTERS
#else
#define PLIMSOLL_KERNEL_CLUSTERS
#endif

#include <algorithm>
#include <cmath>

#include "hydro/loads/kernel/clusters.h"
#include "hydro/loads/kernel/viscous-inl.h"

/// @file
/// Viscous drag of whole branches by the points of `clusters.h`, where the bound (1) there allows.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The motion of a branch relative to the water, and its tangential speeds [m/s].
struct BranchMotion {
  double speed, turning;     ///< |v| at the centre; |ω| [rad/s].
  double middle, low, high;  ///< |v_t| for the normal m, and its bounds all over the branch.
};

/// With a the direction of v_t in the middle, a·m = 0, so a·δ = a·(I − N) (ω × x) − (a·n) (v·n):
/// what is across a hardly changes the speed.
inline BranchMotion motion_of(const Cluster& cluster, const Immersion& in) {
  const double* c = cluster.centre;
  const double* w = in.angular;
  double v[3], speed2 = 0, normal = 0, turning2 = 0, about = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    v[i] = in.linear[i] + w[j] * c[k] - w[k] * c[j];
    speed2 += v[i] * v[i];
    normal += v[i] * cluster.normal[i];
    turning2 += w[i] * w[i];
  }
  BranchMotion m{std::sqrt(speed2), std::sqrt(turning2), 0, 0, 0};
  m.middle = std::sqrt(std::max(0.0, speed2 - normal * normal));
  if (!(m.middle > 0)) return m;
  for (int i = 0; i < 3; ++i) about += (v[i] - normal * cluster.normal[i]) * w[i] / m.middle;
  const double across = std::sqrt(std::max(0.0, turning2 - about * about));  // |a × ω|
  const double tilt = cluster.most_tilt, extent = cluster.most_extent;
  const double along =
      tilt * (std::abs(normal) + tilt * m.speed) + extent * (across + tilt * m.turning);
  const double change = m.speed * tilt + m.turning * extent;
  m.low = m.middle - std::min(along, change);
  const double ahead = m.middle + along;
  m.high = std::min(std::sqrt(ahead * ahead + change * change), m.middle + change);
  return m;
}

/// |f| and bounds of the derivatives of f(v_t) = C_v |v_t| v_t.
struct Steepness {
  double middle[kGaps + 1];  ///< In the middle, from |f| on, as maps of tensors, in their norm.
  double second, third, fifth, sixth;  ///< Along one direction, all over the branch.
  double beyond;  ///< What f departs from that by, on the other side of a kink.
};

/// Those of C_v |v| v for C_v = 1 and |v| = 1, from its power series; on the ITTC line, whose C_v
/// falls slowly, they are less, but for the fifth and sixth by 1.4 %, which are those here.
inline constexpr double kMiddle[kGaps + 1] = {1, 2, 2.4495, 3.4642, 6.9283, 29.4};
inline constexpr double kSecond = 2, kThird = 3, kFifth = 15, kSixth = 58;

inline Steepness quadratic(double coefficient, const BranchMotion& m) {
  const double c = coefficient, over = 1 / m.low, over_middle = 1 / m.middle;
  Steepness f{{}, c * kSecond, c * kThird * over, c * kFifth * over * over * over, 0, 0};
  f.sixth = c * kSixth * over * over * over * over;
  double power = c * m.middle * m.middle;
  for (int k = 0; k <= kGaps; ++k, power *= over_middle) f.middle[k] = kMiddle[k] * power;
  return f;
}

/// Adds those of coefficient·|v|² v.
inline void add_cubic(double coefficient, const BranchMotion& m, Steepness& f) {
  constexpr double kCubeSecond = 6.6333, kCubeThird = 7.746;  // √44 and √60.
  const double c = std::abs(coefficient), s = m.middle;
  f.middle[1] += c * 3 * s * s;
  f.middle[2] += c * kCubeSecond * s;
  f.middle[3] += c * kCubeThird;
  f.second += c * 6 * m.high;
  f.third += c * 6;
}

/// C_v of the thesis. At a kink the formulas of its sides differ by 0.1 |s − kink| s².
inline Steepness steepness_of_thesis(const BranchMotion& m) {
  const auto over = [](double speed) { return std::max(0.0, speed); };
  if (m.middle >= 2) return {.beyond = 0.1 * over(2 - m.low) * 4};
  const bool slow = m.middle < 1;
  Steepness f = quadratic(slow ? 0.1 : 0.2, m);
  if (!slow) add_cubic(-0.1, m, f);
  const double far = over(m.high - (slow ? 1 : 2)) * m.high * m.high;
  f.beyond = 0.1 * (far + (slow ? 0 : over(1 - m.low)));
  return f;
}

/// False where a kink without a bound lies on the branch.
inline bool find_steepness(const ViscousDrag& law, const BranchMotion& m, Steepness& f) {
  if (law.law == ViscousDrag::Law::constant) {
    f = quadratic(law.coefficient, m);
  } else if (law.law == ViscousDrag::Law::thesis) {
    f = steepness_of_thesis(m);
  } else if (m.high * law.reynolds_per_speed <= kLeastReynolds) {
    f = quadratic(kHeldCoefficient, m);
  } else if (m.low * law.reynolds_per_speed >= kLeastReynolds) {
    const double decades = std::log10(m.low * law.reynolds_per_speed) - 2;
    f = quadratic(0.075 / (decades * decades), m);
  } else {
    return false;
  }
  return true;
}

/// Bound of ‖δ‖ [m/s].
inline double mean_change(const Cluster& c, const BranchMotion& m) {
  return c.tilt6 * m.speed + c.extent6 * m.turning;
}

/// Bound of the error per area of ∫ C_v |v_t| v_t dS by a branch's points, and of its moment about
/// the centre of mass divided by the hull's radius [m^2/s^2].
inline double error_of(const Cluster& c, const Immersion& in, const BranchMotion& m,
                       const Steepness& f) {
  const double tilting = c.tilt * m.speed, turning = c.extent * m.turning;
  const double tau = std::sqrt(tilting * tilting + turning * turning);
  const double mean = mean_change(c, m), mean2 = mean * mean;
  const double mean5 = mean2 * mean2 * mean;
  constexpr double kCross = M_SQRT2;  // Norm of a cross product, as a map of its factors' dyad.
  double force = 2.0 / 720 * f.sixth * mean5 * mean;
  double moment = c.extent6 * 2.0 / 120 * f.fifth * mean5 + c.extent * f.middle[0] * c.gap[0];
  constexpr double kInverse[kGaps + 1] = {0, 1, 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5};
  double power = 1;
  for (int k = 1; k <= kGaps; ++k) {
    power *= tau * kInverse[k];
    force += f.middle[k] * power * c.gap[k - 1];
    if (k < kGaps) moment += kCross * c.extent * f.middle[k] * power * c.gap[k];
  }
  // On a face, which has points of its own, the error is of third order: the mean cube of the
  // places on it is less than that of its vertices, and that of its points an eighth.
  const double cube = 9.0 / 8 * c.face3 * m.turning * m.turning;
  const double apart = 2 * f.beyond + cube * m.turning * f.third / 6;
  force += apart;
  moment += c.most_extent * apart + cube * f.second / 2;
  return std::max(force, (c.lever * force + moment) / in.radius);
}

/// The points in lanes. Beyond the last they have no area.
HWY_NOINLINE void add_points(const Cluster& cluster, const Immersion& in, Sums& sums) {
  const D d;
  const V3 linear = all3(in.linear), angular = all3(in.angular);
  const auto load = [&](const double(&field)[3][kMostPoints], int i) HWY_ATTR {
    return V3{hn::Load(d, field[0] + i), hn::Load(d, field[1] + i), hn::Load(d, field[2] + i)};
  };
  V3 force = {zero(), zero(), zero()}, moment = force;
  for (int i = 0; i < cluster.count; i += static_cast<int>(hn::Lanes(d))) {
    const V3 r = load(cluster.r, i), n = load(cluster.n, i);
    const V3 v = linear + cross(angular, r);
    const V normal = dot(v, n);
    const V3 along = {hn::NegMulAdd(normal, n.x, v.x), hn::NegMulAdd(normal, n.y, v.y),
                      hn::NegMulAdd(normal, n.z, v.z)};
    const V speed = hn::Sqrt(dot(along, along));
    const V c = coefficient(*in.viscous, branch_at(*in.viscous, speed), speed);
    const V factor = hn::Load(d, cluster.area + i) * c * speed;
    const V3 f = {factor * along.x, factor * along.y, factor * along.z};
    force = force + f;
    moment = moment + cross(r, f);
  }
  const V scale = all(-in.half_density);
  add(sums, kViscousDrag, V3{scale * force.x, scale * force.y, scale * force.z});
  add(sums, kViscousDrag + 3, V3{scale * moment.x, scale * moment.y, scale * moment.z});
}

/// Adds the viscous drag of a wet branch if its points give it within the tolerance.
HWY_INLINE bool add_cluster(const Cluster& cluster, const Immersion& in, Sums& sums) {
  const BranchMotion m = motion_of(cluster, in);
  // A sixth of the traction may be wrong from there on: no tolerance is that large.
  if (!(m.low > mean_change(cluster, m))) return false;
  if (in.viscous->law == ViscousDrag::Law::thesis && m.low >= 2) return true;
  Steepness f;
  if (!find_steepness(*in.viscous, m, f)) return false;
  if (!(error_of(cluster, in, m, f) <= in.viscous_error)) return false;
  add_points(cluster, in, sums);
  return true;
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

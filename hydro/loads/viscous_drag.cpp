#include "hydro/loads/viscous_drag.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/loads/rotary_drag.h"

namespace hydro {
namespace {

/// Depth at which splitting ends whatever the error: a piece then has 4^-12 of the panel's area.
constexpr int kMaxDepth = 12;

/// Limits of the velocity's change over a panel relative to the velocity itself.
struct Ratios {
  /// Limit for the rule of degree 5: the first term that it misses is of sixth order.
  double smooth;
  /// Limit for cutting a panel along a straight line of given |v_t|: the curvature of the true line
  /// causes a third-order error.
  double straight;
};

/// With these ratios errors are below 1e-7 and 1e-6.
constexpr Ratios kForAdaptive = {0.2, 0.05};

/// With these ratios errors are below 1e-10; beyond them the closed form has more than ten digits.
constexpr Ratios kBesideClosedForm = {0.05, 0.002};

/// The laws that `rotary_drag` integrates.
constexpr std::array<DragPiece, 3> kThesisPieces = {{{0, 0.1, 0}, {1, 0.2, -0.1}, {2, 0, 0}}};

/// Reynolds number below which C_v of the ITTC line is constant: the line is meant for ships and
/// has a pole at 100.
constexpr double kLeastReynolds = 1e4;

/// Speeds where C_v has a kink [m/s], ascending.
struct Kinks {
  std::array<double, 2> speed = {};
  int count = 0;

  const double* begin() const { return speed.data(); }
  const double* end() const { return speed.data() + count; }
};

Kinks kinks_of(const ViscousDrag& law) {
  if (law.law == ViscousDrag::Law::thesis) return {{1, 2}, 2};
  if (law.law == ViscousDrag::Law::ittc57) return {{kLeastReynolds / law.reynolds_per_speed}, 1};
  return {};
}

double thesis_coefficient(double inside, double speed) {
  if (inside < 1) return 0.1;
  return inside < 2 ? 0.2 - 0.1 * speed : 0;
}

double ittc57_coefficient(double inside_reynolds, double reynolds) {
  const double held = inside_reynolds < kLeastReynolds ? kLeastReynolds : reynolds;
  const double decades = std::log10(held) - 2;
  return 0.075 / (decades * decades);
}

/// C_v at `speed` by the formula that holds at `inside`, on the same side of every kink.
double coefficient_on_branch(const ViscousDrag& law, double inside, double speed) {
  switch (law.law) {
    case ViscousDrag::Law::none:
      return 0;
    case ViscousDrag::Law::constant:
      return law.coefficient;
    case ViscousDrag::Law::thesis:
      return thesis_coefficient(inside, speed);
    case ViscousDrag::Law::ittc57:
      return ittc57_coefficient(inside * law.reynolds_per_speed, speed * law.reynolds_per_speed);
  }
  return 0;
}

/// The tangential velocity on a panel's plane, an affine function of position.
struct SlidingFlow {
  const Twist& motion;
  const Eigen::Vector3d& normal;
  const ViscousDrag& law;
  Kinks kinks;

  Eigen::Vector3d at(const Eigen::Vector3d& r) const {
    const Eigen::Vector3d v = motion.at(r);
    return v - v.dot(normal) * normal;
  }
};

struct Node {
  double a, b, c, weight;
};

/// Radon's rule of degree 5.
std::array<Node, 7> radon_rule() {
  const double root = std::sqrt(15.0);
  const double near = (6 - root) / 21;
  const double far = (6 + root) / 21;
  const double w_near = (155 - root) / 1200;
  const double w_far = (155 + root) / 1200;
  return {{{1.0 / 3, 1.0 / 3, 1.0 / 3, 9.0 / 40},
           {near, near, 1 - 2 * near, w_near},
           {near, 1 - 2 * near, near, w_near},
           {1 - 2 * near, near, near, w_near},
           {far, far, 1 - 2 * far, w_far},
           {far, 1 - 2 * far, far, w_far},
           {1 - 2 * far, far, far, w_far}}};
}

const std::array<Node, 7> kRadon = radon_rule();

/// ∫ C_v |v_t| v_t dA and its moment by the seven-point rule, on the branch of C_v that holds at
/// the panel's centre, without the factor −½ρ.
Wrench seven_points(const Panel& panel, const SlidingFlow& flow) {
  Wrench sum;
  double inside = 0;
  for (const Node& node : kRadon) {
    const Eigen::Vector3d r = node.a * panel[0] + node.b * panel[1] + node.c * panel[2];
    const Eigen::Vector3d v = flow.at(r);
    const double speed = v.norm();
    if (&node == kRadon.data()) inside = speed;
    const double c_v = coefficient_on_branch(flow.law, inside, speed);
    const Eigen::Vector3d traction = node.weight * c_v * speed * v;
    sum.force += traction;
    sum.moment += r.cross(traction);
  }
  return area_vector(panel).norm() * sum;
}

/// The integral of seven_points for a panel that crosses kinks from `kink` on: the panel is cut
/// where the speed, taken as linear, reaches them.
Wrench cut_at_kinks(const Panel& panel, const SlidingFlow& flow, const double* kink) {
  if (kink == flow.kinks.end()) return seven_points(panel, flow);
  Eigen::Vector3d excess;
  for (int i = 0; i < 3; ++i) excess[i] = flow.at(panel[i]).norm() - *kink;
  Wrench sum;
  for (const PanelPart& slow : positive_part(panel, -excess)) sum += seven_points(slow.panel, flow);
  for (const PanelPart& fast : positive_part(panel, excess))
    sum += cut_at_kinks(fast.panel, flow, kink + 1);
  return sum;
}

std::array<Panel, 4> split_in_four(const Panel& r) {
  const Eigen::Vector3d m0 = 0.5 * (r[1] + r[2]);
  const Eigen::Vector3d m1 = 0.5 * (r[2] + r[0]);
  const Eigen::Vector3d m2 = 0.5 * (r[0] + r[1]);
  return {{{r[0], m2, m1}, {m2, r[1], m0}, {m1, m0, r[2]}, {m0, m1, m2}}};
}

/// Bounds of |v_t| over a panel, and its largest change from the centre, since v_t rotates about
/// the normal.
struct SpeedRange {
  double low, high, change;
};

SpeedRange speed_range(const Panel& panel, const SlidingFlow& flow) {
  const Eigen::Vector3d center = (panel[0] + panel[1] + panel[2]) / 3;
  double size_squared = 0;
  for (const Eigen::Vector3d& r : panel)
    size_squared = std::max(size_squared, (r - center).squaredNorm());
  const double middle = flow.at(center).norm();
  const double change = std::abs(flow.motion.angular.dot(flow.normal)) * std::sqrt(size_squared);
  return {std::max(0.0, middle - change), middle + change, change};
}

bool contains_kink(const Kinks& kinks, const SpeedRange& range) {
  return std::any_of(kinks.begin(), kinks.end(),
                     [&](double kink) { return range.low < kink && kink < range.high; });
}

/// Error that `adaptive` may leave in the force and, times the lever arm, in the moment.
struct Allowance {
  double force, arm;
  bool covers(const Wrench& error) const {
    return error.force.norm() <= force && error.moment.norm() <= force * arm;
  }
};

/// The ITTC line by splitting. Where it is held the closed form ends the splitting.
Wrench adaptive(const Panel& panel, const SlidingFlow& flow, Allowance allowance, int depth) {
  const SpeedRange range = speed_range(panel, flow);
  if (range.high == 0) return {};
  const bool kink = contains_kink(flow.kinks, range);
  const double enough = (kink ? kForAdaptive.straight : kForAdaptive.smooth) * range.low;
  if (range.change <= enough) return cut_at_kinks(panel, flow, flow.kinks.begin());
  if (range.high <= *flow.kinks.begin()) {
    const std::array<DragPiece, 1> held = {{{0, viscous_coefficient(flow.law, 0), 0}}};
    return rotary_drag(panel, flow.normal, flow.motion, held);
  }
  const std::array<Panel, 4> children = split_in_four(panel);
  Wrench fine;
  for (const Panel& child : children) fine += cut_at_kinks(child, flow, flow.kinks.begin());
  const Wrench coarse = cut_at_kinks(panel, flow, flow.kinks.begin());
  if (depth == kMaxDepth || allowance.covers(fine + -1.0 * coarse)) return fine;
  allowance.force /= 2;
  Wrench sum;
  for (const Panel& child : children) sum += adaptive(child, flow, allowance, depth + 1);
  return sum;
}

Wrench adaptive(const Panel& panel, const SlidingFlow& flow) {
  const SpeedRange range = speed_range(panel, flow);
  const double arm = std::max({panel[0].norm(), panel[1].norm(), panel[2].norm()});
  const double largest = area_vector(panel).norm() * range.high * range.high *
                         viscous_coefficient(flow.law, range.low);
  return adaptive(panel, flow, {kViscousTolerance * largest, arm}, 0);
}

/// ∫ C_v |v_t| v_t dA and its moment for laws that are piecewise linear in the speed.
Wrench by_pieces(const Panel& panel, const SlidingFlow& flow) {
  const SpeedRange range = speed_range(panel, flow);
  const bool thesis = flow.law.law == ViscousDrag::Law::thesis;
  if (range.high == 0 || (thesis && range.low >= 2)) return {};
  const bool kink = contains_kink(flow.kinks, range);
  if (!kink && range.change <= kBesideClosedForm.smooth * range.low)
    return seven_points(panel, flow);
  if (kink && range.change <= kBesideClosedForm.straight * range.low)
    return cut_at_kinks(panel, flow, flow.kinks.begin());
  if (thesis) return rotary_drag(panel, flow.normal, flow.motion, kThesisPieces);
  const std::array<DragPiece, 1> constant = {{{0, flow.law.coefficient, 0}}};
  return rotary_drag(panel, flow.normal, flow.motion, constant);
}

}  // namespace

double viscous_coefficient(const ViscousDrag& law, double speed) {
  return coefficient_on_branch(law, speed, speed);
}

Wrench viscous_drag_load(const Panel& panel, const Eigen::Vector3d& normal, const Twist& motion,
                         const ViscousDrag& law, double half_density) {
  if (law.none()) return {};
  const SlidingFlow flow{motion, normal, law, kinks_of(law)};
  const bool smooth = law.law == ViscousDrag::Law::ittc57;
  return -half_density * (smooth ? adaptive(panel, flow) : by_pieces(panel, flow));
}

}  // namespace hydro

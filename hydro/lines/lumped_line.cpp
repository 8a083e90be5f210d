#include "hydro/lines/lumped_line.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "hydro/airy_waves.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// The line sinks into the bottom by this part of its diameter [-], or of a segment's length.
constexpr double kSinks = 0.1, kSinksOfSegment = 1e-3;
/// Friction of the bottom is less below this speed [m/s].
constexpr double kSticks = 0.01;
/// A step is solved when Newton's last change is this small over the length of a segment [-]: what
/// is left is of its square.
constexpr double kSolved = 1e-7;
constexpr int kMostNewtonSteps = 50;
/// Part of the slope at the start that a line search may leave [-].
constexpr double kSlopeLeft = 0.5;
constexpr int kMostHalvings = 30;
/// At rest a line moves by less than this part of its length in a step [-].
constexpr double kAtRest = 1e-11;
constexpr int kMostRestSteps = 400;

Matrix3d along(const Vector3d& direction) { return direction * direction.transpose(); }

Vector3d direction_of(const Vector3d& d) {
  const double length = d.norm();
  return length > 0 ? Vector3d(d / length) : Vector3d(Vector3d::Zero());
}

/// What acts on a node in a step, but for the springs: G x'' + C x' = load.
struct NodeTerms {
  Matrix3d inertia, damping;
  Vector3d load;
  double bottom = 0;  ///< Stiffness of the bottom [N/m].
};

/// The equations of a step: (2) as x' = rate x + …, x'' = rate x' + …
struct Equations {
  const LumpedLine& line;
  double l;            ///< Length of a segment.
  double rate;         ///< 3/2h
  Matrix3Xd expected;  ///< Shape that is expected.
  Matrix3Xd moving;    ///< x' at x = 0.
  Matrix3Xd speeding;  ///< x'' at x' = 0.
  std::vector<NodeTerms> nodes;
  std::vector<Matrix3d> dampers;  ///< Of the segments.
};

/// The direction of the line at a node of a shape.
Vector3d tangent(const Matrix3Xd& x, Index i) {
  return direction_of(x.col(std::min(i + 1, x.cols() - 1)) - x.col(std::max<Index>(i - 1, 0)));
}

/// The part of the line about a node that is under water: all at a depth of half its height.
double wet_part(double depth, double half_height) {
  return std::clamp(0.5 + depth / (2 * half_height), 0.0, 1.0);
}

/// Adds what the water does to a node of the length l.
void add_water(const LumpedLine& line, double l, const Vector3d& t, const WaterMotion& water,
               const Vector3d& velocity, double density, NodeTerms& node) {
  const Matrix3d T = along(t), P = Matrix3d::Identity() - T;
  const double displaced = density * std::numbers::pi / 4 * line.diameter * line.diameter * l;
  node.inertia += line.added_mass * displaced * P;
  node.load += (1 + line.added_mass) * displaced * P * water.acceleration;
  const Vector3d r = water.velocity - velocity;
  const double area = density / 2 * line.diameter * l;
  const Matrix3d drag = area * (line.drag_across * (P * r).norm() * P +
                                std::numbers::pi * line.drag_along * std::abs(t.dot(r)) * T);
  node.damping += drag;
  node.load += drag * water.velocity;
}

void add_bottom(const LumpedLine& line, double l, const Vector3d& x, const Vector3d& velocity,
                NodeTerms& node) {
  const double sinks = line.diameter > 0 ? kSinks * line.diameter : kSinksOfSegment * l;
  const double mass = line.mass * l;
  node.bottom = std::max(line.weight, line.mass * line.gravity) * l / sinks;
  const double depth = line.bottom - x.z();
  if (!(depth > 0)) return;
  node.damping(2, 2) += 2 * std::sqrt(node.bottom * mass);
  const double friction =
      line.friction * node.bottom * depth / std::max(kSticks, velocity.head<2>().norm());
  node.damping(0, 0) += friction;
  node.damping(1, 1) += friction;
}

/// @param x, v   Expected places and velocities of the nodes.
NodeTerms terms_of(const LumpedLine& line, double l, const Matrix3Xd& x, const Matrix3Xd& v,
                   Index i, const Sea* sea, double time) {
  const bool end = i == 0 || i == x.cols() - 1;
  const double own = end ? l / 2 : l;
  NodeTerms node{.inertia = line.mass * own * Matrix3d::Identity(),
                 .damping = Matrix3d::Zero(),
                 .load = Vector3d::Zero()};
  double wet = 0;
  if (sea) {
    const Vector3d t = tangent(x, i), at = x.col(i);
    const double half_height = std::max({l / 2 * std::abs(t.z()), line.diameter / 2, 1e-6 * l});
    wet = wet_part(surface_height(*sea, at.x(), at.y(), time) - at.z(), half_height);
    if (wet > 0 && line.diameter > 0)
      add_water(line, wet * own, t, water_at(*sea, at, time), v.col(i), sea->density, node);
  }
  const double weight =
      sea ? wet * line.weight + (1 - wet) * line.mass * line.gravity : line.weight;
  node.load.z() -= weight * own;
  if (std::isfinite(line.bottom)) add_bottom(line, own, x.col(i), v.col(i), node);
  return node;
}

/// The slope of the energy at the nodes, and the blocks of its second derivatives.
struct Slope {
  Matrix3Xd residual;
  std::vector<Matrix3d> diagonal, beside;  ///< The latter couples a node with the next one.
};

void add_segment(const Equations& e, const Matrix3Xd& x, const Matrix3Xd& v, Index i, Slope& s) {
  const Vector3d d = x.col(i + 1) - x.col(i);
  const double length = d.norm(), stretch = length - e.l;
  Matrix3d K = e.rate * e.dampers[static_cast<std::size_t>(i)];
  Vector3d pull = e.dampers[static_cast<std::size_t>(i)] * (v.col(i + 1) - v.col(i));
  if (stretch > 0) {
    const Matrix3d n = along(d / length);
    const double T = e.line.stiffness / e.l * stretch;
    pull += T / length * d;
    K += e.line.stiffness / e.l * n + T / length * (Matrix3d::Identity() - n);
  }
  s.residual.col(i) -= pull;
  s.residual.col(i + 1) += pull;
  s.diagonal[static_cast<std::size_t>(i)] += K;
  s.diagonal[static_cast<std::size_t>(i + 1)] += K;
  s.beside[static_cast<std::size_t>(i)] = -K;
}

void find_slope(const Equations& e, const Matrix3Xd& x, Slope& s) {
  const auto count = static_cast<std::size_t>(x.cols());
  s.residual.setZero(3, x.cols());
  s.diagonal.assign(count, Matrix3d::Zero());
  s.beside.resize(count - 1);
  const Matrix3Xd v = e.rate * x + e.moving;
  for (Index i = 0; i < x.cols(); ++i) {
    const NodeTerms& node = e.nodes[static_cast<std::size_t>(i)];
    s.residual.col(i) += node.inertia * (e.rate * v.col(i) + e.speeding.col(i)) +
                         node.damping * v.col(i) - node.load;
    Matrix3d& K = s.diagonal[static_cast<std::size_t>(i)];
    K += e.rate * (e.rate * node.inertia + node.damping);
    const double depth = e.line.bottom - x(2, i);
    if (!(depth > 0)) continue;
    s.residual(2, i) -= node.bottom * depth;
    K(2, 2) += node.bottom;
  }
  for (Index i = 0; i + 1 < x.cols(); ++i) add_segment(e, x, v, i, s);
}

/// Newton's change of the nodes between the ends: a system of blocks on three diagonals.
Matrix3Xd newton_change(const Slope& s) {
  const Index last = s.residual.cols() - 2;
  Matrix3Xd change = Matrix3Xd::Zero(3, s.residual.cols());
  std::vector<Matrix3d> inverse(s.diagonal.size());
  for (Index i = 1; i <= last; ++i) {
    const auto k = static_cast<std::size_t>(i);
    Matrix3d own = s.diagonal[k];
    Vector3d side = -s.residual.col(i);
    if (i > 1) {
      const Matrix3d factor = s.beside[k - 1] * inverse[k - 1];
      own -= factor * s.beside[k - 1];
      side -= factor * change.col(i - 1);
    }
    inverse[k] = own.inverse();
    change.col(i) = side;
  }
  for (Index i = last; i >= 1; --i) {
    const auto k = static_cast<std::size_t>(i);
    Vector3d side = change.col(i);
    if (i < last) side -= s.beside[k] * change.col(i + 1);
    change.col(i) = inverse[k] * side;
  }
  return change;
}

double product(const Matrix3Xd& residual, const Matrix3Xd& change) {
  return residual.cwiseProduct(change).sum();
}

/// Moves the nodes between the ends to the least energy. @return the slope there
Slope solve(const Equations& e, Matrix3Xd& x) {
  Slope s, there;
  find_slope(e, x, s);
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    const Matrix3Xd change = newton_change(s);
    const double slope = product(s.residual, change);
    if (!(slope < 0)) break;  // It is at the least energy, but for round-off.
    double part = 1;
    Matrix3Xd next = x + change;
    find_slope(e, next, there);
    // The energy is convex: the slope along the change grows. Past the least energy it is positive.
    for (int k = 0; k < kMostHalvings; ++k) {
      const double found = product(there.residual, change);
      if (found <= -kSlopeLeft * slope) break;
      part *= std::clamp(slope / (slope - found), 0.1, 0.9);
      next = x + part * change;
      find_slope(e, next, there);
    }
    x = next;
    std::swap(s, there);
    if (part == 1 && change.colwise().norm().maxCoeff() <= kSolved * e.l) break;
  }
  return s;
}

Equations equations_of(const LumpedLine& line, double length, const LineEnds& ends,
                       const LumpedState& state, const Sea* sea, double time, double h) {
  assert(state.places.cols() == line.segments + 1);
  const double l = length / line.segments;
  Equations e{.line = line,
              .l = l,
              .rate = 1.5 / h,
              .expected = 2 * state.places - state.places_before,
              .moving = (state.places_before - 4 * state.places) / (2 * h),
              .speeding = (state.velocities_before - 4 * state.velocities) / (2 * h)};
  e.expected.col(0) = ends.col(0);
  e.expected.col(line.segments) = ends.col(1);
  const Matrix3Xd velocities = 2 * state.velocities - state.velocities_before;
  for (Index i = 0; i < e.expected.cols(); ++i)
    e.nodes.push_back(terms_of(line, l, e.expected, velocities, i, sea, time));
  for (Index i = 0; i < line.segments; ++i) {
    const Vector3d d = e.expected.col(i + 1) - e.expected.col(i);
    const double damping = d.norm() > l ? line.damping : 0;
    e.dampers.push_back(damping * along(direction_of(d)));
  }
  return e;
}

LineEnds forces_of(const Slope& slope) {
  LineEnds forces;
  forces << -slope.residual.leftCols<1>(), -slope.residual.rightCols<1>();
  return forces;
}

/// The blocks of the ends after those between are taken out of the system.
std::array<Matrix3d, 2> stiffness_of_ends(const Slope& s) {
  const std::size_t last = s.diagonal.size() - 1;
  Matrix3d from_first = s.diagonal[0], from_last = s.diagonal[last];
  if (last > 1) {
    from_first = s.diagonal[1];
    from_last = s.diagonal[last - 1];
    for (std::size_t k = 2; k < last; ++k) {
      from_first = s.diagonal[k] - s.beside[k - 1] * from_first.inverse() * s.beside[k - 1];
      const std::size_t m = last - k;
      from_last = s.diagonal[m] - s.beside[m] * from_last.inverse() * s.beside[m];
    }
    const Matrix3d at_last =
        s.diagonal[last] - s.beside[last - 1] * from_first.inverse() * s.beside[last - 1];
    from_first = s.diagonal[0] - s.beside[0] * from_last.inverse() * s.beside[0];
    from_last = at_last;
  }
  return {from_first, from_last};
}

}  // namespace

LineResponse response(const LumpedLine& line, double length, const LineEnds& ends, const Sea* sea,
                      double time, double h, const LumpedState& state) {
  const Equations e = equations_of(line, length, ends, state, sea, time, h);
  LineResponse found{.places = e.expected};
  const Slope slope = solve(e, found.places);
  found.forces = forces_of(slope);
  found.stiffness = stiffness_of_ends(slope);
  return found;
}

void advance(const LumpedLine& line, double length, const LineEnds& ends, const Sea* sea,
             double time, double h, const Matrix3Xd& start, LumpedState& state) {
  const Equations e = equations_of(line, length, ends, state, sea, time, h);
  Matrix3Xd x = start;
  x.col(0) = ends.col(0);
  x.col(line.segments) = ends.col(1);
  state.forces = forces_of(solve(e, x));
  state.places_before = std::move(state.places);
  state.velocities_before = std::move(state.velocities);
  state.velocities = e.rate * x + e.moving;
  state.places = std::move(x);
}

double resting_length(const LumpedLine& line, double length, const LumpedState& state) {
  Index rests = 0;
  for (Index i = 1; i < state.places.cols(); ++i)
    if (std::max(state.places(2, i - 1), state.places(2, i)) <= line.bottom) ++rests;
  return static_cast<double>(rests) * length / line.segments;
}

// Steps of Euler's implicit rule without mass, in a thick fluid that gets thinner and thinner, come
// to the rest of any convex energy.
LumpedState line_at_rest(const LumpedLine& line, double length, const LineEnds& ends,
                         const Sea* sea) {
  const Index count = line.segments + 1;
  LumpedState state;
  state.places.resize(3, count);
  for (Index i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / line.segments;
    state.places.col(i) = (1 - part) * ends.col(0) + part * ends.col(1);
  }
  const double l = length / line.segments;
  std::optional<Sea> still;
  if (sea) {
    still = *sea;
    still->surface = FlatSurface{};
  }
  Matrix3Xd zero = Matrix3Xd::Zero(3, count);
  const double thinnest = 1e-9 * line.stiffness / l;  // [N/m]
  // At first a node moves by l under its weight.
  double thickness = std::max(line.mass * line.gravity, thinnest);
  Slope slope;
  for (int i = 0; i < kMostRestSteps; ++i) {
    Equations e{.line = line,
                .l = l,
                .rate = 1,
                .expected = state.places,
                .moving = -state.places,
                .speeding = zero};
    for (Index k = 0; k < count; ++k) {
      NodeTerms node = terms_of(line, l, state.places, zero, k, still ? &*still : nullptr, 0);
      node.inertia.setZero();
      node.damping = thickness * Matrix3d::Identity();
      e.nodes.push_back(node);
    }
    e.dampers.resize(static_cast<std::size_t>(line.segments), Matrix3d::Zero());
    Matrix3Xd x = state.places;
    slope = solve(e, x);
    const double moved = (x - state.places).colwise().norm().maxCoeff();
    state.places = x;
    if (moved <= kAtRest * length && i > 0) break;
    thickness = std::max(thickness / 2, thinnest);
  }
  state.places_before = state.places;
  state.velocities = state.velocities_before = zero;
  state.forces = forces_of(slope);
  return state;
}

}  // namespace hydro

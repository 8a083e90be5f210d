#include "hydro/lines/lumped_step.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

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
constexpr int kMostNewtonSteps = 50;
/// Part of the slope at the start that a line search may leave [-].
constexpr double kSlopeLeft = 0.5;
constexpr int kMostHalvings = 30;
/// Newton's last change of a node, over the length of a segment [-].
constexpr double kSolved = 1e-6;

Matrix3d along(const Vector3d& direction) { return direction * direction.transpose(); }

Vector3d direction_of(const Vector3d& d) {
  const double length = d.norm();
  return length > 0 ? Vector3d(d / length) : Vector3d(Vector3d::Zero());
}

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

}  // namespace

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

namespace {

void add_segment(const LineEquations& e, const Matrix3Xd& x, Index i, LineSlope& s) {
  const auto k = static_cast<std::size_t>(i);
  const Vector3d d = x.col(i + 1) - x.col(i);
  const double length = d.norm(), stretch = length - e.l;
  Matrix3d K = Matrix3d::Zero();
  Vector3d pull = Vector3d::Zero();
  if (e.line.damping > 0) {
    K = e.rate * e.dampers[k];
    pull = e.dampers[k] * (e.rate * d + e.moving.col(i + 1) - e.moving.col(i));
  }
  if (stretch > 0) {
    const Matrix3d n = along(d / length);
    const double T = e.line.stiffness / e.l * stretch;
    pull += T / length * d;
    K += (e.line.stiffness / e.l - T / length) * n;
    K.diagonal().array() += T / length;
  }
  s.residual.col(i) -= pull;
  s.residual.col(i + 1) += pull;
  s.diagonal[k] += K;
  s.diagonal[k + 1] += K;
  s.beside[k] = -K;
}

void find_slope(const LineEquations& e, const Matrix3Xd& x, LineSlope& s) {
  const auto count = static_cast<std::size_t>(x.cols());
  s.residual.resize(3, x.cols());
  s.diagonal.resize(count);
  s.beside.resize(count - 1);
  for (std::size_t k = 0; k < count; ++k) {
    const NodeTerms& node = e.nodes[k];
    const auto i = static_cast<Index>(k);
    const Vector3d v = e.rate * x.col(i) + e.moving.col(i);
    s.residual.col(i) = node.inertia * (e.rate * v + e.speeding.col(i)) + node.damping * v;
    s.residual.col(i) -= node.load;
    s.diagonal[k] = e.rate * (e.rate * node.inertia + node.damping);
    const double depth = e.line.bottom - x(2, i);
    if (!(depth > 0)) continue;
    s.residual(2, i) -= node.bottom * depth;
    s.diagonal[k](2, 2) += node.bottom;
  }
  for (Index i = 0; i + 1 < x.cols(); ++i) add_segment(e, x, i, s);
}

double product(const Matrix3Xd& residual, const Matrix3Xd& change) {
  return residual.cwiseProduct(change).sum();
}

/// The blocks of the ends after those between are taken out of the system.
std::array<Matrix3d, 2> stiffness_of_ends(const LineSlope& s) {
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

LineEnds forces_of(const LineSlope& slope) {
  LineEnds forces;
  forces << -slope.residual.leftCols<1>(), -slope.residual.rightCols<1>();
  return forces;
}

/// Newton's change of the nodes between the ends: a system of blocks on three diagonals.
void LineSolver::find_change() {
  const Index last = slope_.residual.cols() - 2;
  change_.setZero(3, slope_.residual.cols());
  inverse_.resize(slope_.diagonal.size());
  for (Index i = 1; i <= last; ++i) {
    const auto k = static_cast<std::size_t>(i);
    Matrix3d own = slope_.diagonal[k];
    change_.col(i) = -slope_.residual.col(i);
    if (i > 1) {
      const Matrix3d factor = slope_.beside[k - 1] * inverse_[k - 1];
      own -= factor * slope_.beside[k - 1];
      change_.col(i) -= factor * change_.col(i - 1);
    }
    inverse_[k] = own.inverse();
  }
  for (Index i = last; i >= 1; --i) {
    const auto k = static_cast<std::size_t>(i);
    Vector3d side = change_.col(i);
    if (i < last) side -= slope_.beside[k] * change_.col(i + 1);
    change_.col(i) = inverse_[k] * side;
  }
}

const LineSlope& LineSolver::solve(const LineEquations& e, double solved, Matrix3Xd& x) {
  find_slope(e, x, slope_);
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    find_change();
    const double slope = product(slope_.residual, change_);
    if (!(slope < 0)) break;  // It is at the least energy, but for round-off.
    double part = 1;
    next_x_ = x + change_;
    find_slope(e, next_x_, next_);
    // The energy is convex: the slope along the change grows. Past the least energy it is positive.
    for (int k = 0; k < kMostHalvings; ++k) {
      const double found = product(next_.residual, change_);
      if (found <= -kSlopeLeft * slope) break;
      part *= std::clamp(slope / (slope - found), 0.1, 0.9);
      next_x_ = x + part * change_;
      find_slope(e, next_x_, next_);
    }
    std::swap(x, next_x_);
    std::swap(slope_, next_);
    if (part == 1 && change_.colwise().squaredNorm().maxCoeff() <= solved * solved * e.l * e.l)
      break;
  }
  return slope_;
}

const LineResponse& LumpedStep::begin(const LumpedLine& line, double length, const LineEnds& ends,
                                      const Sea* sea, double time, double h,
                                      const LumpedState& state) {
  assert(state.places.cols() == line.segments + 1);
  LineEquations& e = equations_;
  e.line = line;
  e.l = length / line.segments;
  e.rate = 1.5 / h;
  e.moving = (state.places_before - 4 * state.places) / (2 * h);
  e.speeding = (state.velocities_before - 4 * state.velocities) / (2 * h);
  places_ = 2 * state.places - state.places_before;
  places_.col(0) = ends.col(0);
  places_.col(line.segments) = ends.col(1);
  velocities_ = 2 * state.velocities - state.velocities_before;
  e.nodes.clear();
  for (Index i = 0; i <= line.segments; ++i)
    e.nodes.push_back(terms_of(line, e.l, places_, velocities_, i, sea, time));
  e.dampers.clear();
  for (Index i = 0; i < line.segments && line.damping > 0; ++i) {
    const Vector3d d = places_.col(i + 1) - places_.col(i);
    e.dampers.push_back((d.norm() > e.l ? line.damping : 0) * along(direction_of(d)));
  }
  const LineSlope& slope = solver_.solve(e, kSolved, places_);
  response_ = {forces_of(slope), stiffness_of_ends(slope)};
  return response_;
}

void LumpedStep::end(const LineEnds& ends, LumpedState& state) {
  places_.col(0) = ends.col(0);
  places_.col(equations_.line.segments) = ends.col(1);
  state.forces = forces_of(solver_.solve(equations_, kSolved, places_));
  std::swap(state.places_before, state.places);
  std::swap(state.velocities_before, state.velocities);
  state.places = places_;
  state.velocities = equations_.rate * places_ + equations_.moving;
}

}  // namespace hydro

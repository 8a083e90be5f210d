#include "engine/constraints/prepared_block.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/base/constants.h"

namespace engine {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

int place_of(BodyId id, const std::vector<ConstrainedBody>& bodies) {
  const auto found = std::ranges::lower_bound(bodies, id, {}, &ConstrainedBody::body);
  return found == bodies.end() || found->body != id ? -1 : static_cast<int>(found - bodies.begin());
}

}  // namespace

PreparedBlock::PreparedBlock(const ConstraintBlock& block,
                             const std::vector<ConstrainedBody>& bodies)
    : block_(&block) {
  for (int side = 0; side < 2; ++side) {
    places_[side] = place_of(block.bodies[side], bodies);
    if (places_[side] < 0) continue;
    spread_[side].noalias() =
        bodies[static_cast<std::size_t>(places_[side])].mobility * block.J[side].transpose();
    response_.noalias() += block.J[side] * spread_[side];
  }
  response_ = (response_ + response_.transpose()).eval() / 2;
  // Rows that ask for the same more than once, as those of two joints may, have a solution only
  // with some compliance.
  const double largest = response_.diagonal().maxCoeff();
  const double least = largest > 0 ? kLeastCompliance * largest : 1;
  compliance_ = block.compliance.cwiseMax(Vector3d::Constant(least));
  compliance_[0] = std::max(compliance_[0], block.give * response_(0, 0));
  for (int row = block.rows; row < 3; ++row) compliance_[row] = 1;
  response_.diagonal() += compliance_;
  scale_ = response_.diagonal().cwiseSqrt();
  if (kind() == Kind::bilateral) inverse_ = response_.inverse();
  if (kind() != Kind::contact) return;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> slide;
  slide.computeDirect(response_.bottomRightCorner<2, 2>());
  slide_response_ = slide.eigenvalues();
  slide_axes_ = slide.eigenvectors();
}

void PreparedBlock::push(const Vector3d& impulses, std::vector<Vector6d>& velocities) const {
  for (int side = 0; side < 2; ++side)
    if (places_[side] >= 0)
      velocities[static_cast<std::size_t>(places_[side])].noalias() += spread_[side] * impulses;
}

Vector3d PreparedBlock::missed(const Vector3d& impulses,
                               const std::vector<Vector6d>& velocities) const {
  Vector3d rest = compliance_.cwiseProduct(impulses) - block_->target;
  for (int side = 0; side < 2; ++side)
    if (places_[side] >= 0)
      rest.noalias() += block_->J[side] * velocities[static_cast<std::size_t>(places_[side])];
  return rest;
}

Vector3d PreparedBlock::solved(const Vector3d& now, const std::vector<Vector6d>& velocities) const {
  const Vector3d rest = missed(now, velocities);
  switch (kind()) {
    case Kind::bilateral:
      return now - inverse_ * rest;
    case Kind::one_sided:
      return Vector3d(std::max(0.0, wanted(now[0], rest[0])), 0, 0);
    case Kind::bounded:
      return Vector3d(std::clamp(wanted(now[0], rest[0]), -block_->limit, block_->limit), 0, 0);
    case Kind::contact:
      return contact_solved(now, rest);
  }
  return now;
}

Vector3d PreparedBlock::contact_solved(const Vector3d& now, const Vector3d& rest) const {
  Vector3d next = now;
  next[0] = std::max(0.0, wanted(now[0], rest[0]));
  if (!(next[0] > 0)) return Vector3d::Zero();
  const Vector2d slip = rest.tail<2>() + response_.bottomLeftCorner<2, 1>() * (next[0] - now[0]);
  const Vector2d along = slide_axes_.transpose() * now.tail<2>();
  const Vector2d pull = slide_response_.cwiseProduct(along) - slide_axes_.transpose() * slip;
  next.tail<2>() = slide_axes_ * least_in_disk(slide_response_, pull, block_->limit * next[0]);
  return next;
}

Vector2d least_in_disk(const Vector2d& w, const Vector2d& g, double radius) {
  const Vector2d free = g.cwiseQuotient(w);
  if (free.squaredNorm() <= radius * radius) return free;
  if (!(radius > 0)) return Vector2d::Zero();
  // |x| is that of x_i = g_i/(w_i + ν). Newton's method on 1/|x| comes from the left.
  double nu = std::max(0.0, g.norm() / radius - w.maxCoeff());
  Vector2d x = free;
  for (int i = 0; i < kMostDiskSteps; ++i) {
    const Vector2d sum = w.array() + nu;
    x = g.cwiseQuotient(sum);
    const double length = x.norm();
    if (length <= radius * (1 + kDiskError)) break;
    nu += (length / radius - 1) * length * length / x.cwiseAbs2().cwiseQuotient(sum).sum();
  }
  return x * (radius / x.norm());
}

}  // namespace engine

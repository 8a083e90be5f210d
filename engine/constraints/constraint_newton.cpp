#include "engine/constraints/constraint_newton.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <span>
#include <utility>

#include "engine/base/constants.h"
#include "hydro/decompositions.h"

namespace engine {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Kind = ConstraintBlock::Kind;

/// P δ + Q A δ = b for the rows of a block.
struct Equations {
  Matrix3d P = Matrix3d::Identity();
  Matrix3d Q = Matrix3d::Zero();
  Vector3d b;
  Vector3d compliance;  ///< A's D.

  void hold(int row, double missed) {
    P.row(row).setZero();
    Q(row, row) = 1;
    b[row] = -missed;
  }
};

Equations contact_equations(const PreparedBlock& block, const Vector3d& p, const Vector3d& v) {
  Equations e{.b = -p, .compliance = block.compliance()};
  const double push = block.wanted(p[0], v[0]);
  if (!(push > 0)) return e;
  e.hold(0, v[0]);
  const double friction = block.block().limit;
  const double omega = block.sliding_response();
  const Vector2d t = p.tail<2>() - v.tail<2>() / omega;
  const double length = t.norm(), limit = friction * push;
  if (length <= limit) {
    e.hold(1, v[1]);
    e.hold(2, v[2]);
    return e;
  }
  const Vector2d d = t / length;
  const Matrix2d turning = limit / length * (Matrix2d::Identity() - d * d.transpose());
  e.P.bottomLeftCorner<2, 1>() = -friction * d;
  e.P.bottomRightCorner<2, 2>() -= turning;
  e.Q.bottomRightCorner<2, 2>() = turning / omega;
  e.b.tail<2>() = friction * p[0] * d - p.tail<2>();
  return e;
}

Equations equations(const PreparedBlock& block, const Vector3d& p, const Vector3d& v) {
  if (block.kind() == Kind::contact) return contact_equations(block, p, v);
  Equations e{.b = -p, .compliance = block.compliance()};
  const double wanted = block.wanted(p[0], v[0]);
  const double limit = block.block().limit;
  if (block.kind() == Kind::bilateral)
    for (int row = 0; row < block.block().rows; ++row) e.hold(row, v[row]);
  else if (block.kind() == Kind::one_sided ? wanted > 0 : std::abs(wanted) <= limit)
    e.hold(0, v[0]);
  else if (block.kind() == Kind::bounded)
    e.b[0] = (wanted > 0 ? limit : -limit) - p[0];
  return e;
}

/// A system of 3×3 blocks, dense where it is small.
class System {
 public:
  /// @param bilateral   All rows are held, which makes the system symmetric and positive definite.
  System(std::size_t blocks, bool bilateral)
      : size_(3 * static_cast<Index>(blocks)), bilateral_(bilateral) {
    if (size_ <= (bilateral ? kMostDenseBilateralRows : kMostDenseRows))
      dense_.setZero(size_, size_);
  }

  void add(std::size_t row, std::size_t column, const Matrix3d& block) {
    const Index r = 3 * static_cast<Index>(row), c = 3 * static_cast<Index>(column);
    if (dense_.size() > 0) {
      dense_.block<3, 3>(r, c) += block;
      return;
    }
    for (Index j = 0; j < 3; ++j)
      for (Index i = 0; i < 3; ++i)
        if (block(i, j) != 0) entries_.emplace_back(r + i, c + j, block(i, j));
  }

  /// Overwrites a dense system by its factors.
  std::optional<Eigen::VectorXd> solve(const Eigen::VectorXd& b) {
    if (dense_.size() > 0) return finite(hydro::solve_dense(dense_, b));
    Eigen::SparseMatrix<double> matrix(size_, size_);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    if (bilateral_) {
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt(matrix);
      if (ldlt.info() != Eigen::Success) return std::nullopt;
      return finite(ldlt.solve(b));
    }
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
    if (lu.info() != Eigen::Success) return std::nullopt;
    return finite(lu.solve(b));
  }

 private:
  static std::optional<Eigen::VectorXd> finite(Eigen::VectorXd x) {
    if (!x.allFinite()) return std::nullopt;
    return x;
  }

  Index size_;
  bool bilateral_;
  Eigen::MatrixXd dense_;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// A side of a block at a body.
struct Touch {
  int body;
  std::size_t block;
  int side;
};

/// By body, then by block.
std::vector<Touch> touches(const std::vector<PreparedBlock>& blocks) {
  std::vector<Touch> all;
  all.reserve(2 * blocks.size());
  for (std::size_t k = 0; k < blocks.size(); ++k)
    for (int side = 0; side < 2; ++side)
      if (blocks[k].place(side) >= 0) all.push_back({blocks[k].place(side), k, side});
  std::ranges::sort(all, {}, [](const Touch& t) { return std::pair(t.body, t.block); });
  return all;
}

}  // namespace

std::optional<std::vector<Vector3d>> newton_step(const std::vector<PreparedBlock>& blocks,
                                                 const std::vector<Vector3d>& impulses,
                                                 const std::vector<Vector6d>& velocities) {
  const auto bilateral = [](const PreparedBlock& b) { return b.kind() == Kind::bilateral; };
  System system(blocks.size(), std::ranges::all_of(blocks, bilateral));
  std::vector<Equations> rows;
  rows.reserve(blocks.size());
  Eigen::VectorXd b(3 * static_cast<Index>(blocks.size()));
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const PreparedBlock& block = blocks[k];
    const Vector3d scale = block.scale();
    rows.push_back(equations(block, impulses[k], block.missed(impulses[k], velocities)));
    // Both sides are divided so that the diagonal is of order one.
    Equations& e = rows.back();
    for (int i = 0; i < 3; ++i) {
      const double unit = e.Q(i, i) == 1 ? 1 / scale[i] : scale[i];
      e.P.row(i) *= unit;
      e.Q.row(i) *= unit;
      e.b[i] *= unit;
    }
    b.segment<3>(3 * static_cast<Index>(k)) = e.b;
    const Matrix3d own = e.P + e.Q * e.compliance.asDiagonal();
    system.add(k, k, own * scale.cwiseInverse().asDiagonal());
  }
  const std::vector<Touch> all = touches(blocks);
  for (auto first = all.begin(); first != all.end();) {
    const auto last =
        std::find_if(first, all.end(), [&](const Touch& t) { return t.body != first->body; });
    const std::span<const Touch> of_one_body(first, last);
    for (const Touch& r : of_one_body)
      for (const Touch& c : of_one_body)
        system.add(r.block, c.block,
                   rows[r.block].Q *
                       (blocks[r.block].block().J[r.side] * blocks[c.block].spread(c.side)) *
                       blocks[c.block].scale().cwiseInverse().asDiagonal());
    first = last;
  }
  const std::optional<Eigen::VectorXd> change = system.solve(b);
  if (!change) return std::nullopt;
  std::vector<Vector3d> next = impulses;
  for (std::size_t k = 0; k < blocks.size(); ++k)
    next[k] += change->segment<3>(3 * static_cast<Index>(k)).cwiseQuotient(blocks[k].scale());
  return next;
}

}  // namespace engine

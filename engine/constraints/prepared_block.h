#pragma once

#include <vector>

#include "engine/constraints/constraint_solver.h"

/// @file
/// A block of rows as the solver uses it again and again: with the places of its bodies in the
/// island, and what its impulses do to them.

namespace engine {

class PreparedBlock {
 public:
  using Kind = ConstraintBlock::Kind;
  using Rows = ConstraintBlock::Rows;
  using Columns = Eigen::Matrix<double, 6, 3>;

  /// @param block    It must outlive this.
  /// @param bodies   Bodies of the island, ascending.
  PreparedBlock(const ConstraintBlock& block, const std::vector<ConstrainedBody>& bodies);

  Kind kind() const { return block_->kind; }
  const ConstraintBlock& block() const { return *block_; }
  /// Index of the first or second body in the island; -1 for one that does not move.
  int place(int side) const { return places_[side]; }
  /// W = J S⁻¹ Jᵀ + D, with 1 on the diagonal for rows that there are none of.
  const Eigen::Matrix3d& response() const { return response_; }
  /// D, likewise.
  const Eigen::Vector3d& compliance() const { return compliance_; }
  /// Roots of the diagonal of W.
  const Eigen::Vector3d& scale() const { return scale_; }
  /// S⁻¹ Jᵀ of one side.
  const Columns& spread(int side) const { return spread_[side]; }

  /// Adds the change of velocities by these impulses.
  void push(const Eigen::Vector3d& impulses, std::vector<Vector6d>& velocities) const;

  /// J u + D p − c.
  Eigen::Vector3d missed(const Eigen::Vector3d& impulses,
                         const std::vector<Vector6d>& velocities) const;

  /// The impulse with which the first row would hold without a bound, those of all others held.
  /// @param now      Its present impulse.
  /// @param missed   J u + D p − c.
  double wanted(double now, double missed) const { return now - missed / response_(0, 0); }

  /// The impulses with which (E8) holds for this block, those of all others held.
  /// @param impulses, velocities   The present ones.
  Eigen::Vector3d solved(const Eigen::Vector3d& impulses,
                         const std::vector<Vector6d>& velocities) const;

  /// The greater eigenvalue of the response to impulses along the tangents of a contact.
  double sliding_response() const { return slide_response_.maxCoeff(); }

 private:
  Eigen::Vector3d contact_solved(const Eigen::Vector3d& now, const Eigen::Vector3d& missed) const;

  const ConstraintBlock* block_;
  std::array<int, 2> places_{-1, -1};
  std::array<Columns, 2> spread_{Columns::Zero(), Columns::Zero()};
  Eigen::Vector3d compliance_ = Eigen::Vector3d::Ones();  ///< D
  Eigen::Matrix3d response_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d inverse_ =
      Eigen::Matrix3d::Zero();  ///< Inverse of the response, for a bilateral block.
  Eigen::Vector3d scale_ = Eigen::Vector3d::Ones();
  /// Eigenvalues and -vectors of the response along the tangents of a contact.
  Eigen::Vector2d slide_response_ = Eigen::Vector2d::Ones();
  Eigen::Matrix2d slide_axes_ = Eigen::Matrix2d::Identity();
};

/// The x with |x| <= radius of least ½ Σ w_i x_i² − g·x, w > 0.
Eigen::Vector2d least_in_disk(const Eigen::Vector2d& w, const Eigen::Vector2d& g, double radius);

}  // namespace engine

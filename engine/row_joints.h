#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "engine/force_row.h"

struct dxBody;
struct dxJoint;
struct dxJointGroup;
struct dxWorld;

/// @file
/// Rows of forces as joints of ODE that live for one step.
///
/// A force that only pushes is the normal of a contact; one of both signs is two such forces, or,
/// if it is limited, the friction of a contact whose normal is too soft to do anything. ODE's
/// friction without a limit may fail beside such a normal. A torque is a motor about an axis, or a
/// stop of one.

namespace engine {

class RowJoints {
 public:
  /// @param unit   Factor of masses and forces in ODE.
  /// @param step   Length of the step that will be taken [s].
  RowJoints(dxWorld* world, dxJointGroup* group, double unit, double step);
  ~RowJoints();

  /// @param first, second   Null stands for what does not move; one at least moves.
  void add(const ForceRow& row, dxBody* first, dxBody* second);

  /// λ of the rows in their order, after the step.
  std::vector<double> forces() const;

 private:
  struct Added;
  void add_joint(const ForceRow& row, dxBody* first, dxBody* second, Added added);
  dxJoint* force_joint(const ForceRow& row, const Eigen::Vector3d& direction_W) const;
  dxJoint* torque_joint(const ForceRow& row) const;

  dxWorld* world_;
  dxJointGroup* group_;
  double unit_, step_;
  std::size_t row_count_ = 0;
  std::deque<Added> added_;  ///< ODE keeps the addresses of their feedback.
};

}  // namespace engine

#include "engine/row_joints.h"

#include <ode/ode.h>

#include <Eigen/Geometry>
#include <cmath>

namespace engine {
namespace {

using Eigen::Vector3d;

/// Compliance of a row that is to do nothing [m/(N s)].
constexpr double kInert = 1e30;

}  // namespace

struct RowJoints::Added {
  dJointFeedback feedback{};
  std::size_t row = 0;
  double sign = 1;                           ///< Of its force in λ.
  Vector3d direction_W = Vector3d::UnitX();  ///< Of the force on ODE's first body.
  bool turns = false;
};

RowJoints::RowJoints(dxWorld* world, dxJointGroup* group, double unit, double step)
    : world_(world), group_(group), unit_(unit), step_(step) {}
RowJoints::~RowJoints() = default;

dxJoint* RowJoints::force_joint(const ForceRow& row, const Vector3d& direction_W) const {
  dContact contact{};
  Eigen::Map<Vector3d>(contact.geom.pos) = row.point_W;
  if (row.one_sided) {
    Eigen::Map<Vector3d>(contact.geom.normal) = direction_W;
    contact.surface.mode = dContactSoftERP | dContactSoftCFM | dContactMotionN;
    contact.surface.soft_cfm = row.compliance / unit_;
    contact.surface.motionN = row.target;
    return dJointCreateContact(world_, group_, &contact);
  }
  Eigen::Map<Vector3d>(contact.geom.normal) = direction_W.unitOrthogonal();
  Eigen::Map<Vector3d>(contact.fdir1) = direction_W;
  contact.surface.mode = dContactSoftERP | dContactSoftCFM | dContactFDir1 | dContactMotion1 |
                         dContactSlip1 | dContactMu2;
  contact.surface.soft_cfm = kInert;
  contact.surface.mu = unit_ * row.most;
  contact.surface.motion1 = row.target;
  contact.surface.slip1 = row.compliance / unit_;
  return dJointCreateContact(world_, group_, &contact);
}

dxJoint* RowJoints::torque_joint(const ForceRow& row) const {
  dxJoint* motor = dJointCreateAMotor(world_, group_);
  dJointSetAMotorMode(motor, dAMotorUser);
  dJointSetAMotorNumAxes(motor, 1);
  if (row.one_sided) {
    // The stop has been passed by what the target takes back in one step.
    dJointSetAMotorAngle(motor, 0, -step_ * row.target);
    dJointSetAMotorParam(motor, dParamLoStop, 0);
    dJointSetAMotorParam(motor, dParamStopERP, 1);
    dJointSetAMotorParam(motor, dParamStopCFM, row.compliance / unit_);
    return motor;
  }
  dJointSetAMotorParam(motor, dParamVel, row.target);
  dJointSetAMotorParam(motor, dParamCFM, row.compliance / unit_);
  dJointSetAMotorParam(motor, dParamFMax, std::isfinite(row.most) ? unit_ * row.most : dInfinity);
  return motor;
}

void RowJoints::add(const ForceRow& row, dxBody* first, dxBody* second) {
  const std::size_t index = row_count_++;
  if (row.turns || row.one_sided || std::isfinite(row.most))
    return add_joint(row, first, second, {.row = index});
  // A pull and a push, of which one acts.
  for (const double sign : {1.0, -1.0}) {
    ForceRow side = row;
    side.direction_W *= sign;
    side.target *= sign;
    side.one_sided = true;
    add_joint(side, first, second, {.row = index, .sign = sign});
  }
}

void RowJoints::add_joint(const ForceRow& row, dxBody* first, dxBody* second, Added added) {
  // ODE's first body is the one that moves; the row pushes `second` along its direction.
  added.direction_W = second ? row.direction_W : Vector3d(-row.direction_W);
  added.turns = row.turns;
  const Vector3d& direction = added.direction_W;
  dxJoint* joint = row.turns ? torque_joint(row) : force_joint(row, direction);
  dJointAttach(joint, second ? second : first, second ? first : nullptr);
  if (row.turns) dJointSetAMotorAxis(joint, 0, 0, direction.x(), direction.y(), direction.z());
  added_.push_back(added);
  dJointSetFeedback(joint, &added_.back().feedback);
}

std::vector<double> RowJoints::forces() const {
  std::vector<double> forces(row_count_, 0);
  for (const Added& a : added_) {
    const double* vector = a.turns ? a.feedback.t1 : a.feedback.f1;
    forces[a.row] += a.sign * a.direction_W.dot(Eigen::Map<const Vector3d>(vector)) / unit_;
  }
  return forces;
}

}  // namespace engine

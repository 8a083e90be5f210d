#include "engine/rig/joint_drive.h"

#include <cmath>
#include <numbers>

#include "engine/base/constants.h"
#include "hydro/spatial.h"

namespace engine {
namespace {

using Eigen::Vector3d;
using Mode = JointMotor::Mode;

/// The angle within (−π, π] that differs from it by full turns.
double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

double set_value(const JointMotor& motor, const SetPoints& set_points, double time) {
  return set_points.value(motor.set_point, time);
}

/// A row whose force acts along q, or against it if `sign` is −1.
ForceRow row_of(const RowTerms& terms, double sign, bool turns) {
  ForceRow row{.turns = turns, .target = terms.target, .compliance = terms.compliance};
  row.sign = sign;
  row.of_line = false;
  return row;
}

}  // namespace

JointCoordinate::JointCoordinate(const JointSpec& joint, const JointBodies& initial)
    : turns_(joint.type == JointSpec::Type::hinge),
      anchored_(joint.type != JointSpec::Type::slider && joint.type != JointSpec::Type::fixed),
      axis_(joint.axis_W),
      anchor_(joint.anchor_W) {
  if (initial.first) first_ = *initial.first;
  if (initial.second) second_ = *initial.second;
}

Eigen::Quaterniond JointCoordinate::turn(const hydro::BodyState* now,
                                         const hydro::BodyState& start) const {
  if (!now) return Eigen::Quaterniond::Identity();
  return now->orientation * start.orientation.conjugate();
}

Vector3d JointCoordinate::axis_W(const JointBodies& now) const {
  return turn(now.first, first_) * axis_;
}

double JointCoordinate::value(const JointBodies& now) const {
  const Eigen::Quaterniond Q1 = turn(now.first, first_);
  if (turns_) {
    const Eigen::Quaterniond between = Q1.conjugate() * turn(now.second, second_);
    return wrapped(2 * std::atan2(between.vec().dot(axis_), between.w()));
  }
  const Vector3d x1 = now.first ? now.first->position : first_.position;
  const Vector3d x2 = now.second ? now.second->position : second_.position;
  return (Q1 * axis_).dot(x2 - x1 - Q1 * (second_.position - first_.position));
}

double JointCoordinate::rate(const JointBodies& now) const {
  const hydro::BodyState still{};
  const hydro::BodyState& a = now.first ? *now.first : still;
  const hydro::BodyState& b = now.second ? *now.second : still;
  const Vector3d e = axis_W(now);
  if (turns_) return e.dot(b.angular_velocity - a.angular_velocity);
  return e.dot(b.linear_velocity - a.linear_velocity -
               a.angular_velocity.cross(b.position - a.position));
}

Vector3d JointCoordinate::place_W(const JointBodies& now) const {
  const hydro::BodyState* at = now.second ? now.second : now.first;
  const hydro::BodyState& start = now.second ? second_ : first_;
  if (!anchored_) return at->position;
  return at->position + turn(at, start) * (anchor_ - start.position);
}

bool needs_rows(const JointDrive& drive, bool stiff) {
  const bool steered = drive.motor && drive.motor->mode != Mode::effort;
  return steered || drive.limits || drive.friction > 0 || stiff;
}

double drive_load(const JointDrive& drive, const SetPoints& set_points, double time, double q,
                  double rate, bool stiff) {
  double effort = 0;
  if (drive.motor && drive.motor->mode == Mode::effort)
    effort += std::clamp(set_value(*drive.motor, set_points, time), -drive.motor->largest_effort,
                         drive.motor->largest_effort);
  if (!stiff) effort -= drive.stiffness * (q - drive.rest) + drive.damping * rate;
  return effort;
}

double motor_load(const JointDrive& drive, const SetPoints& set_points) {
  if (!drive.motor || drive.motor->mode != Mode::effort) return 0;
  return set_points.mean_within(drive.motor->set_point, drive.motor->largest_effort);
}

std::vector<ForceRow> drive_rows(const JointDrive& drive, const SetPoints& set_points, double time,
                                 double h, const DriveState& s, bool turns) {
  std::vector<ForceRow> rows;
  const double mobility = 1 / s.inertia;
  const auto missing = [&](double target) { return turns ? wrapped(target - s.q) : target - s.q; };
  if (s.stiff && (drive.stiffness > 0 || drive.damping > 0))
    rows.push_back(row_of(row_terms({.stiffness = drive.stiffness,
                                     .damping = drive.damping,
                                     .missing = missing(drive.rest),
                                     .rate = s.rate,
                                     .mobility = mobility},
                                    h, s.step),
                          1, turns));
  if (drive.motor && drive.motor->mode == Mode::speed) {
    rows.push_back(
        row_of(rigid_terms(set_value(*drive.motor, set_points, time), mobility, h), 1, turns));
    rows.back().largest_force = drive.motor->largest_effort;
    rows.back().of_motor = true;
  }
  if (drive.motor && drive.motor->mode == Mode::position) {
    const double w = drive.motor->rate;
    rows.push_back(row_of(row_terms({.stiffness = w * w * s.inertia,
                                     .damping = 2 * w * s.inertia,
                                     .missing = missing(set_value(*drive.motor, set_points, time)),
                                     .rest_rate = set_points.rate(drive.motor->set_point, time),
                                     .rate = s.rate,
                                     .mobility = mobility},
                                    h, s.step),
                          1, turns));
    rows.back().largest_force = drive.motor->largest_effort;
    rows.back().of_motor = true;
  }
  if (drive.friction > 0) {
    rows.push_back(row_of(rigid_terms(0, mobility, h), 1, turns));
    rows.back().largest_force = drive.friction;
  }
  if (!drive.limits) return rows;
  const double below = (*drive.limits)[0] - s.q, above = s.q - (*drive.limits)[1];
  for (const auto& [beyond, sign] : {std::pair(below, 1.0), std::pair(above, -1.0)}) {
    // Before a stop it may come as near as that by the middle of the next substep.
    const double back = beyond < 0 ? beyond / h : beyond / s.step;
    rows.push_back(row_of(rigid_terms(back, mobility, h), sign, turns));
    rows.back().one_sided = true;
  }
  return rows;
}

}  // namespace engine

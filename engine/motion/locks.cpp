#include "engine/motion/locks.h"

#include <algorithm>

namespace engine {
namespace {

Eigen::Quaterniond locked_orientation(const DofMask& locked, const Eigen::Quaterniond& initial,
                                      const Eigen::Quaterniond& orientation) {
  const auto count = std::count(locked.begin() + 3, locked.end(), true);
  if (count == 3) return initial;
  if (count < 2) return orientation;
  const auto free = std::find(locked.begin() + 3, locked.end(), false) - (locked.begin() + 3);
  return twist(orientation * initial.conjugate(), Eigen::Vector3d::Unit(free)) * initial;
}

}  // namespace

Eigen::Quaterniond twist(const Eigen::Quaterniond& turn, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d along = turn.vec().dot(axis) * axis;
  const Eigen::Quaterniond twist(turn.w(), along.x(), along.y(), along.z());
  // Half a turn about an axis normal to this one has no twist.
  return twist.norm() > 0 ? twist.normalized() : Eigen::Quaterniond::Identity();
}

bool immovable(const DofMask& locked) {
  return std::all_of(locked.begin(), locked.end(), [](bool lock) { return lock; });
}

bool partly_locked(const DofMask& locked) {
  return std::any_of(locked.begin(), locked.end(), [](bool lock) { return lock; });
}

hydro::BodyState without_locked_motion(const DofMask& locked, hydro::BodyState state) {
  for (int i = 0; i < 3; ++i) {
    if (locked[i]) state.linear_velocity[i] = 0;
    if (locked[3 + i]) state.angular_velocity[i] = 0;
  }
  return state;
}

hydro::BodyState project_onto_locks(const DofMask& locked, const hydro::BodyState& initial,
                                    hydro::BodyState state) {
  for (int i = 0; i < 3; ++i)
    if (locked[i]) state.position[i] = initial.position[i];
  state.orientation = locked_orientation(locked, initial.orientation, state.orientation);
  return without_locked_motion(locked, state);
}

}  // namespace engine

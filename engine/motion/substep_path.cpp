#include "engine/motion/substep_path.h"

#include "engine/motion/free_motion.h"

namespace engine {

SubstepPath::SubstepPath(const hydro::BodyState& before, const hydro::BodyState& after, double h)
    : end_(after),
      acceleration_((after.linear_velocity - before.linear_velocity) / h),
      turning_((after.angular_velocity - before.angular_velocity) / h) {}

hydro::BodyState SubstepPath::at(double time) const {
  if (time == 0) return end_;
  hydro::BodyState state = end_;
  state.position += time * (end_.linear_velocity + time / 2 * acceleration_);
  state.orientation =
      rotated(end_.orientation, time * (end_.angular_velocity + time / 2 * turning_));
  return state;
}

}  // namespace engine

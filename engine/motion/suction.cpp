#include "engine/motion/suction.h"

namespace engine {

hydro::Wrench wrench(const Suction& suction, const hydro::BodyState& state) {
  const Eigen::Vector3d force = suction.force * (state.orientation * suction.into_bed_B);
  return {.force = force, .moment = (state.orientation * suction.place_B).cross(force)};
}

}  // namespace engine

#include "engine/wetness.h"

#include "engine/locks.h"

namespace engine {
bool feels_water(const BodySpec& spec) {
  return spec.wet && !hydro::no_load(spec.coefficients) && !immovable(spec.locked);
}

double lowest_point(const Eigen::AlignedBox3d& box_B, const hydro::BodyState& state) {
  const Eigen::RowVector3d down = state.orientation.toRotationMatrix().row(2);
  const double center = state.position.z() + down.dot(box_B.center());
  return center - down.cwiseAbs().dot(box_B.sizes()) / 2;
}

}  // namespace engine

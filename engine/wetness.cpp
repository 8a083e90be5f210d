#include "engine/wetness.h"

#include "engine/locks.h"

namespace engine {
namespace {

bool is_zero(const hydro::ViscousDrag& drag) {
  using Law = hydro::ViscousDrag::Law;
  return drag.law == Law::none || (drag.law == Law::constant && drag.coefficient == 0);
}

}  // namespace

bool feels_water(const BodySpec& spec) {
  const hydro::Coefficients& c = spec.coefficients;
  const bool loaded = c.buoyancy || c.pressure_drag != 0 || c.lift != 0 || !is_zero(c.viscous_drag);
  return spec.wet && loaded && !immovable(spec.locked);
}

double lowest_point(const Eigen::AlignedBox3d& box_B, const hydro::BodyState& state) {
  const Eigen::RowVector3d down = state.orientation.toRotationMatrix().row(2);
  const double center = state.position.z() + down.dot(box_B.center());
  return center - down.cwiseAbs().dot(box_B.sizes()) / 2;
}

}  // namespace engine

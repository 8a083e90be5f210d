#include "hydro/loads/kernel/plain_viscous.h"

#include "hydro/loads/viscous_drag.h"

namespace hydro::kernel {

void add_plain_viscous(const LoadInputs& in, const PlainPanels& panels, int lanes, Sums& sums) {
  for (int lane = 0; lane < lanes; ++lane) {
    if (panels.counts[lane] == 0) continue;
    const auto vector = [&](const double(&v)[3][kMostLanes]) {
      return Eigen::Vector3d(v[0][lane], v[1][lane], v[2][lane]);
    };
    const Panel panel = {vector(panels.r[0]), vector(panels.r[1]), vector(panels.r[2])};
    const Eigen::Vector3d n = vector(panels.n);
    const Twist motion{vector(panels.linear), panels.spin[lane] * n};
    const Wrench load = viscous_drag_load(panel, n, motion, *in.viscous, in.half_density);
    for (int axis = 0; axis < 3; ++axis) {
      sums.lane[kViscousDrag + axis][lane] += load.force[axis];
      sums.lane[kViscousDrag + 3 + axis][lane] += load.moment[axis];
    }
  }
}

}  // namespace hydro::kernel

// Prints the loads of still water on a barge that is half under water and moves ahead at 1 m/s.
#include <cstdio>

#include "hydro/loads/loads.h"
#include "hydro/mesh/primitives.h"

int main() {
  const hydro::TriMesh barge = hydro::make_box({4, 2, 1});
  const hydro::Coefficients coefficients = hydro::for_mesh({}, barge, 1.0034e-6);
  const hydro::BodyState state = {.linear_velocity = {1, 0, 0}};
  const hydro::Loads loads =
      hydro::compute_loads(hydro::make_hull(barge), state, hydro::Sea(), 0, coefficients);
  std::printf("%.3f m^3 displaced: %.1f N of buoyancy, %.1f N of drag\n", loads.displaced_volume,
              loads.buoyancy.force.z(), -loads.total().force.x());
}

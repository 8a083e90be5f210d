#include "hydro/loads/coefficients.h"

#include "hydro/loads/bluntness.h"

namespace hydro {

Coefficients for_mesh(Coefficients coefficients, const TriMesh& mesh_B, double viscosity) {
  ViscousDrag& viscous = coefficients.viscous_drag;
  if (viscous.length == 0) viscous.length = bounding_box(mesh_B).sizes().maxCoeff();
  viscous.reynolds_per_speed = viscous.length / viscosity;
  coefficients.drag_shape = drag_shape(bluntness(mesh_B), coefficients.pressure_drag.blunt);
  return coefficients;
}

}  // namespace hydro

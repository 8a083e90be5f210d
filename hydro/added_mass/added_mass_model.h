#pragma once

#include "hydro/sea.h"
#include "hydro/spatial.h"

namespace hydro {

/// Added mass of a body as it lies in the water. Constant but for what it stores for itself; may be
/// asked by several threads at once and answers the same whatever was asked before.
class AddedMassModel {
 public:
  virtual ~AddedMassModel() = default;

  /// A in the given pose, for the sea's density, about the centre of mass, body axes [kg, kg m,
  /// kg m^2]: symmetric, without negative eigenvalues. Zero if the body is dry. Velocities of the
  /// state do not matter.
  virtual Matrix6d at(const BodyState& state, const Sea& sea, double time) const = 0;
};

}  // namespace hydro

#pragma once

#include "hydro/sea.h"
#include "hydro/spatial.h"

/// @file
/// The interface of the models of added mass.

namespace hydro {

/// The added mass of a body as it lies in the water. A model is constant but for results that it
/// keeps. Several threads may ask it at once, and an answer does not depend on earlier questions.
class AddedMassModel {
 public:
  virtual ~AddedMassModel() = default;

  /// A in the given pose, for the sea's density, about the centre of mass, body axes [kg, kg m,
  /// kg m^2]: symmetric, without negative eigenvalues. Zero if the body is dry. Velocities of the
  /// state do not matter.
  virtual Matrix6d at(const BodyState& state, const Sea& sea, double time) const = 0;

  /// The load of the water that accelerates past the body under Airy waves: with the acceleration
  /// v' of the body its added mass makes A (u̇ − v') in a uniform flow, and this is A u̇. W axes,
  /// moment about the centre of mass [N, N m]. Zero where the sea has no Airy waves.
  virtual Wrench wave_load(const BodyState& state, const Sea& sea, double time) const = 0;
};

}  // namespace hydro

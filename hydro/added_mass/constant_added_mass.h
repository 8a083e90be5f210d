#pragma once

#include "hydro/added_mass/added_mass_model.h"
#include "hydro/added_mass/rigid_wave_load.h"
#include "hydro/loads/loads.h"

/// @file
/// An added mass that the user gives.

namespace hydro {

/// A given matrix while any of the body is wet, and zero while it is dry.
class ConstantAddedMass final : public AddedMassModel {
 public:
  /// Makes the model of a body.
  /// @param mesh_B    Its origin the centre of mass.
  /// @param matrix    About the centre of mass, body axes [kg, kg m, kg m^2]; its symmetric part
  ///                  without negative eigenvalues is taken. The sea's density does not matter.
  ConstantAddedMass(TriMesh mesh_B, const Matrix6d& matrix);

  Matrix6d at(const BodyState& state, const Sea& sea, double time) const override;
  /// The load of rigid_wave_load.h.
  Wrench wave_load(const BodyState& state, const Sea& sea, double time) const override;

  /// The matrix while the body is wet [kg, kg m, kg m^2].
  const Matrix6d& matrix() const { return matrix_; }

 private:
  Hull hull_;
  Matrix6d matrix_;
  RigidWaveLoad waves_;
};

/// True if any point of the mesh lies below the surface, as the loads take it.
bool is_wet(const Hull& hull, const BodyState& state, const Sea& sea, double time);

}  // namespace hydro

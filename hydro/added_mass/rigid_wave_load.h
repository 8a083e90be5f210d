#pragma once

#include <memory>
#include <mutex>

#include "hydro/added_mass/wetted_added_mass.h"

/// @file
/// The load of the water's acceleration for added masses without potentials.
///
/// A matrix A alone tells the load of water that accelerates as a rigid body would. So the motion a
/// is taken whose normal acceleration is nearest to the water's over the wetted surface,
///
///     a = argmin ∫_{S_w} (J·a − u̇·n)² dS,        J = (n, r × n),                              (1)
///
/// and the load is A a: exact in uniform flow. For a spar in short waves it takes heave from the
/// bottom and surge from the sides. Motions along the surface, as the turning of a sphere, move no
/// water, and a has no part of them. Both integrals of its normal equations, ∫ J Jᵀ dS and ∫ J u̇·n
/// dS, are those of wetted_added_mass.h for the potentials ψ = J.

namespace hydro {

/// The loads on one mesh. Several threads may ask at once.
class RigidWaveLoad {
 public:
  /// @param A       About the centre of mass, body axes [kg, kg m, kg m^2].
  /// @param mesh_B  Closed; its origin is the centre of mass. It is the same at every call.
  /// @return A a in W, its moment about the centre of mass
  Wrench at(const Matrix6d& A, const TriMesh& mesh_B, const BodyState& state, const Sea& sea,
            double time) const;

 private:
  mutable std::once_flag made_;  ///< Only waves need what follows.
  mutable std::unique_ptr<const WettedAddedMass> flow_;
  mutable double radius_ = 1;  ///< Radius of the mesh [m]; turns are scaled by it.
};

}  // namespace hydro

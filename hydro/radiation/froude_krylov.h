#pragma once

#include "hydro/mesh/mesh.h"
#include "hydro/radiation/radiation_data.h"

namespace hydro {

/// X_FK of radiation_data.h for ρ = 1: with the pressure p₀ of the undisturbed wave of amplitude 1,
///
///     X_FK = −∫ p₀ (n, r × n) dS,        p₀ = g cosh k(z + h)/cosh kh e^{ik·r},
///
/// over the wetted surface in the mean pose, by the points of triangles that are at most 0.3/k
/// long.
/// @param mesh_B        Closed; its origin is the centre of mass.
/// @param frequencies   ω, > 0 [rad/s].
/// @param headings      β, in H [rad].
/// @return one a frequency, a column for each heading.
std::vector<Loads6cd> froude_krylov(const TriMesh& mesh_B, const MeanPose& pose,
                                    const LinearWater& water,
                                    const std::vector<double>& frequencies,
                                    const std::vector<double>& headings);

}  // namespace hydro

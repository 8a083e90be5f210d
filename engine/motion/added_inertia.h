#pragma once

#include <optional>

#include "engine/base/spatial_vector.h"
#include "engine/base/spec.h"

/// @file
/// Added mass as inertia: the 6×6 matrices that move with a body, and the effect of their changes.
///
/// A body and the water that it moves have the momentum (M + A) u, with u the velocity relative to
/// the water. As the body enters, A grows and the momentum stays; as it leaves, the water keeps its
/// share and u stays. A change ΔA over a substep is both at once in different directions: in the
/// basis x_i in which ΔA x_i = μ_i (M + A) x_i and x_i·(M + A) x_j = δ_ij, A grows where μ_i > 0.
/// Half of the change, an update with the inertia M + A + ½ΔA, and the other half give
///
///     u⁺ = Σ x_i c_i / (1 + max(μ_i, 0)) + S⁻¹ h F,        u = Σ x_i c_i,                  (E4)
///
/// where S is 1 + max(μ_i, ½μ_i) in the same basis: in directions of growth the momentum changes by
/// h F exactly. ΔA is the change from the start to the end of the substep, so A belongs to the pose
/// at both, and the substep is symmetric in time.
///
/// Stability. The energy before is ½ Σ c_i². After, without F, it is ½ Σ c_i²/(1 + μ_i) in the
/// directions of growth and ½ Σ c_i² (1 + μ_i) in the others, nowhere more. No sequence of changes
/// adds energy, whatever the ratio of A to M, the substep or the pose; and no force −A·a of an
/// earlier acceleration appears, which diverges where A exceeds M.

namespace engine {

/// Basis of the velocities that are left to a body, one per column.
using Subspace = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 3>;

/// The velocities that locks or a reduced joint leave to a body.
struct Mobility {
  DofMask locked = {};               ///< Components that do not change.
  std::optional<Subspace> subspace;  ///< N of (E10), which then takes the place of `locked`.
};

/// M about the centre of mass, body axes.
Matrix6d rigid_inertia(const BodySpec& body);

/// (E4) without its last term, and the inertia for that. All are in the same axes.
struct InertiaChange {
  Matrix6d inertia;   ///< S, which loads within the substep act on.
  Vector6d velocity;  ///< u⁺ without loads.
};

/// @param inertia    M + A at the start of the substep.
/// @param change     ΔA over the substep.
/// @param mobility   Other velocities take no part.
InertiaChange inertia_change(const Matrix6d& inertia, const Matrix6d& change,
                             const Mobility& mobility, const Vector6d& u);

/// Solves matrix·x = rhs in the velocities of the mobility. The matrix is symmetric and positive
/// definite.
Vector6d solve_free(Matrix6d matrix, Vector6d rhs, const Mobility& mobility);

/// The inverse of S in the velocities that locks leave, and zero in the others.
Matrix6d mobility_matrix(const Matrix6d& S, const DofMask& locked);

}  // namespace engine

#pragma once

#include <optional>

#include "engine/spatial_vector.h"
#include "engine/spec.h"

/// @file
/// Added mass as inertia: the 6×6 matrices that move with a body, and what a change of them does.
///
/// The momentum of a body and the water that it moves is (M + A) u, with u the velocity relative to
/// the water. As the body enters, A grows and the momentum stays; as it leaves, the water keeps its
/// share and u stays. A change ΔA over a step is both at once in different directions: in the basis
/// x_i in which ΔA x_i = μ_i (M + A) x_i and x_i·(M + A) x_j = δ_ij, growth is the part with μ_i >
/// 0. Half of the change, the step's update with the inertia M + A + ½ΔA, and the other half give
///
///     u⁺ = Σ x_i c_i / (1 + max(μ_i, 0)) + S⁻¹ h F,        u = Σ x_i c_i,                  (E4)
///
/// where S is 1 + max(μ_i, ½μ_i) in the same basis: in directions of growth the momentum changes by
/// h F exactly. ΔA is that from the start to the end of the step, so that A belongs to the pose at
/// both and the step is symmetric in time.
///
/// Stability. The energy before is ½ Σ c_i². After, without F, it is ½ Σ c_i²/(1 + μ_i) in the
/// directions of growth and ½ Σ c_i² (1 + μ_i) in the others, nowhere more. So no sequence of
/// changes can feed the motion, whatever the ratio of A to M, the step or the pose; a force −A·a
/// taken from an earlier step, which diverges where A exceeds M, never appears.

namespace engine {

/// Velocities that are left to a body, one a column.
using Subspace = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 3>;

/// How a body by itself may go, in the axes of what it is given with.
struct Mobility {
  DofMask locked = {};               ///< Not so,
  std::optional<Subspace> subspace;  ///< and only so, where they are given: N of reduced_joint.h.
};

/// M about the centre of mass, body axes.
Matrix6d rigid_inertia(const BodySpec& body);

/// (E4) without its last term, and what that needs. All in the same axes.
struct InertiaChange {
  Matrix6d inertia;   ///< S: what loads within the step work against.
  Vector6d velocity;  ///< u⁺ without loads.
};

/// @param inertia   M + A at the start of the step.
/// @param change    ΔA over the step.
/// @param mobility   What is not free takes no part.
InertiaChange inertia_change(const Matrix6d& inertia, const Matrix6d& change,
                             const Mobility& mobility, const Vector6d& u);

/// Solves matrix·x = rhs for what is free; x is zero in the rest. The matrix is symmetric and
/// positive definite.
Vector6d solve_free(Matrix6d matrix, Vector6d rhs, const Mobility& mobility);

}  // namespace engine

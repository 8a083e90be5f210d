#pragma once

#include <vector>

#include "hydro/bem/galerkin.h"

/// @file
/// What a linear potential lacks of the true one, from its kinks.
///
/// The water slips along the body with ∇ψ + w_t, which is smooth within faces. The jump J of its
/// component across an edge, seen with both panels unfolded into a plane, measures what linear
/// functions miss there. In the norm of the equation, half an order above the mean square, that is
/// h a J² for an edge between panels of total area a and height h over the edge; and the added mass
/// lacks the square of the norm: κ Σ h a J_m J_n. For a smooth flow κ is 0.004; beside sharp edges
/// of the body, where the flow is singular, it is ten times that (kSmooth, kSharp).

namespace hydro::bem {

/// κ, from bodies of known added mass: spheres, spheroids and tori; cube, tetrahedron, octahedron
/// and icosahedron, on which it lies between 0.033 and 0.060 (1,500 to 5,000 panels).
inline constexpr double kSmooth = 0.004;
inline constexpr double kSharp = 0.038;

struct Kinks {
  Matrix6d missing = Matrix6d::Zero();  ///< What the added mass for ρ = 1 lacks, not negative.
  /// What each edge has of it by its length: what halving it would gain, in any motion.
  std::vector<double> of_edge;
};

/// @param weight   For the motions: the inverse of what their added mass, for ρ = 1, is compared
/// to.
Kinks find_kinks(const TriMesh& mesh, const std::vector<Element>& elements, const Edges& edges,
                 const Potential& psi, const Matrix6d& weight);

}  // namespace hydro::bem

#pragma once

#include <Eigen/Core>

#include "hydro/added_mass/bem/dense.h"
#include "hydro/added_mass/bem/surface.h"
#include "hydro/spatial.h"

/// @file
/// The potential of a body that moves in unbounded fluid, by Galerkin's method with functions that
/// are quadratic on every panel and continuous.
///
/// ψ is minus the velocity potential, so that ∂ψ/∂n = −w·n for the body's velocity field w: e, or
/// e × r. The double layer of ψ is the field of a vortex sheet, and a field with the body's motion
/// inside has vorticity 2e there. What its normal component must be on the surface reads, for all
/// test functions v, with curl v = n × ∇v,
///
///     (1/4π) ∫∫ curl ψ·curl v / r = ∫ (w·n) v + ∫ curl v·a,
///     4π a(x) = ∫_V curl w / r − ∫_S (n × w) / r.
///
/// For translations a is that of ψ + x_m, a function of the same space, so that ν = ψ + x_m has
/// a right-hand side without it. For rotations the divergence theorem makes
/// 4π a = Σ_T [(n·e) ∫_T y/r − e (n·x) ∫_T 1/r]. No kernel stronger than 1/r is met, and with
/// exact integrals the added mass is in error by the square of the error of ψ.
///
/// The functions are the hats λ of the vertices, and for each edge the bubble 4 λ_i λ_j of its
/// ends: ψ is linear between vertices, and a bubble's coefficient is what it has beyond that in the
/// middle of the edge. The hats alone make the linear functions; that space's solution tells how
/// well panels resolve the flow.
///
/// Constants on each closed part are free; the solvers set them so that each part's hats have a
/// mean of 0, and anchored() as the fluid at rest far away sets them.

namespace hydro::bem {

/// Coefficients: a row a vertex, then a row an edge; a column a motion.
using Potential = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Vertices and edges.
inline Eigen::Index function_count(const Surface& surface) {
  return surface.vertex_count() + static_cast<Eigen::Index>(surface.edges.faces.size());
}

/// The rows of the functions on a face: its corners, then its edges from corner i to i + 1.
std::array<int, 6> functions_of(const Surface& surface, std::size_t face);

/// ∫ N_m φ_k dS for function k and motion m, N = (n, r × n).
Potential loads_on(const Surface& surface);

/// The right-hand sides, those of translations for ν.
Potential right_hand_sides(const Surface& surface, const std::vector<Swirl>& swirl);

/// ψ from what the right-hand sides give: the coordinates taken off again.
Potential potential_of(const Surface& surface, Potential solution);

/// ∫ λ_i dS for each vertex [m^2].
Eigen::VectorXd areas_of_vertices(const Surface& surface);

/// A solution and how far its added mass may be from that of the surface.
///
/// A flow that is singular as r^γ along an edge is found by polynomials of degree p with an error
/// of the added mass that falls as p^(−4γ) on the same panels (Stephan and Suri, 1989); γ = π/ω
/// where the fluid fills an angle ω beside the edge, from 1/2 at a knife's edge over 2/3 at a
/// cube's to 1 at a flat joint, beyond which flows are smooth and errors fall faster. So what
/// quadratic functions lack is between 0 and 1/3 of what they have gained over linear ones on the
/// same panels, less than 1/5 at a cube's edges; beside the corners of coarse panels up to 2/5. ψ
/// is taken kBeyond of the gain farther, and as much stands for the doubt.
struct Solution {
  Potential psi;
  Matrix6d doubt = Matrix6d::Zero();  ///< What the added mass for ρ = 1 may be wrong by.
  Eigen::Index unknowns = 0;
  double bytes = 0;  ///< Of what was stored.
  int steps = 0;     ///< Of the iteration.
};
inline constexpr double kBeyond = 0.2;

/// Solves with every interaction stored.
/// @throws std::invalid_argument if the panels are too thin for that.
Solution solve_dense(const Surface& surface);

/// Solves by compressed interactions, for large meshes: with hats alone, and nothing beyond. The
/// doubt follows from what each bubble by itself would gain.
/// @throws std::invalid_argument if the iteration does not converge.
Solution solve_compressed(const Surface& surface);

/// ψ with constants such that the fluid is at rest far away. A cavity's potential has no such
/// constant: the hats on its wall get a mean of 0.
Potential anchored(const Surface& surface, Potential psi);

}  // namespace hydro::bem

#pragma once

#include <Eigen/Core>

#include "hydro/added_mass/bem/dense.h"
#include "hydro/added_mass/bem/surface.h"
#include "hydro/spatial.h"

/// @file
/// The potential of a body that moves in unbounded fluid, by Galerkin's method with continuous
/// functions that are quadratic on every panel.
///
/// ψ is minus the velocity potential, so that ∂ψ/∂n = −w·n for the body's velocity field w, which
/// is e or e × r. The double layer of ψ is the field of a vortex sheet, and a field with the body's
/// motion inside has vorticity 2e there. The condition on its normal component at the surface is,
/// for all test functions v with curl v = n × ∇v,
///
///     (1/4π) ∫∫ curl ψ·curl v / r = ∫ (w·n) v + ∫ curl v·a,
///     4π a(x) = ∫_V curl w / r − ∫_S (n × w) / r.
///
/// For translations ν = ψ + x_m, a function of the same space, absorbs the term with a, so its
/// right-hand side has none. For rotations the divergence theorem gives 4π a = Σ_T [(n·e) ∫_T y/r −
/// e (n·x) ∫_T 1/r]. No kernel is stronger than 1/r, and with exact integrals the error of the
/// added mass is quadratic in the error of ψ.
///
/// The basis functions are the hats λ of the vertices and, for each edge, the bubble 4 λ_i λ_j of
/// its ends: hats interpolate linearly between vertices, and a bubble's coefficient is the
/// deviation from that at the middle of the edge. The hats alone span the linear functions; the
/// solution in that space shows how well the panels resolve the flow.
///
/// A constant on each closed part is free. The solvers set it so that the part's hats have a mean
/// of 0, with constants that bring the fluid to rest far away (with_far_field_constants).

namespace hydro::bem {

/// Coefficients: one row per vertex, then one per edge; one column per motion.
using Potential = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Number of vertices and edges.
inline Eigen::Index function_count(const Surface& surface) {
  return surface.vertex_count() + static_cast<Eigen::Index>(surface.edges.faces.size());
}

/// The rows of the functions on a face: its corners, then its edges from corner i to i + 1.
std::array<int, 6> functions_of(const Surface& surface, std::size_t face);

/// ∫ N_m φ_k dS for function k and motion m, N = (n, r × n).
Potential loads_on(const Surface& surface);

/// Right-hand sides; the columns of translations are for ν.
Potential right_hand_sides(const Surface& surface,
                           const std::vector<RotationMoments>& rotation_moments);

/// Returns ψ from a solution for these right-hand sides: it subtracts x_m from ν.
Potential potential_of(const Surface& surface, Potential solution);

/// ∫ λ_i dS for each vertex [m^2].
Eigen::VectorXd areas_of_vertices(const Surface& surface);

/// A solution and an estimate of the error of its added mass.
///
/// If the flow is singular as r^γ along an edge, polynomials of degree p give an error of the added
/// mass that falls as p^(−4γ) on the same panels (Stephan and Suri, 1989). Here γ = π/ω where the
/// fluid fills an angle ω beside the edge: 1/2 at a knife edge, 2/3 at a cube's, 1 at a flat joint,
/// beyond which flows are smooth and errors fall faster. The error of quadratic functions is
/// therefore between 0 and 1/3 of their gain over linear ones on the same panels: less than 1/5 at
/// a cube's edges, and up to 2/5 beside the corners of coarse panels. ψ is extrapolated by kBeyond
/// times the gain; the same amount is the error estimate.
struct Solution {
  Potential psi;
  Matrix6d error_estimate = Matrix6d::Zero();  ///< Estimated error of the added mass for ρ = 1.
  Eigen::Index unknowns = 0;
  double bytes = 0;  ///< Size of the stored interactions.
  int steps = 0;     ///< Number of iterations.
};
inline constexpr double kBeyond = 0.2;

/// Solves with every interaction stored.
/// @throws std::invalid_argument if the panels are too thin for the factorisation.
Solution solve_dense(const Surface& surface);

/// Solves by compressed interactions, for large meshes: with hats alone and without extrapolation.
/// The error estimate follows from the gain that each bubble alone would bring.
/// @throws std::invalid_argument if the iteration does not converge.
Solution solve_compressed(const Surface& surface);

/// ψ with constants such that the fluid is at rest far away. A cavity's potential has no such
/// constant: the hats on its wall keep their mean of 0.
Potential with_far_field_constants(const Surface& surface, Potential psi);

}  // namespace hydro::bem

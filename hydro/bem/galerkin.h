#pragma once

#include <Eigen/Core>

#include "hydro/bem/surface.h"
#include "hydro/spatial.h"

/// @file
/// The potential of a body that moves in unbounded fluid, by Galerkin's method with functions that
/// are linear on every panel and continuous.
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
/// Constants on each closed part are free; they are set by solve() so that each part's mean is 0,
/// and by anchored() as the fluid at rest far away sets them.

namespace hydro::bem {

/// A row a vertex, a column a motion.
using Potential = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// ∫ N_m λ_i dS for vertex i and motion m, N = (n, r × n).
Potential loads_on(const TriMesh& mesh, const std::vector<Element>& elements);

/// The right-hand sides, those of translations for ν.
/// @param swirl   As in DenseInteractions.
Potential right_hand_sides(const TriMesh& mesh, const std::vector<Element>& elements,
                           const std::vector<Eigen::Matrix3d>& swirl);

/// ψ from what the right-hand sides give: the coordinates taken off again, means set to 0.
Potential potential_of(const TriMesh& mesh, const std::vector<Element>& elements,
                       const Parts& parts, Potential solution);

/// ∫ λ_i dS on the part of vertex i [m^2].
Eigen::VectorXd areas_of_vertices(const TriMesh& mesh, const std::vector<Element>& elements);

/// Solves with every interaction stored, by Cholesky's method.
Potential solve_dense(const TriMesh& mesh, const std::vector<Element>& elements,
                      const Parts& parts);

/// A solution by conjugate gradients on compressed interactions.
struct LargeSolution {
  Potential psi;
  double bytes = 0;  ///< Of what was stored.
  int steps = 0;     ///< Of the iteration.
};
/// @throws std::invalid_argument if the iteration does not converge.
LargeSolution solve_compressed(const TriMesh& mesh, const std::vector<Element>& elements,
                               const Parts& parts);

/// ψ with constants such that the fluid is at rest far away. A cavity's potential has no such
/// constant: its wall keeps a mean of 0.
Potential anchored(const TriMesh& mesh, const std::vector<Element>& elements, const Parts& parts,
                   Potential psi);

}  // namespace hydro::bem

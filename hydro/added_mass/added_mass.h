#pragma once

#include <array>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/spatial.h"

/// @file
/// Added mass of a wholly submerged body in unbounded fluid.
///
/// ψ_m is the fluid's potential for unit motion m of the body (surge … yaw), counted so that it is
/// positive ahead of the body: ∂ψ_m/∂n = −N_m on the surface with N = (n, r × n), n out of the body
/// and r from the origin of B; velocity is −∇ψ. Then A_mn = ρ ∫ ψ_m N_n dS is the added mass, which
/// is symmetric and not negative.
///
/// Bodies may be thin, concave, pierced or in several parts. Fluid in a closed cavity belongs to
/// the added mass: it moves as the cavity's walls make it, as a whole in translation. Its potential
/// has a mean of 0 on the walls; everywhere else ψ vanishes far away, so parts of the integral mean
/// something by themselves.

namespace hydro {

/// How the potential is sought.
enum class AddedMassMethod {
  galerkin,  ///< Quadratic on panels of its own, split until the tolerance is met.
  constant   ///< Constant on each face, collocation at centroids: the plain method, for comparison.
};

/// Options of solve_added_mass().
struct AddedMassOptions {
  AddedMassMethod method = AddedMassMethod::galerkin;  ///< Functions and panels of the solution.
  /// Tolerance of the error that finer panels would lessen, relative as in
  /// AddedMassSolution::error_estimate. The estimate alone counts the flow around single facets of
  /// the mesh, which a round body does not have.
  double tolerance = 1e-3;
  /// Faces are split no further than to this many panels; a mesh with more is solved as it is. Time
  /// and memory grow with the square of the panels up to 5,000; a larger mesh gets linear functions
  /// and compressed interactions, in a time and memory that grow as F log F.
  int most_panels = 2000;
};

/// ψ of the six motions on a triangle, linear: a row a motion, a column a corner.
using CornerPotentials = Eigen::Matrix<double, 6, 3>;

/// The added mass of a body in unbounded fluid.
struct AddedMassSolution {
  /// A for ρ = 1, about the origin of B, body axes; symmetric.
  Matrix6d matrix = Matrix6d::Zero();
  /// Largest |A_mn − A_nm| before it was made symmetric, measured as error_estimate.
  double symmetry_error = 0;
  /// Expected bound of the error of A: |x·ΔA·y| over √(x·S·x y·S·y) for any two motions x, y, with
  /// S = A and a tenth of the displaced fluid's own inertia. Not known (0) for the constant method.
  double error_estimate = 0;
  /// Per face of the mesh the best linear fit of ψ (least squares): Σ triangle_share over the faces
  /// is `matrix` to within its symmetry error.
  std::vector<CornerPotentials> potentials;
  int panels = 0;      ///< Triangles on which it was solved.
  int unknowns = 0;    ///< Number of unknowns of the solution.
  double seconds = 0;  ///< Wall time [s].
  double bytes = 0;    ///< Size of the largest arrays held at a time.
};

/// Solves for the added mass of a body, far from any surface.
/// @param mesh_B   Closed and outward; moments are about its origin.
/// @throws std::invalid_argument if the mesh is not closed, or encloses nothing.
AddedMassSolution solve_added_mass(const TriMesh& mesh_B, const AddedMassOptions& options = {});

/// The solution of a body about another origin: A' = T A Tᵀ and ψ' = T ψ with T = (1, 0; −[p]×, 1).
/// @param p   The new origin, in the old frame; the axes stay.
AddedMassSolution moved_origin(AddedMassSolution solution, const Eigen::Vector3d& p);

/// ∫ ψ_m N_n dS over a triangle on which ψ is linear: a row a motion m, a column a component n.
/// Exact. For a part of a face, interpolate the face's potentials to the part's corners.
Matrix6d triangle_share(const std::array<Eigen::Vector3d, 3>& corners_B,
                        const CornerPotentials& potentials);

}  // namespace hydro

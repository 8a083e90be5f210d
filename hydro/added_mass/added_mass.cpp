#include "hydro/added_mass/added_mass.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "hydro/added_mass/bem/adapt.h"
#include "hydro/added_mass/bem/collocation.h"
#include "hydro/added_mass/bem/facet_error.h"
#include "hydro/added_mass/bem/galerkin.h"
#include "hydro/decompositions.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"

namespace hydro {
namespace {

using bem::Element;
using bem::Potential;
using bem::Surface;
using Eigen::Index;
using Eigen::Vector3d;

/// Least error that is claimed: that of the integrals over pairs of panels.
constexpr double kLeastError = 1e-4;

/// With more panels interactions are compressed: slower for fewer, but F log F instead of F².
constexpr std::size_t kMostStored = 5000;

/// Everything found on one set of panels.
struct Stage {
  Surface surface;
  std::vector<int> parent;  ///< Face of which each panel is a part.
  bem::Solution solution;
  Matrix6d matrix;  ///< Not made symmetric.
  Matrix6d scale;
  double error = 0;  ///< Error that finer panels would lessen.
};

/// Scale of errors: the added mass and a tenth of the displaced fluid's own inertia about the
/// origin. It transforms as the added mass does.
Matrix6d scale_of(const Matrix6d& matrix, const SolidProperties& solid) {
  const Eigen::Matrix3d cross = cross_matrix(solid.centroid);
  Matrix6d inertia;
  inertia << solid.volume * Eigen::Matrix3d::Identity(), -solid.volume * cross,
      solid.volume * cross, solid.inertia - solid.volume * cross * cross;
  return 0.5 * (matrix + matrix.transpose()) + 0.1 * inertia;
}

/// The largest |x·difference·y| over vectors with x·scale·x = y·scale·y = 1.
double largest_relative(const Matrix6d& difference, const Matrix6d& scale) {
  const Cholesky6 root(scale);
  Matrix6d relative;
  for (int i = 0; i < 6; ++i) relative.col(i) = root.solve_lower(difference.col(i));
  for (int i = 0; i < 6; ++i)
    relative.row(i) = root.solve_lower(relative.row(i).transpose()).transpose();
  return std::sqrt(eigenvalues(Matrix6d(relative.transpose() * relative))[5]);
}

Stage solve_on(bem::Split split, const SolidProperties& solid) {
  Stage stage{bem::make_surface(split.mesh), std::move(split.parent)};
  stage.solution = stage.surface.face_count() > kMostStored ? bem::solve_compressed(stage.surface)
                                                            : bem::solve_dense(stage.surface);
  stage.matrix = stage.solution.psi.transpose() * bem::loads_on(stage.surface);
  stage.scale = scale_of(stage.matrix, solid);
  stage.error = largest_relative(stage.solution.error_estimate, stage.scale) + kLeastError;
  return stage;
}

Stage refined_until(const TriMesh& mesh_B, const SolidProperties& solid,
                    const AddedMassOptions& options) {
  std::vector<int> own(static_cast<std::size_t>(mesh_B.face_count()));
  std::iota(own.begin(), own.end(), 0);
  Stage stage = solve_on({mesh_B, own}, solid);
  while (stage.error > options.tolerance && mesh_B.face_count() < options.most_panels) {
    const std::vector<bool> marked =
        bem::edges_to_halve(stage.surface, stage.solution.psi, stage.scale.inverse());
    bem::Split finer =
        bem::bisected({stage.surface.mesh, stage.parent}, stage.surface.edges, marked);
    if (finer.mesh.face_count() > options.most_panels) break;
    stage = solve_on(std::move(finer), solid);
  }
  return stage;
}

/// ∫ ψ λ_j over a panel: a column a corner.
CornerPotentials moments_on(const Surface& surface, std::size_t panel, const Potential& psi) {
  const std::array<int, 6> rows = bem::functions_of(surface, panel);
  const double area = surface.elements[panel].area;
  CornerPotentials moments = CornerPotentials::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector6d vertex = psi.row(rows[i]).transpose(), edge = psi.row(rows[3 + i]).transpose();
    for (std::size_t j = 0; j < 3; ++j) {
      // ∫ λ_i λ_j = area/12 (1 + δ_ij), and ∫ 4 λ_i λ_k λ_j is twice as large at the edge's ends.
      const bool opposite = j == (i + 2) % 3;
      moments.col(static_cast<Index>(j)) +=
          area / 12 * (i == j ? 2 : 1) * vertex + area / 15 * (opposite ? 1 : 2) * edge;
    }
  }
  return moments;
}

/// Fits ψ on each face of the mesh by what it is on the panels that the face was split into.
std::vector<CornerPotentials> projected(const TriMesh& mesh_B, const Stage& stage,
                                        const Potential& psi) {
  const std::vector<Element> faces = bem::make_elements(mesh_B);
  std::vector<CornerPotentials> potentials(faces.size(), CornerPotentials::Zero());
  for (std::size_t p = 0; p < stage.surface.face_count(); ++p) {
    const auto parent = static_cast<std::size_t>(stage.parent[p]);
    Eigen::Matrix3d hats;  // of the face's corners, a column each, at the panel's, a row each
    for (std::size_t k = 0; k < 3; ++k)
      hats.row(static_cast<Index>(k)) =
          bem::hats_at(faces[parent], stage.surface.elements[p].corners[k]).transpose();
    potentials[parent] += moments_on(stage.surface, p, psi) * hats;
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    // The inverse of ∫ λ_i λ_k = area/12 (1 + δ_ik).
    const Vector6d whole = potentials[f].rowwise().sum();
    potentials[f] = 12 / faces[f].area * (potentials[f].colwise() - whole / 4);
  }
  return potentials;
}

AddedMassSolution solve_about_origin(const TriMesh& mesh_B, const AddedMassOptions& options) {
  const Stage stage = refined_until(mesh_B, solid_properties(mesh_B), options);
  AddedMassSolution solution;
  solution.matrix = stage.matrix;
  // A flow that is as fine as panels is found in part or not at all: not both are lacking.
  solution.error_estimate =
      std::max(stage.error, largest_relative(bem::facet_error(stage.surface), stage.scale));
  solution.potentials =
      projected(mesh_B, stage, bem::with_far_field_constants(stage.surface, stage.solution.psi));
  solution.panels = static_cast<int>(stage.surface.face_count());
  solution.unknowns = static_cast<int>(stage.solution.unknowns);
  solution.bytes = stage.solution.bytes;
  return solution;
}

/// A' = T A Tᵀ and ψ' = T ψ with T = (1, 0; −[p]×, 1); A' is as symmetric as A.
AddedMassSolution with_origin_at(const Vector3d& p, AddedMassSolution solution) {
  Matrix6d shift = Matrix6d::Identity();
  shift.bottomLeftCorner<3, 3>() = -cross_matrix(p);
  solution.matrix = (shift * solution.matrix * shift.transpose()).eval();
  for (CornerPotentials& psi : solution.potentials) psi = (shift * psi).eval();
  return solution;
}

/// Solves about the centroid and moves the result, so that a moved body's is the same to round-off.
AddedMassSolution solve_on_panels(const TriMesh& mesh_B, const Vector3d& centroid,
                                  const AddedMassOptions& options) {
  return with_origin_at(-centroid, solve_about_origin(translated(mesh_B, -centroid), options));
}

AddedMassSolution solve_constant(const TriMesh& mesh_B) {
  const Surface surface = bem::make_surface(mesh_B);
  const Potential psi = bem::collocate(surface);
  AddedMassSolution solution;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    solution.potentials.push_back(psi.row(static_cast<Index>(f)).transpose() *
                                  Eigen::RowVector3d::Ones());
    solution.matrix += triangle_share(surface.elements[f].corners, solution.potentials.back());
  }
  solution.panels = solution.unknowns = static_cast<int>(surface.face_count());
  solution.bytes = 8 * std::pow(static_cast<double>(surface.face_count()), 2);
  return solution;
}

void check(const TriMesh& mesh_B, const SolidProperties& solid) {
  const MeshReport report = check_mesh(mesh_B);
  if (report.closed() && report.misoriented_edges.count == 0 && solid.volume > 0) return;
  const std::vector<std::string> faults = describe(report);
  throw std::invalid_argument("no added mass: expected a closed mesh, turned outward" +
                              (faults.empty() ? std::string() : "; " + faults.front()));
}

}  // namespace

AddedMassSolution solve_added_mass(const TriMesh& mesh_B, const AddedMassOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const SolidProperties solid = solid_properties(mesh_B);
  check(mesh_B, solid);
  AddedMassSolution solution = options.method == AddedMassMethod::galerkin
                                   ? solve_on_panels(mesh_B, solid.centroid, options)
                                   : solve_constant(mesh_B);
  const Matrix6d scale = scale_of(solution.matrix, solid);
  solution.symmetry_error = largest_relative(solution.matrix - solution.matrix.transpose(), scale);
  solution.matrix = (0.5 * (solution.matrix + solution.matrix.transpose())).eval();
  if (options.method == AddedMassMethod::galerkin)
    solution.error_estimate += solution.symmetry_error;
  solution.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return solution;
}

AddedMassSolution moved_origin(AddedMassSolution solution, const Vector3d& p) {
  AddedMassSolution moved = with_origin_at(p, std::move(solution));
  moved.matrix = (0.5 * (moved.matrix + moved.matrix.transpose())).eval();
  return moved;
}

Matrix6d triangle_share(const std::array<Vector3d, 3>& corners_B,
                        const CornerPotentials& potentials) {
  const Vector3d area = 0.5 * (corners_B[1] - corners_B[0]).cross(corners_B[2] - corners_B[0]);
  const Vector6d whole = potentials.rowwise().sum();
  Matrix6d share;
  share.leftCols<3>() = whole / 3 * area.transpose();
  share.rightCols<3>().setZero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector6d weight = (whole + potentials.col(static_cast<Index>(i))) / 12;
    share.rightCols<3>() += weight * corners_B[i].cross(area).transpose();
  }
  return share;
}

}  // namespace hydro

#include "hydro/added_mass.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "hydro/bem/collocation.h"
#include "hydro/bem/estimate.h"
#include "hydro/mass_properties.h"
#include "hydro/mesh_check.h"

namespace hydro {
namespace {

using bem::Element;
using bem::Potential;
using Eigen::Index;
using Eigen::Vector3d;

/// Of the correction for what linear potentials lack, the part that may be wrong.
constexpr double kDoubt = 0.7;

/// Least error that is claimed: that of the integrals over pairs of panels.
constexpr double kLeastError = 1e-4;

/// Edges are halved that hold this part of the kinks. With less there are more solves, with more
/// the panels are less well spread.
constexpr double kHalvedPart = 0.7;

/// With more panels interactions are compressed: slower for fewer, but F log F instead of F².
constexpr Index kMostStored = 6000;

/// Everything found on one set of panels.
struct Stage {
  bem::Split split;
  std::vector<Element> elements;
  bem::Parts parts;
  bem::Edges edges;
  Potential psi;
  Matrix6d scale;
  bem::Kinks kinks;
  Matrix6d matrix;  ///< Not made symmetric.
  double bytes = 0;
};

/// What errors are measured by: the added mass and a tenth of the displaced fluid's own inertia
/// about the origin. Turned or moved, it transforms as the added mass does.
Matrix6d scale_of(const Matrix6d& matrix, const SolidProperties& solid) {
  const Vector3d& c = solid.centroid;
  Eigen::Matrix3d cross;
  cross << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
  Matrix6d inertia;
  inertia << solid.volume * Eigen::Matrix3d::Identity(), -solid.volume * cross,
      solid.volume * cross, solid.inertia - solid.volume * cross * cross;
  return 0.5 * (matrix + matrix.transpose()) + 0.1 * inertia;
}

/// The largest |x·difference·y| over vectors with x·scale·x = y·scale·y = 1.
double largest_relative(const Matrix6d& difference, const Matrix6d& scale) {
  const Matrix6d root = Matrix6d(scale.llt().matrixL()).inverse();
  return (root * difference * root.transpose()).jacobiSvd().singularValues()[0];
}

Stage solve_on(bem::Split split, const SolidProperties& solid) {
  Stage stage{.split = std::move(split)};
  const TriMesh& mesh = stage.split.mesh;
  stage.elements = bem::make_elements(mesh);
  stage.parts = bem::parts_of(mesh);
  stage.edges = bem::edges_of(mesh);
  if (mesh.face_count() > kMostStored) {
    bem::LargeSolution large = bem::solve_compressed(mesh, stage.elements, stage.parts);
    stage.psi = std::move(large.psi);
    stage.bytes = large.bytes;
  } else {
    stage.psi = bem::solve_dense(mesh, stage.elements, stage.parts);
    stage.bytes = 8 * static_cast<double>(mesh.face_count() * mesh.face_count() +
                                          mesh.vertex_count() * mesh.vertex_count());
  }
  stage.matrix = stage.psi.transpose() * bem::loads_on(mesh, stage.elements);
  stage.scale = scale_of(stage.matrix, solid);
  stage.kinks =
      bem::find_kinks(mesh, stage.elements, stage.edges, stage.psi, stage.scale.inverse());
  return stage;
}

double estimated_error(const Stage& stage) {
  return kDoubt * largest_relative(stage.kinks.missing, stage.scale) + kLeastError;
}

/// The edges with the largest kinks that together hold kHalvedPart of them. Equal ones go
/// together, whatever round-off says.
std::vector<bool> edges_to_halve(const std::vector<double>& kinks) {
  std::vector<double> sorted = kinks;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  double whole = 0, held = 0, least = 0;
  for (const double kink : sorted) whole += kink;
  for (std::size_t i = 0; i < sorted.size() && held < kHalvedPart * whole; ++i) {
    held += sorted[i];
    least = sorted[i];
  }
  std::vector<bool> marked(kinks.size());
  for (std::size_t i = 0; i < kinks.size(); ++i) marked[i] = kinks[i] >= least * (1 - 1e-6);
  return marked;
}

Stage refined_until(const TriMesh& mesh_B, const SolidProperties& solid,
                    const AddedMassOptions& options) {
  Stage stage = solve_on({mesh_B, {}}, solid);
  stage.split.parent.resize(static_cast<std::size_t>(mesh_B.face_count()));
  for (std::size_t f = 0; f < stage.split.parent.size(); ++f)
    stage.split.parent[f] = static_cast<int>(f);
  while (estimated_error(stage) > options.tolerance) {
    bem::Split finer = bem::bisected(stage.split, stage.edges, edges_to_halve(stage.kinks.of_edge));
    if (finer.mesh.face_count() > options.most_panels) break;
    stage = solve_on(std::move(finer), solid);
  }
  return stage;
}

/// Each motion's ψ mixed from those found such that the added mass gains what the kinks say it
/// lacks. Motions without added mass are left alone.
Potential corrected(const Stage& stage) {
  Matrix6d stiff = stage.matrix;
  stiff += 1e-3 * stage.scale;
  const Matrix6d mix = stiff.partialPivLu().solve(stage.kinks.missing);
  return stage.psi + stage.psi * mix;
}

/// Fits ψ on each face of the mesh by what it is on the panels that the face was split into.
std::vector<CornerPotentials> fitted(const TriMesh& mesh_B, const Stage& stage,
                                     const Potential& psi) {
  std::vector<CornerPotentials> moments(static_cast<std::size_t>(mesh_B.face_count()),
                                        CornerPotentials::Zero());
  const std::vector<Element> faces = bem::make_elements(mesh_B);
  for (std::size_t p = 0; p < stage.elements.size(); ++p) {
    const auto parent = static_cast<std::size_t>(stage.split.parent[p]);
    const Element& face = faces[parent];
    CornerPotentials values;
    Eigen::Matrix3d hats;  // of the face's corners, a row each, at the panel's, a column each
    for (Index k = 0; k < 3; ++k) {
      values.col(k) = psi.row(stage.split.mesh.faces(k, static_cast<Index>(p))).transpose();
      const Vector3d offset =
          stage.elements[p].corners[static_cast<std::size_t>(k)] - face.centroid;
      for (std::size_t i = 0; i < 3; ++i)
        hats(static_cast<Index>(i), k) = 1.0 / 3 + face.curls[i].cross(face.normal).dot(offset);
    }
    moments[parent] +=
        stage.elements[p].area / 12 *
        (values.rowwise().sum() * hats.rowwise().sum().transpose() + values * hats.transpose());
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    // The inverse of ∫ λ_i λ_k = area/12 (1 + δ_ik).
    const Vector6d whole = moments[f].rowwise().sum();
    moments[f] = 12 / faces[f].area * (moments[f].colwise() - whole / 4);
  }
  return moments;
}

AddedMassSolution solve_linear(const TriMesh& mesh_B, const SolidProperties& solid,
                               const AddedMassOptions& options) {
  const Stage stage = refined_until(mesh_B, solid, options);
  const TriMesh& panels = stage.split.mesh;
  const Potential psi = bem::anchored(panels, stage.elements, stage.parts, corrected(stage));
  AddedMassSolution solution;
  solution.matrix = psi.transpose() * bem::loads_on(panels, stage.elements);
  solution.error_estimate = estimated_error(stage);
  solution.potentials = fitted(mesh_B, stage, psi);
  solution.panels = static_cast<int>(panels.face_count());
  solution.unknowns = static_cast<int>(panels.vertex_count());
  solution.bytes = stage.bytes;
  return solution;
}

AddedMassSolution solve_constant(const TriMesh& mesh_B) {
  const std::vector<Element> elements = bem::make_elements(mesh_B);
  const Potential psi = bem::collocate(mesh_B, elements, bem::parts_of(mesh_B));
  AddedMassSolution solution;
  for (std::size_t f = 0; f < elements.size(); ++f) {
    solution.potentials.push_back(psi.row(static_cast<Index>(f)).transpose() *
                                  Eigen::RowVector3d::Ones());
    solution.matrix += triangle_share(elements[f].corners, solution.potentials.back());
  }
  solution.panels = solution.unknowns = static_cast<int>(mesh_B.face_count());
  solution.bytes =
      8 * static_cast<double>(mesh_B.face_count()) * static_cast<double>(mesh_B.face_count());
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
  AddedMassSolution solution = options.method == AddedMassMethod::linear
                                   ? solve_linear(mesh_B, solid, options)
                                   : solve_constant(mesh_B);
  const Matrix6d scale = scale_of(solution.matrix, solid);
  solution.symmetry_error = largest_relative(solution.matrix - solution.matrix.transpose(), scale);
  solution.matrix = (0.5 * (solution.matrix + solution.matrix.transpose())).eval();
  solution.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return solution;
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

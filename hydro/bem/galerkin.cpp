#include "hydro/bem/galerkin.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hydro/bem/dense.h"

namespace hydro::bem {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double kPerSphere = 1 / (4 * std::numbers::pi);

/// Faces at each vertex, with the corner that it is.
std::vector<std::vector<std::pair<Index, int>>> corners_at(const TriMesh& mesh) {
  std::vector<std::vector<std::pair<Index, int>>> corners(
      static_cast<std::size_t>(mesh.vertex_count()));
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i)
      corners[static_cast<std::size_t>(mesh.faces(i, f))].emplace_back(f, i);
  }
  return corners;
}

/// (1/4π) Σ curl·curl' ∫∫ 1/r over the faces at each two vertices. Lower triangle.
Eigen::MatrixXd assembled(const TriMesh& mesh, const std::vector<Element>& elements,
                          const Eigen::MatrixXd& single) {
  const Index count = mesh.vertex_count();
  const auto corners = corners_at(mesh);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  tbb::parallel_for(tbb::blocked_range<Index>(0, count, 4), [&](const auto& range) {
    Eigen::Matrix3Xd potential(3, mesh.face_count());
    for (Index i = range.begin(); i < range.end(); ++i) {
      potential.setZero();
      for (const auto& [f, corner] : corners[static_cast<std::size_t>(i)])
        potential.noalias() +=
            elements[static_cast<std::size_t>(f)].curls[static_cast<std::size_t>(corner)] *
            (kPerSphere * single.col(f).transpose());
      for (Index f = 0; f < mesh.face_count(); ++f) {
        for (int c = 0; c < 3; ++c)
          matrix(mesh.faces(c, f), i) +=
              elements[static_cast<std::size_t>(f)].curls[static_cast<std::size_t>(c)].dot(
                  potential.col(f));
      }
    }
  });
  return matrix;
}

/// Adds what makes a constant on each part an equation of its own: that its mean is 0.
void pin_means(const TriMesh& mesh, const std::vector<Element>& elements, const Parts& parts,
               Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd areas = areas_of_vertices(mesh, elements);
  for (std::size_t k = 0; k < parts.volume.size(); ++k) {
    Eigen::VectorXd own = areas;
    for (Index i = 0; i < own.size(); ++i)
      if (parts.of_vertex[static_cast<std::size_t>(i)] != static_cast<int>(k)) own[i] = 0;
    // Any factor gives the same solution; this one is of the size of the other eigenvalues.
    matrix.selfadjointView<Eigen::Lower>().rankUpdate(own, std::pow(own.sum(), -1.5));
  }
}

}  // namespace

Potential loads_on(const TriMesh& mesh, const std::vector<Element>& elements) {
  Potential loads = Potential::Zero(mesh.vertex_count(), 6);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Element& element = elements[static_cast<std::size_t>(f)];
    for (std::size_t i = 0; i < 3; ++i) {
      auto row = loads.row(mesh.faces(static_cast<Index>(i), f));
      const Vector3d arm = (3 * element.centroid + element.corners[i]) / 4;
      row.head<3>() += element.area / 3 * element.normal.transpose();
      row.tail<3>() += element.area / 3 * arm.cross(element.normal).transpose();
    }
  }
  return loads;
}

Potential right_hand_sides(const TriMesh& mesh, const std::vector<Element>& elements,
                           const std::vector<Eigen::Matrix3d>& swirl) {
  Potential sides = loads_on(mesh, elements);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto t = static_cast<std::size_t>(f);
    for (std::size_t i = 0; i < 3; ++i)
      sides.row(mesh.faces(static_cast<Index>(i), f)).tail<3>() +=
          kPerSphere * elements[t].curls[i].transpose() * swirl[t];
  }
  return sides;
}

Eigen::VectorXd areas_of_vertices(const TriMesh& mesh, const std::vector<Element>& elements) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i)
      areas[mesh.faces(i, f)] += elements[static_cast<std::size_t>(f)].area / 3;
  }
  return areas;
}

Potential potential_of(const TriMesh& mesh, const std::vector<Element>& elements,
                       const Parts& parts, Potential solution) {
  solution.leftCols<3>() -= mesh.vertices.transpose();
  const Eigen::VectorXd areas = areas_of_vertices(mesh, elements);
  Potential sums = Potential::Zero(static_cast<Index>(parts.volume.size()), 6);
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(sums.rows());
  for (Index i = 0; i < solution.rows(); ++i) {
    const int part = parts.of_vertex[static_cast<std::size_t>(i)];
    sums.row(part) += areas[i] * solution.row(i);
    whole[part] += areas[i];
  }
  for (Index i = 0; i < solution.rows(); ++i) {
    const int part = parts.of_vertex[static_cast<std::size_t>(i)];
    solution.row(i) -= sums.row(part) / whole[part];
  }
  return solution;
}

Potential solve_dense(const TriMesh& mesh, const std::vector<Element>& elements,
                      const Parts& parts) {
  DenseInteractions interactions = dense_interactions(mesh, elements);
  const Potential sides = right_hand_sides(mesh, elements, interactions.swirl);
  Eigen::MatrixXd matrix = assembled(mesh, elements, interactions.single);
  interactions.single.resize(0, 0);
  pin_means(mesh, elements, parts, matrix);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(matrix);
  if (cholesky.info() != Eigen::Success)
    throw std::invalid_argument("the panels are too thin to solve for the added mass");
  return potential_of(mesh, elements, parts, cholesky.solve(sides));
}

}  // namespace hydro::bem

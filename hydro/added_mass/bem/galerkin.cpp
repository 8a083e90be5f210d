#include "hydro/added_mass/bem/galerkin.h"

#include <cmath>

#include "hydro/added_mass/bem/conjugate_gradients.h"
#include "hydro/added_mass/bem/dense.h"
#include "hydro/added_mass/bem/dense_symmetric.h"

namespace hydro::bem {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Residual of the bubbles' equations without hats, relative to their right-hand side. The error of
/// the added mass in rotation is as large, and a hundred times larger on slivers; with 1e-8 the
/// results for a rotated body differ by 1e-9.
constexpr double kResidual = 1e-10;

/// Adds an equation for the constant on each part: the mean of its hats is 0.
/// @param matrix   Lower triangle.
void pin_means(const Surface& surface, Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd areas = areas_of_vertices(surface);
  for (std::size_t k = 0; k < surface.parts.volume.size(); ++k) {
    Eigen::VectorXd own = areas;
    for (Index i = 0; i < own.size(); ++i)
      if (surface.parts.of_vertex[static_cast<std::size_t>(i)] != static_cast<int>(k)) own[i] = 0;
    // Any factor gives the same solution; this one has the size of the other eigenvalues.
    const double factor = std::pow(own.sum(), -1.5);
    matrix.topLeftCorner(own.size(), own.size())
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(own, factor);
  }
}

}  // namespace

std::array<int, 6> functions_of(const Surface& surface, std::size_t face) {
  std::array<int, 6> functions;
  for (std::size_t i = 0; i < 3; ++i) {
    functions[i] = surface.vertex(face, i);
    functions[3 + i] = static_cast<int>(surface.vertex_count()) + surface.edges.of_face[face][i];
  }
  return functions;
}

Potential loads_on(const Surface& surface) {
  Potential loads = Potential::Zero(function_count(surface), 6);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const Element& element = surface.elements[f];
    const std::array<int, 6> rows = functions_of(surface, f);
    // The integral of each of the six functions is a third of the area; its centre is `arm`.
    const auto add = [&](int row, const Vector3d& arm) {
      loads.row(row).head<3>() += element.area / 3 * element.normal.transpose();
      loads.row(row).tail<3>() += element.area / 3 * arm.cross(element.normal).transpose();
    };
    for (std::size_t i = 0; i < 3; ++i) {
      add(rows[i], (3 * element.centroid + element.corners[i]) / 4);
      add(rows[3 + i], (6 * element.centroid - element.corners[(i + 2) % 3]) / 5);
    }
  }
  return loads;
}

Potential right_hand_sides(const Surface& surface,
                           const std::vector<RotationMoments>& rotation_moments) {
  Potential sides = loads_on(surface);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto& curls = surface.elements[f].curls;
    const std::array<int, 6> rows = functions_of(surface, f);
    const Eigen::Matrix3d whole =
        rotation_moments[f][0] + rotation_moments[f][1] + rotation_moments[f][2];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      sides.row(rows[i]).tail<3>() += kPerSphere * curls[i].transpose() * whole;
      sides.row(rows[3 + i]).tail<3>() += 4 * kPerSphere *
                                          (curls[j].transpose() * rotation_moments[f][i] +
                                           curls[i].transpose() * rotation_moments[f][j]);
    }
  }
  return sides;
}

Eigen::VectorXd areas_of_vertices(const Surface& surface) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.vertex_count());
  for (std::size_t f = 0; f < surface.face_count(); ++f)
    for (std::size_t i = 0; i < 3; ++i) areas[surface.vertex(f, i)] += surface.elements[f].area / 3;
  return areas;
}

Potential potential_of(const Surface& surface, Potential solution) {
  solution.topLeftCorner(surface.vertex_count(), 3) -= surface.mesh.vertices.transpose();
  return solution;
}

Solution solve_dense(const Surface& surface) {
  DenseEquations equations = dense_equations(surface);
  const Potential sides = right_hand_sides(surface, equations.rotation_moments);
  pin_means(surface, equations.matrix);
  const Index hats = surface.vertex_count(), bubbles = sides.rows() - hats;
  const Eliminated without_hats(std::move(equations.matrix), hats);
  const Potential nodal = without_hats.solve(sides.topRows(hats));  // without bubbles
  Eigen::VectorXd inverse(bubbles);
  for (Index i = 0; i < bubbles; ++i) inverse[i] = 1 / without_hats.remaining(i, i);
  const Iterated iterated = conjugate_gradients(
      sides.bottomRows(bubbles) - without_hats.forward(nodal), kResidual,
      [&](const Potential& x) { return without_hats.apply(x); },
      [&](const Potential& r) { return Potential(inverse.asDiagonal() * r); });
  Potential gained(sides.rows(), 6);
  gained << -without_hats.solve(without_hats.backward(iterated.solution)), iterated.solution;
  Potential psi = gained;
  psi.topRows(hats) += nodal;
  Solution solution;
  solution.psi = potential_of(surface, std::move(psi)) + kBeyond * gained;
  solution.error_estimate = kBeyond * gained.transpose() * loads_on(surface);
  solution.unknowns = sides.rows();
  solution.bytes = 8 * static_cast<double>(sides.rows() * sides.rows());
  solution.steps = iterated.steps;
  return solution;
}

}  // namespace hydro::bem

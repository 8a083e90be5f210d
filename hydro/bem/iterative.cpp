#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hydro/bem/compressed.h"
#include "hydro/bem/galerkin.h"

namespace hydro::bem {
namespace {

using Eigen::Index;

constexpr double kPerSphere = 1 / (4 * std::numbers::pi);

/// Residuals are taken down to this part of the right-hand sides. For translations the added mass
/// is in error by its square.
constexpr double kResidual = 1e-3;
constexpr int kMostSteps = 1000;

/// The equations as they act on potentials.
class Equations {
 public:
  Equations(const TriMesh& mesh, const std::vector<Element>& elements, const Parts& parts,
            const CompressedInteractions& interactions)
      : mesh_(mesh),
        elements_(elements),
        parts_(parts),
        interactions_(interactions),
        areas_(areas_of_vertices(mesh, elements)),
        whole_(Eigen::VectorXd::Zero(static_cast<Index>(parts.volume.size()))) {
    for (Index i = 0; i < areas_.size(); ++i) whole_[part(i)] += areas_[i];
  }

  Potential apply(const Potential& psi) const {
    Columns sheet = Columns::Zero(mesh_.face_count(), 18);
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      for (Index i = 0; i < 3; ++i)
        for (Index axis = 0; axis < 3; ++axis)
          sheet.row(f).segment<6>(6 * axis) += curl(f, i)[axis] * psi.row(mesh_.faces(i, f));
    }
    const Columns field = interactions_.apply(sheet);
    Potential result = means_of(psi);
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      for (Index i = 0; i < 3; ++i)
        for (Index axis = 0; axis < 3; ++axis)
          result.row(mesh_.faces(i, f)) +=
              kPerSphere * curl(f, i)[axis] * field.row(f).segment<6>(6 * axis);
    }
    return result;
  }

  /// The largest part of each diagonal element, that of single panels.
  Eigen::VectorXd diagonal() const {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(mesh_.vertex_count());
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      for (Index i = 0; i < 3; ++i)
        diagonal[mesh_.faces(i, f)] +=
            kPerSphere * curl(f, i).squaredNorm() * interactions_.self(static_cast<std::size_t>(f));
    }
    return diagonal;
  }

 private:
  const Eigen::Vector3d& curl(Index face, Index corner) const {
    return elements_[static_cast<std::size_t>(face)].curls[static_cast<std::size_t>(corner)];
  }
  int part(Index vertex) const { return parts_.of_vertex[static_cast<std::size_t>(vertex)]; }

  /// As solve_dense gives each part's mean an equation.
  Potential means_of(const Potential& psi) const {
    Potential sums = Potential::Zero(whole_.size(), 6);
    for (Index i = 0; i < psi.rows(); ++i) sums.row(part(i)) += areas_[i] * psi.row(i);
    Potential result(psi.rows(), 6);
    for (Index i = 0; i < psi.rows(); ++i)
      result.row(i) = areas_[i] * std::pow(whole_[part(i)], -1.5) * sums.row(part(i));
    return result;
  }

  const TriMesh& mesh_;
  const std::vector<Element>& elements_;
  const Parts& parts_;
  const CompressedInteractions& interactions_;
  Eigen::VectorXd areas_;
  Eigen::VectorXd whole_;  ///< Area of each part [m^2].
};

/// a / b, and 0 where a motion is done with.
Vector6d ratio(const Vector6d& a, const Vector6d& b) {
  return (b.array() == 0).select(0, a.cwiseQuotient(b));
}

Vector6d products(const Potential& a, const Potential& b) {
  return a.cwiseProduct(b).colwise().sum().transpose();
}

}  // namespace

LargeSolution solve_compressed(const TriMesh& mesh, const std::vector<Element>& elements,
                               const Parts& parts) {
  const CompressedInteractions interactions(mesh, elements);
  const Equations equations(mesh, elements, parts, interactions);
  const Eigen::VectorXd diagonal = equations.diagonal();
  const auto preconditioned = [&](const Potential& r) {
    return Potential(diagonal.cwiseInverse().asDiagonal() * r);
  };
  Potential residual = right_hand_sides(mesh, elements, interactions.swirl());
  Potential solution = Potential::Zero(residual.rows(), 6);
  Potential direction = preconditioned(residual);
  Vector6d size = products(residual, direction);
  // A motion that moves no water, as a sphere's roll, is measured by the others.
  const Vector6d goal =
      (size.array().max(1e-12 * size.maxCoeff()) * kResidual * kResidual).matrix();
  int steps = 0;
  for (; (size.array() > goal.array()).any(); ++steps) {
    if (steps == kMostSteps)
      throw std::invalid_argument("the panels are too uneven to solve for the added mass");
    const Potential image = equations.apply(direction);
    const Vector6d step = ratio(size, products(direction, image));
    solution += direction * step.asDiagonal();
    residual -= image * step.asDiagonal();
    const Potential next = preconditioned(residual);
    const Vector6d next_size = products(residual, next);
    direction = next + direction * ratio(next_size, size).asDiagonal();
    size = next_size;
  }
  return {potential_of(mesh, elements, parts, solution), interactions.bytes(), steps};
}

}  // namespace hydro::bem

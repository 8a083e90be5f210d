#include <cmath>

#include "hydro/added_mass/bem/compressed.h"
#include "hydro/added_mass/bem/conjugate_gradients.h"
#include "hydro/added_mass/bem/galerkin.h"

namespace hydro::bem {
namespace {

using Eigen::Index;

/// Residual relative to the right-hand sides. The error of the added mass in translation is its
/// square.
constexpr double kIterativeResidual = 3e-4;

/// Lower bound of the bubbles' gain one by one over their gain together, to which neighbours
/// contribute: the ratio is 0.2 to 0.7 on boxes, cylinders, tori and spheres.
constexpr double kAlone = 0.2;

/// The matrix of the hats' equations as an operator on potentials.
class HatEquations {
 public:
  HatEquations(const Surface& surface, const CompressedInteractions& interactions)
      : surface_(surface),
        interactions_(interactions),
        areas_(areas_of_vertices(surface)),
        whole_(Eigen::VectorXd::Zero(static_cast<Index>(surface.parts.volume.size()))) {
    for (Index i = 0; i < areas_.size(); ++i) whole_[part(i)] += areas_[i];
  }

  Potential apply(const Potential& psi) const {
    const Columns field = interactions_.apply(sheet_of(psi));
    Potential result = means_of(psi);
    for (std::size_t f = 0; f < surface_.face_count(); ++f) {
      for (std::size_t i = 0; i < 3; ++i)
        for (Index axis = 0; axis < 3; ++axis)
          result.row(surface_.vertex(f, i)) +=
              kPerSphere * surface_.elements[f].curls[i][axis] *
              field.row(static_cast<Index>(f)).segment<6>(6 * axis);
    }
    return result;
  }

  /// curl ψ: for each element and axis, six motions.
  Columns sheet_of(const Potential& psi) const {
    Columns sheet = Columns::Zero(surface_.mesh.face_count(), 18);
    for (std::size_t f = 0; f < surface_.face_count(); ++f) {
      for (std::size_t i = 0; i < 3; ++i)
        for (Index axis = 0; axis < 3; ++axis)
          sheet.row(static_cast<Index>(f)).segment<6>(6 * axis) +=
              surface_.elements[f].curls[i][axis] * psi.row(surface_.vertex(f, i));
    }
    return sheet;
  }

  /// Dominant part of each diagonal element, from pairs of a panel with itself.
  Eigen::VectorXd diagonal() const {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(surface_.vertex_count());
    for (std::size_t f = 0; f < surface_.face_count(); ++f) {
      for (std::size_t i = 0; i < 3; ++i)
        diagonal[surface_.vertex(f, i)] +=
            kPerSphere * surface_.elements[f].curls[i].squaredNorm() * interactions_.self(f).sum();
    }
    return diagonal;
  }

 private:
  int part(Index vertex) const {
    return surface_.parts.of_vertex[static_cast<std::size_t>(vertex)];
  }

  /// The equations for the means of the parts, as in solve_dense.
  Potential means_of(const Potential& psi) const {
    Potential sums = Potential::Zero(whole_.size(), 6);
    for (Index i = 0; i < psi.rows(); ++i) sums.row(part(i)) += areas_[i] * psi.row(i);
    Potential result(psi.rows(), 6);
    for (Index i = 0; i < psi.rows(); ++i)
      result.row(i) = areas_[i] * std::pow(whole_[part(i)], -1.5) * sums.row(part(i));
    return result;
  }

  const Surface& surface_;
  const CompressedInteractions& interactions_;
  Eigen::VectorXd areas_;
  Eigen::VectorXd whole_;  ///< Area of each part [m^2].
};

/// (1/4π) ∫∫ (curl φ)²/r of the bubbles, from pairs of a panel with itself.
Eigen::VectorXd stiffness_of_bubbles(const Surface& surface,
                                     const CompressedInteractions& interactions) {
  Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(static_cast<Index>(surface.edges.faces.size()));
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto& curls = surface.elements[f].curls;
    const Eigen::Matrix3d& hats = interactions.self(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const auto k = static_cast<Index>(i), l = static_cast<Index>(j);
      stiffness[surface.edges.of_face[f][i]] +=
          16 * kPerSphere *
          (curls[j].squaredNorm() * hats(k, k) + 2 * curls[i].dot(curls[j]) * hats(k, l) +
           curls[i].squaredNorm() * hats(l, l));
    }
  }
  return stiffness;
}

/// Residuals of the bubbles' equations, one row per edge.
Potential residuals_of_bubbles(const Surface& surface, const CompressedInteractions& interactions,
                               const Potential& sides, const Columns& sheet) {
  const Columns field = interactions.apply_to_hats(sheet);
  Potential residuals = sides.bottomRows(sides.rows() - surface.vertex_count());
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto& curls = surface.elements[f].curls;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      for (Index axis = 0; axis < 3; ++axis)
        residuals.row(surface.edges.of_face[f][i]) -=
            4 * kPerSphere *
            (curls[j][axis] * field.row(static_cast<Index>(3 * f + i)).segment<6>(6 * axis) +
             curls[i][axis] * field.row(static_cast<Index>(3 * f + j)).segment<6>(6 * axis));
    }
  }
  return residuals;
}

}  // namespace

Solution solve_compressed(const Surface& surface) {
  const CompressedInteractions interactions(surface);
  const HatEquations equations(surface, interactions);
  const Eigen::VectorXd diagonal = equations.diagonal();
  const Potential sides = right_hand_sides(surface, interactions.rotation_moments());
  const Iterated iterated = conjugate_gradients(
      sides.topRows(surface.vertex_count()), kIterativeResidual,
      [&](const Potential& x) { return equations.apply(x); },
      [&](const Potential& r) { return Potential(diagonal.cwiseInverse().asDiagonal() * r); });
  const Potential residuals =
      residuals_of_bubbles(surface, interactions, sides, equations.sheet_of(iterated.solution));
  const Eigen::VectorXd stiffness = stiffness_of_bubbles(surface, interactions);
  Solution solution;
  Potential nodal = Potential::Zero(sides.rows(), 6);
  nodal.topRows(surface.vertex_count()) = iterated.solution;
  solution.psi = potential_of(surface, std::move(nodal));
  // The error of hats is the gain of the bubbles plus the error that would remain with them.
  solution.error_estimate = (1 + kBeyond) / kAlone * residuals.transpose() *
                            stiffness.cwiseInverse().asDiagonal() * residuals;
  solution.unknowns = surface.vertex_count();
  solution.bytes = interactions.bytes();
  solution.steps = iterated.steps;
  return solution;
}

}  // namespace hydro::bem

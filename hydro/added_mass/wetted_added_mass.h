#pragma once

#include <array>
#include <vector>

#include "hydro/added_mass/added_mass.h"
#include "hydro/added_mass/added_mass_model.h"
#include "hydro/loads/refine.h"

/// @file
/// The wetted panels' share of a body's added mass in unbounded fluid,
///
///     A = ρ ∫_{S_w} ψ_m N_n dS,                                                             (1)
///
/// made symmetric and without negative eigenvalues. ψ is that of the wholly submerged body, so the
/// free surface is not felt: a body half under has half of its added mass if it is symmetric about
/// the waterline. Exact for ψ linear on each face and, in waves, for the surface as the loads take
/// it (refine.h).

namespace hydro {

/// The solution of a body about another origin: A' = T A Tᵀ and ψ' = T ψ with T = (1, 0; −[p]×, 1).
/// @param p   The new origin, in the old frame; the axes stay.
AddedMassSolution moved_origin(AddedMassSolution solution, const Eigen::Vector3d& p);

/// The symmetric part of a matrix with its negative eigenvalues set to zero (to round-off).
Matrix6d semi_definite_part(const Matrix6d& matrix);

class WettedAddedMass final : public AddedMassModel {
 public:
  /// @param mesh_B     Closed; its origin the centre of mass.
  /// @param solution   Of this mesh, about the same origin.
  WettedAddedMass(const TriMesh& mesh_B, const AddedMassSolution& solution);

  Matrix6d at(const BodyState& state, const Sea& sea, double time) const override;

  /// A of the wholly submerged body for ρ = 1.
  const Matrix6d& whole() const { return whole_; }

 private:
  /// A face of the mesh and what its share is made of.
  struct Face {
    Eigen::Vector3i vertices;
    std::array<Eigen::Vector3d, 3> corners_B;
    CornerPotentials psi;
    Matrix6d share;  ///< Of all of it, ρ = 1.

    Matrix6d share_of(const Eigen::Matrix3d& products) const;
  };
  /// A box around faces_[first … last). Its branches follow it, up to `next`; a leaf has none.
  struct Node {
    Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();
    Eigen::Vector3d half_B = Eigen::Vector3d::Zero();  ///< Half its sides.
    int first = 0, last = 0;
    int next = 0;
    Matrix6d share = Matrix6d::Zero();  ///< Of all its faces.
  };
  class Builder;
  struct Immersion;

  Matrix6d sum_of_wet(Immersion& in) const;
  void add_leaf(Immersion& in, const Node& leaf, Matrix6d& sum) const;
  void add_in_waves(Immersion& in, const Face& face, Matrix6d& sum) const;

  Eigen::Index vertices_ = 0;  ///< Of the mesh.
  double radius_ = 0;          ///< As Hull::radius [m].
  Matrix6d whole_;
  std::vector<Face> faces_;  ///< In the order of the tree's leaves.
  std::vector<Node> nodes_;
};

}  // namespace hydro

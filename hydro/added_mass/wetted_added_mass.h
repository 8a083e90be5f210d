#pragma once

#include <memory>

#include "hydro/added_mass/added_mass.h"
#include "hydro/added_mass/added_mass_model.h"
#include "hydro/added_mass/potentials.h"
#include "hydro/added_mass/wetted_share.h"
#include "hydro/loads/felt_waves.h"

/// @file
/// The wetted panels' share of a body's added mass in unbounded fluid,
///
///     A = ρ ∫_{S_w} ψ_m N_n dS,                                                             (1)
///
/// made symmetric and without negative eigenvalues. ψ is that of the wholly submerged body, so the
/// free surface is not felt: a body half under has half of its added mass if it is symmetric about
/// the waterline. The integral is exact for ψ that is linear on each face and, in waves, for the
/// surface that the loads take (refine.h).
///
/// Under Airy waves the same potentials give the load of the water's acceleration by Haskind's
/// formula,
///
///     D_m = [A (u̇_c, 0)]_m + ρ ∫_{S_w} ψ_m (u̇ − u̇_c)·n dS,                                 (2)
///
/// with u̇_c that at the centre of mass, so that a uniform flow meets the very A of (1).

namespace hydro {

/// The symmetric part of a matrix with its negative eigenvalues set to zero (to round-off).
Matrix6d semi_definite_part(const Matrix6d& matrix);

/// The share of the wetted panels in the added mass of deep water, by (1).
class WettedAddedMass final : public AddedMassModel {
 public:
  /// Makes the model of a body.
  /// @param mesh_B     Closed; its origin is the centre of mass.
  /// @param solution   The solution for this mesh, about the same origin.
  /// @param sea        The sea that it will be asked about most. It prepares the waves of that one,
  ///                   which changes no answer.
  WettedAddedMass(const TriMesh& mesh_B, const AddedMassSolution& solution,
                  const Sea* sea = nullptr);

  Matrix6d at(const BodyState& state, const Sea& sea, double time) const override;

  /// By (2).
  Wrench wave_load(const BodyState& state, const Sea& sea, double time) const override;

  /// (1) for ρ = 1, and what flat water cuts off the body; the cut is empty in waves, and of a body
  /// that is dry or wholly submerged.
  kernel::WettedShare share(const BodyState& state, const Sea& sea, double time) const;

  /// The integrals of (1) and (2) for ρ = 1, body axes: zero for a dry body.
  kernel::WaveShare wave_share(const BodyState& state, const Sea& sea, double time) const;

  /// The load of (2), in W, and the matrix of (1) for ρ = 1 that it belongs to.
  struct WaveLoad {
    Matrix6d matrix = Matrix6d::Zero();  ///< (1) for ρ = 1.
    Wrench load;                         ///< (2) in W.
  };
  /// The load of (2) and its matrix, from one walk over the panels.
  WaveLoad load_of_waves(const BodyState& state, const Sea& sea, double time) const;

  /// A of the wholly submerged body for ρ = 1.
  const Matrix6d& whole() const { return whole_; }

  /// The panels as the kernel reads them.
  const kernel::Panels& panels() const { return panels_; }
  /// The panels by place.
  const kernel::Tree& tree() const { return tree_; }

 private:
  /// How a body lies to the water of a sea at a time.
  struct Immersion;
  /// A sea, and how the body feels it.
  struct PreparedSea;

  HeadError head_error() const;

  double radius_ = 0;  ///< As Hull::radius [m].
  Matrix6d whole_;
  kernel::Panels panels_;
  kernel::Tree tree_;
  kernel::Potentials potentials_;
  std::shared_ptr<const PreparedSea> prepared_;  ///< Null: none.
};

}  // namespace hydro

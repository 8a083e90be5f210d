#pragma once

#include "hydro/added_mass/water_entry.h"
#include "hydro/added_mass/wetted_added_mass.h"

/// @file
/// The added mass of a body by the potentials of deep water, near a surface that gives way.
///
/// The share of the wetted panels A_w (wetted_added_mass.h) is right for a body that is under water
/// and for one that is half under and symmetric. It is far too large for a body that begins to
/// enter: the wetted tip of such a body moves as much water as it does under a whole body. There
/// the added mass along the vertical ẑ is a of water_entry.h, that of a plate of the waterplane
/// that has risen. So the share is taken in proportion,
///
///     A = f A_w,        f = b + (1 − b) min(1, a / ẑ·A_w ẑ),        b = 1 − (1 − 2v)²,      (1)
///
/// with v the immersed part of the volume; f = b = 1 from v = ½ on. The water rises by C h (1 −
/// 2v)², as that of surface_added_mass.h. One factor for all motions keeps what A_w tells of their
/// shape: a ball that turns moves no water, an edge that enters askew is pushed aside. f is at most
/// 1, and A ≥ 0 as A_w is.
///
/// In waves v and a are those under the plane through the water around the body.

namespace hydro {

/// The added mass by (1): the model `deep` of a scene.
class DeepAddedMass final : public AddedMassModel {
 public:
  /// Makes the model of a body.
  /// @param mesh_B     Closed; its origin is the centre of mass.
  /// @param solution   The solution for this mesh, about the same origin.
  /// @param sea        As for WettedAddedMass.
  DeepAddedMass(const TriMesh& mesh_B, const AddedMassSolution& solution, const Sea* sea = nullptr);

  Matrix6d at(const BodyState& state, const Sea& sea, double time) const override;

  /// f times that of A_w.
  Wrench wave_load(const BodyState& state, const Sea& sea, double time) const override;

  /// A of the wholly submerged body for ρ = 1.
  const Matrix6d& whole() const { return share_.whole(); }

 private:
  /// f of (1).
  /// @param share_B   A_w for ρ = 1.
  /// @param known     The part that flat water cuts off; null: it is computed.
  double factor(const Matrix6d& share_B, const SurfaceCut* known, const BodyState& state,
                const Sea& sea, double time) const;
  /// The plane through the water around the body.
  WaterPlane plane_about(const BodyState& state, const Sea& sea, double time) const;
  SurfaceCut cut_by(const WaterPlane& plane) const;

  WettedAddedMass share_;
  Eigen::AlignedBox3d box_B_;
  double volume_ = 0;  ///< Volume of the whole body [m^3].
};

}  // namespace hydro

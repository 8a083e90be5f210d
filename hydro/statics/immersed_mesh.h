#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/loads/kernel/tree.h"
#include "hydro/mesh/mesh.h"
#include "hydro/statics/hydrostatics.h"
#include "hydro/statics/wet_sums.h"

namespace hydro {

/// A closed mesh whose hydrostatics are asked for at many attitudes and heights. at() looks at the
/// faces near the waterline alone: its cost grows as the root of their number.
///
/// The tree of the loads (kernel/tree.h) has the moments of its branches. With the vertical k in B
/// the integrals (1) to (3) in hydrostatics.h over a branch that is wholly wet are polynomials in
/// the height h,
///
///     V            = k·s + h a,                    a = ∫ k·n dS,   s = ∫ k·n r dS,
///     ∫ (x, y) dV  = (R_WB (Q k + h s))_xy,        Q = ∫ k·n r rᵀ dS                        (7)
///     ∫ −d dV      = (k·Q k + 2h k·s + h² a) / 2.
///
/// Frames and units as in hydrostatics.h; R_WB is the attitude. Results differ from those of
/// hydrostatics() by round-off.
class ImmersedMesh {
 public:
  /// @param mesh_B   Closed and outward; it must outlive this.
  explicit ImmersedMesh(const TriMesh& mesh_B);
  explicit ImmersedMesh(TriMesh&&) = delete;

  /// @param height   Height of the centre of mass above the water [m].
  Hydrostatics at(const Eigen::Matrix3d& R_WB, double height) const;

  /// Height of the centre of mass at which the body displaces `volume` [m].
  ///
  /// Displacement falls with height at the rate of the waterplane area (dV/dh = −area), so the
  /// height is unique; where an interval of heights is possible (a gap between parts one above the
  /// other), one of them is returned. The search is Newton's method within a shrinking bracket, to
  /// round-off: 2e-15 of the volume.
  /// @throws std::invalid_argument unless volume is positive and less than the whole body's.
  double floating_height(const Eigen::Matrix3d& R_WB, double volume) const;

  /// z of the lowest point, in G [m].
  double lowest(const Eigen::Matrix3d& R_WB) const;

 private:
  void add_leaf(const kernel::Node& leaf, const Eigen::Matrix3d& R_WB, double height,
                WetSums& sums) const;

  const TriMesh& mesh_B_;
  double margin_;  ///< Distance from the water at which a box is surely wet or dry [m].
  double volume_;  ///< Volume of the whole body [m^3].
  kernel::Tree tree_;
  std::vector<int> faces_;  ///< Faces of the mesh in the order of the tree's leaves.
};

}  // namespace hydro

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/statics/hydrostatics.h"
#include "hydro/statics/wet_sums.h"

namespace hydro {

/// A mesh at the height at which it displaces a volume.
struct FloatingMesh {
  double height = 0;   ///< Height of the centre of mass above the water [m].
  double draught = 0;  ///< Depth of the lowest point [m].
  Hydrostatics hydrostatics;
};

/// A closed mesh whose hydrostatics are asked for at many attitudes and heights. at() looks at the
/// faces near the waterline alone: its cost grows as the root of their number.
///
/// A tree over the faces has the moments of its branches. With the vertical k in B the integrals
/// (1) to (3) in hydrostatics.h over a branch that is wholly wet are polynomials in the height h,
///
///     V            = k·s + h a,                    a = ∫ k·n dS,   s = ∫ k·n r dS,
///     ∫ (x, y) dV  = (R_WB (Q k + h s))_xy,        Q = ∫ k·n r rᵀ dS                        (7)
///     ∫ −d dV      = (k·Q k + 2h k·s + h² a) / 2.
///
/// Frames and units as in hydrostatics.h; R_WB is the attitude. Results differ from those of
/// hydrostatics() by round-off. Where the hydrostatics of a mesh are asked for once, the mesh may
/// stand for it.
class ImmersedMesh {
 public:
  /// @param mesh_B   Closed and outward.
  ImmersedMesh(const TriMesh& mesh_B);

  /// Largest distance of a vertex from the centre of mass [m].
  double radius() const { return radius_; }

  /// @param height   Height of the centre of mass above the water [m].
  Hydrostatics at(const Eigen::Matrix3d& R_WB, double height) const;

  /// The body at the height at which it displaces `volume` [m^3].
  ///
  /// Displacement falls with height at the rate of the waterplane area (dV/dh = −area), so the
  /// height is unique; where an interval of heights is possible (a gap between parts one above the
  /// other), one of them is returned. The search is Newton's method within a shrinking bracket, to
  /// round-off: 2e-15 of the volume.
  /// @param guess   Height near which it is looked for first [m].
  /// @throws std::invalid_argument unless volume is positive and less than the whole body's.
  FloatingMesh afloat(const Eigen::Matrix3d& R_WB, double volume,
                      std::optional<double> guess = std::nullopt) const;

  /// z of the lowest point, in G [m].
  double lowest(const Eigen::Matrix3d& R_WB) const;

 private:
  /// ∫ f n dS for f = 1; x, y, z; xx, yy, zz, xy, yz, zx: a row each.
  using Moments = Eigen::Matrix<double, 10, 3>;

  struct Node {
    Moments moments = Moments::Zero();
    double area = 0;          ///< [m^2]
    Eigen::AlignedBox3d box;  ///< The box around the faces, and some round-off [m].
    int first = 0, last = 0;  ///< The node has faces first … last − 1.
    int next = 0;             ///< Index of the node that follows the whole branch.
  };

  void divide(int first, int last);
  void fill_leaf(Node& leaf) const;
  void add_whole(const Node& node, const Eigen::Matrix3d& R_WB, double h, WetSums& sums) const;
  void add_leaf(const Node& leaf, const Eigen::Matrix3d& R_WB, double height, WetSums& sums) const;
  /// Height of the lowest point along a unit vector in B [m].
  double lowest_along(const Eigen::Vector3d& up) const;

  TriMesh mesh_B_;  ///< Its faces are in the order of the leaves.
  double radius_;
  double volume_;            ///< Volume of the whole body [m^3].
  std::vector<Node> nodes_;  ///< A branch follows its root, first child first.
};

}  // namespace hydro

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/statics/hydrostatics.h"
#include "hydro/statics/wet_sums.h"

namespace hydro {

/// A closed mesh whose hydrostatics are asked for at many attitudes and heights. at() looks at the
/// faces near the waterline alone: its cost grows as the root of their number.
///
/// The mesh is divided into a tree of boxes. With the vertical k in B, and s and Q the sums of r
/// and of r rᵀ over the corners of a face with the area vector a, the terms of (1) to (3) in
/// hydrostatics.h of faces that are wholly wet are polynomials in the height h,
///
///     V            = Σ k·a (k·s + 3h) / 3,
///     ∫ (x, y) dV  = Σ k·a (R_WB (Q̂ k + 4h s))_xy / 12,                Q̂ = Q + s sᵀ        (7)
///     ∫ −d dV      = Σ k·a (k·Q̂ k + 8h k·s + 12h²) / 24,
///
/// whose coefficients Σ a, Σ a sᵀ and Σ a ⊗ Q̂ each node of the tree has.
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
  struct Node {
    int first = 0, last = 0;  ///< Its faces are order_[first … last).
    int right = 0;            ///< Index of its right child, the left one follows it; 0: a leaf.
    Eigen::Vector3d middle, half;                    ///< Middle and half size of its box [m, B].
    Eigen::Vector3d area = Eigen::Vector3d::Zero();  ///< Σ a
    Eigen::Matrix3d first_moment = Eigen::Matrix3d::Zero();  ///< Σ a sᵀ
    std::array<Eigen::Matrix3d, 3> second_moment;            ///< Σ a_m Q̂ for each component m.
    double surface = 0;                                      ///< Σ |a|
  };

  int build(int first, int last);
  void add_faces(Node& node) const;
  void add_wet(int index, const Eigen::Matrix3d& R_WB, double height, WetSums& sums) const;

  const TriMesh& mesh_B_;
  double margin_;  ///< Distance from the water at which a box is surely wet or dry [m].
  double volume_;  ///< Volume of the whole body [m^3].
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace hydro

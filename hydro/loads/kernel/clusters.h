#pragma once

#include <vector>

#include "hydro/loads/kernel/panels.h"

/// @file
/// Few points that stand for the many faces of a branch: a quadrature for its viscous drag.
///
/// Tangential velocity at a point is v_t = (I − N) (v + ω × x), with N = n nᵀ and x, v from a
/// place c of the branch. With M = m mᵀ for one normal m, and scales σ of N − M and ℓ of x, the
/// features
///
///     y = ((N − M)/σ, (I − N) [x]×/ℓ, x/ℓ)
///
/// give δ = v_t − (I − M) v and x by linear maps whose norms are τ = |(σ v, ℓ ω)| at most and ℓ.
/// A branch keeps some of its own points, with areas such that the sums of products of up to five
/// features are next to those of all its faces: the points by the pivots of the Cholesky factor of
/// the kernel Σ_k (θ² y·y')^k / k!², the areas by least squares in its norm, and points that would
/// have a negative area left out. That is a kernel quadrature [H22]. A leaf chooses among the
/// points of the rule of degree 2 on its faces, a branch among those of its halves.
///
/// What is left between the products' sums is measured, per area and in Frobenius' norm: gaps g_1
/// to g_5. So for f(v_t) = C_v |v_t| v_t, smooth where v_t lies, Taylor's series gives the bound
///
///     |error| / area ≤ Σ_{k ≤ 5} |Dᵏf| g_k τᵏ / k! + 2 |D⁶f| ‖δ‖⁶ / 6!                      (1)
///
/// with the norm in the sixth mean, ‖δ‖ ≤ |v| ‖sin ∠(n, m)‖ + |ω| ‖x‖ by Minkowski, and alike for
/// the moment about c. As weights are positive and points have a normal each, the drag of a branch
/// takes energy in any motion, as that of its faces does.
/// Errors lie far below the bound: with a tolerance of 1e-2, below 1e-5 (`clusters_test.cpp`).
///
/// [H22] Hayakawa, Oberhauser, Lyons. Positively weighted kernel quadrature via subsampling.
///       NeurIPS (2022).

namespace hydro::kernel {

/// Points of a branch, at most.
inline constexpr int kMostPoints = 64;

/// Products of features that have a gap: of so many, at most.
inline constexpr int kGaps = 5;

/// The points of a branch and what (1) needs to know of it, in body axes [m, m^2].
struct alignas(64) Cluster {
  double r[3][kMostPoints] = {}, n[3][kMostPoints] = {};
  double area[kMostPoints] = {};  ///< Positive; 0 beyond `count`.
  int count = 0;
  double centre[3] = {}, normal[3] = {};  ///< c and m.
  double lever = 0;                       ///< |c| [m].
  double tilt = 0, extent = 0;            ///< The scales σ [-] and ℓ [m].
  double gap[kGaps] = {};                 ///< g_1 to g_5 [-].
  double tilt6 = 0, extent6 = 0;          ///< Norms in the sixth mean [-, m].
  double most_tilt = 0, most_extent = 0;  ///< [-, m]
  double face3 = 0;  ///< Mean cube of the vertices' distance from their face's centroid [m^3].
};

struct Node;

/// The clusters of a tree's nodes, or none where the hull is too small to gain by them.
std::vector<Cluster> make_clusters(const Panels& panels, const std::vector<Node>& nodes);

}  // namespace hydro::kernel

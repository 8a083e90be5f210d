#pragma once

#include <array>
#include <vector>

#include "hydro/loads/kernel/load_inputs.h"
#include "hydro/loads/kernel/panels.h"

/// @file
/// A tree over the leaves of a hull. A node holds moments that give the loads on all its faces at
/// once.
///
/// With J = (n, r × n) and the twist ν the normal velocity is v·n = J·ν, and
///
///     ∫ h n dS            needs ∫ J_a {1, x, y, z} dS            for h = below − up·r      (1)
///     ∫ (v·n)² J_a dS  =  Σ ν_b ν_c ∫ J_a J_b J_c dS                                       (2)
///     ∫ |v_t|² J_a dS  =  ∫ |v|² J_a dS − (2), with ∫ J_a {1, x, …, xx, xy, …, zz} dS      (3)
///
/// So a branch that is wet all over and whose faces all move into the water, or all out of it, is
/// one product of 31 numbers with each component: exact on flat water, to round-off. Viscous drag
/// has no such moments and is summed face by face.

namespace hydro::kernel {

/// The rows of moments, named by the factor that J has under the integral.
enum : int {
  kOne = 0,
  kPlace = 1,    ///< x, y, z.
  kSquare = 4,   ///< xx, yy, zz, xy, yz, zx.
  kNormal = 10,  ///< J_b J_c: b ≤ c, b slowest.
  kMoments = 31
};

/// The lane that holds the integral with 1 in place of J. In row kOne that is the area.
inline constexpr int kAreaLane = 6;

struct alignas(64) Node {
  double moment[kMoments][kMostLanes] = {};  ///< ∫ J_a {…} dS, a in the lanes.
  double centre[3], half[3];                 ///< The box around the vertices [m].
  double j_centre[6], j_half[6];             ///< Bounds of J over the faces.
  int first = 0, last = 0;                   ///< The node has leaves [first, last).
  int next = 0;  ///< The index of the node that follows the whole branch.

  bool leaf() const { return last - first == 1; }
};

struct Tree {
  std::vector<Node> nodes;  ///< A branch follows its root, first child first.
  int chunk_leaves = 0;     ///< A branch of this many leaves or fewer is one piece of work.
};

/// The largest number of pieces of work that a tree is cut into.
inline constexpr int kMostChunks = 128;

/// Branches that are pieces of work.
struct Chunks {
  std::array<int, kMostChunks> node;
  int count = 0;
};

Tree make_tree(const Panels& panels);

/// Volume over area of a hull [m]. A head that is wrong by a part of it makes the force wrong by
/// that part of the buoyancy at most.
double volume_over_area(const Tree& tree);

}  // namespace hydro::kernel

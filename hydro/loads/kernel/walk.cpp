#include "hydro/loads/kernel/walk.h"

#include <array>
#include <cassert>

#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/loads/kernel/walk.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "hydro/loads/kernel/airy_branch-inl.h"
#include "hydro/loads/kernel/faces-inl.h"
#include "hydro/loads/kernel/local-inl.h"
#include "hydro/loads/kernel/tree-inl.h"
#include "hydro/loads/kernel/walk-inl.h"
#include "hydro/parallel.h"

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// True if C_v is zero all over a branch: the thesis's law above 2 m/s. |v_t|² = |v|² − (v·n)².
inline bool without_viscous_drag(const Node& node, const LoadInputs& in) {
  if (!in.viscous) return true;
  if (in.viscous->law != ViscousDrag::Law::thesis) return false;
  const double* w = in.angular;
  double speed2 = 0, reach2 = 0, turning2 = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double v = in.linear[i] + w[j] * node.centre[k] - w[k] * node.centre[j];
    speed2 += v * v;
    reach2 += node.half[i] * node.half[i];
    turning2 += w[i] * w[i];
  }
  const double least = std::sqrt(speed2) - std::sqrt(turning2 * reach2);
  const Range normal = normal_speed_range(node, in.linear, in);
  const double most_normal2 = std::max(normal.low * normal.low, normal.high * normal.high);
  return least > 0 && least * least - most_normal2 >= 4;
}

/// Adds the viscous drag of a branch that is wet all over.
HWY_NOINLINE void add_viscous_of_branch(LoadWalk& work, const LoadInputs& in, const Tree& tree,
                                        int branch) {
  const int end = tree.nodes[static_cast<std::size_t>(branch)].next;
  for (int i = branch; i < end;) {
    const Node& node = tree.nodes[static_cast<std::size_t>(i)];
    if (without_viscous_drag(node, in)) {
      i = node.next;
    } else {
      if (node.leaf()) add_viscous_of_leaf(work, in, node.first);
      ++i;
    }
  }
}

/// Adds the buoyancy of a branch that is wet all over and that the surface does not bend over.
HWY_NOINLINE void add_buoyancy_of_branch(LoadWalk& work, Factors& factors, const Tree& tree,
                                         int branch) {
  const int end = tree.nodes[static_cast<std::size_t>(branch)].next;
  for (int i = branch; i < end;) {
    const Node& node = tree.nodes[static_cast<std::size_t>(i)];
    const bool whole = set_local_depth(node, work.in, factors.depth);
    if (whole) add_branch_buoyancy(node, factors.depth, work.in, work.sums);
    if (!whole && node.leaf()) add_buoyancy_of_leaf(work, node);
    i = whole ? node.next : i + 1;
  }
}

/// The error of the water's velocity that leaves no larger an error of the pressure than its head
/// may have [m/s].
inline double allowed_velocity_error(const LoadInputs& in, const Node& root) {
  if (in.wave_error == 0) return 0;
  double speed2 = 0, turning2 = 0, reach2 = 0;
  for (int i = 0; i < 3; ++i) {
    speed2 += in.linear[i] * in.linear[i];
    turning2 += in.angular[i] * in.angular[i];
    const double reach = std::abs(root.centre[i]) + root.half[i];
    reach2 += reach * reach;
  }
  const double water = in.surface->waves.flow[0] + in.surface->shear.fastest;
  const double fastest = std::sqrt(speed2) + std::sqrt(turning2 * reach2) + water;
  constexpr double kLargestFriction = 0.1;  // C_v of all laws but that of a constant.
  const double friction = !in.viscous ? 0 : std::max(kLargestFriction, in.viscous->coefficient);
  const double coefficient =
      std::max(in.drag_front, in.drag_back) + in.lift + friction * in.half_density;
  return in.half_density * in.surface->gravity * in.wave_error / (coefficient * fastest);
}

/// Adds the loads of the motion of a branch that is wet all over, under Airy waves. The queue of
/// faces has room for those of few leaves.
HWY_NOINLINE void add_motion_of_branch(LoadWalk& work, const BranchWater& water, const Node& node) {
  for (int leaf = node.first; leaf < node.last; ++leaf) {
    const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
    for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
      const Plane p = plane_at(faces, lane);
      const Triangle t = triangle_at(faces, lane);
      const V area = areas_at(faces, lane);
      add_motion(work, {leaf, lane}, p, t, area, flow_at_corners(water, p, t), {.wet = true});
    }
    drain(work, false);
  }
}

/// Takes a wet branch under Airy waves whole if the water over it is quadratic.
HWY_NOINLINE bool take_whole_in_airy_waves(LoadWalk& work, const Tree& tree, int branch) {
  const Node& node = tree.nodes[static_cast<std::size_t>(branch)];
  if (!fits<Ask::velocity>(node, work.in, work.velocity_error)) return false;
  BranchWater water;
  find_branch_water<Ask::velocity>(node, work.in, work.sea, water);
  add_branch_buoyancy(node, water.head, work.in, work.sums);
  add_branch_volume(node, water.depth, work.in, work.sums);
  LoadInputs in = work.in;
  double u[3], drag;
  const bool steady = middle_flow(node, water, u) <= work.velocity_error;
  for (int i = 0; i < 3; ++i) {
    in.linear[i] -= u[i];
    in.drag_linear[i] -= in.shape[i][0] * u[0] + in.shape[i][1] * u[1] + in.shape[i][2] * u[2];
  }
  if (steady && of_one_sign(node, in, work.velocity_error, drag)) {
    add_branch_motion(node, factors_of(in), in, drag, work.sums);
    if (in.viscous) add_viscous_of_branch(work, in, tree, branch);
  } else {
    work.sums.lane[kArea][0] += node.moment[kOne][kAreaLane];
    add_motion_of_branch(work, water, node);
  }
  return true;
}

/// Takes a wet branch whole if it can be.
HWY_INLINE bool take_whole(LoadWalk& work, Factors& factors, const Tree& tree, int branch) {
  const LoadInputs& in = work.in;
  const Node& node = tree.nodes[static_cast<std::size_t>(branch)];
  if (in.surface && in.surface->is_airy()) return take_whole_in_airy_waves(work, tree, branch);
  double drag;
  if (!of_one_sign(node, in, 0, drag)) return false;
  if (!in.surface || set_local_depth(node, in, factors.depth)) {
    add_branch_buoyancy(node, factors.depth, in, work.sums);
  } else {
    if (in.surface->bends) return false;
    // This is cheaper than to ask each of its branches for the sign of its motion, too.
    add_buoyancy_of_branch(work, factors, tree, branch);
  }
  add_branch_motion(node, factors, in, drag, work.sums);
  if (in.moving && in.viscous) add_viscous_of_branch(work, in, tree, branch);
  return true;
}

/// Takes a leaf face by face.
HWY_INLINE void take_leaf(LoadWalk& work, const Node& leaf, Wetness wet) {
  const LoadInputs& in = work.in;
  LeafFacts known = {.wet = wet == Wetness::wet};
  if (in.surface && in.surface->is_airy())
    return add_leaf_in_airy_waves<Ask::velocity>(work, leaf, known);
  const bool uncut = known.wet && !(in.surface && in.surface->bends);
  if (in.branches && in.moving && uncut) known.without_viscous = without_viscous_drag(leaf, in);
  in.surface ? add_leaf_in_waves(work, leaf, known) : add_leaf(work, leaf, known);
}

/// Adds the loads on a branch. Its branches that fit in a chunk go to `chunks` instead, if it is
/// there.
void walk(const Panels& panels, const Tree& tree, const LoadInputs& in, int branch, Chunks* chunks,
          Sums& sums) {
  LoadWalk work(panels, in, sums);
  if (in.surface && in.surface->is_airy())
    work.velocity_error = allowed_velocity_error(in, tree.nodes[0]);
  Factors factors = factors_of(in);
  const int end = tree.nodes[static_cast<std::size_t>(branch)].next;
  TableWalk tables;
  for (int node = branch; node < end;) {
    const Node& here = tree.nodes[static_cast<std::size_t>(node)];
    tables.go_to(work, node);
    const bool asks = in.branches || here.leaf();
    const Wetness wet = asks ? wetness(here, in, &work.sea) : Wetness::mixed;
    if (wet == Wetness::dry) {
      node = here.next;
    } else if (in.branches && wet == Wetness::wet && take_whole(work, factors, tree, node)) {
      node = here.next;
    } else if (chunks && here.last - here.first <= tree.chunk_leaves) {
      assert(chunks->count < kMostChunks);
      chunks->node[static_cast<std::size_t>(chunks->count++)] = node;
      node = here.next;
    } else {
      tables.enter<Ask::velocity>(work, here);
      if (here.leaf()) take_leaf(work, here, wet);
      ++node;
    }
  }
  drain(work, true);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro::kernel {
namespace {

HWY_EXPORT(walk);

/// The number of leaves from which several threads share a body. Below it threads take longer to
/// wake than to work. With whole branches and no viscous drag few leaves are looked into.
int shared_from(const LoadInputs& in) {
  return in.branches && !in.surface && !(in.moving && in.viscous) ? 8192 : 256;
}

}  // namespace

Sums sum_hull(const Panels& panels, const Tree& tree, const LoadInputs& in) {
  const auto walk_branch = [&](int branch, Chunks* chunks, Sums& to) {
    HWY_DYNAMIC_DISPATCH(walk)(panels, tree, in, branch, chunks, to);
  };
  Sums sums;
  if (static_cast<int>(panels.leaves.size()) < shared_from(in)) {
    walk_branch(0, nullptr, sums);
    return sums;
  }
  Chunks chunks;
  walk_branch(0, &chunks, sums);
  std::array<std::array<double, kSums>, kMostChunks> parts;
  const auto count = static_cast<std::size_t>(chunks.count);
  parallel_for(count, [&](std::size_t i) {
    Sums part;
    walk_branch(chunks.node[i], nullptr, part);
    for (int k = 0; k < kSums; ++k) parts[i][k] = part.total(k);
  });
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < kSums; ++k) sums.lane[k][0] += parts[i][k];
  return sums;
}

}  // namespace hydro::kernel
#endif

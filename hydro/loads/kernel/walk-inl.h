// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_WALK) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_WALK
#undef PLIMSOLL_KERNEL_WALK
#else
#define PLIMSOLL_KERNEL_WALK
#endif

#include "hydro/loads/kernel/local_sea-inl.h"
#include "hydro/loads/kernel/refine-inl.h"
#include "hydro/loads/kernel/sea_table_sums-inl.h"
#include "hydro/loads/kernel/tree-inl.h"
#include "hydro/loads/kernel/waves-inl.h"

/// @file
/// The parts of a walk through a tree that do not depend on its sums.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// How a branch lies to the waterline.
enum class Wetness { dry, mixed, wet };

/// @param sea   It may be null where the water is flat.
HWY_INLINE Wetness wetness(const Node& node, const LoadInputs& in, const LocalSea* sea) {
  if (in.wet) return Wetness::wet;
  Range depth = depth_range(node, in);
  if (in.surface && depth.high + in.surface->highest <= 0) return Wetness::dry;
  if (in.surface && depth.low + in.surface->lowest >= 0) return Wetness::wet;
  if (in.surface) {
    const ElevationRange elevation = elevation_over(node, in, *sea);
    depth = {depth.low + elevation.low, depth.high + elevation.high};
  }
  if (depth.high <= 0) return Wetness::dry;
  return depth.low >= 0 ? Wetness::wet : Wetness::mixed;
}

/// The branches of a walk that have a table of the sea, and their leaves. Faces that wait are
/// worked on before a table changes.
class TableWalk {
 public:
  /// Sets the table of a branch that is not in one, and that of a leaf.
  template <Ask kAsk, class Work>
  HWY_INLINE void enter(Work& work, const Node& node) {
    if (!work.in.surface || !work.in.surface->table.pays) return;
    LocalSea& sea = work.sea;
    if (!wide_) {
      wide_ = plan_table<kAsk>(node, work.in, sea.wide);
      if (!wide_) return;
      drain(work, true);
      set_table<kAsk>(node, work.in, sea.wide);
      sea.table = &sea.wide;
      end_ = node.next;
    }
    if (!node.leaf()) return;
    drain(work, true);
    const bool pays =
        plan_table<kAsk>(node, work.in, sea.near) && 2 * sea.near.size() <= sea.wide.size();
    if (pays) restrict_table(sea.wide, sea.near);
    sea.table = pays ? &sea.near : &sea.wide;
  }

  /// Goes on to a node: ends the table of a leaf before, and that of a branch which the node is not
  /// in.
  template <class Work>
  HWY_INLINE void go_to(Work& work, int node) {
    if (!wide_) return;
    const bool ends = node >= end_;
    if (!ends && work.sea.table == &work.sea.wide) return;
    drain(work, true);
    work.sea.table = ends ? nullptr : &work.sea.wide;
    wide_ = !ends;
  }

 private:
  bool wide_ = false;
  int end_ = 0;
};

/// Adds all faces of a leaf under flat water.
template <class Work, class... Known>
HWY_INLINE void add_leaf(Work& work, const Node& node, Known... known) {
  const int leaf = node.first;
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  const V3 up = all3(work.in.up);
  for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
    const Plane p = plane_at(faces, lane);
    const Triangle t = triangle_at(faces, lane);
    const V middle = all(work.in.below) - dot(up, p.c);
    const V along1 = dot(up, p.e1), along2 = dot(up, p.e2);
    const auto at = [&](const V2& r)
                        HWY_ATTR { return middle - hn::MulAdd(along1, r.x, along2 * r.y); };
    const Values depth = {at(t.a), at(t.b), at(t.c)};
    add_faces(work, leaf, lane, hn::FirstN(D(), kMostLanes), depth, known...);
  }
  drain(work, false);
}

/// Adds a leaf in waves that may be wet in part.
/// @param water   The water at its vertices: `Depths` or `LeafWater`.
template <class Work, class Vertices, class... Known>
HWY_INLINE void add_leaf_under(const Vertices& water, Work& work, int leaf, Known... known) {
  const LeafVertices& vertices = work.panels.vertices[static_cast<std::size_t>(leaf)];
  for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
    const auto at = water.at_faces(vertices, lane);
    const M straight = work.in.surface->splits() ? without_bent(work.panels, work.in, leaf, lane,
                                                                depth_of(at), work.bending)
                                                 : hn::FirstN(D(), kMostLanes);
    add_faces(work, leaf, lane, straight, at, known...);
  }
  drain(work, false);
}

/// Adds a leaf of which the depths alone matter.
template <class Work, class... Known>
HWY_INLINE void add_leaf_in_waves(Work& work, const Node& node, Known... known) {
  Depths depths;
  find_depths(work.panels, work.in, node, work.sea, depths);
  add_leaf_under(depths, work, node.first, known...);
}

/// Adds a leaf under Airy waves.
template <Ask kAsk, class Work, class... Known>
HWY_INLINE void add_leaf_in_airy_waves(Work& work, const Node& node, Known... known) {
  LeafWater water;
  find_water<kAsk>(work.panels, work.in, node, work.sea, water);
  add_leaf_under(water, work, node.first, known...);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

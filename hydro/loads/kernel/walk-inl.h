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

/// The box around the first of some triangles in lanes, as that of a branch.
inline Node box_of_first(const Plane& p, const Triangle& t) {
  const V3 a = point_on(p, t.a), b = point_on(p, t.b), c = point_on(p, t.c);
  Node box;
  const auto set = [&box](int axis, V x, V y, V z) HWY_ATTR {
    const double low = hn::GetLane(hn::Min(x, hn::Min(y, z)));
    const double high = hn::GetLane(hn::Max(x, hn::Max(y, z)));
    box.centre[axis] = 0.5 * (low + high);
    box.half[axis] = 0.5 * (high - low);
  };
  set(0, a.x, b.x, c.x);
  set(1, a.y, b.y, c.y);
  set(2, a.z, b.z, c.z);
  return box;
}

/// Works on the faces of a leaf that wait. Where its branch is too large for a table and the
/// surface bends over a face, the face is halved into pieces that each have a table: they have many
/// places.
template <Ask kAsk, class Work>
HWY_NOINLINE void drain_leaf(Work& work) {
  LocalSea& sea = work.sea;
  if (sea.table || !work.in.surface->table.pays || work.bending.count == 0)
    return drain(work, false);
  TriangleQueue pieces = work.bending;
  work.bending.count = 0;
  drain(work, true);
  const M first = hn::FirstN(D(), 1);
  while (pieces.count > 0) {
    const int last = pieces.count - 1;
    pad(pieces, last + static_cast<int>(hn::Lanes(D())));
    pieces.count = last;
    const Plane p = plane_of(work.panels, pieces, last);
    const Triangle t = triangle_of(pieces, last);
    const Values depth = load_values(pieces.depth, last);
    const VI face = hn::LoadU(DI(), pieces.face + last);
    if (!hn::AllFalse(D(), hn::And(first, beyond_the_surface(bearings_of(work.in, p), t))))
      continue;
    const Node box = box_of_first(p, t);
    const bool fits = plan_table<kAsk>(box, work.in, sea.wide);
    if (!fits && pieces.count + 2 * kMostLanes < TriangleQueue::kRoom) {
      const V half = all(0.5);
      put_halves(work, p, face, halving_of(t, depth, {half, half, half}), first, pieces);
      continue;
    }
    put_pieces(first, face, t, depth, work.bending);
    if (fits) {
      set_table<kAsk>(box, work.in, sea.wide);
      sea.table = &sea.wide;
    }
    drain(work, true);
    sea.table = nullptr;
  }
}

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

/// Adds a leaf in waves that may be wet in part, but for the faces that wait then.
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
}

/// Adds a leaf of which the depths alone matter.
template <class Work, class... Known>
HWY_INLINE void add_leaf_in_waves(Work& work, const Node& node, Known... known) {
  Depths depths;
  find_depths(work.panels, work.in, node, work.sea, depths);
  add_leaf_under(depths, work, node.first, known...);
  drain(work, false);
}

/// Adds a leaf under Airy waves.
template <Ask kAsk, class Work, class... Known>
HWY_INLINE void add_leaf_in_airy_waves(Work& work, const Node& node, Known... known) {
  LeafWater water;
  find_water<kAsk>(work.panels, work.in, node, work.sea, water);
  add_leaf_under(water, work, node.first, known...);
  drain_leaf<kAsk>(work);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

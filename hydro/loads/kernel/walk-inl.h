// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_WALK) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_WALK
#undef PLIMSOLL_KERNEL_WALK
#else
#define PLIMSOLL_KERNEL_WALK
#endif

#include "hydro/loads/kernel/airy-inl.h"
#include "hydro/loads/kernel/refine-inl.h"
#include "hydro/loads/kernel/tree-inl.h"
#include "hydro/loads/kernel/waves-inl.h"

/// @file
/// The parts of a walk through a tree that do not depend on what it adds up.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// How a branch lies to the waterline.
enum class Wetness { dry, mixed, wet };

HWY_INLINE Wetness wetness(const Node& node, const LoadInputs& in) {
  if (in.wet) return Wetness::wet;
  Range depth = depth_range(node, in);
  if (in.surface && depth.high + in.surface->highest <= 0) return Wetness::dry;
  if (in.surface && depth.low + in.surface->lowest >= 0) return Wetness::wet;
  if (in.surface) {
    const ElevationRange elevation = in.surface->is_grid()
                                         ? grid_over(*in.surface, node.centre, node.half)
                                         : waves_over(in.surface->waves, node.centre, node.half);
    depth = {depth.low + elevation.low, depth.high + elevation.high};
  }
  if (depth.high <= 0) return Wetness::dry;
  return depth.low >= 0 ? Wetness::wet : Wetness::mixed;
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
  find_depths(work.panels, work.in, node, depths);
  add_leaf_under(depths, work, node.first, known...);
}

/// Adds a leaf under Airy waves.
template <Ask kAsk, class Work, class... Known>
HWY_INLINE void add_leaf_in_airy_waves(Work& work, const Node& node, Known... known) {
  LeafWater water;
  find_water<kAsk>(work.panels, work.in, node, work.turns, water);
  add_leaf_under(water, work, node.first, known...);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

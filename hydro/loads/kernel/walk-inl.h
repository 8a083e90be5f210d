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

/// The box around a piece of a face, as that of a branch.
inline Node box_of(const Panels& panels, const TriangleQueue& pieces, int piece) {
  const std::int64_t place = pieces.face[piece];
  const Face face = face_of(panels.leaves[static_cast<std::size_t>(place / kLeafFaces)],
                            static_cast<int>(place % kLeafFaces));
  Node box;
  for (int a = 0; a < 3; ++a) {
    const auto at = [&](int corner) {
      return face.c[a] + pieces.x[corner][piece] * face.e1[a] +
             pieces.y[corner][piece] * face.e2[a];
    };
    const auto [low, high] = std::minmax({at(0), at(1), at(2)});
    box.centre[a] = 0.5 * (low + high);
    box.half[a] = 0.5 * (high - low);
  }
  return box;
}

/// Halves a piece across its longest edge, and puts the halves in its place and behind it.
template <class Work>
HWY_NOINLINE void halve(Work& work, TriangleQueue& pieces, int piece) {
  int longest = 0;
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double squared = std::pow(pieces.x[j][piece] - pieces.x[i][piece], 2) +
                           std::pow(pieces.y[j][piece] - pieces.y[i][piece], 2);
    if (squared <= most) continue;
    longest = i;
    most = squared;
  }
  const int from = longest, to = (longest + 1) % 3;
  const double x = 0.5 * (pieces.x[from][piece] + pieces.x[to][piece]);
  const double y = 0.5 * (pieces.y[from][piece] + pieces.y[to][piece]);
  pad(pieces, piece + static_cast<int>(hn::Lanes(D())));
  const Plane plane = plane_of(work.panels, pieces, piece);
  const double depth = hn::GetLane(depth_at(work.in, work.sea, point_on(plane, {all(x), all(y)})));
  put_piece(pieces, piece, pieces);
  const int last = pieces.count - 1;
  const auto set = [&](int which, int corner) {
    pieces.x[corner][which] = x;
    pieces.y[corner][which] = y;
    pieces.depth[corner][which] = depth;
  };
  set(piece, to);
  set(last, from);
}

/// True if a box lies above the highest crest, or, where what is above the surface is summed,
/// below the lowest trough.
inline bool beyond_the_surface(const LoadInputs& in, const Node& box) {
  const double level = in.below + in.surface->hidden_depth;
  const double z = centre_along(box, in.up), dz = reach_along(box, in.up);
  return in.above ? z + dz <= level + in.surface->lowest : z - dz >= level + in.surface->highest;
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
  while (pieces.count > 0) {
    const int last = pieces.count - 1;
    const Node box = box_of(work.panels, pieces, last);
    const bool counts = !beyond_the_surface(work.in, box);
    const bool fits = counts && plan_table<kAsk>(box, work.in, sea.wide);
    if (counts && !fits && pieces.count + kMostLanes < TriangleQueue::kRoom) {
      halve(work, pieces, last);
      continue;
    }
    if (counts) put_piece(pieces, last, work.bending);
    --pieces.count;
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

// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_LOCAL_SEA) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_LOCAL_SEA
#undef PLIMSOLL_KERNEL_LOCAL_SEA
#else
#define PLIMSOLL_KERNEL_LOCAL_SEA
#endif

#include "hydro/loads/kernel/airy-inl.h"
#include "hydro/loads/kernel/sea_table-inl.h"
#include "hydro/loads/kernel/waves-inl.h"

/// @file
/// The water about a hull at places in lanes: by all waves, or by a table of many waves where there
/// is one.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The water at places in lanes. The elevation is found before the depth of a place is known, and
/// the motion of the water after it; between the two it keeps what it found.
struct LocalSea {
  explicit LocalSea(const LoadInputs& in) : turns(in) {}

  SeaTable wide;  ///< The table of the branch that is walked through, where there is one,
  SeaTable near;  ///< and that of a leaf of it.
  const SeaTable* table = nullptr;  ///< The one that holds; none is there for few waves.
  Turns turns;
  PlanProducts products;
};

/// The elevation at places [m]. `sea` keeps what `water_around` needs there.
HWY_INLINE V rise_at(const LoadInputs& in, LocalSea& sea, const V3& r) {
  if (sea.table) return rise_by_table(*sea.table, *in.surface, r, sea.products);
  return find_turns(in.surface->waves, r, sea.turns);
}

/// The depth of places below the surface, as `LoadInputs` counts it [m].
HWY_INLINE V depth_below(const LoadInputs& in, V rise, const V3& r) {
  return all(in.below) + (rise - dot(all3(in.up), r));
}

/// The water at the places of the last `rise_at`, at the given depth below the surface, as
/// `LoadInputs` counts it. Above the surface it goes on as its functions do.
/// @param rise   The elevation there: where C is 1, the head is the depth to the last bit.
template <Ask kAsk>
HWY_INLINE Water water_around(const LoadInputs& in, const V3& r, V depth, V rise,
                              const LocalSea& sea, double least_depth = -1e300) {
  const WaveField& waves = in.surface->waves;
  const V3 up = all3(in.up);
  const V s = depth + all(in.surface->hidden_depth);
  const V level = all(in.below + in.surface->hidden_depth);
  const V down = stretched(waves, hn::Max(s, all(least_depth)), s - (level - dot(up, r)));
  Water water = sea.table ? water_by_table<kAsk>(*sea.table, in, sea.products, depth, rise, down)
                          : water_by_waves<kAsk>(in, depth, rise, down, sea.turns);
  if constexpr (kAsk == Ask::velocity)
    if (in.surface->shear.moves) water.u = water.u + sheared(in.surface->shear, dot(up, r));
  return water;
}

/// The same, but that above the surface it is as at the surface.
template <Ask kAsk>
HWY_INLINE Water water_at(const LoadInputs& in, const V3& r, V depth, V rise, const LocalSea& sea) {
  return water_around<kAsk>(in, r, depth, rise, sea, 0);
}

/// Bounds of the elevation over a branch [m].
inline ElevationRange elevation_over(const Node& node, const LoadInputs& in, const LocalSea& sea) {
  const WaterSurface& surface = *in.surface;
  if (surface.is_grid()) return grid_over(surface, node.centre, node.half);
  if (sea.table) return range_by_table(*sea.table, surface, node);
  return waves_over(surface.waves, node.centre, node.half);
}

/// The depth of places anywhere on the hull.
HWY_INLINE V depth_at(const LoadInputs& in, LocalSea& sea, const V3& r) {
  if (sea.table) return depth_below(in, rise_at(in, sea, r), r);
  return depth_at(in, LeafSurface{*in.surface, {}, false}, r);
}

inline HWY_NOINLINE void find_depths(const Panels& panels, const LoadInputs& in, const Node& leaf,
                                     LocalSea& sea, Depths& depths) {
  const LeafVertices& vertices = panels.vertices[static_cast<std::size_t>(leaf.first)];
  const LeafSurface over = surface_over(*in.surface, leaf);
  double* to = depths.at;
  for (int block = vertices.first; block < vertices.last; ++block)
    for (int lane = 0; lane < kMostLanes; lane += static_cast<int>(hn::Lanes(D()))) {
      const VertexBlock& here = panels.blocks[static_cast<std::size_t>(block)];
      const V3 r = load3(here.r, lane);
      hn::Store(sea.table ? depth_at(in, sea, r) : depth_at(in, over, r), D(), to);
      to += hn::Lanes(D());
    }
}

/// The water at the corners of faces.
struct MovingWater {
  Values depth;  ///< Below the surface [m].
  Values head;
  V3 a, b, c;  ///< `Water::u` at the corners.
};

/// The water at the corners of pieces of faces.
template <Ask kAsk>
inline HWY_NOINLINE MovingWater water_at_corners(const LoadInputs& in, const Plane& p,
                                                 const Triangle& t, const Values& depth,
                                                 LocalSea& sea) {
  const auto at = [&](const V2& corner, V depth_there) HWY_ATTR {
    const V3 r = point_on(p, corner);
    const V rise = rise_at(in, sea, r);
    return water_at<kAsk>(in, r, depth_there, rise, sea);
  };
  const Water a = at(t.a, depth.a), b = at(t.b, depth.b), c = at(t.c, depth.c);
  return {depth, {a.head, b.head, c.head}, a.u, b.u, c.u};
}

/// The water at the vertices of a leaf. Each vertex is there once.
struct alignas(64) LeafWater {
  Depths depths;
  double head[3 * kLeafFaces];
  double u[3][3 * kLeafFaces];

  HWY_INLINE MovingWater at_faces(const LeafVertices& vertices, int lane) const {
    const D d;
    const hn::Rebind<std::int64_t, D> di;
    const auto corner = [&](const double* from, int i) HWY_ATTR {
      return hn::GatherIndex(d, from, hn::Load(di, vertices.of_face[i] + lane));
    };
    const auto vector = [&](int i) HWY_ATTR {
      return V3{corner(u[0], i), corner(u[1], i), corner(u[2], i)};
    };
    return {depths.at_faces(vertices, lane),
            {corner(head, 0), corner(head, 1), corner(head, 2)},
            vector(0),
            vector(1),
            vector(2)};
  }
};

template <Ask kAsk>
inline HWY_NOINLINE void find_water(const Panels& panels, const LoadInputs& in, const Node& leaf,
                                    LocalSea& sea, LeafWater& water) {
  const LeafVertices& vertices = panels.vertices[static_cast<std::size_t>(leaf.first)];
  int to = 0;
  for (int block = vertices.first; block < vertices.last; ++block)
    for (int lane = 0; lane < kMostLanes; lane += static_cast<int>(hn::Lanes(D()))) {
      const V3 r = load3(panels.blocks[static_cast<std::size_t>(block)].r, lane);
      const V rise = rise_at(in, sea, r), depth = depth_below(in, rise, r);
      const Water at = water_at<kAsk>(in, r, depth, rise, sea);
      hn::Store(depth, D(), water.depths.at + to);
      hn::Store(at.head, D(), water.head + to);
      hn::Store(at.u.x, D(), water.u[0] + to);
      hn::Store(at.u.y, D(), water.u[1] + to);
      hn::Store(at.u.z, D(), water.u[2] + to);
      to += static_cast<int>(hn::Lanes(D()));
    }
}

// Faces ask for what they need of the water: depth and head are one where it is still.

HWY_INLINE const Values& depth_of(const Values& depth) { return depth; }
HWY_INLINE const Values& depth_of(const MovingWater& water) { return water.depth; }
HWY_INLINE const Values& head_of(const Values& depth) { return depth; }
HWY_INLINE const Values& head_of(const MovingWater& water) { return water.head; }

/// u·d at the corners.
HWY_INLINE Values along_of(const MovingWater& water, const V3& d) {
  return {dot(water.a, d), dot(water.b, d), dot(water.c, d)};
}

HWY_INLINE Values operator-(const Values& a, const Values& b) {
  return {a.a - b.a, a.b - b.b, a.c - b.c};
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_WAVES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_WAVES
#undef PLIMSOLL_KERNEL_WAVES
#else
#define PLIMSOLL_KERNEL_WAVES
#endif

#include <hwy/contrib/math/math-inl.h>

#include "hydro/loads/kernel/faces-inl.h"
#include "hydro/loads/kernel/grid-inl.h"
#include "hydro/loads/kernel/surface.h"

/// @file
/// Faces under a surface that is not flat.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

HWY_INLINE V waves_at(const WaveField& waves, const V3& r) {
  V sum = zero();
  for (int i = 0; i < waves.count; ++i) {
    if (waves.row[0][i] == 0) continue;
    const V phase =
        hn::MulAdd(all(waves.row[1][i]), r.x,
                   hn::MulAdd(all(waves.row[2][i]), r.y,
                              hn::MulAdd(all(waves.row[3][i]), r.z, all(waves.row[4][i]))));
    sum = hn::MulAdd(all(waves.row[0][i]), hn::Cos(D(), phase), sum);
  }
  return sum;
}

// The same at one place, several waves at once.

HWY_INLINE V row(const WaveField& waves, int which, int from) {
  return hn::LoadU(D(), waves.row[which] + from);
}

HWY_INLINE V phases(const WaveField& waves, const double* r, int from) {
  return hn::MulAdd(row(waves, 1, from), all(r[0]),
                    hn::MulAdd(row(waves, 2, from), all(r[1]),
                               hn::MulAdd(row(waves, 3, from), all(r[2]), row(waves, 4, from))));
}

HWY_INLINE double total(V v) { return hn::GetLane(hn::SumOfLanes(D(), v)); }

/// A wave changes by |k·d| of its amplitude at most over a step d.
HWY_NOINLINE ElevationRange waves_over(const WaveField& waves, const double* centre,
                                       const double* half) {
  V middle = zero(), reach = zero();
  for (int i = 0; i < waves.count; i += static_cast<int>(hn::Lanes(D()))) {
    const V amplitude = row(waves, 0, i);
    V turn = zero();
    for (int axis = 0; axis < 3; ++axis)
      turn = hn::MulAdd(hn::Abs(row(waves, 1 + axis, i)), all(half[axis]), turn);
    middle = hn::MulAdd(amplitude, hn::Cos(D(), phases(waves, centre, i)), middle);
    reach = hn::MulAdd(hn::Abs(amplitude), hn::Min(turn, all(2)), reach);
  }
  const double mean = total(middle), most = total(reach);
  return {mean - most, mean + most};
}

/// The elevation at c, its gradient and its second derivatives xx, yy, zz, xy, yz, zx in body axes.
HWY_NOINLINE void expand_waves(const WaveField& waves, const double* c, double& value,
                               double (&g)[3], double (&h)[6]) {
  V elevation = zero(), slope[3], bend[6];
  for (V& v : slope) v = zero();
  for (V& v : bend) v = zero();
  for (int i = 0; i < waves.count; i += static_cast<int>(hn::Lanes(D()))) {
    const V phase = phases(waves, c, i);
    const V cosine = row(waves, 0, i) * hn::Cos(D(), phase);
    const V sine = row(waves, 0, i) * hn::Sin(D(), phase);
    const V k[3] = {row(waves, 1, i), row(waves, 2, i), row(waves, 3, i)};
    elevation = elevation + cosine;
    for (int a = 0; a < 3; ++a) {
      slope[a] = slope[a] - sine * k[a];
      bend[a] = bend[a] - cosine * k[a] * k[a];
      bend[3 + a] = bend[3 + a] - cosine * k[a] * k[(a + 1) % 3];
    }
  }
  value = total(elevation);
  for (int a = 0; a < 3; ++a) g[a] = total(slope[a]);
  for (int a = 0; a < 6; ++a) h[a] = total(bend[a]);
}

/// The elevation over a leaf.
struct LeafSurface {
  const Surface& surface;
  GridPatch patch;
  bool few_cells;  ///< The patch is all of it.
};

HWY_INLINE LeafSurface surface_over(const Surface& surface, const Node& leaf) {
  LeafSurface over{surface, {}, false};
  if (surface.is_grid()) over.few_cells = set_patch(surface.grid, leaf, over.patch);
  return over;
}

HWY_INLINE V elevation_at(const LeafSurface& over, const V3& r) {
  if (over.few_cells) return patch_at(over.patch, over.surface.grid, r);
  return over.surface.is_grid() ? grid_at(over.surface.grid, r) : waves_at(over.surface.waves, r);
}

HWY_INLINE V depth_at(const Immersion& in, const LeafSurface& over, const V3& r) {
  return all(in.below) + (elevation_at(over, r) - dot(all3(in.up), r));
}

/// Depths of a leaf's vertices, each once [m].
struct alignas(64) Depths {
  double at[3 * kLeafFaces];
};

HWY_NOINLINE void find_depths(const Work& work, const Node& leaf, Depths& depths) {
  const LeafVertices& vertices = work.panels.vertices[static_cast<std::size_t>(leaf.first)];
  const LeafSurface over = surface_over(*work.in.surface, leaf);
  double* to = depths.at;
  for (int block = vertices.first; block < vertices.last; ++block)
    for (int lane = 0; lane < kMostLanes; lane += static_cast<int>(hn::Lanes(D()))) {
      const VertexBlock& here = work.panels.blocks[static_cast<std::size_t>(block)];
      hn::Store(depth_at(work.in, over, load3(here.r, lane)), D(), to);
      to += hn::Lanes(D());
    }
}

HWY_INLINE Values depths_of(const LeafVertices& vertices, const Depths& depths, int lane) {
  const D d;
  const hn::Rebind<std::int64_t, D> di;
  const auto corner = [&](int i) HWY_ATTR {
    return hn::GatherIndex(d, depths.at, hn::Load(di, vertices.of_face[i] + lane));
  };
  return {corner(0), corner(1), corner(2)};
}

/// Passes a face on as pieces over which the surface is linear.
inline void refine(Work& work, const Leaf& leaf, std::int64_t leaf_index, int lane,
                   const double (&depth)[3]) {
  struct Context {
    Work& work;
    std::int64_t face;
  } context{work, place_of(leaf_index, lane)};
  const auto take = [](void* to, const FlatPiece& piece) {
    auto& [its_work, face] = *static_cast<Context*>(to);
    put_piece(face, piece.x, piece.y, piece.depth, its_work.cut_by_water);
    if (its_work.cut_by_water.count > Pieces::kRoom / 2) drain(its_work, false);
  };
  visit_linear_pieces(*work.in.surface, work.in.below, face_of(leaf, lane), depth, take, &context);
}

/// The faces of a vector that the surface bends over: as pieces. Those that are left.
HWY_NOINLINE M without_bent(Work& work, std::int64_t leaf_index, int lane, const Values& depth) {
  const D d;
  const Leaf& leaf = work.panels.leaves[static_cast<std::size_t>(leaf_index)];
  alignas(64) double depths[3][kMostLanes];
  alignas(64) double straight[kMostLanes];
  hn::Store(depth.a, d, depths[0]);
  hn::Store(depth.b, d, depths[1]);
  hn::Store(depth.c, d, depths[2]);
  for (int i = 0; i < static_cast<int>(hn::Lanes(d)); ++i) {
    const double corners[3] = {depths[0][i], depths[1][i], depths[2][i]};
    straight[i] = bent_over(*work.in.surface, leaf, lane + i) ? 0 : 1;
    if (straight[i] == 0 && face_of(leaf, lane + i).area > 0)
      refine(work, leaf, leaf_index, lane + i, corners);
  }
  return hn::Load(d, straight) > zero();
}

/// Buoyancy alone of a leaf that is wet all over and that the surface does not bend over.
HWY_NOINLINE void add_buoyancy_of_leaf(Work& work, const Node& leaf) {
  const D d;
  const LeafVertices& vertices = work.panels.vertices[static_cast<std::size_t>(leaf.first)];
  const LeafSurface over = surface_over(*work.in.surface, leaf);
  V sums[6];
  for (V& sum : sums) sum = zero();
  for (int block = vertices.first; block < vertices.last; ++block)
    for (int lane = 0; lane < kMostLanes; lane += static_cast<int>(hn::Lanes(d))) {
      const VertexBlock& here = work.panels.blocks[static_cast<std::size_t>(block)];
      const V depth = depth_at(work.in, over, load3(here.r, lane));
      for (int a = 0; a < 6; ++a)
        sums[a] = hn::NegMulAdd(depth, hn::Load(d, here.j[a] + lane), sums[a]);
    }
  for (int a = 0; a < 6; ++a) add(work.sums, kBuoyancy + a, sums[a]);
}

/// A leaf that may be wet in part.
HWY_INLINE void add_leaf_in_waves(Work& work, const Node& node, Known known) {
  const int leaf = node.first;
  const LeafVertices& vertices = work.panels.vertices[static_cast<std::size_t>(leaf)];
  Depths depths;
  find_depths(work, node, depths);
  for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
    const Values depth = depths_of(vertices, depths, lane);
    const M straight = work.in.surface->bends ? without_bent(work, leaf, lane, depth)
                                              : hn::FirstN(D(), kMostLanes);
    add_faces(work, leaf, lane, known, straight, depth);
  }
  drain(work, false);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

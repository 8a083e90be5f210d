// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_WAVES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_WAVES
#undef PLIMSOLL_KERNEL_WAVES
#else
#define PLIMSOLL_KERNEL_WAVES
#endif

#include <hwy/contrib/math/math-inl.h>

#include "hydro/kernel/faces-inl.h"
#include "hydro/kernel/surface.h"

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

/// The first grid line of a cell and the place in it; beyond the grid that of its edge.
struct CellPlace {
  V line, part;
};

HWY_INLINE CellPlace cell_at(V place, std::int64_t lines) {
  const V held = hn::Max(zero(), hn::Min(place, all(static_cast<double>(lines - 1))));
  const V last = all(static_cast<double>(lines > 1 ? lines - 2 : 0));
  const V line = hn::Min(hn::Floor(held), last);
  return {line, held - line};
}

HWY_INLINE V grid_at(const GridField& grid, const V3& r) {
  const D d;
  const hn::Rebind<std::int64_t, D> di;
  const CellPlace u = cell_at(dot(all3(grid.e_x), r) + all(grid.u0), grid.columns);
  const CellPlace v = cell_at(dot(all3(grid.e_y), r) + all(grid.v0), grid.rows);
  const V rows = all(static_cast<double>(grid.rows));
  const auto corner = hn::ConvertTo(di, hn::MulAdd(u.line, rows, v.line));
  const std::int64_t right = grid.columns > 1 ? grid.rows : 0, up = grid.rows > 1 ? 1 : 0;
  const auto height = [&](std::int64_t offset)
                          HWY_ATTR { return hn::GatherIndex(d, grid.heights + offset, corner); };
  const V low = hn::MulAdd(u.part, height(right) - height(0), height(0));
  const V high = hn::MulAdd(u.part, height(right + up) - height(up), height(up));
  return hn::MulAdd(v.part, high - low, low);
}

/// Depths of a leaf's vertices, each once [m].
struct alignas(64) Depths {
  double at[3 * kLeafFaces];
};

HWY_NOINLINE void find_depths(const Work& work, std::int64_t leaf, Depths& depths) {
  const D d;
  const Immersion& in = work.in;
  const LeafVertices& vertices = work.panels.vertices[static_cast<std::size_t>(leaf)];
  const V3 up = all3(in.up);
  for (int i = 0; i < vertices.count; i += static_cast<int>(hn::Lanes(d))) {
    const V3 r = {hn::Load(d, vertices.r[0] + i), hn::Load(d, vertices.r[1] + i),
                  hn::Load(d, vertices.r[2] + i)};
    const V elevation =
        in.surface->is_grid() ? grid_at(in.surface->grid, r) : waves_at(in.surface->waves, r);
    hn::Store(all(in.below) + (elevation - dot(up, r)), d, depths.at + i);
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
  visit_linear_pieces(*work.in.surface, work.in.below, corners_of(leaf, lane, depth), take,
                      &context);
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
    if (straight[i] == 0 && leaf.area[lane + i] > 0)
      refine(work, leaf, leaf_index, lane + i, corners);
  }
  return hn::Load(d, straight) > zero();
}

/// Buoyancy and area alone of a leaf that is wet all over and that the surface does not bend over.
HWY_NOINLINE void add_buoyancy_of_leaf(Work& work, std::int64_t leaf) {
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  Depths depths;
  find_depths(work, leaf, depths);
  for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
    const Plane p = plane_at(faces, lane);
    const V area = hn::Load(D(), faces.area + lane);
    const Values depth =
        depths_of(work.panels.vertices[static_cast<std::size_t>(leaf)], depths, lane);
    add(work.sums, kArea, area);
    add_normal(work.sums, kBuoyancy, p, cross(p.c, p.n),
               linear_on(triangle_at(faces, lane), area, depth));
  }
}

/// A leaf that may be wet in part.
HWY_INLINE void add_leaf_in_waves(Work& work, std::int64_t leaf, Known known) {
  const LeafVertices& vertices = work.panels.vertices[static_cast<std::size_t>(leaf)];
  Depths depths;
  find_depths(work, leaf, depths);
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

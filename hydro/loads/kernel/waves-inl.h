// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_WAVES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_WAVES
#undef PLIMSOLL_KERNEL_WAVES
#else
#define PLIMSOLL_KERNEL_WAVES
#endif

#include <hwy/contrib/math/math-inl.h>

#include "hydro/loads/kernel/grid-inl.h"
#include "hydro/loads/kernel/pieces-inl.h"
#include "hydro/loads/kernel/water_surface.h"
#include "hydro/loads/kernel/wave_functions-inl.h"

/// @file
/// The elevation of a surface that is not flat.

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
    sum = hn::MulAdd(all(waves.row[0][i]), turn_of(phase).cosine, sum);
  }
  return sum;
}

// The functions below work on one place and several waves at once.

HWY_INLINE V row(const WaveField& waves, int which, int from) {
  return hn::LoadU(D(), waves.row[which] + from);
}

HWY_INLINE V phases(const WaveField& waves, const double* r, int from) {
  return hn::MulAdd(row(waves, 1, from), all(r[0]),
                    hn::MulAdd(row(waves, 2, from), all(r[1]),
                               hn::MulAdd(row(waves, 3, from), all(r[2]), row(waves, 4, from))));
}

HWY_INLINE double total(V v) { return hn::GetLane(hn::SumOfLanes(D(), v)); }

/// The elevation at a place [m].
inline HWY_NOINLINE double middle_rise(const WaveField& waves, const double* r) {
  V sum = zero();
  for (int i = 0; i < waves.count; i += static_cast<int>(hn::Lanes(D())))
    sum = hn::MulAdd(row(waves, 0, i), turn_of(phases(waves, r, i)).cosine, sum);
  return total(sum);
}

/// A wave changes by |k·d| of its amplitude at most over a step d.
inline HWY_NOINLINE ElevationRange waves_over(const WaveField& waves, const double* centre,
                                              const double* half) {
  V middle = zero(), reach = zero();
  for (int i = 0; i < waves.count; i += static_cast<int>(hn::Lanes(D()))) {
    const V amplitude = row(waves, 0, i);
    V turn = zero();
    for (int axis = 0; axis < 3; ++axis)
      turn = hn::MulAdd(hn::Abs(row(waves, 1 + axis, i)), all(half[axis]), turn);
    middle = hn::MulAdd(amplitude, turn_of(phases(waves, centre, i)).cosine, middle);
    reach = hn::MulAdd(hn::Abs(amplitude), hn::Min(turn, all(2)), reach);
  }
  const double mean = total(middle), most = total(reach);
  return {mean - most, mean + most};
}

/// The elevation at c, its gradient and its second derivatives xx, yy, zz, xy, yz, zx in body axes.
inline HWY_NOINLINE void expand_waves(const WaveField& waves, const double* c, double& value,
                                      double (&g)[3], double (&h)[6]) {
  V elevation = zero(), slope[3], bend[6];
  for (V& v : slope) v = zero();
  for (V& v : bend) v = zero();
  for (int i = 0; i < waves.count; i += static_cast<int>(hn::Lanes(D()))) {
    const Turn turn = turn_of(phases(waves, c, i));
    const V cosine = row(waves, 0, i) * turn.cosine;
    const V sine = row(waves, 0, i) * turn.sine;
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
  const WaterSurface& surface;
  GridPatch patch;
  bool few_cells;  ///< The patch covers all of the leaf.
};

HWY_INLINE LeafSurface surface_over(const WaterSurface& surface, const Node& leaf) {
  LeafSurface over{surface, {}, false};
  if (surface.is_grid()) over.few_cells = set_patch(surface.grid, leaf, over.patch);
  return over;
}

HWY_INLINE V elevation_at(const LeafSurface& over, const V3& r) {
  if (over.few_cells) return patch_at(over.patch, over.surface.grid, r);
  return over.surface.is_grid() ? grid_at(over.surface.grid, r) : waves_at(over.surface.waves, r);
}

HWY_INLINE V depth_at(const LoadInputs& in, const LeafSurface& over, const V3& r) {
  return all(in.below) + (elevation_at(over, r) - dot(all3(in.up), r));
}

/// The depths of a leaf's vertices [m]. Each vertex is there once.
struct alignas(64) Depths {
  double at[3 * kLeafFaces];

  HWY_INLINE Values at_faces(const LeafVertices& vertices, int lane) const {
    const D d;
    const hn::Rebind<std::int64_t, D> di;
    const auto corner = [&](int i) HWY_ATTR {
      return hn::GatherIndex(d, at, hn::Load(di, vertices.of_face[i] + lane));
    };
    return {corner(0), corner(1), corner(2)};
  }
};

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_SURFACE_CUT) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_SURFACE_CUT
#undef PLIMSOLL_SURFACE_CUT
#else
#define PLIMSOLL_SURFACE_CUT
#endif

#include "hydro/added_mass/surface_cut.h"
#include "hydro/loads/kernel/pieces-inl.h"

/// @file
/// The parts of faces, pieces of faces, and branches of a hull that a plane of water cuts off:
/// integrals of the fields ẑ, d ẑ and d²/2 ẑ, d the depth, and the edges at d = 0.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// Adds triangles that are wet all over.
/// @param row      Row of kCutArea.
/// @param shadow   Their areas times −n·ẑ.
template <int kCount>
HWY_INLINE void add_shadow(LaneSums<kCount>& sums, int row, V shadow, const Values& depth) {
  const V sum = depth.a + depth.b + depth.c;
  const V squares = hn::MulAdd(depth.a, depth.a, hn::MulAdd(depth.b, depth.b, depth.c * depth.c));
  add(sums, row + kCutArea, shadow);
  add(sums, row + kCutVolume, shadow * sum * all(1.0 / 3));
  add(sums, row + kCutDepth, shadow * hn::MulAdd(sum, sum, squares) * all(1.0 / 24));
}

/// Adds the edges at which the triangles that count meet the surface, each with c = p × q as in (4)
/// and (5) of hydrostatics.h. Vertices within `level` of the surface are in it, so that an edge in
/// the surface counts for the face below it alone.
template <int kCount>
HWY_INLINE void add_outline(LaneSums<kCount>& sums, int row, const Plane& plane, const Triangle& t,
                            const Values& found, const HorizontalAxes& axes, double level,
                            M counts) {
  const auto levelled = [&](V depth) HWY_ATTR {
    return hn::IfThenZeroElse(hn::Abs(depth) < all(level), depth);
  };
  const Values depth = {levelled(found.a), levelled(found.b), levelled(found.c)};
  const M meets = hn::And(counts, hn::And(highest(depth) > zero(), lowest(depth) <= zero()));
  const Cut cut = cut_at_zero(t, depth, meets);
  // The waterplane is to the left from `from` to `to`.
  const V2 from = chosen(cut.alone_positive, cut.far.c, cut.far.a);
  const V2 to = chosen(cut.alone_positive, cut.far.a, cut.far.c);
  const V3 p = point_on(plane, from), q = point_on(plane, to);
  const V3 east = all3(axes.x), north = all3(axes.y);
  const V px = dot(p, east), py = dot(p, north), qx = dot(q, east), qy = dot(q, north);
  const V dx = qx - px, dy = qy - py, sx = px + qx, sy = py + qy;
  const V c = hn::IfThenElseZero(meets, hn::MulSub(px, qy, py * qx));
  const V sixth = c * all(1.0 / 6), part = c * all(1.0 / 24);
  const auto square = [&](V pa, V pb, V qa, V qb, V sa, V sb) HWY_ATTR {
    return part * hn::MulAdd(pa, pb, hn::MulAdd(qa, qb, sa * sb));
  };
  add(sums, row + kCutPerimeter, hn::IfThenElseZero(meets, hn::Sqrt(hn::MulAdd(dx, dx, dy * dy))));
  add(sums, row + kCutPlace, sixth * sx);
  add(sums, row + kCutPlace + 1, sixth * sy);
  add(sums, row + kCutSquare, square(px, px, qx, qx, sx, sx));
  add(sums, row + kCutSquare + 1, square(px, py, qx, qy, sx, sy));
  add(sums, row + kCutSquare + 2, square(py, py, qy, qy, sy, sy));
}

/// Adds a branch that is wet all over.
template <int kCount>
inline void add_branch_cut(LaneSums<kCount>& sums, int row, const Node& node,
                           const LoadInputs& in) {
  double along[kNormal] = {};  // ∫ n·ẑ {1, x, …, zx} dS
  for (int k = 0; k < kNormal; ++k)
    for (int a = 0; a < 3; ++a) along[k] += in.up[a] * node.moment[k][a];
  double first = 0, second = 0;  // with ẑ·r and its square
  for (int i = 0; i < 3; ++i) {
    first += in.up[i] * along[kPlace + i];
    second += in.up[i] * in.up[i] * along[kSquare + i] +
              2 * in.up[i] * in.up[(i + 1) % 3] * along[kSquare + 3 + i];
  }
  const double d = in.below;
  sums.lane[row + kCutArea][0] -= along[kOne];
  sums.lane[row + kCutVolume][0] -= d * along[kOne] - first;
  sums.lane[row + kCutDepth][0] -= 0.5 * (d * d * along[kOne] - 2 * d * first + second);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_REFINE) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_REFINE
#undef PLIMSOLL_KERNEL_REFINE
#else
#define PLIMSOLL_KERNEL_REFINE
#endif

#include <cassert>

#include "hydro/loads/kernel/local_sea-inl.h"
#include "hydro/loads/kernel/pieces-inl.h"
#include "hydro/loads/kernel/water_surface.h"
#include "hydro/loads/kernel/waves-inl.h"
#include "hydro/loads/refine.h"

/// @file
/// Splitting of faces in lanes until the water surface is linear over each piece: `refine.h` in
/// plane coordinates.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// A linear function over planes.
struct Linear {
  V middle, x, y;

  HWY_INLINE V at(const V2& r) const { return hn::MulAdd(x, r.x, hn::MulAdd(y, r.y, middle)); }
};

/// The component of the place in a direction given in body axes.
HWY_INLINE Linear along(const double (&direction)[3], const Plane& p) {
  const V3 d = all3(direction);
  return {dot(d, p.c), dot(d, p.e1), dot(d, p.e2)};
}

/// The edges of triangles over which the surface bends by more than the tolerance.
struct Bends {
  M ab, bc, ca;
};

/// The limits that the test of an edge reads.
struct Bearings {
  const LoadInputs& in;
  Linear east, north, up;
};

HWY_INLINE Bearings bearings_of(const LoadInputs& in, const Plane& p) {
  return {in, along(in.surface->east, p), along(in.surface->north, p), along(in.up, p)};
}

HWY_INLINE V waves_second_difference_squared(const BendLimits& limits, V dx, V dy, V zz) {
  const V xx = dx * dx, xy = dx * dy, yy = dy * dy;
  const auto q = [&](int j) HWY_ATTR { return all(limits.quartic[static_cast<std::size_t>(j)]); };
  const auto dive = [&](int j) HWY_ATTR { return all(limits.dive[static_cast<std::size_t>(j)]); };
  const V level = hn::MulAdd(xx, hn::MulAdd(q(0), xx, hn::MulAdd(q(1), xy, q(2) * yy)),
                             yy * hn::MulAdd(q(3), xy, q(4) * yy));
  const V rate =
      hn::MulAdd(dive(0), xx, hn::MulAdd(dive(1), xy, hn::MulAdd(dive(2), yy, dive(3) * zz)));
  return hn::MulAdd(rate, zz, level);
}

/// The elevation of a grid above level half way between two points, less the mean of theirs.
HWY_INLINE V grid_sag(const Bearings& to, const Plane& p, const V2& a, const V2& b, V depth_a,
                      V depth_b) {
  const V2 middle = between(a, b, all(0.5));
  const V ends = all(0.5) * (depth_a + depth_b) - all(to.in.below) + to.up.at(middle);
  return grid_at(to.in.surface->grid, point_on(p, middle)) - ends;
}

/// The squared length of an edge, and the mean square of the waves' second difference over it.
struct EdgeBend {
  V squared, bend;
};

HWY_INLINE EdgeBend waves_over_edge(const Bearings& to, const V2& a, const V2& b) {
  const WaterSurface& surface = *to.in.surface;
  const BendLimits& limits = surface.limits;
  const V2 d = {b.x - a.x, b.y - a.y};
  const V dx = hn::MulAdd(to.east.x, d.x, to.east.y * d.y);
  const V dy = hn::MulAdd(to.north.x, d.x, to.north.y * d.y);
  const V squared = hn::MulAdd(dx, dx, dy * dy);
  const bool dives = limits.dive[3] > 0;
  if (!dives) return {squared, waves_second_difference_squared(limits, dx, dy, zero())};
  const V dz = hn::MulAdd(to.up.x, d.x, to.up.y * d.y), zz = dz * dz;
  const V highest_end = hn::Max(to.up.at(a), to.up.at(b));
  const V depth =
      hn::Max(zero(), all(to.in.below + surface.hidden_depth + limits.lowest) - highest_end);
  const V upper = hn::Min(depth, all(limits.near));
  const V rate =
      hn::MulAdd(all(limits.near_rate), upper, all(2 * limits.least_number) * (depth - upper));
  return {squared + zz,
          exponential(zero() - rate) * waves_second_difference_squared(limits, dx, dy, zz)};
}

HWY_INLINE M grid_bends(const Bearings& to, const Plane& p, const V2& a, const V2& b, V depth_a,
                        V depth_b) {
  const WaterSurface& surface = *to.in.surface;
  const double tolerance = surface.limits.tolerance;
  const V2 d = {b.x - a.x, b.y - a.y};
  const V dx = hn::MulAdd(to.east.x, d.x, to.east.y * d.y);
  const V dy = hn::MulAdd(to.north.x, d.x, to.north.y * d.y);
  const V squared = hn::MulAdd(dx, dx, dy * dy);
  const M long_enough = squared > all(surface.limits.smallest_squared);
  const GridField& grid = surface.grid;
  const V cells2 = squared * all(1 / (grid.cell * grid.cell));
  const M far = hn::And(long_enough, cells2 > all(1));
  const M over = hn::And(far, cells2 * all(grid.bend) > all(8 * tolerance));
  const M may = hn::AndNot(far, hn::And(long_enough, cells2 * all(grid.bend * grid.bend) >
                                                         all(16 * tolerance * tolerance)));
  if (hn::AllFalse(D(), may)) return over;
  const V sag = hn::Abs(grid_sag(to, p, a, b, depth_a, depth_b));
  return hn::Or(over, hn::And(may, sag > all(tolerance)));
}

HWY_INLINE M edge_bends(const Bearings& to, const Plane& p, const V2& a, const V2& b, V depth_a,
                        V depth_b) {
  if (to.in.surface->is_grid()) return grid_bends(to, p, a, b, depth_a, depth_b);
  const BendLimits& limits = to.in.surface->limits;
  const EdgeBend edge = waves_over_edge(to, a, b);
  return hn::And(edge.squared > all(limits.smallest_squared),
                 edge.bend > all(64 * limits.tolerance * limits.tolerance));
}

HWY_INLINE Bends bends_over(const Bearings& to, const Plane& p, const Triangle& t,
                            const Values& depth) {
  return {edge_bends(to, p, t.a, t.b, depth.a, depth.b),
          edge_bends(to, p, t.b, t.c, depth.b, depth.c),
          edge_bends(to, p, t.c, t.a, depth.c, depth.a)};
}

/// `part_at_cut` of edges in lanes.
HWY_INLINE V part_at_cut(const Bearings& to, const V2& a, const V2& b) {
  const BendLimits& limits = to.in.surface->limits;
  const V from = to.up.at(a), end = to.up.at(b), middle = all(0.5) * (from + end);
  V nearest = all(1e300), part = zero();
  for (const double height : limits.cuts) {
    const V z = all(height), before = z - from, after = end - z, off = hn::Abs(z - middle);
    const M inside = hn::And(before * after > zero(),
                             hn::Min(hn::Abs(before), hn::Abs(after)) > all(limits.least_part));
    const M nearer = hn::And(inside, all(kLonger) * off < nearest);
    nearest = hn::IfThenElse(nearer, off, nearest);
    part = hn::IfThenElse(nearer, before / (end - from), part);
  }
  return part;
}

/// Where the edges of triangles are split, as `SurfaceSampler::split_between` says; 0 where they
/// are not.
struct Splits {
  V ab, bc, ca;
};

/// The edges that bend are split in the middle, and others where the current bends.
HWY_INLINE Splits splits_at(const Bearings& to, const Triangle& t, const Bends& bends) {
  const V half = all(0.5);
  if (to.in.surface->limits.cuts.empty())
    return {hn::IfThenElseZero(bends.ab, half), hn::IfThenElseZero(bends.bc, half),
            hn::IfThenElseZero(bends.ca, half)};
  return {hn::IfThenElse(bends.ab, half, part_at_cut(to, t.a, t.b)),
          hn::IfThenElse(bends.bc, half, part_at_cut(to, t.b, t.c)),
          hn::IfThenElse(bends.ca, half, part_at_cut(to, t.c, t.a))};
}

/// The edges to split of triangles that are summed at six points, as
/// `SurfaceSampler::curved_split_between` says.
/// @param counts   Triangles that are not on the side of the surface that is summed are taken off.
HWY_INLINE Bends curved_bends(const Bearings& to, const Triangle& t, const Values& depth,
                              M& counts) {
  const BendLimits& limits = to.in.surface->limits;
  const EdgeBend ab = waves_over_edge(to, t.a, t.b), bc = waves_over_edge(to, t.b, t.c);
  const EdgeBend ca = waves_over_edge(to, t.c, t.a);
  const V far = all(kFarDeparture / 8) * hn::Sqrt(hn::Max(ab.bend, hn::Max(bc.bend, ca.bend)));
  M crosses = hn::FirstN(D(), 0);
  if (!to.in.wet) {
    const M near_water = highest(depth) > zero() - far, near_air = lowest(depth) < far;
    counts = hn::And(counts, to.in.above ? near_air : near_water);
    crosses = hn::And(near_water, near_air);
  }
  const double most = limits.sum_tolerance, departs = 8 * limits.cut_tolerance;
  const auto splits = [&](const EdgeBend& edge) HWY_ATTR {
    const V sum = edge.bend * edge.squared * edge.squared * edge.squared * all(limits.six_points);
    const M misses =
        hn::Or(sum > all(most * most), hn::And(crosses, edge.bend > all(departs * departs)));
    return hn::And(edge.squared > all(limits.smallest_squared), misses);
  };
  return {splits(ab), splits(bc), splits(ca)};
}

/// The triangles on which the sum at three points misses no more than it may.
HWY_INLINE M fits_three_points(const Bearings& to, const Triangle& t) {
  const BendLimits& limits = to.in.surface->limits;
  const auto sum = [&](const V2& a, const V2& b) HWY_ATTR {
    const EdgeBend edge = waves_over_edge(to, a, b);
    return edge.bend * edge.squared;
  };
  const V largest = hn::Max(sum(t.a, t.b), hn::Max(sum(t.b, t.c), sum(t.c, t.a)));
  const double most = limits.sum_tolerance;
  return largest * all(limits.three_points) <= all(most * most);
}

/// Calls add(rule, triangles) with the rule of points of some triangles that count, for one rule
/// after the other.
template <class Add>
HWY_INLINE void with_rules(const Bearings& to, const Triangle& t, M counts, Add add) {
  const M few = fits_three_points(to, t);
  if (!hn::AllFalse(D(), hn::And(counts, few))) add(kThreePoints, hn::And(counts, few));
  if (!hn::AllFalse(D(), hn::AndNot(few, counts))) add(kSixPoints, hn::AndNot(few, counts));
}

HWY_INLINE M any(const Splits& splits) {
  return hn::Max(splits.ab, hn::Max(splits.bc, splits.ca)) > zero();
}

/// True where no part of a triangle counts: it lies above the highest crest, or where what is above
/// the surface is summed below the lowest trough.
HWY_INLINE M beyond_the_surface(const Bearings& to, const Triangle& t) {
  const Values height = {to.up.at(t.a), to.up.at(t.b), to.up.at(t.c)};
  const WaterSurface& surface = *to.in.surface;
  const double level = to.in.below + surface.hidden_depth;
  return to.in.above ? highest(height) <= all(level + surface.lowest)
                     : lowest(height) >= all(level + surface.highest);
}

/// Faces of a vector that the surface or the current bends over go to `bending`. Returns those that
/// are left.
inline HWY_NOINLINE M without_bent(const Panels& panels, const LoadInputs& in, std::int64_t leaf,
                                   int lane, const Values& depth, TriangleQueue& bending) {
  const Leaf& faces = panels.leaves[static_cast<std::size_t>(leaf)];
  const Plane p = plane_at(faces, lane);
  const Triangle t = triangle_at(faces, lane);
  const Bearings to = bearings_of(in, p);
  const M bent = any(splits_at(to, t, bends_over(to, p, t, depth)));
  const M splits =
      hn::AndNot(beyond_the_surface(to, t), hn::And(bent, areas_at(faces, lane) > zero()));
  if (!hn::AllFalse(D(), splits)) append(panels, splits, leaf, lane, depth, bending);
  return hn::Not(bent);
}

/// Adds the triangles of some lanes. (Highway's Compress copies a table at each call.)
HWY_INLINE void put_pieces(M which, VI face, const Triangle& t, const Values& depth,
                           TriangleQueue& to) {
  const D d;
  assert(to.count + static_cast<int>(hn::Lanes(d)) <= TriangleQueue::kRoom);
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, which, bits);
  std::int64_t chosen_lanes[kMostLanes] = {};
  int count = 0;
  for (unsigned left = bits[0]; left != 0; left &= left - 1)
    chosen_lanes[count++] = std::countr_zero(left);
  const auto order = hn::SetTableIndices(d, chosen_lanes);
  const auto put = [&](V value, double(&field)[TriangleQueue::kRoom]) HWY_ATTR {
    hn::StoreU(hn::TableLookupLanes(value, order), d, field + to.count);
  };
  hn::StoreU(hn::TableLookupLanes(face, hn::SetTableIndices(DI(), chosen_lanes)), DI(),
             to.face + to.count);
  put(t.a.x, to.x[0]);
  put(t.b.x, to.x[1]);
  put(t.c.x, to.x[2]);
  put(t.a.y, to.y[0]);
  put(t.b.y, to.y[1]);
  put(t.c.y, to.y[2]);
  put(depth.a, to.depth[0]);
  put(depth.b, to.depth[1]);
  put(depth.c, to.depth[2]);
  to.count += count;
}

/// Triangles with the corners turned so that the edge to split is from a to b.
struct Halving {
  Triangle t;
  Values depth;
  M splits;
  V part;  ///< Part of the edge before its place of splitting.
};

/// The longest edge that is to be split is, the first of edges that are equally long.
HWY_INLINE Halving halving_of(const Triangle& t, const Values& depth, const Splits& splits) {
  const auto squared = [](V part, const V2& a, const V2& b) HWY_ATTR {
    const V x = b.x - a.x, y = b.y - a.y;
    return hn::IfThenElseZero(part > zero(), hn::MulAdd(x, x, y * y));
  };
  const V ab = squared(splits.ab, t.a, t.b), bc = squared(splits.bc, t.b, t.c);
  const V ca = squared(splits.ca, t.c, t.a);
  const M longer = bc > all(kLonger) * ab;
  const M third = ca > all(kLonger) * hn::IfThenElse(longer, bc, ab);
  const M second = hn::AndNot(third, longer);
  const auto point = [&](const V2& a, const V2& b, const V2& c)
                         HWY_ATTR { return chosen(second, third, a, b, c); };
  const auto value = [&](V a, V b, V c) HWY_ATTR { return chosen(second, third, a, b, c); };
  return {{point(t.a, t.b, t.c), point(t.b, t.c, t.a), point(t.c, t.a, t.b)},
          {value(depth.a, depth.b, depth.c), value(depth.b, depth.c, depth.a),
           value(depth.c, depth.a, depth.b)},
          any(splits),
          value(splits.ab, splits.bc, splits.ca)};
}

/// Puts the halves of pieces among others.
template <class Work>
HWY_INLINE void put_halves(Work& work, const Plane& p, VI face, const Halving& h, M which,
                           TriangleQueue& to) {
  const V2 middle = between(h.t.a, h.t.b, h.part);
  const V at_middle = depth_at(work.in, work.sea, point_on(p, middle));
  put_pieces(which, face, {h.t.a, middle, h.t.c}, {h.depth.a, at_middle, h.depth.c}, to);
  put_pieces(which, face, {middle, h.t.b, h.t.c}, {at_middle, h.depth.b, h.depth.c}, to);
}

/// Splits the pieces from `from` on that the surface or the current bends over and puts the halves
/// back among them; the others go to those that are refined. Pieces beyond the surface are
/// dropped, and pieces of less than smallest² of area stay whole.
///
/// The last pieces are taken first, so each generation adds `lanes` pieces at most, and no edge is
/// longer than 2 · 256 smallest: after 18 generations the area is small. Two more halve the number
/// of heights that a piece crosses, so kMostCuts of them take 8.
template <class Work>
HWY_NOINLINE void refine_pieces(Work& work, TriangleQueue& bending, int from, int used) {
  const D d;
  const LoadInputs& in = work.in;
  const Plane p = plane_of(work.panels, bending, from);
  const VI face = hn::LoadU(DI(), bending.face + from);
  const Triangle t = triangle_of(bending, from);
  const Values depth = load_values(bending.depth, from);
  const Bearings to = bearings_of(in, p);
  M counts = hn::AndNot(beyond_the_surface(to, t), hn::FirstN(d, static_cast<std::size_t>(used)));
  const M large = area_of(t) >= all(in.surface->limits.smallest_squared);
  const bool curved = in.surface->limits.curved;
  const Bends bends = curved ? curved_bends(to, t, depth, counts) : bends_over(to, p, t, depth);
  const Halving h = halving_of(t, depth, splits_at(to, t, bends));
  const M splits = hn::And(counts, hn::And(large, h.splits));
  put_pieces(hn::AndNot(splits, counts), face, t, depth, work.refined());
  if (!hn::AllFalse(d, splits)) put_halves(work, p, face, h, splits, bending);
  if (work.refined().count > TriangleQueue::kRoom / 2) drain_cut(work, false);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

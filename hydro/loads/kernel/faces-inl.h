// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_FACES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_FACES
#undef PLIMSOLL_KERNEL_FACES
#else
#define PLIMSOLL_KERNEL_FACES
#endif

#include "hydro/loads/kernel/local_sea-inl.h"
#include "hydro/loads/kernel/pieces-inl.h"
#include "hydro/loads/kernel/refine-inl.h"
#include "hydro/loads/kernel/viscous-inl.h"
#include "hydro/loads/kernel/waves-inl.h"
#include "hydro/loads/point_rules.h"

/// @file
/// The loads on the faces of a leaf. Faces that are wet all over are summed where they lie; the
/// others wait in queues as pieces.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The state of a walk: its sums, and the pieces that wait until they fill a vector.
struct LoadWalk {
  // A constructor: GCC 12 would set all of an aggregate to zero first, which takes longer than many
  // a walk.
  LoadWalk(const Panels& of, const LoadInputs& with, Sums& to)
      : panels(of), in(with), sums(to), sea(with) {}

  const Panels& panels;
  const LoadInputs& in;
  Sums& sums;
  TriangleQueue bending;       ///< The surface may bend over them by more than the tolerance.
  TriangleQueue cut_by_water;  ///< They may be wet in part.
  TriangleQueue curved;        ///< The same; the water is not linear over them.
  TriangleQueue turning;       ///< They are wet, v·n changes its sign; pressure drag is missing.
  LocalSea sea;                ///< For one place at a time.
  TriangleQueue& refined() { return in.surface->limits.curved ? curved : cut_by_water; }

  double velocity_error = 0;  ///< Allowed of the velocity of the waves' water over branches [m/s].
};

// The motion at the corners relative to the water, which is still or moves. Normal speeds are those
// that pressure drag sees.

HWY_INLINE Values normal_speeds(const LoadInputs&, const Flow& flow, const Plane&,
                                const Triangle& t, const Values&) {
  return {flow.normal_at(t.a), flow.normal_at(t.b), flow.normal_at(t.c)};
}
HWY_INLINE Values normal_speeds(const LoadInputs& in, const Flow& flow, const Plane& p,
                                const Triangle& t, const MovingWater& water) {
  return normal_speeds(in, flow, p, t, water.depth) - along_of(water, drag_normal(in, p.n));
}

/// v·e1 and v·e2.
struct Tangential {
  Values along1, along2;
};

HWY_INLINE Tangential tangential_speeds(const Flow& flow, const Plane&, const Triangle& t,
                                        const Values&) {
  return {{flow.along1(t.a.y), flow.along1(t.b.y), flow.along1(t.c.y)},
          {flow.along2(t.a.x), flow.along2(t.b.x), flow.along2(t.c.x)}};
}
HWY_INLINE Tangential tangential_speeds(const Flow& flow, const Plane& p, const Triangle& t,
                                        const MovingWater& water) {
  const Tangential own = tangential_speeds(flow, p, t, water.depth);
  return {own.along1 - along_of(water, p.e1), own.along2 - along_of(water, p.e2)};
}

/// The flow past faces for viscous drag, which takes the mean of the water's velocity.
HWY_INLINE Flow mean_flow(const Flow& flow, const Plane&, const Values&) { return flow; }
HWY_INLINE Flow mean_flow(const Flow& flow, const Plane& p, const MovingWater& water) {
  const V third = all(1.0 / 3);
  const V3 sum = water.a + water.b + water.c;
  Flow mean = flow;
  mean.a = hn::NegMulAdd(third, dot(sum, p.e1), flow.a);
  mean.b = hn::NegMulAdd(third, dot(sum, p.e2), flow.b);
  return mean;
}

/// ½ρC_p with the sign of the motion into the water, where u is of one sign.
HWY_INLINE V signed_drag(const LoadInputs& in, M forward) {
  return hn::IfThenElse(forward, all(in.drag_front), all(-in.drag_back));
}

HWY_INLINE Traction lift_on(const Triangle& t, V scale, const Tangential& v) {
  return square_on(t, scale, v.along1) + square_on(t, scale, v.along2);
}

/// The pressure drag on the triangles that count, for any v·n at the corners. They are cut where it
/// is zero.
HWY_INLINE Traction cut_drag_on(const LoadInputs& in, const Values& u, const Triangle& t,
                                M counts) {
  const V high = highest(u);
  const M turns = hn::And(counts, hn::And(lowest(u) < zero(), high > zero()));
  const Cut cut = cut_at_zero(t, u, turns);
  const auto drag = [&](const Triangle& part, const Values& speed, M which, M forward) HWY_ATTR {
    const V scale = signed_drag(in, forward) * area_of(part);
    return square_on(part, hn::IfThenElseZero(which, scale), speed);
  };
  const M rest_forward = hn::AndNot(cut.alone_positive, high > zero());
  const Traction near = drag(cut.near, cut.at_near, counts, rest_forward);
  if (hn::AllFalse(D(), turns)) return near;
  return near + drag(cut.far, cut.at_far, turns, rest_forward) +
         drag(cut.corner, cut.at_corner, turns, cut.alone_positive);
}

/// The volume that is below the surface under Airy waves. Elsewhere it is that of the buoyancy.
HWY_INLINE void add_volume(LoadWalk&, const Plane&, const Triangle&, V, const Values&) {}
HWY_INLINE void add_volume(LoadWalk& work, const Plane& p, const Triangle& t, V area,
                           const MovingWater& water) {
  const V down = zero() - dot(p.n, all3(work.in.up));
  add(work.sums, kVolume, down * linear_on(t, area, water.depth).q);
}

/// Adds all loads on the triangles that count. These are wet all over.
template <class Water>
HWY_NOINLINE void add_wet(LoadWalk& work, const Plane& p, const Triangle& t, M counts,
                          const Water& water) {
  const LoadInputs& in = work.in;
  const V area = hn::IfThenElseZero(counts, area_of(t));
  const V3 c_cross_n = cross(p.c, p.n);
  add(work.sums, kArea, area);
  add_normal(work.sums, kBuoyancy, p, c_cross_n, linear_on(t, area, head_of(water)));
  add_volume(work, p, t, area, water);
  if (!in.moving) return;
  const Flow flow = flow_over(p, in);
  if (in.drag_front != 0 || in.drag_back != 0)
    add_normal(work.sums, kPressureDrag, p, c_cross_n,
               cut_drag_on(in, normal_speeds(in, flow, p, t, water), t, counts));
  if (in.lift != 0)
    add_normal(work.sums, kLift, p, c_cross_n,
               lift_on(t, all(in.lift) * area, tangential_speeds(flow, p, t, water)));
  if (in.viscous) add_viscous(work.sums, in, p, mean_flow(flow, p, water), t, area);
}

/// Adds all loads on triangles that count, over which the water is not linear, by a rule of points.
template <std::size_t kPoints>
HWY_NOINLINE void add_curved(LoadWalk& work, const Plane& p, const Triangle& t, M counts,
                             const std::array<TrianglePoint, kPoints>& rule) {
  const LoadInputs& in = work.in;
  const V area = hn::IfThenElseZero(counts, area_of(t));
  const V3 c_cross_n = cross(p.c, p.n), drag_n = drag_normal(in, p.n);
  const Flow flow = flow_over(p, in);
  Traction buoyancy = {zero(), zero(), zero()}, drag = buoyancy, lift = buoyancy;
  V depths = zero();
  V3 mean = {zero(), zero(), zero()};
  for (const TrianglePoint& point : rule) {
    const V2 at = point_of(t, point);
    const V part = all(point.weight) * area;
    const V3 r = point_on(p, at);
    const V rise = rise_at(in, work.sea, r), depth = depth_below(in, rise, r);
    const Water water = water_at<Ask::velocity>(in, r, depth, rise, work.sea);
    buoyancy = buoyancy + traction_at(part * water.head, at);
    depths = hn::MulAdd(part, depth, depths);
    const V v_n = flow.normal_at(at) - dot(water.u, drag_n);
    drag = drag + traction_at(part * signed_drag(in, v_n > zero()) * v_n * v_n, at);
    const V along1 = flow.along1(at.y) - dot(water.u, p.e1);
    const V along2 = flow.along2(at.x) - dot(water.u, p.e2);
    lift = lift + traction_at(part * hn::MulAdd(along1, along1, along2 * along2), at);
    const V weight = all(point.weight);
    mean = {hn::MulAdd(weight, water.u.x, mean.x), hn::MulAdd(weight, water.u.y, mean.y),
            hn::MulAdd(weight, water.u.z, mean.z)};
  }
  add(work.sums, kArea, area);
  add_normal(work.sums, kBuoyancy, p, c_cross_n, buoyancy);
  add(work.sums, kVolume, zero() - dot(p.n, all3(in.up)) * depths);
  if (in.drag_front != 0 || in.drag_back != 0)
    add_normal(work.sums, kPressureDrag, p, c_cross_n, drag);
  const V k = all(in.lift);
  if (in.lift != 0)
    add_normal(work.sums, kLift, p, c_cross_n, {k * lift.q, k * lift.qx, k * lift.qy});
  if (!in.viscous) return;
  Flow past = flow;
  past.a = flow.a - dot(mean, p.e1);
  past.b = flow.b - dot(mean, p.e2);
  add_viscous(work.sums, in, p, past, t, area);
}

/// Adds the loads on the pieces from `from` on, one a lane. The first `used` lanes count. The
/// pieces of a submerged hull are not cut: their depths are those below its centre of mass.
HWY_INLINE void add_pieces(LoadWalk& work, const TriangleQueue& pieces, int from, int used) {
  const Plane p = plane_of(work.panels, pieces, from);
  const Triangle whole = triangle_of(pieces, from);
  const Values depth_of_whole = load_values(pieces.depth, from);
  const M counted = hn::FirstN(D(), static_cast<std::size_t>(used));
  const auto add_part = [&](const Triangle& part, M counts, const Values& depth) HWY_ATTR {
    if (work.in.surface && work.in.surface->is_airy())
      add_wet(work, p, part, counts,
              water_at_corners<Ask::velocity>(work.in, p, part, depth, work.sea));
    else
      add_wet(work, p, part, counts, depth);
  };
  if (work.in.wet) return add_part(whole, counted, depth_of_whole);
  const WetParts wet = wet_parts(whole, depth_of_whole, counted);
  add_part(wet.first, wet.has_first, wet.at_first);
  if (!hn::AllFalse(D(), wet.has_second)) add_part(wet.second, wet.has_second, wet.at_second);
}

/// Adds the pressure drag of pieces that are wet all over. Their `depth` is v·n at the corners.
HWY_INLINE void add_turning(LoadWalk& work, const TriangleQueue& pieces, int from, int used) {
  const Plane p = plane_of(work.panels, pieces, from);
  const M counts = hn::FirstN(D(), static_cast<std::size_t>(used));
  add_normal(
      work.sums, kPressureDrag, p, cross(p.c, p.n),
      cut_drag_on(work.in, load_values(pieces.depth, from), triangle_of(pieces, from), counts));
}

/// The same for pieces over which the water is not linear.
HWY_INLINE void add_curved_pieces(LoadWalk& work, const TriangleQueue& pieces, int from, int used) {
  const Plane p = plane_of(work.panels, pieces, from);
  const Triangle whole = triangle_of(pieces, from);
  const M counted = hn::FirstN(D(), static_cast<std::size_t>(used));
  const auto add_parts = [&](const auto& rule, M counts) HWY_ATTR {
    if (work.in.wet) return add_curved(work, p, whole, counts, rule);
    const WetParts wet = wet_parts(whole, load_values(pieces.depth, from), counts);
    add_curved(work, p, wet.first, wet.has_first, rule);
    if (!hn::AllFalse(D(), wet.has_second)) add_curved(work, p, wet.second, wet.has_second, rule);
  };
  with_rules(bearings_of(work.in, p), whole, counted, add_parts);
}

HWY_INLINE void drain_cut(LoadWalk& work, bool to_the_last) {
  drain(work, work.cut_by_water, to_the_last, add_pieces);
  drain(work, work.curved, to_the_last, add_curved_pieces);
}

HWY_INLINE void drain(LoadWalk& work, bool to_the_last) {
  drain(work, work.bending, to_the_last, refine_pieces<LoadWalk>);
  drain_cut(work, to_the_last);
  drain(work, work.turning, to_the_last, add_turning);
}

/// Facts about a leaf that the walk has found out.
struct LeafFacts {
  bool wet = false;              ///< It is wet all over.
  bool without_viscous = false;  ///< Its viscous drag is zero.
};

/// Where faces of a vector lie.
struct FacePlace {
  std::int64_t leaf;
  int lane;
};

/// Adds the pressure drag on the faces of which v·n has one sign. The others are queued.
/// @param area   0 for faces that do not count.
HWY_INLINE void add_whole_drag(LoadWalk& work, FacePlace at, const Plane& p, const V3& c_cross_n,
                               const Values& u, const Triangle& t, V area) {
  const M forward = highest(u) > zero();
  const M turns = hn::And(area > zero(), hn::And(lowest(u) < zero(), forward));
  const V scale = signed_drag(work.in, forward) * area;
  add_normal(work.sums, kPressureDrag, p, c_cross_n,
             square_on(t, hn::IfThenZeroElse(turns, scale), u));
  if (!hn::AllFalse(D(), turns)) append(work.panels, turns, at.leaf, at.lane, u, work.turning);
}

/// Adds the loads of the motion of faces that are wet all over.
/// @param area   0 for faces that do not count.
template <class Water>
HWY_INLINE void add_motion(LoadWalk& work, FacePlace at, const Plane& p, const Triangle& t, V area,
                           const Water& water, LeafFacts known) {
  const LoadInputs& in = work.in;
  const Flow flow = flow_over(p, in);
  const V3 c_cross_n = cross(p.c, p.n);
  if (in.drag_front != 0 || in.drag_back != 0)
    add_whole_drag(work, at, p, c_cross_n, normal_speeds(in, flow, p, t, water), t, area);
  if (in.lift != 0)
    add_normal(work.sums, kLift, p, c_cross_n,
               lift_on(t, all(in.lift) * area, tangential_speeds(flow, p, t, water)));
  if (in.viscous && !known.without_viscous)
    add_viscous(work.sums, in, p, mean_flow(flow, p, water), t, area);
}

/// Adds the loads on the faces that count, of a vector of a leaf's faces from `lane` on.
/// @param water   The depths at their vertices [m], or all of the water there.
template <class Water>
HWY_INLINE void add_faces(LoadWalk& work, std::int64_t leaf, int lane, M counts, const Water& water,
                          LeafFacts known) {
  const Values& depth = depth_of(water);
  const D d;
  const LoadInputs& in = work.in;
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  const V whole = areas_at(faces, lane);
  counts = hn::And(counts, whole > zero());  // Faces that only fill the leaf do not count.
  M wet = counts;
  if (!known.wet) {
    const M dips = hn::And(counts, highest(depth) > zero());
    wet = hn::And(dips, lowest(depth) >= zero());
    const M crosses = hn::AndNot(wet, dips);
    if (!hn::AllFalse(d, crosses))
      append(work.panels, crosses, leaf, lane, depth, work.cut_by_water);
    if (hn::AllFalse(d, wet)) return;
  }
  const Plane p = plane_at(faces, lane);
  const Triangle t = triangle_at(faces, lane);
  const V area = hn::IfThenElseZero(wet, whole);
  const V3 c_cross_n = cross(p.c, p.n);
  add(work.sums, kArea, area);
  add_normal(work.sums, kBuoyancy, p, c_cross_n, linear_on(t, area, head_of(water)));
  add_volume(work, p, t, area, water);
  if (in.moving) add_motion(work, {leaf, lane}, p, t, area, water, known);
}

/// Adds the viscous drag alone of a leaf that is wet all over and moves as `in` tells.
HWY_INLINE void add_viscous_of_leaf(LoadWalk& work, const LoadInputs& in, std::int64_t leaf) {
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
    const Plane p = plane_at(faces, lane);
    const V area = areas_at(faces, lane);
    add_viscous(work.sums, in, p, flow_over(p, in), triangle_at(faces, lane), area);
  }
}

/// Adds the buoyancy alone of a leaf that is wet all over and over which the surface does not bend.
inline HWY_NOINLINE void add_buoyancy_of_leaf(LoadWalk& work, const Node& leaf) {
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

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_FACES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_FACES
#undef PLIMSOLL_KERNEL_FACES
#else
#define PLIMSOLL_KERNEL_FACES
#endif

#include "hydro/loads/kernel/pieces-inl.h"
#include "hydro/loads/kernel/refine-inl.h"
#include "hydro/loads/kernel/viscous-inl.h"
#include "hydro/loads/kernel/waves-inl.h"

/// @file
/// The loads on the faces of a leaf. Faces that are wet all over are summed where they lie; the
/// others wait in queues as pieces.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The state of a walk: its sums, and the pieces that wait until they fill a vector.
struct LoadWalk {
  const Panels& panels;
  const LoadInputs& in;
  Sums& sums;
  TriangleQueue bending;       ///< The surface may bend over them by more than the tolerance.
  TriangleQueue cut_by_water;  ///< They may be wet in part.
  TriangleQueue turning;       ///< They are wet, v·n changes its sign; pressure drag is missing.
};

HWY_INLINE Values normal_speeds(const Flow& flow, const Triangle& t) {
  return {flow.normal_at(t.a), flow.normal_at(t.b), flow.normal_at(t.c)};
}

/// ½ρC_p with the sign of the motion into the water, where u is of one sign.
HWY_INLINE V signed_drag(const LoadInputs& in, M forward) {
  return hn::IfThenElse(forward, all(in.drag_front), all(-in.drag_back));
}

HWY_INLINE Traction lift_on(const Flow& flow, const Triangle& t, V scale) {
  const Values along1 = {flow.along1(t.a.y), flow.along1(t.b.y), flow.along1(t.c.y)};
  const Values along2 = {flow.along2(t.a.x), flow.along2(t.b.x), flow.along2(t.c.x)};
  return square_on(t, scale, along1) + square_on(t, scale, along2);
}

/// The pressure drag on the triangles that count, for any motion. They are cut where v·n is zero.
HWY_INLINE Traction cut_drag_on(const LoadInputs& in, const Flow& flow, const Triangle& t,
                                M counts) {
  const Values u = normal_speeds(flow, t);
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

/// Adds all loads on the triangles that count. These are wet all over.
inline HWY_NOINLINE void add_wet(LoadWalk& work, const Plane& p, const Triangle& t, M counts,
                                 const Values& depth) {
  const LoadInputs& in = work.in;
  const V area = hn::IfThenElseZero(counts, area_of(t));
  const V3 c_cross_n = cross(p.c, p.n);
  add(work.sums, kArea, area);
  add_normal(work.sums, kBuoyancy, p, c_cross_n, linear_on(t, area, depth));
  if (!in.moving) return;
  const Flow flow = flow_over(p, in);
  if (in.drag_front != 0 || in.drag_back != 0)
    add_normal(work.sums, kPressureDrag, p, c_cross_n, cut_drag_on(in, flow, t, counts));
  if (in.lift != 0)
    add_normal(work.sums, kLift, p, c_cross_n, lift_on(flow, t, all(in.lift) * area));
  if (in.viscous) add_viscous(work.sums, in, {p, flow, t, area});
}

/// Adds the loads on the pieces from `from` on, one a lane. The first `used` lanes count.
HWY_INLINE void add_pieces(LoadWalk& work, const TriangleQueue& pieces, int from, int used) {
  const Plane p = plane_of(work.panels, pieces, from);
  const WetParts wet = wet_parts(triangle_of(pieces, from), load_values(pieces.depth, from),
                                 hn::FirstN(D(), static_cast<std::size_t>(used)));
  add_wet(work, p, wet.first, wet.has_first, wet.at_first);
  if (!hn::AllFalse(D(), wet.has_second))
    add_wet(work, p, wet.second, wet.has_second, wet.at_second);
}

/// Adds the pressure drag of pieces that are wet all over.
HWY_INLINE void add_turning(LoadWalk& work, const TriangleQueue& pieces, int from, int used) {
  const Plane p = plane_of(work.panels, pieces, from);
  const M counts = hn::FirstN(D(), static_cast<std::size_t>(used));
  add_normal(work.sums, kPressureDrag, p, cross(p.c, p.n),
             cut_drag_on(work.in, flow_over(p, work.in), triangle_of(pieces, from), counts));
}

HWY_INLINE void drain_cut(LoadWalk& work, bool to_the_last) {
  drain(work, work.cut_by_water, to_the_last, add_pieces);
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

/// Adds the pressure drag on the faces that count and on which v·n has one sign. The others are
/// queued.
HWY_INLINE void add_whole_drag(LoadWalk& work, const Plane& p, const V3& c_cross_n,
                               const Flow& flow, const Triangle& t, V area, M counts,
                               std::int64_t leaf, int lane) {
  const Values u = normal_speeds(flow, t);
  const M forward = highest(u) > zero();
  const M turns = hn::And(counts, hn::And(lowest(u) < zero(), forward));
  const V scale = signed_drag(work.in, forward) * area;
  add_normal(work.sums, kPressureDrag, p, c_cross_n,
             square_on(t, hn::IfThenZeroElse(turns, scale), u));
  if (!hn::AllFalse(D(), turns)) append(work.panels, turns, leaf, lane, u, work.turning);
}

/// Adds the loads on the faces that count, of a vector of a leaf's faces from `lane` on.
/// @param depth   The depths at their vertices [m].
HWY_INLINE void add_faces(LoadWalk& work, std::int64_t leaf, int lane, M counts,
                          const Values& depth, LeafFacts known) {
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
  add_normal(work.sums, kBuoyancy, p, c_cross_n, linear_on(t, area, depth));
  if (!in.moving) return;
  const Flow flow = flow_over(p, in);
  if (in.drag_front != 0 || in.drag_back != 0)
    add_whole_drag(work, p, c_cross_n, flow, t, area, wet, leaf, lane);
  if (in.lift != 0)
    add_normal(work.sums, kLift, p, c_cross_n, lift_on(flow, t, all(in.lift) * area));
  if (in.viscous && !known.without_viscous) add_viscous(work.sums, in, {p, flow, t, area});
}

/// Adds the viscous drag alone of a leaf that is wet all over.
HWY_INLINE void add_viscous_of_leaf(LoadWalk& work, std::int64_t leaf) {
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
    const Plane p = plane_at(faces, lane);
    const V area = areas_at(faces, lane);
    add_viscous(work.sums, work.in, {p, flow_over(p, work.in), triangle_at(faces, lane), area});
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

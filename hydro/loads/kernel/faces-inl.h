// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_FACES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_FACES
#undef PLIMSOLL_KERNEL_FACES
#else
#define PLIMSOLL_KERNEL_FACES
#endif

#include <bit>

#include "hydro/loads/kernel/lanes-inl.h"
#include "hydro/loads/kernel/pieces.h"
#include "hydro/loads/kernel/viscous-inl.h"

/// @file
/// Loads on the faces of a leaf: those that are wet all over at once, the others as pieces.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// Sums over a run of leaves, and the pieces that are left over until there are enough.
struct Work {
  const Panels& panels;
  const Immersion& in;
  Sums& sums;
  Pieces cut_by_water;  ///< May be wet in part.
  Pieces turning;       ///< Wet all over, v·n changes its sign: only pressure drag is missing.
};

HWY_INLINE V3 load3(const double (&field)[3][kMostLanes], int at) {
  const D d;
  return {hn::Load(d, field[0] + at), hn::Load(d, field[1] + at), hn::Load(d, field[2] + at)};
}

HWY_INLINE Plane plane_at(const Leaf& leaf, int lane) {
  const FaceBlock& block = leaf.block(lane);
  const int at = lane % kMostLanes;
  Plane p{load3(block.c, at), load3(block.n, at), load3(block.e1, at), {}};
  p.e2 = cross(p.n, p.e1);
  return p;
}

HWY_INLINE V areas_at(const Leaf& leaf, int lane) {
  return hn::Load(D(), leaf.block(lane).area + lane % kMostLanes);
}

HWY_INLINE Triangle triangle_at(const Leaf& leaf, int lane) {
  const D d;
  const FaceBlock& block = leaf.block(lane);
  const int at = lane % kMostLanes;
  const V2 a = {hn::Load(d, block.x[0] + at), hn::Load(d, block.y[0] + at)};
  const V2 b = {hn::Load(d, block.x[1] + at), hn::Load(d, block.y[1] + at)};
  return {a, b, {zero() - (a.x + b.x), zero() - (a.y + b.y)}};
}

/// The planes of pieces `from` and on.
HWY_INLINE Plane plane_of(const Work& work, const Pieces& pieces, int from) {
  const auto index = hn::LoadU(hn::Rebind<std::int64_t, D>(), pieces.face + from);
  const FaceBlock& first = work.panels.leaves[0].block(0);
  const auto gather = [&](const double(&field)[3][kMostLanes]) HWY_ATTR {
    const D d;
    return V3{hn::GatherIndex(d, field[0], index), hn::GatherIndex(d, field[1], index),
              hn::GatherIndex(d, field[2], index)};
  };
  Plane p{gather(first.c), gather(first.n), gather(first.e1), {}};
  p.e2 = cross(p.n, p.e1);
  return p;
}

HWY_INLINE Values load_values(const double (&from)[3][Pieces::kRoom], int at) {
  const D d;
  return {hn::LoadU(d, from[0] + at), hn::LoadU(d, from[1] + at), hn::LoadU(d, from[2] + at)};
}

HWY_INLINE Triangle triangle_of(const Pieces& pieces, int from) {
  const Values x = load_values(pieces.x, from), y = load_values(pieces.y, from);
  return {{x.a, y.a}, {x.b, y.b}, {x.c, y.c}};
}

/// Puts some faces of a leaf, from `lane` on, among the pieces. One by one: they are few, and
/// compressing ten vectors takes longer.
HWY_NOINLINE void append(Work& work, Pieces& pieces, M which, std::int64_t leaf, int lane,
                         const Values& depth) {
  const D d;
  alignas(64) double depths[3][kMostLanes];
  hn::Store(depth.a, d, depths[0]);
  hn::Store(depth.b, d, depths[1]);
  hn::Store(depth.c, d, depths[2]);
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, which, bits);
  for (unsigned left = bits[0]; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    put_face(work.panels, leaf, lane + i, {depths[0][i], depths[1][i], depths[2][i]}, pieces);
  }
}

HWY_INLINE Values normal_speeds(const Flow& flow, const Triangle& t) {
  return {flow.normal_at(t.a), flow.normal_at(t.b), flow.normal_at(t.c)};
}

/// ½ρC_p with the sign of the motion into the water, where u is of one sign.
HWY_INLINE V signed_drag(const Immersion& in, M forward) {
  return hn::IfThenElse(forward, all(in.drag_front), all(-in.drag_back));
}

HWY_INLINE Traction lift_on(const Flow& flow, const Triangle& t, V scale) {
  const Values along1 = {flow.along1(t.a.y), flow.along1(t.b.y), flow.along1(t.c.y)};
  const Values along2 = {flow.along2(t.a.x), flow.along2(t.b.x), flow.along2(t.c.x)};
  return square_on(t, scale, along1) + square_on(t, scale, along2);
}

/// Pressure drag on the triangles that count, of any motion: cut where v·n is zero.
HWY_INLINE Traction cut_drag_on(const Immersion& in, const Flow& flow, const Triangle& t,
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

/// All loads on the triangles that count; they are wet all over.
HWY_NOINLINE void add_wet(Work& work, const Plane& p, const Triangle& t, M counts,
                          const Values& depth) {
  const Immersion& in = work.in;
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

HWY_INLINE V chosen(M first, V a, V b) { return hn::IfThenElse(first, a, b); }
HWY_INLINE V2 chosen(M first, const V2& a, const V2& b) {
  return {chosen(first, a.x, b.x), chosen(first, a.y, b.y)};
}

/// The pieces from `from` on, one a lane, cut at the waterline; the first `used` lanes count.
HWY_INLINE void add_pieces(Work& work, const Pieces& pieces, int from, int used) {
  const D d;
  const Plane p = plane_of(work, pieces, from);
  const Triangle t = triangle_of(pieces, from);
  const Values depth = load_values(pieces.depth, from);
  const M counts = hn::And(hn::FirstN(d, static_cast<std::size_t>(used)), highest(depth) > zero());
  const M crosses = hn::And(counts, lowest(depth) < zero());
  const Cut cut = cut_at_zero(t, depth, crosses);
  // The wet side is the corner, or the trapezium's two triangles.
  const M corner = cut.alone_positive;
  add_wet(work, p,
          {chosen(corner, cut.corner.a, cut.near.a), chosen(corner, cut.corner.b, cut.near.b),
           chosen(corner, cut.corner.c, cut.near.c)},
          counts,
          {chosen(corner, cut.at_corner.a, cut.at_near.a),
           chosen(corner, cut.at_corner.b, cut.at_near.b),
           chosen(corner, cut.at_corner.c, cut.at_near.c)});
  const M two = hn::AndNot(corner, crosses);
  if (!hn::AllFalse(d, two)) add_wet(work, p, cut.far, two, cut.at_far);
}

/// The pressure drag of pieces that are wet all over.
HWY_INLINE void add_turning(Work& work, const Pieces& pieces, int from, int used) {
  const Plane p = plane_of(work, pieces, from);
  const M counts = hn::FirstN(D(), static_cast<std::size_t>(used));
  add_normal(work.sums, kPressureDrag, p, cross(p.c, p.n),
             cut_drag_on(work.in, flow_over(p, work.in), triangle_of(pieces, from), counts));
}

/// Works on pieces while there are enough to fill the lanes, or all of them.
template <class Add>
HWY_INLINE void drain(Work& work, Pieces& pieces, bool to_the_last, Add add_some) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  while (pieces.count >= lanes) {
    pieces.count -= lanes;
    add_some(work, pieces, pieces.count, lanes);
  }
  if (!to_the_last || pieces.count == 0) return;
  pad(pieces, lanes);
  add_some(work, pieces, 0, pieces.count);
  pieces.count = 0;
}

HWY_INLINE void drain(Work& work, bool to_the_last) {
  drain(work, work.cut_by_water, to_the_last, add_pieces);
  drain(work, work.turning, to_the_last, add_turning);
}

/// What is known of a leaf beforehand.
struct Known {
  bool wet = false;              ///< All over.
  bool without_viscous = false;  ///< Its viscous drag is zero.
};

/// Pressure drag on the faces that count: those of one sign here, the others as pieces.
HWY_INLINE void add_whole_drag(Work& work, const Plane& p, const V3& c_cross_n, const Flow& flow,
                               const Triangle& t, V area, M counts, std::int64_t leaf, int lane) {
  const Values u = normal_speeds(flow, t);
  const M forward = highest(u) > zero();
  const M turns = hn::And(counts, hn::And(lowest(u) < zero(), forward));
  const V scale = signed_drag(work.in, forward) * area;
  add_normal(work.sums, kPressureDrag, p, c_cross_n,
             square_on(t, hn::IfThenZeroElse(turns, scale), u));
  if (!hn::AllFalse(D(), turns)) append(work, work.turning, turns, leaf, lane, u);
}

/// The faces that count of a vector from `lane` of a leaf on, with the depths at their vertices.
HWY_INLINE void add_faces(Work& work, std::int64_t leaf, int lane, Known known, M counts,
                          const Values& depth) {
  const D d;
  const Immersion& in = work.in;
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  const V whole = areas_at(faces, lane);
  counts = hn::And(counts, whole > zero());  // Not those that only fill the leaf.
  M wet = counts;
  if (!known.wet) {
    const M dips = hn::And(counts, highest(depth) > zero());
    wet = hn::And(dips, lowest(depth) >= zero());
    const M crosses = hn::AndNot(wet, dips);
    if (!hn::AllFalse(d, crosses)) append(work, work.cut_by_water, crosses, leaf, lane, depth);
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

/// The viscous drag alone of a leaf that is wet all over.
HWY_INLINE void add_viscous_of_leaf(Work& work, std::int64_t leaf) {
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
    const Plane p = plane_at(faces, lane);
    const V area = areas_at(faces, lane);
    add_viscous(work.sums, work.in, {p, flow_over(p, work.in), triangle_at(faces, lane), area});
  }
}

/// All faces of a leaf under flat water.
HWY_INLINE void add_leaf(Work& work, std::int64_t leaf, Known known) {
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  const V3 up = all3(work.in.up);
  for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
    const Plane p = plane_at(faces, lane);
    const Triangle t = triangle_at(faces, lane);
    const V middle = all(work.in.below) - dot(up, p.c);
    const V along1 = dot(up, p.e1), along2 = dot(up, p.e2);
    const auto at = [&](const V2& r)
                        HWY_ATTR { return middle - hn::MulAdd(along1, r.x, along2 * r.y); };
    add_faces(work, leaf, lane, known, hn::FirstN(D(), kMostLanes), {at(t.a), at(t.b), at(t.c)});
  }
  drain(work, false);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_PIECES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_PIECES
#undef PLIMSOLL_KERNEL_PIECES
#else
#define PLIMSOLL_KERNEL_PIECES
#endif

#include <algorithm>
#include <bit>

#include "hydro/loads/kernel/lanes-inl.h"
#include "hydro/loads/kernel/triangle_queue.h"

/// @file
/// The faces of a leaf, and pieces of faces, in lanes; and the wet part of each.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

using DI = hn::Rebind<std::int64_t, D>;
using VI = hn::Vec<DI>;

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

/// Where pieces `from` and on have a field of their face, counted in doubles from that field of the
/// first face. `kSize` is the size of a block of kMostLanes faces [bytes].
template <std::size_t kSize>
HWY_INLINE VI index_in_blocks(const TriangleQueue& pieces, int from) {
  constexpr int kRows = static_cast<int>(kSize / sizeof(double)) / kMostLanes;
  static_assert(kRows * kMostLanes * sizeof(double) == kSize && kRows % 2 == 0 && kRows < 32);
  const VI place = hn::LoadU(DI(), pieces.face + from);
  const VI lane = hn::And(place, hn::Set(DI(), kMostLanes - 1));
  const VI blocks = place - lane;  // times kMostLanes
  VI index = lane;
  if constexpr (kRows & 2) index = index + hn::ShiftLeft<1>(blocks);
  if constexpr (kRows & 4) index = index + hn::ShiftLeft<2>(blocks);
  if constexpr (kRows & 8) index = index + hn::ShiftLeft<3>(blocks);
  if constexpr (kRows & 16) index = index + hn::ShiftLeft<4>(blocks);
  return index;
}

/// The planes of pieces `from` and on.
HWY_INLINE Plane plane_of(const Panels& panels, const TriangleQueue& pieces, int from) {
  const VI index = index_in_blocks<sizeof(FaceBlock)>(pieces, from);
  const FaceBlock& first = panels.leaves[0].block(0);
  const auto gather = [&](const double(&field)[3][kMostLanes]) HWY_ATTR {
    const D d;
    return V3{hn::GatherIndex(d, field[0], index), hn::GatherIndex(d, field[1], index),
              hn::GatherIndex(d, field[2], index)};
  };
  Plane p{gather(first.c), gather(first.n), gather(first.e1), {}};
  p.e2 = cross(p.n, p.e1);
  return p;
}

HWY_INLINE Values load_values(const double (&from)[3][TriangleQueue::kRoom], int at) {
  const D d;
  return {hn::LoadU(d, from[0] + at), hn::LoadU(d, from[1] + at), hn::LoadU(d, from[2] + at)};
}

HWY_INLINE Triangle triangle_of(const TriangleQueue& pieces, int from) {
  const Values x = load_values(pieces.x, from), y = load_values(pieces.y, from);
  return {{x.a, y.a}, {x.b, y.b}, {x.c, y.c}};
}

/// Puts some faces of a leaf, from `lane` on, among the pieces. They are few, so they are put one
/// by one: to compress ten vectors takes longer.
inline HWY_NOINLINE void append(const Panels& panels, M which, std::int64_t leaf, int lane,
                                const Values& depth, TriangleQueue& pieces) {
  const D d;
  alignas(64) double depths[3][kMostLanes];
  hn::Store(depth.a, d, depths[0]);
  hn::Store(depth.b, d, depths[1]);
  hn::Store(depth.c, d, depths[2]);
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, which, bits);
  for (unsigned left = bits[0]; left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    put_face(panels, leaf, lane + i, {depths[0][i], depths[1][i], depths[2][i]}, pieces);
  }
}

HWY_INLINE V chosen(M first, V a, V b) { return hn::IfThenElse(first, a, b); }
HWY_INLINE V2 chosen(M first, const V2& a, const V2& b) {
  return {chosen(first, a.x, b.x), chosen(first, a.y, b.y)};
}

/// The wet part of triangles: one or two triangles each, with the depths at their vertices.
struct WetParts {
  Triangle first, second;
  Values at_first, at_second;
  M has_first, has_second;
};

/// The triangles that count, cut at the waterline.
HWY_INLINE WetParts wet_parts(const Triangle& t, const Values& depth, M counts) {
  const M dips = hn::And(counts, highest(depth) > zero());
  const M crosses = hn::And(dips, lowest(depth) < zero());
  const Cut cut = cut_at_zero(t, depth, crosses);
  // The wet side is the corner, or the trapezium's two triangles.
  const M corner = cut.alone_positive;
  return {{chosen(corner, cut.corner.a, cut.near.a), chosen(corner, cut.corner.b, cut.near.b),
           chosen(corner, cut.corner.c, cut.near.c)},
          cut.far,
          {chosen(corner, cut.at_corner.a, cut.at_near.a),
           chosen(corner, cut.at_corner.b, cut.at_near.b),
           chosen(corner, cut.at_corner.c, cut.at_near.c)},
          cut.at_far,
          dips,
          hn::AndNot(corner, crosses)};
}

/// Works on pieces while there are enough to fill the lanes, or on all of them. Pieces that
/// `add_some` puts back among them are worked on, too.
template <class Work, class Add>
HWY_INLINE void drain(Work& work, TriangleQueue& pieces, bool to_the_last, Add add_some) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  while (pieces.count >= lanes || (to_the_last && pieces.count > 0)) {
    const int some = std::min(pieces.count, lanes);
    if (some < lanes) pad(pieces, lanes);
    pieces.count -= some;
    add_some(work, pieces, pieces.count, some);
  }
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

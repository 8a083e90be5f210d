#include "hydro/added_mass/wetted_share.h"

#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/added_mass/wetted_share.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "hydro/loads/kernel/walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

using ShareSums = LaneSums<36>;

/// The sums over a run of leaves, and the pieces that wait until there are enough.
struct ShareWalk {
  const Panels& panels;
  const Potentials& potentials;
  const LoadInputs& in;
  ShareSums& sums;             ///< −∫ ψ_m N_n dS, row by row.
  TriangleQueue bending;       ///< The surface may bend over them by more than the tolerance.
  TriangleQueue cut_by_water;  ///< May be wet in part.
};

/// ∫ {1, x, y, xx, xy, yy} dA.
struct AreaMoments {
  V one, x, y, xx, xy, yy;
};

HWY_INLINE AreaMoments operator+(const AreaMoments& a, const AreaMoments& b) {
  return {a.one + b.one, a.x + b.x, a.y + b.y, a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}

HWY_INLINE AreaMoments moments_of(const Triangle& t, V area) {
  const V x = t.a.x + t.b.x + t.c.x, y = t.a.y + t.b.y + t.c.y;
  const auto products = [&](V pa, V pb, V pc, V p, V qa, V qb, V qc, V q) HWY_ATTR {
    return hn::MulAdd(pa, qa, hn::MulAdd(pb, qb, hn::MulAdd(pc, qc, p * q)));
  };
  const V third = area * all(1.0 / 3), twelfth = area * all(1.0 / 12);
  return {area,
          third * x,
          third * y,
          twelfth * products(t.a.x, t.b.x, t.c.x, x, t.a.x, t.b.x, t.c.x, x),
          twelfth * products(t.a.x, t.b.x, t.c.x, x, t.a.y, t.b.y, t.c.y, y),
          twelfth * products(t.a.y, t.b.y, t.c.y, y, t.a.y, t.b.y, t.c.y, y)};
}

/// Adds (1) of all six. @param row   row(i) is row i of the faces' potentials.
template <class Row>
HWY_INLINE void add_moments(ShareSums& sums, const Plane& p, const AreaMoments& a, Row row) {
  const V3 c_cross_n = cross(p.c, p.n);
  for (int m = 0; m < 6; ++m) {
    const V middle = row(3 * m), along1 = row(3 * m + 1), along2 = row(3 * m + 2);
    const auto integral = [&](V one, V x, V y) HWY_ATTR {
      return hn::MulAdd(middle, one, hn::MulAdd(along1, x, along2 * y));
    };
    add_normal(sums, 6 * m, p, c_cross_n,
               {integral(a.one, a.x, a.y), integral(a.x, a.xx, a.xy), integral(a.y, a.xy, a.yy)});
  }
}

HWY_NOINLINE void add_pieces(ShareWalk& work, const TriangleQueue& pieces, int from, int used) {
  const WetParts wet = wet_parts(triangle_of(pieces, from), load_values(pieces.depth, from),
                                 hn::FirstN(D(), static_cast<std::size_t>(used)));
  const auto moments = [](const Triangle& t, M counts) HWY_ATTR {
    return moments_of(t, hn::IfThenElseZero(counts, area_of(t)));
  };
  AreaMoments a = moments(wet.first, wet.has_first);
  if (!hn::AllFalse(D(), wet.has_second)) a = a + moments(wet.second, wet.has_second);
  const VI index = index_in_blocks<sizeof(PotentialBlock)>(pieces, from);
  const PotentialBlock& first = work.potentials.blocks[0];
  add_moments(work.sums, plane_of(work.panels, pieces, from), a,
              [&](int i) HWY_ATTR { return hn::GatherIndex(D(), first.row[i], index); });
}

HWY_INLINE void drain_cut(ShareWalk& work, bool to_the_last) {
  drain(work, work.cut_by_water, to_the_last, add_pieces);
}

HWY_INLINE void drain(ShareWalk& work, bool to_the_last) {
  drain(work, work.bending, to_the_last, refine_pieces<ShareWalk>);
  drain_cut(work, to_the_last);
}

/// The wet faces that count of a vector from `lane` of a leaf on; those across the waterline become
/// pieces.
HWY_INLINE void add_faces(ShareWalk& work, std::int64_t leaf, int lane, M counts,
                          const Values& depth) {
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  const V area = areas_at(faces, lane);
  const M dips = hn::And(hn::And(counts, area > zero()), highest(depth) > zero());
  const M wet = hn::And(dips, lowest(depth) >= zero());
  const M crosses = hn::AndNot(wet, dips);
  if (!hn::AllFalse(D(), crosses))
    append(work.panels, crosses, leaf, lane, depth, work.cut_by_water);
  if (hn::AllFalse(D(), wet)) return;
  const PotentialBlock& potentials =
      work.potentials.blocks[static_cast<std::size_t>(place_of(leaf, lane) / kMostLanes)];
  const int at = lane % kMostLanes;
  add_moments(work.sums, plane_at(faces, lane),
              moments_of(triangle_at(faces, lane), hn::IfThenElseZero(wet, area)),
              [&](int i) HWY_ATTR { return hn::Load(D(), potentials.row[i] + at); });
}

void wetted_share_here(const Panels& panels, const Tree& tree, const Potentials& potentials,
                       const LoadInputs& in, ShareSums& sums) {
  ShareWalk work{panels, potentials, in, sums, {}, {}};
  const auto end = tree.nodes.size();
  for (std::size_t i = 0; i < end;) {
    const Node& node = tree.nodes[i];
    const Wetness wet = wetness(node, in);
    if (wet == Wetness::wet) {
      for (int m = 0; m < 6; ++m)
        for (int n = 0; n < 6; ++n) sums.lane[6 * m + n][0] -= potentials.shares[i](m, n);
    } else if (wet == Wetness::mixed && node.leaf()) {
      in.surface ? add_leaf_in_waves(work, node) : add_leaf(work, node);
    }
    i = wet == Wetness::mixed ? i + 1 : static_cast<std::size_t>(node.next);
  }
  drain(work, true);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro::kernel {

HWY_EXPORT(wetted_share_here);

Matrix6d wetted_share(const Panels& panels, const Tree& tree, const Potentials& potentials,
                      const LoadInputs& in) {
  LaneSums<36> sums;
  HWY_DYNAMIC_DISPATCH(wetted_share_here)(panels, tree, potentials, in, sums);
  Matrix6d share;
  for (int m = 0; m < 6; ++m)
    for (int n = 0; n < 6; ++n) share(m, n) = -sums.total(6 * m + n);
  return share;
}

}  // namespace hydro::kernel
#endif

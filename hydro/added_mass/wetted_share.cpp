#include "hydro/added_mass/wetted_share.h"

#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/added_mass/wetted_share.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "hydro/added_mass/surface_cut-inl.h"
#include "hydro/loads/kernel/airy_branch-inl.h"
#include "hydro/loads/kernel/walk-inl.h"
#include "hydro/loads/point_rules.h"

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

using ShareSums = LaneSums<kShareSums>;

/// The sums over a run of leaves, and the pieces that wait until there are enough.
/// @tparam kWaves   The load of the waves is asked for, too.
template <bool kWaves>
struct ShareWalk {
  const Panels& panels;
  const Potentials& potentials;
  const LoadInputs& in;
  ShareSums& sums;
  HorizontalAxes axes;
  double level;                ///< Level of add_outline.
  TriangleQueue bending;       ///< The surface may bend over them by more than the tolerance.
  TriangleQueue cut_by_water;  ///< May be wet in part.
  LocalSea sea;                ///< For one place at a time.

  TriangleQueue& refined() { return cut_by_water; }
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

/// Adds ∫ ψ_m u̇·n dA of triangles of the given area.
template <class Row>
HWY_INLINE void add_wave_load(ShareSums& sums, const Plane& p, const Triangle& t, V area,
                              const MovingWater& water, Row row) {
  const Traction f = linear_on(t, area, along_of(water, p.n));
  for (int m = 0; m < 6; ++m)
    add(sums, kLoad + m,
        hn::MulAdd(row(3 * m), f.q, hn::MulAdd(row(3 * m + 1), f.qx, row(3 * m + 2) * f.qy)));
}
template <class Row>
HWY_INLINE void add_wave_load(ShareSums&, const Plane&, const Triangle&, V, const Values&, Row) {}

/// The same over which u̇ is not linear, at the points of a rule.
template <class Row, std::size_t kPoints>
HWY_INLINE void add_curved_wave_load(ShareWalk<true>& work, const Plane& p, const Triangle& t,
                                     V area, const std::array<TrianglePoint, kPoints>& rule,
                                     Row row) {
  Traction f = {zero(), zero(), zero()};
  for (const TrianglePoint& point : rule) {
    const V2 at = point_of(t, point);
    const V3 r = point_on(p, at);
    const V rise = rise_at(work.in, work.sea, r), depth = depth_below(work.in, rise, r);
    const Water water = water_at<Ask::acceleration>(work.in, r, depth, rise, work.sea);
    f = f + traction_at(all(point.weight) * area * dot(water.u, p.n), at);
  }
  for (int m = 0; m < 6; ++m)
    add(work.sums, kLoad + m,
        hn::MulAdd(row(3 * m), f.q, hn::MulAdd(row(3 * m + 1), f.qx, row(3 * m + 2) * f.qy)));
}

/// Adds pieces that are wet in part.
template <bool kWaves>
HWY_NOINLINE void add_pieces(ShareWalk<kWaves>& work, const TriangleQueue& pieces, int from,
                             int used) {
  const Triangle whole = triangle_of(pieces, from);
  const Values depth_of_whole = load_values(pieces.depth, from);
  const M counted = hn::FirstN(D(), static_cast<std::size_t>(used));
  const Plane p = plane_of(work.panels, pieces, from);
  const VI index = index_in_blocks<sizeof(PotentialBlock)>(pieces, from);
  const PotentialBlock& first = work.potentials.blocks[0];
  const auto row = [&](int i) HWY_ATTR { return hn::GatherIndex(D(), first.row[i], index); };
  /// Calls add(triangle, area, depth) for the wet parts of the pieces that count.
  const auto for_parts = [&](M counts, auto add) HWY_ATTR {
    const WetParts wet = wet_parts(whole, depth_of_whole, counts);
    const auto part = [&](const Triangle& t, M has, const Values& depth)
                          HWY_ATTR { add(t, hn::IfThenElseZero(has, area_of(t)), depth); };
    part(wet.first, wet.has_first, wet.at_first);
    if (!hn::AllFalse(D(), wet.has_second)) part(wet.second, wet.has_second, wet.at_second);
  };
  AreaMoments moments = {zero(), zero(), zero(), zero(), zero(), zero()};
  const V slope = zero() - dot(p.n, all3(work.in.up));
  for_parts(counted, [&](const Triangle& t, V area, const Values& depth) HWY_ATTR {
    moments = moments + moments_of(t, area);
    if (!work.in.surface) add_shadow(work.sums, kCut, slope * area, depth);
    if constexpr (kWaves)
      if (!work.in.surface->limits.curved)
        add_wave_load(work.sums, p, t, area,
                      water_at_corners<Ask::acceleration>(work.in, p, t, depth, work.sea), row);
  });
  add_moments(work.sums, p, moments, row);
  if (!work.in.surface)
    add_outline(work.sums, kCut, p, whole, depth_of_whole, work.axes, work.level, counted);
  if constexpr (kWaves) {
    if (!work.in.surface->limits.curved) return;
    with_rules(bearings_of(work.in, p), whole, counted, [&](const auto& rule, M counts) HWY_ATTR {
      for_parts(counts, [&](const Triangle& t, V area, const Values&)
                            HWY_ATTR { add_curved_wave_load(work, p, t, area, rule, row); });
    });
  }
}

template <bool kWaves>
HWY_INLINE void drain_cut(ShareWalk<kWaves>& work, bool to_the_last) {
  drain(work, work.cut_by_water, to_the_last, add_pieces<kWaves>);
}

template <bool kWaves>
HWY_INLINE void drain(ShareWalk<kWaves>& work, bool to_the_last) {
  drain(work, work.bending, to_the_last, refine_pieces<ShareWalk<kWaves>>);
  drain_cut(work, to_the_last);
}

/// Row i of the potentials of a leaf's faces from `lane` on.
template <bool kWaves>
HWY_INLINE V potential(const ShareWalk<kWaves>& work, std::int64_t leaf, int lane, int i) {
  const auto block = static_cast<std::size_t>(place_of(leaf, lane) / kMostLanes);
  return hn::Load(D(), work.potentials.blocks[block].row[i] + lane % kMostLanes);
}

/// The wet faces that count of a vector from `lane` of a leaf on; those across the waterline become
/// pieces.
template <bool kWaves, class Water>
HWY_INLINE void add_faces(ShareWalk<kWaves>& work, std::int64_t leaf, int lane, M counts,
                          const Water& water) {
  const Values& depth = depth_of(water);
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  const V area = areas_at(faces, lane);
  const M dips = hn::And(hn::And(counts, area > zero()), highest(depth) > zero());
  const M wet = hn::And(dips, lowest(depth) >= all(work.level));
  const M crosses = hn::AndNot(wet, dips);
  if (!hn::AllFalse(D(), crosses))
    append(work.panels, crosses, leaf, lane, depth, work.cut_by_water);
  if (hn::AllFalse(D(), wet)) return;
  const auto row = [&](int i) HWY_ATTR { return potential(work, leaf, lane, i); };
  const Plane p = plane_at(faces, lane);
  const Triangle t = triangle_at(faces, lane);
  const V counted = hn::IfThenElseZero(wet, area);
  add_wave_load(work.sums, p, t, counted, water, row);
  add_moments(work.sums, p, moments_of(t, counted), row);
  if (!work.in.surface)
    add_shadow(work.sums, kCut, zero() - counted * dot(p.n, all3(work.in.up)), depth);
}

/// Adds the share of a branch that is wet all over.
inline void add_share(const Matrix6d& share, ShareSums& sums) {
  for (int m = 0; m < 6; ++m)
    for (int n = 0; n < 6; ++n) sums.lane[kShare + 6 * m + n][0] -= share(m, n);
}

/// Adds the load of the waves on a branch that is wet all over.
/// @return false if the water's acceleration is not quadratic over it
inline HWY_NOINLINE bool add_wave_load_of_branch(ShareWalk<true>& work, const Node& node,
                                                 const Matrix6d& share) {
  const LoadInputs& in = work.in;
  const double error = in.surface->gravity * in.wave_error / work.potentials.largest;
  if (!fits<Ask::acceleration>(node, in, error)) return false;
  BranchWater water;
  find_branch_water<Ask::acceleration>(node, in, work.sea, water);
  double u[3];
  if (middle_flow(node, water, u) <= error) {
    for (int m = 0; m < 6; ++m)
      work.sums.lane[kLoad + m][0] += share(m, 0) * u[0] + share(m, 1) * u[1] + share(m, 2) * u[2];
    return true;
  }
  for (int leaf = node.first; leaf < node.last; ++leaf) {
    const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
    for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D()))) {
      const Plane p = plane_at(faces, lane);
      const Triangle t = triangle_at(faces, lane);
      const auto row = [&](int i) HWY_ATTR { return potential(work, leaf, lane, i); };
      add_wave_load(work.sums, p, t, areas_at(faces, lane), flow_at_corners(water, p, t), row);
    }
  }
  return true;
}

template <bool kWaves>
HWY_INLINE void add_whole_leaf(ShareWalk<kWaves>& work, const Node& leaf) {
  if constexpr (kWaves)
    add_leaf_in_airy_waves<Ask::acceleration>(work, leaf);
  else
    work.in.surface ? add_leaf_in_waves(work, leaf) : add_leaf(work, leaf);
}

template <bool kWaves>
void share_here(const Panels& panels, const Tree& tree, const Potentials& potentials,
                const LoadInputs& in, ShareSums& sums) {
  ShareWalk<kWaves> work{
      panels, potentials, in,          sums, HorizontalAxes(in.up), level_within(tree),
      {},     {},         LocalSea(in)};
  TableWalk tables;
  const auto end = tree.nodes.size();
  for (std::size_t i = 0; i < end;) {
    const Node& node = tree.nodes[i];
    tables.go_to(work, static_cast<int>(i));
    const Wetness wet = wetness(node, in, &work.sea);
    const Matrix6d& share = potentials.shares[i];
    bool whole = wet == Wetness::wet;
    if constexpr (kWaves) whole = whole && add_wave_load_of_branch(work, node, share);
    if (whole) {
      add_share(share, sums);
      if (!in.surface) add_branch_cut(sums, kCut, node, in);
    } else if (wet != Wetness::dry) {
      tables.enter<kWaves ? Ask::acceleration : Ask::elevation>(work, node);
      if (node.leaf()) add_whole_leaf(work, node);
    }
    i = whole || wet == Wetness::dry ? static_cast<std::size_t>(node.next) : i + 1;
  }
  drain(work, true);
}

void wetted_share_here(const Panels& panels, const Tree& tree, const Potentials& potentials,
                       const LoadInputs& in, ShareSums& sums) {
  share_here<false>(panels, tree, potentials, in, sums);
}

void wave_share_here(const Panels& panels, const Tree& tree, const Potentials& potentials,
                     const LoadInputs& in, ShareSums& sums) {
  share_here<true>(panels, tree, potentials, in, sums);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro::kernel {

HWY_EXPORT(wetted_share_here);
HWY_EXPORT(wave_share_here);

namespace {

Matrix6d share_of(const LaneSums<kShareSums>& sums) {
  Matrix6d share;
  for (int m = 0; m < 6; ++m)
    for (int n = 0; n < 6; ++n) share(m, n) = -sums.total(kShare + 6 * m + n);
  return share;
}

}  // namespace

WettedShare wetted_share(const Panels& panels, const Tree& tree, const Potentials& potentials,
                         const LoadInputs& in) {
  LaneSums<kShareSums> sums;
  HWY_DYNAMIC_DISPATCH(wetted_share_here)(panels, tree, potentials, in, sums);
  std::array<double, kCutSums> cut;
  for (int row = 0; row < kCutSums; ++row)
    cut[static_cast<std::size_t>(row)] = sums.total(kCut + row);
  return {.share = share_of(sums), .cut = in.surface ? SurfaceCut{} : cut_of(cut)};
}

WaveShare wave_share(const Panels& panels, const Tree& tree, const Potentials& potentials,
                     const LoadInputs& in) {
  LaneSums<kShareSums> sums;
  HWY_DYNAMIC_DISPATCH(wave_share_here)(panels, tree, potentials, in, sums);
  WaveShare result{.share = share_of(sums)};
  for (int m = 0; m < 6; ++m) result.load[m] = sums.total(kLoad + m);
  return result;
}

}  // namespace hydro::kernel
#endif

#include "hydro/added_mass/surface_cut.h"

#include <algorithm>
#include <cmath>

#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/added_mass/surface_cut.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "hydro/added_mass/surface_cut-inl.h"
#include "hydro/loads/kernel/walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The sums over the leaves, and the faces at the waterline that wait until there are enough.
struct CutWalk {
  // A constructor: GCC 12 would set all of the queue of an aggregate to zero first.
  CutWalk(const Panels& of, const LoadInputs& with, LaneSums<kCutSums>& to, double within)
      : panels(of), in(with), sums(to), axes(with.up), level(within) {}

  const Panels& panels;
  const LoadInputs& in;
  LaneSums<kCutSums>& sums;
  HorizontalAxes axes;
  double level;
  TriangleQueue cut_by_water;
};

HWY_NOINLINE void add_pieces(CutWalk& work, const TriangleQueue& pieces, int from, int used) {
  const M counts = hn::FirstN(D(), static_cast<std::size_t>(used));
  const Triangle t = triangle_of(pieces, from);
  const Values depth = load_values(pieces.depth, from);
  const WetParts wet = wet_parts(t, depth, counts);
  const Plane plane = plane_of(work.panels, pieces, from);
  const V slope = zero() - dot(plane.n, all3(work.in.up));
  const auto add_part = [&](const Triangle& part, const Values& at, M has) HWY_ATTR {
    add_shadow(work.sums, 0, hn::IfThenElseZero(has, slope * area_of(part)), at);
  };
  add_part(wet.first, wet.at_first, wet.has_first);
  add_part(wet.second, wet.at_second, wet.has_second);
  add_outline(work.sums, 0, plane, t, depth, work.axes, work.level, counts);
}

HWY_INLINE void drain(CutWalk& work, bool to_the_last) {
  drain(work, work.cut_by_water, to_the_last, add_pieces);
}

/// The wet faces of a vector from `lane` of a leaf on; those that meet the surface become pieces.
HWY_INLINE void add_faces(CutWalk& work, std::int64_t leaf, int lane, M counts,
                          const Values& depth) {
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  const V area = areas_at(faces, lane);
  const M dips = hn::And(hn::And(counts, area > zero()), highest(depth) > zero());
  const M wet = hn::And(dips, lowest(depth) >= all(work.level));
  const M meets = hn::AndNot(wet, dips);
  if (!hn::AllFalse(D(), meets)) append(work.panels, meets, leaf, lane, depth, work.cut_by_water);
  if (hn::AllFalse(D(), wet)) return;
  const V slope = zero() - dot(plane_at(faces, lane).n, all3(work.in.up));
  add_shadow(work.sums, 0, hn::IfThenElseZero(wet, slope * area), depth);
}

void surface_cut_here(const Panels& panels, const Tree& tree, const LoadInputs& in,
                      LaneSums<kCutSums>& sums) {
  CutWalk work(panels, in, sums, level_within(tree));
  const auto end = tree.nodes.size();
  for (std::size_t i = 0; i < end;) {
    const Node& node = tree.nodes[i];
    const Wetness wet = wetness(node, in, nullptr);
    if (wet == Wetness::wet)
      add_branch_cut(sums, 0, node, in);
    else if (wet == Wetness::mixed && node.leaf())
      add_leaf(work, node);
    i = wet == Wetness::mixed ? i + 1 : static_cast<std::size_t>(node.next);
  }
  drain(work, true);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro::kernel {

HWY_EXPORT(surface_cut_here);

double level_within(const Tree& tree) {
  constexpr double kRoundings = 1e-13;
  if (tree.nodes.empty()) return 0;
  const double* half = tree.nodes.front().half;
  return kRoundings * (half[0] + half[1] + half[2]);
}

HorizontalAxes::HorizontalAxes(const double (&up)[3]) {
  const Eigen::Vector3d z(up[0], up[1], up[2]);
  Eigen::Index least = 0;
  z.cwiseAbs().minCoeff(&least);
  Eigen::Map<Eigen::Vector3d> east(x), north(y);
  east = Eigen::Vector3d::Unit(least).cross(z).normalized();
  north = z.cross(east);
}

SurfaceCut cut_of(const std::array<double, kCutSums>& sums) {
  // Beyond this r a body is more pointed than a needle, or not wet but for roundings.
  constexpr double kMostPointed = 0.95;
  // Largest plate over S²/P; one ellipse has 0.85. With 1 the added mass of a teapot that sinks on
  // its side falls by 0.6 % in all as spout and handle touch down, with this value by 0.05 %.
  constexpr double kMostApart = 1.25;
  const double area = sums[kCutArea], volume = sums[kCutVolume], perimeter = sums[kCutPerimeter];
  SurfaceCut cut{.volume = volume, .area = area, .perimeter = perimeter};
  if (!(volume > 0) || !(area > 0) || !(perimeter > 0)) return cut;
  const double r = std::clamp(sums[kCutDepth] * area / (volume * volume), 0.0, kMostPointed);
  cut.draught = r / (1 - r) * volume / area;
  const double x = sums[kCutPlace] / area, y = sums[kCutPlace + 1] / area;
  const double xx = sums[kCutSquare] / area - x * x, yy = sums[kCutSquare + 2] / area - y * y;
  const double xy = sums[kCutSquare + 1] / area - x * y;
  const double mean = (xx + yy) / 2, apart = std::hypot((xx - yy) / 2, xy);
  if (!(mean > apart)) return cut;
  const double breadth = std::sqrt(mean - apart);
  cut.round = breadth / std::sqrt(mean + apart);
  const double one = 4.0 / 3 * area * breadth / (1 + (M_PI / 2 - 1) * std::pow(cut.round, 1.5));
  cut.plate = std::min(one, kMostApart * area * area / perimeter);
  cut.half_breadth = std::lerp(std::sqrt(3.0), 2, cut.round) * breadth * cut.plate / one;
  return cut;
}

SurfaceCut surface_cut(const Panels& panels, const Tree& tree, const WaterPlane& plane) {
  LoadInputs in{.below = plane.height};
  for (int i = 0; i < 3; ++i) in.up[i] = plane.up[i];
  LaneSums<kCutSums> sums;
  HWY_DYNAMIC_DISPATCH(surface_cut_here)(panels, tree, in, sums);
  std::array<double, kCutSums> totals;
  for (int row = 0; row < kCutSums; ++row) totals[static_cast<std::size_t>(row)] = sums.total(row);
  return cut_of(totals);
}

}  // namespace hydro::kernel
#endif

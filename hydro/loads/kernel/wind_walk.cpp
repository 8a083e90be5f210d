#include "hydro/loads/kernel/wind_walk.h"

#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/loads/kernel/wind_walk.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "hydro/loads/kernel/faces-inl.h"
#include "hydro/loads/kernel/walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// Factor of the fourth order of (1) of wind_walk.h, for the orders that are left out [-]: on walls
/// that rise from the water the error is 0.2 % with it and 0.4 % without.
constexpr double kHigherOrders = 1.1;

/// The state of a walk over the dry part.
struct WindWalk : LoadWalk {
  WindWalk(const Panels& of, const LoadInputs& with, const PowerLaw* by, Sums& to)
      : LoadWalk(of, with, to), law(by) {}

  const PowerLaw* law;
  TriangleQueue& refined() { return cut_by_water; }
};

HWY_INLINE Values negative(const Values& f) { return {zero() - f.a, zero() - f.b, zero() - f.c}; }

/// The factor of a wind by the power law over triangles: (1) of wind_walk.h.
HWY_INLINE Values factor_over(const PowerLaw& law, const Values& height) {
  const auto dry = [](V z) HWY_ATTR { return hn::Max(z, zero()); };
  const Values z = {dry(height.a), dry(height.b), dry(height.c)};
  const V middle = hn::Max(all(1.0 / 3) * (z.a + z.b + z.c), all(1e-60));
  const Values d = {z.a - middle, z.b - middle, z.c - middle};
  const V squares =
      hn::Max(hn::MulAdd(d.a, d.a, hn::MulAdd(d.b, d.b, d.c * d.c)), all(1e-30) * middle * middle);
  const V product = d.a * d.b * d.c;
  const V both = all(1) / (squares * middle);  // Divisions are slow: one gives both reciprocals.
  const V inverse = both * squares, p = squares * inverse * inverse;
  const V skew = product * inverse * inverse * inverse, skew_over_p = product * both;
  const double a = law.exponent, second = (1 - a) / 2, third = second * (2 - a) / 3;
  const double fourth = kHigherOrders * third * (3 - a) / 4;
  const V mean = hn::MulAdd(
      all(a),
      hn::MulSub(all(third / 10), skew, p * hn::MulAdd(all(fourth / 60), p, all(second / 12))),
      all(1));
  const V slope =
      all(a) * hn::MulAdd(all(third / 5), p, hn::NegMulAdd(all(second * 1.2), skew_over_p, all(1)));
  const V at_middle = exponential(all(a) * hn::Log(D(), middle * all(law.per_height)));
  const V constant = at_middle * mean, along = at_middle * slope * inverse;
  return {hn::MulAdd(along, d.a, constant), hn::MulAdd(along, d.b, constant),
          hn::MulAdd(along, d.c, constant)};
}

/// v·n at the corners, relative to the wind.
HWY_INLINE Values speeds_in_wind(const WindWalk& work, const Plane& p, const Triangle& t,
                                 const Values& height) {
  const Values own = normal_speeds(work.in, flow_over(p, work.in), p, t, height);
  if (!work.law) return own;
  const Values factor = factor_over(*work.law, height);
  const V wind = dot(all3(work.law->velocity), p.n);
  return own - Values{wind * factor.a, wind * factor.b, wind * factor.c};
}

/// Adds the drag on triangles that count. These are dry all over.
HWY_NOINLINE void add_dry(WindWalk& work, const Plane& p, const Triangle& t, M counts,
                          const Values& height) {
  add_normal(work.sums, kPressureDrag, p, cross(p.c, p.n),
             cut_drag_on(work.in, speeds_in_wind(work, p, t, height), t, counts));
}

/// Adds pieces that may be dry in part.
HWY_INLINE void add_pieces_in_wind(WindWalk& work, const TriangleQueue& pieces, int from,
                                   int used) {
  const Plane p = plane_of(work.panels, pieces, from);
  const WetParts dry =
      wet_parts(triangle_of(pieces, from), negative(load_values(pieces.depth, from)),
                hn::FirstN(D(), static_cast<std::size_t>(used)));
  add_dry(work, p, dry.first, dry.has_first, dry.at_first);
  if (!hn::AllFalse(D(), dry.has_second))
    add_dry(work, p, dry.second, dry.has_second, dry.at_second);
}

HWY_INLINE void drain_cut(WindWalk& work, bool to_the_last) {
  drain(work, work.cut_by_water, to_the_last, add_pieces_in_wind);
}

HWY_INLINE void drain(WindWalk& work, bool to_the_last) {
  drain(work, work.bending, to_the_last, refine_pieces<WindWalk>);
  drain_cut(work, to_the_last);
  drain(work, work.turning, to_the_last, add_turning);
}

/// Adds the drag on the faces that count, of a vector of a leaf's faces from `lane` on.
HWY_INLINE void add_faces(WindWalk& work, std::int64_t leaf, int lane, M counts,
                          const Values& depth) {
  const D d;
  const Leaf& faces = work.panels.leaves[static_cast<std::size_t>(leaf)];
  const V area = areas_at(faces, lane);
  counts = hn::And(counts, area > zero());  // Faces that only fill the leaf do not count.
  const M rises = hn::And(counts, lowest(depth) < zero());
  const M crosses = hn::And(rises, highest(depth) > zero());
  if (!hn::AllFalse(d, crosses)) append(work.panels, crosses, leaf, lane, depth, work.cut_by_water);
  const M dry = hn::AndNot(crosses, rises);
  if (hn::AllFalse(d, dry)) return;
  const Plane p = plane_at(faces, lane);
  const Triangle t = triangle_at(faces, lane);
  add_whole_drag(work, {leaf, lane}, p, cross(p.c, p.n),
                 speeds_in_wind(work, p, t, negative(depth)), t, hn::IfThenElseZero(dry, area));
}

/// Adds a leaf that is dry all over. In uniform wind its heights do not matter.
HWY_INLINE void add_dry_leaf(WindWalk& work, const Node& node) {
  const LeafVertices& vertices = work.panels.vertices[static_cast<std::size_t>(node.first)];
  Depths depths;
  if (work.law) find_depths(work.panels, work.in, node, work.sea, depths);
  const Values above = {all(-1), all(-1), all(-1)};
  for (int lane = 0; lane < kLeafFaces; lane += static_cast<int>(hn::Lanes(D())))
    add_faces(work, node.first, lane, hn::FirstN(D(), kMostLanes),
              work.law ? depths.at_faces(vertices, lane) : above);
  drain(work, false);
}

HWY_INLINE void add_leaf_in_wind(WindWalk& work, const Node& node, bool dry) {
  if (dry && (work.in.surface || !work.law)) return add_dry_leaf(work, node);
  work.in.surface ? add_leaf_in_waves(work, node) : add_leaf(work, node);
}

void wind_here(const Panels& panels, const Tree& tree, const LoadInputs& in, const PowerLaw* law,
               Sums& sums) {
  WindWalk work(panels, in, law, sums);
  const Factors factors = factors_of(in);
  TableWalk tables;
  int dry_end = 0;  // Branches of a dry branch are dry.
  const int end = static_cast<int>(tree.nodes.size());
  for (int i = 0; i < end;) {
    const Node& node = tree.nodes[static_cast<std::size_t>(i)];
    tables.go_to(work, i);
    const Wetness wet = i < dry_end ? Wetness::dry : wetness(node, in, &work.sea);
    const bool dry = wet == Wetness::dry;
    if (dry) dry_end = std::max(dry_end, node.next);
    double drag = 0;
    const bool whole = dry && !law && of_one_sign(node, in, 0, drag);
    if (whole) add_branch_motion(node, factors, in, drag, sums);
    if (!whole && wet != Wetness::wet) {
      if (!dry || law) tables.enter<Ask::elevation>(work, node);
      if (node.leaf()) add_leaf_in_wind(work, node, dry);
    }
    i = whole || wet == Wetness::wet ? node.next : i + 1;
  }
  drain(work, true);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro::kernel {

HWY_EXPORT(wind_here);

Sums sum_wind(const Panels& panels, const Tree& tree, const LoadInputs& in, const PowerLaw* law) {
  Sums sums;
  HWY_DYNAMIC_DISPATCH(wind_here)(panels, tree, in, law, sums);
  return sums;
}

}  // namespace hydro::kernel
#endif

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "hydro/loads/clip.h"
#include "hydro/loads/felt_waves.h"
#include "hydro/loads/point_rules.h"
#include "hydro/sea.h"

/// @file
/// Splitting of panels on which the water surface is not linear.
///
/// Depth is taken as linear over a panel, and so are head and velocity of the water under Airy
/// waves. On a large panel in short waves that is wrong, so its edges are halved until the surface,
/// or the head, departs from linear along each by less than a tolerance. The decision to halve an
/// edge depends on that edge alone, so neighbours agree and no cracks open, except at slivers with
/// areas below `smallest`², which are left whole.
///
/// Loads under Airy waves need fewer pieces: over a panel that bends they are summed at six points
/// (point_rules.h), which is exact for polynomials of fourth degree. For a wave a·cos over a
/// triangle whose longest edge is d, the mean of the head is then wrong by
///
///     2.3e-7 a (k d)⁵                                                                          (1)
///
/// in the root mean square over phases and directions. At the three middles of the edges, which is
/// exact for polynomials of second degree, the mean of the head is wrong by the first of
///
///     5e-4 a (k d)³,        2e-3 a (k d)² d                                                    (2)
///
/// and its moment over the panel's area by the second, which counts over ℓ of felt_waves.h: where
/// both are small, three points do. A panel that the waterline crosses is cut along the chord,
/// where the head is zero but for the surface's departure δ from it; the force misses ρg ∫ ½ δ²
/// along the waterline, always in the same direction.
///
/// The loads may miss a part of the buoyancy and a part of the waves' own load
/// (felt_waves.h).
///
/// Drag takes the velocity of the current as linear, too. The velocity of a table bends at its
/// rows, so an edge that crosses the height of one is split there.

namespace hydro {

/// Length below which loads split no edge, over the body's radius [-]. A smaller value costs more
/// in a rough sea; a larger one loses waves of a few such lengths.
inline constexpr double kSmallestPanel = 1.0 / 256;

/// The pieces of a face at most. Each has at least half of kSmallestPanel² of the radius squared,
/// and a triangle within the radius at most ¾√3 of that. Faces take far
/// fewer, as they are split where it counts: at the tolerance 1e-4 the worst of a box of 1 m in
/// waves of H_s 0.1 m and T_p 0.8 s takes 285, of one 10 m long in the like 1,262; at 1e-6 the
/// worst seen, of a box of 300 m in 1024 waves of H_s 3 m, takes 8,224. Where more would be needed
/// a run says so.
inline constexpr int kMostPiecesOfAFace =
    static_cast<int>(2 * 1.2990381056766580 / (kSmallestPanel * kSmallestPanel));

/// The numbers that decide whether the surface bends over an edge by more than the tolerance.
struct BendLimits {
  /// For waves: the mean square over their phases of the surface's second difference over a step
  /// (dx, dy) is the quartic Σ_j quartic[j] dx^(4−j) dy^j.
  std::array<double, 5> quartic = {};
  /// For Airy waves: a step (dx, dy, dz) adds (dive[0] dx² + dive[1] dx dy + dive[2] dy² + dive[3]
  /// dz²) dz² for the head at the surface.
  std::array<double, 4> dive = {};
  /// Below the lowest trough the head of Airy waves bends less: `decay`. The logarithm of the mean
  /// square is a convex function of the depth. Down to `near` [m] it lies below its chord, of slope
  /// −near_rate [1/m]; beyond it falls by −2k at least, k the least wave number [rad/m].
  double near = 0, near_rate = 0, least_number = 0;
  double lowest = 0;            ///< The lowest trough above the still water [m].
  double tolerance = 0;         ///< kSagTolerance times the surface's standard deviation [m].
  double smallest_squared = 0;  ///< Edges of at most this squared length stay whole [m^2].
  /// For panels summed at points: the mean square of what the sum over one misses of the mean head
  /// is six_points d^6, or three_points d², times that of the second difference over its longest
  /// edge d, by (1) and (2). For the surface alone they are 0.
  bool curved = false;                      ///< Panels that bend are summed at points.
  double six_points = 0, three_points = 0;  ///< [1/m^6, 1/m^2]
  double sum_tolerance = 0;                 ///< Tolerance of the mean head over a piece [m].
  double cut_tolerance = 0;  ///< Tolerance of the waterline's departure from its chord [m].
  /// Heights above the centre of mass at which edges are split [m], kMostCuts at most.
  std::vector<double> cuts;
  double least_part = 0;  ///< Edges are split no nearer to an end than this height [m].

  /// Factor of the mean square of the second difference at a depth below the lowest trough [-].
  double decay(double depth) const {
    const double d = std::max(0.0, depth), upper = std::min(d, near);
    return std::exp(-near_rate * upper - 2 * least_number * (d - upper));
  }
};

/// Crests, troughs and derivatives of many waves are less than this many of their standard
/// deviations [-]: of 1e8 crests of a Gaussian sea one is higher.
inline constexpr double kFarCrest = 6;

/// The surface departs from the middle of a chord by less than this many of the root mean squares
/// of its departure [-].
inline constexpr double kFarDeparture = 4;

/// The quantities that must be linear over the pieces of a panel: the surface; the head of Airy
/// waves, too; or the current, too.
enum class SplitFor { surface, head, current };

/// The most heights at which panels are cut. They bound the number of pieces that wait at a time.
/// Where a current bends more often over a body, panels are cut where it bends most.
inline constexpr std::size_t kMostCuts = 15;

/// The heights above that of a body's centre of mass, `height` in W, at which a current by a table
/// is not straight [m]. They are those within `reach` [m], the highest first.
/// @param most   Where there are more, those with the largest bends are kept.
std::vector<double> bends_of_current(const Sea& sea, double height, double reach,
                                     std::size_t most = std::numeric_limits<std::size_t>::max());

/// Sets the heights at which a body with its centre of mass at `height` in W is cut for the
/// current.
/// @param smallest   As for SurfaceSampler.
void set_cuts(const Sea& sea, double height, double smallest, BendLimits& limits);

/// Where an edge from one height to another is split at one of the heights, as a part of its length
/// from the first; 0 if it crosses none. If it crosses several, the split is nearest to the middle.
double part_at_cut(const BendLimits& limits, double from, double to);

/// The water surface as seen from a body: elevations over points relative to its centre of mass.
class SurfaceSampler {
 public:
  /// @param smallest   Edges shorter than this are never halved [m], > 0: it bounds the work.
  /// @param error      With it pieces are such as sums at six points need under Airy waves.
  SurfaceSampler(const Sea& sea, const Eigen::Vector3d& p_WB, double time, double smallest,
                 SplitFor what = SplitFor::head, const std::optional<HeadError>& error = {});

  /// Height of the surface over `r` above the still water level [m].
  double elevation(const Eigen::Vector3d& r) const {
    return flat_ ? 0 : surface_elevation(sea_, p_WB_.x() + r.x(), p_WB_.y() + r.y(), time_);
  }

  /// True if the surface departs from linear between two points by more than the tolerance.
  bool bends_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  /// Where an edge from a to b is split, as a part of its length: in the middle if the surface
  /// bends over it, and else where the current does. It is 0 if the edge stays whole.
  double split_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    if (bends_between(a, b)) return 0.5;
    return limits_.cuts.empty() ? 0 : part_at_cut(limits_, a.z(), b.z());
  }

  /// False if no edge of the given length [m] bends.
  bool may_bend(double length) const;

  const BendLimits& limits() const { return limits_; }

  /// How an edge of a panel that is summed at six points is split: in the middle if the sum over a
  /// panel with such an edge misses too much, or if the panel is cut by the waterline and its chord
  /// does; else where the current bends. It is 0 if the edge stays whole.
  /// @param crosses   The waterline may cross the panel.
  double curved_split_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              bool crosses) const;

  /// The root mean square of the surface's departure from an edge at its middle [m], or of the
  /// head's where that is larger.
  double departure(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  /// Calls sum(rule) with the rule of points that a piece of a panel is summed by.
  template <class Sum>
  void with_rule(const Panel& piece, Sum&& sum) const {
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d &a = piece[i], &b = piece[(i + 1) % 3];
      largest = std::max(largest, waves_bend(a, b) * (b - a).squaredNorm());
    }
    const bool few =
        largest * limits_.three_points <= limits_.sum_tolerance * limits_.sum_tolerance;
    few ? sum(kThreePoints) : sum(kSixPoints);
  }

  bool flat() const { return flat_; }

  /// True if sums over a panel are taken at points: the surface bends over some edge.
  bool curves(const Panel& panel) const {
    return limits_.curved &&
           (split_between(panel[0], panel[1]) != 0 || split_between(panel[1], panel[2]) != 0 ||
            split_between(panel[2], panel[0]) != 0);
  }

  /// True if the area of a panel is below smallest²: it is not worth splitting.
  bool is_small(const Panel& panel) const {
    return area_vector(panel).squaredNorm() < limits_.smallest_squared * limits_.smallest_squared;
  }

 private:
  /// Mean square of the second difference of the head between two points [m^2].
  double waves_bend(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  bool grid_bends(const HeightField& field, const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b) const;

  const Sea& sea_;
  Eigen::Vector3d p_WB_;
  double time_;
  bool flat_;
  BendLimits limits_;
};

/// True if the loads of a sea miss more than they may where faces have kMostPiecesOfAFace pieces:
/// over an edge at kSmallestPanel, whatever its direction over the plan.
/// @param radius   Radius of the body [m].
bool needs_more_pieces(const Sea& sea, double radius, const HeadError& error);

/// Largest departure of the surface from linear along a panel's edge, over the surface's standard
/// deviation [-]. The relative error of the waves' part of a load is about two thirds of it.
inline constexpr double kSagTolerance = 5e-3;

/// Ratio of squared lengths above which an edge counts as longer than another [-]: of edges that
/// are equal but for rounding the first is halved, whatever axes the corners are given in.
inline constexpr double kLonger = 1 + 1e-12;

/// Where a panel is split: at a part of the length of an edge, from its first corner.
struct PanelSplit {
  int edge = -1;  ///< From corner `edge` to the next one; −1: the panel stays whole.
  double part = 0;
};

/// The split of the longest edge that is to be split.
/// @param split_between   split_between(a, b) is where an edge is split, or 0.
template <class Split>
PanelSplit longest_split(const Panel& panel, Split&& split_between) {
  PanelSplit longest;
  double length_squared = 0;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d& a = panel[i];
    const Eigen::Vector3d& b = panel[(i + 1) % 3];
    const double squared = (b - a).squaredNorm();
    if (squared <= kLonger * length_squared) continue;
    const double part = split_between(a, b);
    if (part == 0) continue;
    longest = {i, part};
    length_squared = squared;
  }
  return longest;
}

/// Calls visit(piece, elevation) for the two pieces of a panel that is split.
template <class Sampler, class Visit>
void for_both_pieces(const Panel& panel, const Eigen::Vector3d& elevation, const PanelSplit& split,
                     const Sampler& surface, Visit&& visit) {
  const int i = split.edge, j = (i + 1) % 3, k = (i + 2) % 3;
  const Eigen::Vector3d middle = (1 - split.part) * panel[i] + split.part * panel[j];
  const double height = surface.elevation(middle);
  visit(Panel{panel[i], middle, panel[k]}, Eigen::Vector3d(elevation[i], height, elevation[k]));
  visit(Panel{middle, panel[j], panel[k]}, Eigen::Vector3d(height, elevation[j], elevation[k]));
}

/// Splits a panel until the surface is linear over each piece, within the tolerance, and the
/// current is.
///
/// @param elevation   Elevation of the surface over the three vertices [m].
/// @param skips       skips(piece) is true if neither the piece nor any part of it is of interest.
/// @param visit       visit(piece, elevation) is called for each piece.
/// @param surface     A SurfaceSampler, or an object with its functions.
template <class Sampler, class Skips, class Visit>
void for_each_linear_piece(const Panel& panel, const Eigen::Vector3d& elevation,
                           const Sampler& surface, Skips&& skips, Visit&& visit) {
  if (skips(panel)) return;
  const PanelSplit split = longest_split(
      panel, [&](const auto& a, const auto& b) { return surface.split_between(a, b); });
  if (split.edge < 0 || surface.is_small(panel)) return visit(panel, elevation);
  for_both_pieces(panel, elevation, split, surface, [&](const Panel& piece, const auto& at) {
    for_each_linear_piece(piece, at, surface, skips, visit);
  });
}

/// Splits a panel that is summed at points, and visits the pieces that may be wet.
///
/// @param level       Level of the still water above the origin of the panel [m]. Elevations are
///                    above this level.
/// @param wet         The panel is wet all over.
/// @param visit       visit(piece, elevation) is called for each piece.
/// @param visit_dry   The same for pieces that are dry.
template <class Visit, class VisitDry>
void for_each_curved_piece(const Panel& panel, const Eigen::Vector3d& elevation, double level,
                           bool wet, const SurfaceSampler& surface, Visit&& visit,
                           VisitDry&& visit_dry) {
  double departure = 0;
  for (int i = 0; i < 3; ++i)
    departure = std::max(departure, surface.departure(panel[i], panel[(i + 1) % 3]));
  const double far = kFarDeparture * departure;
  double shallowest = HUGE_VAL, deepest = -HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const double depth = level + elevation[i] - panel[i].z();
    shallowest = std::min(shallowest, depth);
    deepest = std::max(deepest, depth);
  }
  if (!wet && deepest <= -far) return visit_dry(panel, elevation);
  const bool crosses = !wet && shallowest < far;
  const PanelSplit split = longest_split(panel, [&](const auto& a, const auto& b) {
    return surface.curved_split_between(a, b, crosses);
  });
  if (split.edge < 0 || surface.is_small(panel)) return visit(panel, elevation);
  for_both_pieces(panel, elevation, split, surface, [&](const Panel& piece, const auto& at) {
    for_each_curved_piece(piece, at, level, wet, surface, visit, visit_dry);
  });
}

/// The same without the pieces that are dry.
template <class Visit>
void for_each_curved_piece(const Panel& panel, const Eigen::Vector3d& elevation, double level,
                           bool wet, const SurfaceSampler& surface, Visit&& visit) {
  for_each_curved_piece(panel, elevation, level, wet, surface, visit,
                        [](const Panel&, const Eigen::Vector3d&) {});
}

/// Splits a panel that the surface bends over and visits all pieces.
template <class Visit>
void for_each_linear_piece(const Panel& panel, const Eigen::Vector3d& elevation,
                           const SurfaceSampler& surface, Visit&& visit) {
  for_each_linear_piece(
      panel, elevation, surface, [](const Panel&) { return false; }, visit);
}

}  // namespace hydro

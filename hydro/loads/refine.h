#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "hydro/loads/clip.h"
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
/// Drag takes the velocity of the current as linear, too. That of a table is not at its rows, so an
/// edge that crosses such a height is split there.

namespace hydro {

/// Length below which loads split no edge, over the body's radius [-]. A smaller value costs more
/// in a rough sea; a larger one loses waves of a few such lengths.
inline constexpr double kSmallestPanel = 1.0 / 256;

/// The numbers that decide whether the surface bends over an edge by more than the tolerance.
struct BendLimits {
  /// For waves: the mean square over their phases of the surface's second difference over a step
  /// (dx, dy) is the quartic Σ_j quartic[j] dx^(4−j) dy^j.
  std::array<double, 5> quartic = {};
  /// For Airy waves: a step (dx, dy, dz) adds (dive[0] dx² + dive[1] dx dy + dive[2] dy² + dive[3]
  /// dz²) dz² for the head at the surface.
  std::array<double, 4> dive = {};
  /// Below the lowest trough the head of Airy waves bends less: with the depth d there the mean
  /// square is that at the surface times e^{−2kd} at most, k the least wave number [rad/m].
  double least_number = 0;
  double lowest = 0;            ///< The lowest trough above the still water [m].
  double tolerance = 0;         ///< kSagTolerance times the surface's standard deviation [m].
  double smallest_squared = 0;  ///< Edges of at most this squared length stay whole [m^2].
  /// Heights above the centre of mass at which edges are split [m], kMostCuts at most.
  std::vector<double> cuts;
  double least_part = 0;  ///< Edges are split no nearer to an end than this height [m].
};

/// What must be linear over the pieces of a panel: the surface; the head of Airy waves, too; or the
/// current, too.
enum class SplitFor { surface, head, current };

/// The most heights at which panels are cut. They bound the number of pieces that wait at a time.
/// Where a current bends more often over a body, panels are cut where it bends most.
inline constexpr std::size_t kMostCuts = 15;

/// The heights above that of a body's centre of mass, `height` in W, at which a current by a table
/// is not straight [m]. They are those within `reach` [m], the highest first.
/// @param most   Where there are more, those with the largest bends are kept.
std::vector<double> bends_of_current(const Sea& sea, double height, double reach,
                                     std::size_t most = std::numeric_limits<std::size_t>::max());

/// Where an edge from one height to another is split at one of the heights, as a part of its length
/// from the first; 0 if it crosses none. Of several it is the one nearest to the middle.
double part_at_cut(const BendLimits& limits, double from, double to);

/// The water surface as seen from a body: elevations over points relative to its centre of mass.
class SurfaceSampler {
 public:
  /// @param smallest   Edges shorter than this are never halved [m], > 0: it bounds the work.
  SurfaceSampler(const Sea& sea, const Eigen::Vector3d& p_WB, double time, double smallest,
                 SplitFor what = SplitFor::head);

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

  bool flat() const { return flat_; }

  /// True if the area of a panel is below smallest²: it is not worth splitting.
  bool is_small(const Panel& panel) const {
    return area_vector(panel).squaredNorm() < limits_.smallest_squared * limits_.smallest_squared;
  }

 private:
  bool waves_bend(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  bool grid_bends(const HeightField& field, const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b) const;

  const Sea& sea_;
  Eigen::Vector3d p_WB_;
  double time_;
  bool flat_;
  BendLimits limits_;
};

/// Largest departure of the surface from linear along a panel's edge, over the surface's standard
/// deviation [-]. The relative error of the waves' part of a load is about two thirds of it.
inline constexpr double kSagTolerance = 5e-3;

/// Ratio of squared lengths above which an edge counts as longer than another [-]: of edges that
/// are equal but for rounding the first is halved, whatever axes the corners are given in.
inline constexpr double kLonger = 1 + 1e-12;

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
  int longest = -1;
  double length_squared = 0, part = 0;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d& a = panel[i];
    const Eigen::Vector3d& b = panel[(i + 1) % 3];
    const double squared = (b - a).squaredNorm();
    if (squared <= kLonger * length_squared) continue;
    const double split = surface.split_between(a, b);
    if (split == 0) continue;
    longest = i;
    part = split;
    length_squared = squared;
  }
  if (longest < 0 || surface.is_small(panel)) {
    visit(panel, elevation);
    return;
  }
  const int i = longest;
  const int j = (i + 1) % 3;
  const int k = (i + 2) % 3;
  const Eigen::Vector3d middle = (1 - part) * panel[i] + part * panel[j];
  const double height = surface.elevation(middle);
  for_each_linear_piece({panel[i], middle, panel[k]}, {elevation[i], height, elevation[k]}, surface,
                        skips, visit);
  for_each_linear_piece({middle, panel[j], panel[k]}, {height, elevation[j], elevation[k]}, surface,
                        skips, visit);
}

/// Splits a panel as above and visits all pieces.
template <class Visit>
void for_each_linear_piece(const Panel& panel, const Eigen::Vector3d& elevation,
                           const SurfaceSampler& surface, Visit&& visit) {
  for_each_linear_piece(
      panel, elevation, surface, [](const Panel&) { return false; }, visit);
}

}  // namespace hydro

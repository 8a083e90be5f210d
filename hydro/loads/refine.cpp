#include "hydro/loads/refine.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "hydro/airy_waves.h"

namespace hydro {
namespace {

/// A height at which a current bends.
struct Bend {
  double height;  ///< [m]
  double change;  ///< Change of the velocity's slope [1/s].
};

/// Bends below this part of the largest slope are round-off.
constexpr double kLeastBend = 1e-12;

/// Heights nearer to a vertex than this part of the smallest length of an edge are at the vertex.
constexpr double kLeastPart = 1e-8;

/// The factors of (1) and (2) [-].
constexpr double kSixPointError = 2.3e-7, kThreePointError = 5e-4, kThreePointMoment = 2e-3;

/// The waterline's departure from its chord over the head's error that is allowed [-]: the
/// departure changes the wet area, which drag feels, and the head only in second order. Measured
/// over random seas and poses of boxes and ellipsoids.
constexpr double kCutOverHead = 6;

double wave_number_squared(const WaveComponent& w) { return w.kx * w.kx + w.ky * w.ky; }

/// Adds the second differences of waves to the limits.
/// @param dives   The limits of the head are asked for, too.
/// @return the standard deviation of the surface [m]
double add_waves(const WaveSurface& waves, bool dives, BendLimits& limits) {
  std::array<double, 5>& quartic = limits.quartic;
  std::array<double, 4>& dive = limits.dive;
  double variance = 0;
  for (const WaveComponent& w : waves.components) {
    const double energy = w.amplitude * w.amplitude / 2;
    const double xx = w.kx * w.kx, yy = w.ky * w.ky;
    variance += energy;
    quartic[0] += energy * xx * xx;
    quartic[1] += energy * 4 * xx * w.kx * w.ky;
    quartic[2] += energy * 6 * xx * yy;
    quartic[3] += energy * 4 * w.kx * w.ky * yy;
    quartic[4] += energy * yy * yy;
    if (!dives || energy == 0) continue;
    const double number = std::sqrt(xx + yy);
    limits.least_number = dive[3] > 0 ? std::min(limits.least_number, number) : number;
    dive[0] += energy * 2 * (xx + yy) * xx;
    dive[1] += energy * 4 * (xx + yy) * w.kx * w.ky;
    dive[2] += energy * 2 * (xx + yy) * yy;
    dive[3] += energy * (xx + yy) * (xx + yy);
  }
  return std::sqrt(variance);
}

/// The logarithm of Σ E k⁴ e^{−2kd} is a convex function of the depth d: down to `near` it lies
/// below its chord.
void set_decay(const WaveSurface& waves, double near, BendLimits& limits) {
  double here = 0, there = 0;
  for (const WaveComponent& w : waves.components) {
    const double kk = wave_number_squared(w), bend = w.amplitude * w.amplitude * kk * kk;
    here += bend;
    there += bend * std::exp(-2 * std::sqrt(kk) * near);
  }
  limits.near = near;
  limits.near_rate = there > 0 ? std::log(here / there) / near : 2 * limits.least_number;
}

/// Sets the limits of pieces that are summed at points; with `dives`, those for the head. The error
/// of a piece is half of the allowed one, as errors add up over pieces that are longer than the
/// shortest waves.
void set_sum_limits(const WaveSurface& waves, const HeadError& error, double deviation, bool dives,
                    BendLimits& limits) {
  double fourth = 0, weighted_fourth = 0, sixth = 0, tenth = 0;  // Powers of k.
  for (const WaveComponent& w : waves.components) {
    const double kk = wave_number_squared(w), weight = cancelled(std::sqrt(kk), error);
    const double bend = w.amplitude * w.amplitude / 2 * kk * kk;
    fourth += bend;
    weighted_fourth += bend * weight * weight;
    sixth += bend * kk;
    tenth += bend * kk * kk * kk;
  }
  const double allowed = allowed_head_error(error, deviation), size = error.size();
  limits.curved = true;
  limits.cut_tolerance = kCutOverHead * allowed;
  if (!dives) {
    limits.tolerance = limits.cut_tolerance;
    return;
  }
  limits.tolerance = allowed * std::sqrt(fourth / weighted_fourth);
  limits.six_points = 2 * kSixPointError * kSixPointError * tenth / fourth;
  limits.three_points = 2 * (kThreePointError * kThreePointError * sixth / fourth +
                             kThreePointMoment * kThreePointMoment / (size * size));
  limits.sum_tolerance = allowed / 2;
}

}  // namespace

std::vector<double> bends_of_current(const Sea& sea, double height, double reach,
                                     std::size_t most) {
  const std::vector<CurrentRow>& rows = sea.profile;
  Eigen::Vector2d above = Eigen::Vector2d::Zero();
  double steepest = 0;
  std::vector<Bend> bends;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Eigen::Vector2d below = Eigen::Vector2d::Zero();
    if (i + 1 < rows.size())
      below = (rows[i + 1].velocity - rows[i].velocity) / (rows[i + 1].depth - rows[i].depth);
    const double z = sea.level - rows[i].depth - height;
    if (std::abs(z) < reach) bends.push_back({z, (below - above).norm()});
    steepest = std::max(steepest, below.norm());
    above = below;
  }
  std::erase_if(bends, [&](const Bend& bend) { return bend.change <= kLeastBend * steepest; });
  if (bends.size() > most) {
    std::stable_sort(bends.begin(), bends.end(),
                     [](const Bend& a, const Bend& b) { return a.change > b.change; });
    bends.resize(most);
  }
  std::vector<double> heights;
  for (const Bend& bend : bends) heights.push_back(bend.height);
  std::sort(heights.begin(), heights.end(), std::greater<>());
  return heights;
}

void set_cuts(const Sea& sea, double height, double smallest, BendLimits& limits) {
  if (sea.profile.empty()) return;
  limits.cuts = bends_of_current(sea, height, smallest / kSmallestPanel, kMostCuts);
  limits.least_part = kLeastPart * smallest;
}

double part_at_cut(const BendLimits& limits, double from, double to) {
  const double middle = 0.5 * (from + to);
  double nearest = std::numeric_limits<double>::infinity(), cut = from;
  for (const double z : limits.cuts) {
    const double before = z - from, after = to - z;
    const bool inside =
        before * after > 0 && std::min(std::abs(before), std::abs(after)) > limits.least_part;
    if (!inside || !(kLonger * std::abs(z - middle) < nearest)) continue;
    nearest = std::abs(z - middle);
    cut = z;
  }
  return cut == from ? 0 : (cut - from) / (to - from);
}

SurfaceSampler::SurfaceSampler(const Sea& sea, const Eigen::Vector3d& p_WB, double time,
                               double smallest, SplitFor what,
                               const std::optional<HeadError>& error)
    : sea_(sea),
      p_WB_(p_WB),
      time_(time),
      flat_(is_flat(sea)),
      limits_{.lowest = surface_bounds(sea).lowest - sea.level,
              .smallest_squared = smallest * smallest} {
  if (const auto* waves = std::get_if<WaveSurface>(&sea.surface)) {
    const bool dives = waves->kinematics == Kinematics::airy && what != SplitFor::surface;
    const double deviation = add_waves(*waves, dives, limits_);
    limits_.tolerance = kSagTolerance * deviation;
    limits_.lowest = std::max(limits_.lowest, -kFarCrest * deviation);
    if (dives) set_decay(*waves, error ? error->size() : smallest / kSmallestPanel, limits_);
    if (error && waves->kinematics == Kinematics::airy && deviation > 0)
      set_sum_limits(*waves, *error, deviation, dives, limits_);
  } else if (const auto* field = std::get_if<HeightField>(&sea.surface)) {
    limits_.tolerance = kSagTolerance * field->deviation;
  }
  if (what == SplitFor::current) set_cuts(sea, p_WB.z(), smallest, limits_);
}

/// At mid-step the chord of a wave a·cos is a (k·d)²/8 from its crest. The quartic is the mean
/// square of a (k·d)² over the phases, summed over all components; with a e^{kz} cos it is that of
/// a ((k·d)² + k² dz²).
double SurfaceSampler::waves_bend(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  const Eigen::Vector3d step = b - a;
  const std::array<double, 5>& quartic = limits_.quartic;
  const std::array<double, 4>& dive = limits_.dive;
  const double dx = step.x(), dy = step.y(), zz = step.z() * step.z();
  const double square =
      quartic[0] * dx * dx * dx * dx + quartic[1] * dx * dx * dx * dy +
      quartic[2] * dx * dx * dy * dy + quartic[3] * dx * dy * dy * dy +
      quartic[4] * dy * dy * dy * dy +
      (dive[0] * dx * dx + dive[1] * dx * dy + dive[2] * dy * dy + dive[3] * zz) * zz;
  if (limits_.least_number == 0) return square;
  const double top = p_WB_.z() + std::max(a.z(), b.z());
  return limits_.decay(sea_.level + limits_.lowest - top) * square;
}

double SurfaceSampler::departure(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  return std::sqrt(waves_bend(a, b)) / 8;
}

double SurfaceSampler::curved_split_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                            bool crosses) const {
  const double squared = (b - a).squaredNorm();
  if (squared > limits_.smallest_squared) {
    const double bend = waves_bend(a, b);
    const double sum = bend * squared * squared * squared * limits_.six_points;
    const double most = limits_.sum_tolerance, departs = 8 * limits_.cut_tolerance;
    if (sum > most * most || (crosses && bend > departs * departs)) return 0.5;
  }
  return limits_.cuts.empty() ? 0 : part_at_cut(limits_, a.z(), b.z());
}

bool SurfaceSampler::bends_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  if (flat_) return false;
  const bool dives = limits_.dive[3] > 0;
  const double squared = dives ? (b - a).squaredNorm() : (b - a).head<2>().squaredNorm();
  if (squared <= limits_.smallest_squared) return false;
  if (const auto* field = std::get_if<HeightField>(&sea_.surface)) return grid_bends(*field, a, b);
  return waves_bend(a, b) > 64 * limits_.tolerance * limits_.tolerance;
}

bool SurfaceSampler::may_bend(double length) const {
  if (flat_ || length * length <= limits_.smallest_squared) return false;
  if (const auto* field = std::get_if<HeightField>(&sea_.surface)) {
    const double cells = length / field->cell;
    // A shorter edge bends less, but up to one cell the bound is weaker.
    return cells * cells * field->bend > 8 * limits_.tolerance ||
           std::min(cells, 1.0) * field->bend > 4 * limits_.tolerance;
  }
  // (k·d)⁴ is at most |k|⁴|d|⁴, and the quartic's coefficients give Σ ½a²|k|⁴.
  const std::array<double, 5>& quartic = limits_.quartic;
  const double fourth = quartic[0] + quartic[2] / 3 + quartic[4];
  return fourth * std::pow(length, 4) > 64 * limits_.tolerance * limits_.tolerance;
}

/// Over n > 1 cells second differences up to `bend` sum to a sag of at most n² bend / 8; within two
/// cells there is at most one kink, with a sag of n bend / 4. Only where this bound is too large is
/// the surface itself evaluated, and only for steps that cannot hide a bend between ends and
/// middle.
bool SurfaceSampler::grid_bends(const HeightField& field, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b) const {
  const double cells = (b - a).head<2>().norm() / field.cell;
  if (cells > 1) return cells * cells * field.bend > 8 * limits_.tolerance;
  if (cells * field.bend <= 4 * limits_.tolerance) return false;
  const double sag = elevation(0.5 * (a + b)) - 0.5 * (elevation(a) + elevation(b));
  return std::abs(sag) > limits_.tolerance;
}

bool needs_more_pieces(const Sea& sea, double radius, const HeadError& error) {
  if (!has_airy_waves(sea)) return false;
  const std::optional<Sea> felt = without_weak_waves(sea, error);
  const double edge = kSmallestPanel * radius;
  // An edge of this length is not halved, so limits are asked for a little less.
  const Eigen::Vector3d place(0, 0, sea.level);
  const SurfaceSampler surface(felt ? *felt : sea, place, 0, (1 - 1e-9) * edge, SplitFor::head,
                               error);
  constexpr int kDirections = 8;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = M_PI * i / kDirections;
    const Eigen::Vector3d end = edge * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
    if (surface.curved_split_between(Eigen::Vector3d::Zero(), end, true) != 0) return true;
  }
  return false;
}

}  // namespace hydro

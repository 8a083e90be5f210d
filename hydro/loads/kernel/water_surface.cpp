#include "hydro/loads/kernel/water_surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <vector>

#include "hydro/airy_waves.h"

namespace hydro::kernel {
namespace {

/// The rows of waves in their own room.
struct Rows {
  double* first;
  std::size_t length;

  double* row(int which) const { return first + static_cast<std::size_t>(which) * length; }
};

/// Makes room for `count` waves.
Rows make_room(std::size_t count, WaveField& waves) {
  waves.count = static_cast<int>(count + 7) / 8 * 8;
  const Rows rows{waves.few.data(), static_cast<std::size_t>(std::max(waves.count, 8))};
  if (waves.count <= WaveField::kRoom) return rows;
  waves.many.resize(WaveField::kRows * rows.length);
  return {waves.many.data(), rows.length};
}

/// The sums of scale·k, scale·k², and so on, and of their squares.
struct Powers {
  double sums[4] = {}, squares[4] = {};

  void add(double scale, double k) {
    for (int n = 0; n < 4; ++n) {
      scale *= k;
      sums[n] += scale;
      squares[n] += scale * scale / 2;
    }
  }
  void set(double (&bounds)[4]) const {
    for (int n = 0; n < 4; ++n) bounds[n] = std::min(sums[n], kFarCrest * std::sqrt(squares[n]));
  }
};

/// The fewest waves for which a table takes less time than their sum.
constexpr std::size_t kFewestTabulated = 12;

/// Half the longest side of a branch's box over the hull's radius, at most: it may be turned, and
/// stick out of the sphere [-]. Water that is not within it is summed without a table.
constexpr double kReachOverRadius = 2;

/// Sets the limits of tables, by (1) of sea_table-inl.h, up to the number of nodes that does for
/// all branches of a hull.
/// @param error     With its weights of short waves.
/// @param allowed   Error of the head that tables may have [m].
/// @param reach     A bound of half the length of a branch's box [m].
void set_table_limits(const WaveSurface& surface, const HeadError& error, double allowed,
                      double reach, TableLimits& table) {
  const std::size_t count = surface.components.size();
  table.pays = count >= kFewestTabulated;
  if (!table.pays) return;
  table.allowed = allowed;
  for (auto& side : table.error) std::fill(std::begin(side), std::end(side), HUGE_VAL);
  std::vector<double> along[3], missed[3];
  for (int side = 0; side < 3; ++side) {
    along[side].resize(count);
    missed[side].resize(count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const WaveComponent& w = surface.components[i];
    const double number = wave_number(w);
    along[0][i] = std::abs(w.kx) / 2;
    along[1][i] = std::abs(w.ky) / 2;
    along[2][i] = number / 2;
    for (auto& side : missed) side[i] = 2 * cancelled(number, error) * w.amplitude;
  }
  for (int side = 0; side < 3; ++side) {
    double power = 1;
    for (int n = 1; n <= kMostTableNodes; ++n) {
      double sum = 0;
      for (std::size_t i = 0; i < count; ++i) {
        double& wave = missed[side][i];
        wave *= along[side][i] / n;
        sum += wave * wave / 2;
      }
      table.error[side][n] = std::sqrt(sum);
      power *= reach;
      if (n > 1 && table.error[side][n] * power <= allowed) break;
    }
  }
}

/// Sets what depends on neither place nor orientation.
/// @param factor   Factor of the amplitudes [-].
/// @return the rows, zero where they are not set
Rows set_numbers(const WaveSurface& surface, const Sea& sea, double factor, WaveField& waves) {
  const Rows rows = make_room(surface.components.size(), waves);
  std::fill(rows.first, rows.row(WaveField::kRows), 0.0);
  for (int i = 0; i < WaveField::kRows; ++i) waves.row[i] = rows.row(i);
  waves.airy = surface.kinematics == Kinematics::airy && waves.count > 0;
  waves.deep = !(sea.depth < AiryWaves::kDeepest);
  waves.water_depth = waves.deep ? 0 : sea.depth;
  Powers bends, flow;
  double variance = 0;
  for (std::size_t i = 0; i < surface.components.size(); ++i) {
    WaveComponent w = surface.components[i];
    w.amplitude *= factor;
    const auto set = [&](int row, double value) { rows.row(row)[i] = value; };
    const double number = wave_number(w);
    set(WaveField::kAmplitude, w.amplitude);
    set(WaveField::kEast, w.kx);
    set(WaveField::kEast + 1, w.ky);
    waves.height += std::abs(w.amplitude);
    variance += w.amplitude * w.amplitude / 2;
    bends.add(std::abs(w.amplitude), number);
    set(WaveField::kWeight, 0.5);
    if (!waves.airy || number == 0 || w.amplitude == 0) continue;
    const double velocity = sea.gravity / intrinsic_frequency(number, sea.depth, sea.gravity);
    flow.add(std::abs(w.amplitude) * velocity, number);
    set(WaveField::kSpeed, velocity);
    waves.least_number = waves.least_number > 0 ? std::min(waves.least_number, number) : number;
    set(WaveField::kNumber, number);
    set(WaveField::kUpward, velocity * number);
    set(WaveField::kWeight, waves.deep ? 1 : 1 / (1 + std::exp(-2 * number * sea.depth)));
  }
  bends.set(waves.bends);
  flow.set(waves.flow);
  waves.height = std::min(waves.height, kFarCrest * std::sqrt(variance));
  return rows;
}

/// The rows that set_numbers() leaves at zero.
constexpr int kPlacedRows[] = {WaveField::kVector,  WaveField::kVector + 1, WaveField::kVector + 2,
                               WaveField::kPhase,   WaveField::kFlow,       WaveField::kFlow + 1,
                               WaveField::kFlow + 2};

/// Takes the numbers of other waves: those rows are shared.
/// @return the rows of its own, zero beyond the last of the waves
Rows share_numbers(const WaveField& from, std::size_t components, WaveField& waves) {
  const Rows rows = make_room(components, waves);
  std::copy(std::begin(from.row), std::end(from.row), std::begin(waves.row));
  for (const int row : kPlacedRows) {
    waves.row[row] = rows.row(row);
    std::fill(rows.row(row) + components, rows.row(row + 1), 0.0);
  }
  waves.airy = from.airy;
  waves.deep = from.deep;
  waves.water_depth = from.water_depth;
  waves.height = from.height;
  waves.least_number = from.least_number;
  std::copy(std::begin(from.bends), std::end(from.bends), std::begin(waves.bends));
  std::copy(std::begin(from.flow), std::end(from.flow), std::begin(waves.flow));
  return rows;
}

/// An angle less whole turns [rad]. It is as exact as the angle itself, and four times cheaper than
/// the exact remainder.
double without_turns(double angle) { return angle - 2 * M_PI * std::nearbyint(angle / (2 * M_PI)); }

void set_waves(const FeltSea& felt, const WaveSurface& surface, const BodyState& state,
               const Eigen::Matrix3d& R_WB, double time, WaveField& waves) {
  const double factor = amplitude_factor(surface, time);
  const Rows rows = factor == 1 ? share_numbers(felt.waves(), surface.components.size(), waves)
                                : set_numbers(surface, felt.felt(), factor, waves);
  for (std::size_t i = 0; i < surface.components.size(); ++i) {
    const WaveComponent& w = surface.components[i];
    const Eigen::Vector3d k = R_WB.transpose() * Eigen::Vector3d(w.kx, w.ky, 0);
    const double speed = waves.row[WaveField::kSpeed][i];
    for (int axis = 0; axis < 3; ++axis) {
      rows.row(WaveField::kVector + axis)[i] = k[axis];
      rows.row(WaveField::kFlow + axis)[i] = speed > 0 ? speed * k[axis] : 0;
    }
    const double phase =
        w.kx * state.position.x() + w.ky * state.position.y() - w.omega * time + w.phase;
    rows.row(WaveField::kPhase)[i] = without_turns(phase);
  }
}

void set_grid(const HeightField& field, const BodyState& state, const Eigen::Matrix3d& R_WB,
              GridField& grid) {
  grid.heights = field.heights.data();
  grid.rows = field.heights.rows();
  grid.columns = field.heights.cols();
  for (int axis = 0; axis < 3; ++axis) {
    grid.e_x[axis] = R_WB(0, axis) / field.cell;
    grid.e_y[axis] = R_WB(1, axis) / field.cell;
  }
  grid.u0 = (state.position.x() - field.origin.x()) / field.cell;
  grid.v0 = (state.position.y() - field.origin.y()) / field.cell;
  grid.cell = field.cell;
  grid.bend = field.bend;
}

FeltSea::Splits make_splits(const Sea& sea, double smallest, double longest_edge, SplitFor what,
                            bool airy, const std::optional<HeadError>& error) {
  const SurfaceSampler sampler(sea, Eigen::Vector3d::Zero(), 0, smallest,
                               what == SplitFor::surface ? what : SplitFor::head, error);
  FeltSea::Splits splits{.limits = sampler.limits(), .bends = sampler.may_bend(longest_edge)};
  const BendLimits& limits = splits.limits;
  if (airy)
    set_table_limits(std::get<WaveSurface>(sea.surface), error.value_or(HeadError{}),
                     error && limits.sum_tolerance > 0 ? limits.sum_tolerance : limits.tolerance,
                     kReachOverRadius * smallest / kSmallestPanel, splits.table);
  return splits;
}

}  // namespace

FeltSea::FeltSea(const Sea& sea, double smallest, double longest_edge,
                 const std::optional<HeadError>& error, std::initializer_list<SplitFor> uses)
    : all_(sea), smallest_(smallest), bounds_(surface_bounds(sea)) {
  if (error) felt_ = without_weak_waves(sea, *error);
  felt_bounds_ = felt_ ? surface_bounds(*felt_) : bounds_;
  if (const auto* sum = std::get_if<WaveSurface>(&felt().surface))
    set_numbers(*sum, felt(), 1, waves_);
  for (const SplitFor what : uses)
    (what == SplitFor::surface ? for_surface_ : for_head_) =
        make_splits(felt(), smallest, longest_edge, what, waves_.airy, error);
}

const FeltSea::Splits& FeltSea::splits(SplitFor what) const {
  const std::optional<Splits>& splits = what == SplitFor::surface ? for_surface_ : for_head_;
  assert(splits);
  return *splits;
}

bool FeltSea::is_like(const Sea& sea) const {
  const auto* waves = std::get_if<WaveSurface>(&sea.surface);
  const auto* own = std::get_if<WaveSurface>(&all_.surface);
  return waves && own && *waves == *own && sea.gravity == all_.gravity && sea.level == all_.level &&
         sea.depth == all_.depth && sea.current == all_.current && sea.profile == all_.profile;
}

WaterSurface::WaterSurface(const FeltSea& felt, const BodyState& state, double time,
                           SplitFor what) {
  const Sea& sea = felt.felt();
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  if (const auto* sum = std::get_if<WaveSurface>(&sea.surface))
    set_waves(felt, *sum, state, R_WB, time, waves);
  gravity = sea.gravity;
  if (const auto* field = std::get_if<HeightField>(&sea.surface))
    set_grid(*field, state, R_WB, grid);
  if (what == SplitFor::current)
    shear = make_shear(sea, state.position, R_WB, felt.smallest() / kSmallestPanel);
  lowest = felt.felt_bounds().lowest - sea.level;
  highest = felt.felt_bounds().highest - sea.level;
  if (waves.count > 0) {
    lowest = std::max(lowest, -waves.height);
    highest = std::min(highest, waves.height);
  }
  const FeltSea::Splits& splits = felt.splits(what);
  bends = splits.bends;
  limits = splits.limits;
  table = splits.table;
  if (what == SplitFor::current) set_cuts(sea, state.position.z(), felt.smallest(), limits);
  for (int axis = 0; axis < 3; ++axis) {
    east[axis] = R_WB(0, axis);
    north[axis] = R_WB(1, axis);
  }
}

double allowed_wave_error(double part, double volume_over_area, const WaterSurface& surface) {
  if (surface.is_grid()) return part * volume_over_area;
  return part * std::min(volume_over_area, surface.waves.height);
}

ElevationRange grid_over(const WaterSurface& surface, const double* centre, const double* half) {
  const ElevationRange all = {surface.lowest, surface.highest};
  const GridField& grid = surface.grid;
  double u = grid.u0, v = grid.v0, du = 0, dv = 0;
  for (int axis = 0; axis < 3; ++axis) {
    u += grid.e_x[axis] * centre[axis];
    v += grid.e_y[axis] * centre[axis];
    du += std::abs(grid.e_x[axis]) * half[axis];
    dv += std::abs(grid.e_y[axis]) * half[axis];
  }
  constexpr double kMostLines = 4;  // To look at more takes longer than it saves.
  if (!(du < kMostLines / 2 && dv < kMostLines / 2)) return all;
  const auto line = [](double place, std::int64_t lines) {
    return static_cast<std::int64_t>(std::clamp(place, 0.0, static_cast<double>(lines - 1)));
  };
  const std::int64_t u_end = line(std::ceil(u + du), grid.columns);
  const std::int64_t v_end = line(std::ceil(v + dv), grid.rows);
  ElevationRange range = {all.high, all.low};
  for (std::int64_t i = line(std::floor(u - du), grid.columns); i <= u_end; ++i) {
    for (std::int64_t j = line(std::floor(v - dv), grid.rows); j <= v_end; ++j) {
      const double height = grid.heights[i * grid.rows + j];
      range = {std::min(range.low, height), std::max(range.high, height)};
    }
  }
  return range;
}

}  // namespace hydro::kernel

#include "hydro/sea.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hydro/wave_sums.h"

namespace hydro {
namespace {

/// The cell of a height field that holds a point, and the point's coordinates in it, 0 … 1; a point
/// beyond the grid is moved to the nearest edge.
struct CellPoint {
  Eigen::Index row, column;
  double u, v;  // along columns (x) and rows (y)
};

CellPoint locate(const HeightField& field, double x, double y) {
  const auto along = [](double s, Eigen::Index count, Eigen::Index& index) {
    const double last = static_cast<double>(count - 1);
    s = std::clamp(s, 0.0, last);
    index = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(s), 0,
                                     std::max<Eigen::Index>(count - 2, 0));
    return s - static_cast<double>(index);
  };
  CellPoint p;
  p.u = along((x - field.origin.x()) / field.cell, field.heights.cols(), p.column);
  p.v = along((y - field.origin.y()) / field.cell, field.heights.rows(), p.row);
  return p;
}

/// Heights at the corners of a cell; in a grid of one row or column they repeat.
struct CellCorners {
  double h00, h10, h01, h11;  // (row, column): h10 is one column on, h01 one row on
};

CellCorners corners(const HeightField& field, const CellPoint& p) {
  const Eigen::Index row1 = std::min(p.row + 1, field.heights.rows() - 1);
  const Eigen::Index column1 = std::min(p.column + 1, field.heights.cols() - 1);
  return {field.heights(p.row, p.column), field.heights(p.row, column1),
          field.heights(row1, p.column), field.heights(row1, column1)};
}

double elevation(const FlatSurface&, double, double, double) { return 0; }

double elevation(const HeightField& field, double x, double y, double) {
  const CellPoint p = locate(field, x, y);
  const CellCorners c = corners(field, p);
  return (1 - p.v) * ((1 - p.u) * c.h00 + p.u * c.h10) + p.v * ((1 - p.u) * c.h01 + p.u * c.h11);
}

double elevation(const WaveSurface& waves, double x, double y, double time) {
  const double factor = amplitude_factor(waves, time);
  if (waves.components.size() >= kFewestWavesInLanes)
    return factor * elevation_in_lanes(waves, x, y, time);
  double height = 0;
  for (const WaveComponent& w : waves.components)
    height += w.amplitude * std::cos(w.kx * x + w.ky * y - w.omega * time + w.phase);
  return factor * height;
}

Eigen::Vector2d slope(const FlatSurface&, double, double, double) {
  return Eigen::Vector2d::Zero();
}

Eigen::Vector2d slope(const HeightField& field, double x, double y, double) {
  const CellPoint p = locate(field, x, y);
  const CellCorners c = corners(field, p);
  const double x_end =
      field.origin.x() + field.cell * static_cast<double>(field.heights.cols() - 1);
  const double y_end =
      field.origin.y() + field.cell * static_cast<double>(field.heights.rows() - 1);
  const bool in_x = x >= field.origin.x() && x <= x_end;
  const bool in_y = y >= field.origin.y() && y <= y_end;
  return {in_x ? ((1 - p.v) * (c.h10 - c.h00) + p.v * (c.h11 - c.h01)) / field.cell : 0.0,
          in_y ? ((1 - p.u) * (c.h01 - c.h00) + p.u * (c.h11 - c.h10)) / field.cell : 0.0};
}

Eigen::Vector2d slope(const WaveSurface& waves, double x, double y, double time) {
  Eigen::Vector2d s = Eigen::Vector2d::Zero();
  for (const WaveComponent& w : waves.components) {
    const double sine = std::sin(w.kx * x + w.ky * y - w.omega * time + w.phase);
    s -= w.amplitude * sine * Eigen::Vector2d(w.kx, w.ky);
  }
  return amplitude_factor(waves, time) * s;
}

/// Largest second difference along the rows, along the columns and across the cells [m].
double largest_bend(const Eigen::MatrixXd& h) {
  const Eigen::Index rows = h.rows();
  const Eigen::Index columns = h.cols();
  double bend = 0;
  const auto include = [&](const auto& difference) {
    if (difference.size() > 0) bend = std::max(bend, difference.cwiseAbs().maxCoeff());
  };
  if (rows > 2)
    include((h.topRows(rows - 2) + h.bottomRows(rows - 2) - 2 * h.middleRows(1, rows - 2)).eval());
  if (columns > 2)
    include((h.leftCols(columns - 2) + h.rightCols(columns - 2) - 2 * h.middleCols(1, columns - 2))
                .eval());
  if (rows > 1 && columns > 1)
    include((h.topLeftCorner(rows - 1, columns - 1) + h.bottomRightCorner(rows - 1, columns - 1) -
             h.topRightCorner(rows - 1, columns - 1) - h.bottomLeftCorner(rows - 1, columns - 1))
                .eval());
  return bend;
}

SurfaceBounds elevation_bounds(const FlatSurface&) { return {}; }

SurfaceBounds elevation_bounds(const HeightField& field) { return field.bounds; }

SurfaceBounds elevation_bounds(const WaveSurface& waves) {
  double sum = 0;
  for (const WaveComponent& w : waves.components) sum += std::abs(w.amplitude);
  return {-sum, sum};
}

}  // namespace

HeightField make_height_field(Eigen::MatrixXd heights, double cell, const Eigen::Vector2d& origin) {
  if (heights.size() == 0) throw std::invalid_argument("a height field needs at least one height");
  if (!heights.allFinite())
    throw std::invalid_argument("a height of the height field is not finite");
  if (!(cell > 0)) throw std::invalid_argument("the cell of a height field must be positive");
  HeightField field{.heights = std::move(heights), .cell = cell, .origin = origin};
  field.deviation = std::sqrt((field.heights.array() - field.heights.mean()).square().mean());
  field.bend = largest_bend(field.heights);
  field.bounds = {field.heights.minCoeff(), field.heights.maxCoeff()};
  return field;
}

Eigen::Vector2d velocity_at(const std::vector<CurrentRow>& profile, double depth) {
  const auto below = std::find_if(profile.begin(), profile.end(),
                                  [&](const CurrentRow& row) { return row.depth > depth; });
  if (below == profile.begin()) return below->velocity;
  const CurrentRow& above = *(below - 1);
  if (below == profile.end()) return above.velocity;
  const double part = (depth - above.depth) / (below->depth - above.depth);
  return above.velocity + part * (below->velocity - above.velocity);
}

Eigen::Vector3d current_at(const Sea& sea, double z) {
  if (sea.profile.empty()) return sea.current;
  const Eigen::Vector2d velocity = velocity_at(sea.profile, sea.level - z);
  return {velocity.x(), velocity.y(), 0};
}

double surface_elevation(const Sea& sea, double x, double y, double time) {
  return std::visit([&](const auto& surface) { return elevation(surface, x, y, time); },
                    sea.surface);
}

double amplitude_factor(const WaveSurface& waves, double time) {
  if (waves.ramp <= 0 || time >= waves.ramp) return 1;
  return time <= 0 ? 0 : (1 - std::cos(M_PI * time / waves.ramp)) / 2;
}

double surface_height(const Sea& sea, double x, double y, double time) {
  return sea.level + surface_elevation(sea, x, y, time);
}

Eigen::Vector2d surface_slope(const Sea& sea, double x, double y, double time) {
  return std::visit([&](const auto& surface) { return slope(surface, x, y, time); }, sea.surface);
}

SurfaceBounds surface_bounds(const Sea& sea) {
  const SurfaceBounds bounds =
      std::visit([](const auto& surface) { return elevation_bounds(surface); }, sea.surface);
  return {sea.level + bounds.lowest, sea.level + bounds.highest};
}

bool is_flat(const Sea& sea) { return std::holds_alternative<FlatSurface>(sea.surface); }

bool changes_with_time(const Sea& sea) { return std::holds_alternative<WaveSurface>(sea.surface); }

double time_of_mean_speed(const Sea& sea, double length) {
  constexpr double kPeriods = 2;  // More: a speed is found later; fewer: swell counts as one.
  constexpr double kLeastOfHighest = 0.1;
  double longest = std::sqrt(2 * M_PI * length / sea.gravity), highest = 0;
  if (const auto* waves = std::get_if<WaveSurface>(&sea.surface)) {
    for (const WaveComponent& wave : waves->components)
      highest = std::max(highest, std::abs(wave.amplitude));
    for (const WaveComponent& wave : waves->components)
      if (std::abs(wave.amplitude) >= kLeastOfHighest * highest)
        longest = std::max(longest, 2 * M_PI / std::abs(wave.omega));
  }
  return kPeriods * longest;
}

}  // namespace hydro

#include "app/render/water_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace render {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Angle below the horizon at which the grid ends, half a pixel of most pictures [rad].
constexpr double kHorizon = 4e-4;

/// Part of the surface that the camera may see.
struct Sector {
  double height = 0;    ///< Distance of the eye from the surface [m].
  double steepest = 0;  ///< Largest angle below the horizon (above it, from under water) [rad].
  double flattest = 0;  ///< Smallest such angle [rad].
  double middle = 0;    ///< Azimuth of the camera's gaze [rad].
  double spread = 0;    ///< Largest difference of azimuth from `middle` [rad].
};

/// Finds the sector of the rays through a lattice of points of the picture.
Sector seen_sector(const View& view, double side) {
  Sector s;
  s.flattest = M_PI / 2;
  const Vector3d level_gaze = Vector3d::UnitZ().cross(view.level_W);
  s.middle = std::atan2(level_gaze.y(), level_gaze.x());
  constexpr int kSteps = 8;
  for (int i = -kSteps; i <= kSteps; ++i)
    for (int j = -kSteps; j <= kSteps; ++j) {
      const Vector3d ray =
          view.ray(static_cast<double>(i) / kSteps, static_cast<double>(j) / kSteps).normalized();
      const double angle = std::asin(-side * ray.z());
      s.steepest = std::max(s.steepest, angle);
      s.flattest = std::min(s.flattest, angle);
      if (angle < -0.1) continue;
      const double turn = std::remainder(std::atan2(ray.y(), ray.x()) - s.middle, 2 * M_PI);
      s.spread = std::max(s.spread, std::abs(turn));
    }
  return s;
}

/// Widens a sector for waves: the nearest visible point is on the side of the slab next to the eye.
Sector widened(Sector s, const View& view, const Slab& slab, double side) {
  const double height = std::abs(view.eye_W.z() - slab.level);
  const double toward = side > 0 ? slab.highest - slab.level : slab.level - slab.lowest;
  const double away = side > 0 ? slab.level - slab.lowest : slab.highest - slab.level;
  s.height = std::max(height, 0.05 * view.distance);
  const double clearance = std::max(height - toward, 0.0);
  const double nearest = clearance / std::tan(std::max(s.steepest, 0.02));
  const bool sees_foot = s.steepest > 1.2 || clearance == 0;
  s.steepest = sees_foot ? M_PI / 2 : std::atan2(s.height, 0.9 * nearest);
  const double farthest = (height + away) / std::tan(std::max(s.flattest, kHorizon));
  s.flattest = std::max(kHorizon, std::atan2(s.height, 1.2 * farthest));
  s.spread = sees_foot ? M_PI : std::min(M_PI, 1.1 * s.spread + 0.02);
  return s;
}

/// Returns the radii of the rows from the nearest to the farthest visible one [m].
std::vector<double> ring_radii(const Sector& s, const GridSteps& steps) {
  std::vector<double> radii = {s.height / std::tan(s.steepest)};
  const double last = s.height / std::tan(s.flattest);
  while (radii.back() < last) {
    const double angle = std::atan2(s.height, radii.back()) - steps.angle;
    const double by_angle = angle > s.flattest ? s.height / std::tan(angle) : last;
    radii.push_back(std::min(last, std::max(by_angle, radii.back() + steps.length)));
  }
  return radii;
}

std::vector<double> few_radii(const Sector& s, GridSteps steps) {
  constexpr std::size_t kMostRows = 320;
  std::vector<double> radii = ring_radii(s, steps);
  while (radii.size() > kMostRows) {
    steps.angle *= 1.2;
    steps.length *= 1.2;
    radii = ring_radii(s, steps);
  }
  return radii;
}

/// Returns the part of a wave that a grid shows: 0 up to 3 cells a wavelength, 1 from 6 on, smooth
/// between.
double shown_part(double wavelength, double cell) {
  const double t = std::clamp((wavelength / cell - 3) / 3, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

hydro::Sea without_short_waves(const hydro::Sea& sea, double cell) {
  hydro::Sea result = sea;
  auto& waves = std::get<hydro::WaveSurface>(result.surface).components;
  for (hydro::WaveComponent& w : waves)
    w.amplitude *= shown_part(2 * M_PI / std::hypot(w.kx, w.ky), cell);
  std::erase_if(waves, [](const hydro::WaveComponent& w) { return w.amplitude == 0; });
  return result;
}

/// Returns the gradient of the height from the neighbours in the grid.
Vector2d slope_in_grid(const PolarGrid& grid, const Eigen::VectorXd& heights, int row, int column) {
  const auto difference = [&](int from_row, int from_column, int to_row, int to_column) {
    const Index from = Index{from_row} * grid.columns + from_column;
    const Index to = Index{to_row} * grid.columns + to_column;
    const Vector2d step = grid.points_W.col(to) - grid.points_W.col(from);
    return Vector3d(step.x(), step.y(), heights[to] - heights[from]);
  };
  const Vector3d along =
      difference(row, std::max(column - 1, 0), row, std::min(column + 1, grid.columns - 1));
  const Vector3d outward =
      difference(std::max(row - 1, 0), column, std::min(row + 1, grid.rows - 1), column);
  const double det = along.x() * outward.y() - along.y() * outward.x();
  if (std::abs(det) < 1e-12 * along.head<2>().norm() * outward.head<2>().norm() || det == 0)
    return Vector2d::Zero();
  return {(along.z() * outward.y() - outward.z() * along.y()) / det,
          (outward.z() * along.x() - along.z() * outward.x()) / det};
}

}  // namespace

Eigen::Matrix3Xi PolarGrid::triangles() const {
  Eigen::Matrix3Xi result(3, Index{2} * (rows - 1) * (columns - 1));
  Index next = 0;
  for (int r = 0; r + 1 < rows; ++r)
    for (int c = 0; c + 1 < columns; ++c) {
      const int i = r * columns + c;
      result.col(next++) = Eigen::Vector3i(i, i + columns, i + 1);
      result.col(next++) = Eigen::Vector3i(i + 1, i + columns, i + columns + 1);
    }
  return result;
}

PolarGrid make_polar_grid(const View& view, const Slab& slab, GridSteps steps) {
  const double side = view.eye_W.z() >= slab.level ? 1 : -1;
  const Sector s = widened(seen_sector(view, side), view, slab, side);
  const std::vector<double> radii = few_radii(s, steps);
  PolarGrid grid{.rows = static_cast<int>(radii.size()), .columns = steps.columns};
  grid.points_W.resize(2, Index{grid.rows} * grid.columns);
  for (int r = 0; r < grid.rows; ++r) {
    const double radius = radii[static_cast<std::size_t>(r)];
    const double inner = radii[static_cast<std::size_t>(std::max(r - 1, 0))];
    grid.cell.push_back(std::max(radius - inner, 2 * s.spread * radius / (grid.columns - 1)));
    for (int c = 0; c < grid.columns; ++c) {
      const double azimuth = s.middle + s.spread * (1 - 2.0 * c / (grid.columns - 1));
      grid.points_W.col(Index{r} * grid.columns + c) =
          view.eye_W.head<2>() + radius * Vector2d(std::cos(azimuth), std::sin(azimuth));
    }
  }
  return grid;
}

WaterSurface::WaterSurface(const hydro::Sea& sea, const View& view, double straight, double ripple)
    : eye_W_(view.eye_W) {
  const hydro::SurfaceBounds bounds = hydro::surface_bounds(sea);
  const Slab slab{.level = sea.level, .lowest = bounds.lowest, .highest = bounds.highest};
  const double row_angle = 2.5 * view.half_height / 360;  // 2.5 pixels of 720
  if (ripple > 0)
    grid_ = make_polar_grid(view, slab, {std::min(straight, ripple), row_angle, 256});
  else if (std::isfinite(straight))
    grid_ = make_polar_grid(view, slab, {straight, row_angle, 128});
  else
    grid_ = make_polar_grid(view, slab, kFlatSteps);
  if (!std::holds_alternative<hydro::WaveSurface>(sea.surface)) {
    seas_ = {sea};
    return;
  }
  for (const double cell : grid_.cell) seas_.push_back(without_short_waves(sea, cell));
}

const hydro::Sea& WaterSurface::sea_of_row(int row) const {
  return seas_[std::min(static_cast<std::size_t>(row), seas_.size() - 1)];
}

Eigen::MatrixXf WaterSurface::vertices(double time, const hydro::SurfacePatch* ripples) const {
  const Index count = grid_.points_W.cols();
  Eigen::VectorXd heights(count);
  for (Index i = 0; i < count; ++i)
    heights[i] = hydro::surface_elevation(sea_of_row(static_cast<int>(i / grid_.columns)),
                                          grid_.points_W(0, i), grid_.points_W(1, i), time);
  for (Index i = 0; ripples != nullptr && i < count; ++i)
    heights[i] += ripples->at(grid_.points_W(0, i), grid_.points_W(1, i));
  Eigen::MatrixXf vertices(5, count);
  const double level_E = seas_[0].level - eye_W_.z();
  for (Index i = 0; i < count; ++i) {
    const auto row = static_cast<int>(i / grid_.columns);
    const auto column = static_cast<int>(i % grid_.columns);
    const Vector2d p_E = grid_.points_W.col(i) - eye_W_.head<2>();
    const Vector2d slope = slope_in_grid(grid_, heights, row, column);
    vertices.col(i) << p_E.cast<float>(), static_cast<float>(heights[i] + level_E),
        slope.cast<float>();
  }
  return vertices;
}

}  // namespace render

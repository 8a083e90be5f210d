#pragma once

#include <Eigen/Core>
#include <vector>

#include "app/render/view.h"
#include "hydro/sea.h"
#include "hydro/water/simulated_water.h"

/// @file
/// Grid over the visible part of a level surface, with a resolution that suits the camera.

namespace render {

/// A grid in polar coordinates about the point below (or above) the eye: rows are circles out to
/// the horizon, columns are spokes. Near the eye rows are as far apart as the surface's shape
/// allows, farther out as the picture's resolution allows.
struct PolarGrid {
  int rows = 0;
  int columns = 0;
  Eigen::Matrix2Xd points_W;           ///< 2×(rows·columns), row after row from near to far [m].
  std::vector<double> cell;            ///< Larger side of the cells around each row [m].
  Eigen::Matrix3Xi triangles() const;  ///< Vertex indices, from near to far.
};

/// Bounds of the surface's height [m].
struct Slab {
  double level = 0;  ///< Height of the grid.
  double lowest = 0;
  double highest = 0;
};

/// Resolution of a grid.
struct GridSteps {
  double length = 0;  ///< Smallest distance between rows [m].
  double angle = 0;   ///< Smallest angle between rows seen from the eye [rad].
  int columns = 0;
};

/// Resolution for a level plane.
inline constexpr GridSteps kFlatSteps = {.length = 0, .angle = 0.02, .columns = 60};

/// Makes a grid that fills the picture for every surface height within the slab. Steps are enlarged
/// if there would be more than 320 rows.
PolarGrid make_polar_grid(const View& view, const Slab& slab, GridSteps steps);

/// Water surface over a grid; only its heights change with time.
class WaterSurface {
 public:
  /// @param straight   Length over which the surface may be taken as linear, infinite if flat [m].
  /// @param ripple     Cell of the waves of bodies [m]; 0: there are none.
  WaterSurface(const hydro::Sea& sea, const View& view, double straight, double ripple = 0);

  const PolarGrid& grid() const { return grid_; }

  /// Returns 5×(rows·columns) values: position in E [m] and slopes ∂ξ/∂x, ∂ξ/∂y of the surface.
  /// @param ripples   Waves upon those of the sea; null: none.
  Eigen::MatrixXf vertices(double time, const hydro::SurfacePatch* ripples = nullptr) const;

 private:
  const hydro::Sea& sea_of_row(int row) const;

  PolarGrid grid_;
  Eigen::Vector3d eye_W_;
  /// The sea; with waves, one sea per row without the waves that are too short for the row's cells.
  std::vector<hydro::Sea> seas_;
};

}  // namespace render

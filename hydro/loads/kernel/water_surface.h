#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hydro/loads/kernel/panels.h"
#include "hydro/loads/refine.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"

/// @file
/// A sea that is not flat as the kernel reads it: its elevation as a function of the place on the
/// body, in body axes about the centre of mass, at one time.

namespace hydro::kernel {

/// Linear waves: Σ amplitude·cos(k·r + phase), up to a multiple of eight with amplitude 0.
struct WaveField {
  static constexpr int kRoom = 128;

  /// Rows: amplitude [m], k_x, k_y, k_z [rad/m] and phase [rad].
  std::array<double, 5 * kRoom> few;
  std::vector<double> many;  ///< In use where `few` has no room.
  const double* row[5] = {};
  int count = 0;
  double curvature = 0;  ///< Σ |amplitude| k²: bound of the second derivatives [1/m].
  double third = 0;      ///< Σ |amplitude| |k|³, of the third ones [1/m^2].
};

/// A grid: bilinear between heights at the columns u = e_x·r + u_0 and rows v = e_y·r + v_0.
struct GridField {
  const double* heights = nullptr;  ///< By columns [m].
  std::int64_t rows = 0, columns = 0;
  double e_x[3] = {}, e_y[3] = {};  ///< [1/m]
  double u0 = 0, v0 = 0;            ///< Of the centre of mass.
  double cell = 1;                  ///< Distance of neighbouring lines [m].
  double bend = 0;                  ///< Largest second difference of neighbouring heights [m].
};

/// The surface around a body. It refers to the sea and to itself: neither copied nor moved.
class WaterSurface {
 public:
  /// @param smallest   As for SurfaceSampler.
  WaterSurface(const Sea& sea, const BodyState& state, double time, double smallest,
               double longest_edge);
  WaterSurface(const WaterSurface&) = delete;
  WaterSurface& operator=(const WaterSurface&) = delete;

  WaveField waves;  ///< Of no component where the sea is a grid.
  GridField grid;
  double lowest = 0, highest = 0;      ///< Bounds of the elevation [m].
  bool bends = false;                  ///< Some edge of the hull may have to be split.
  BendLimits limits;                   ///< These tell which edge has to be.
  double east[3] = {}, north[3] = {};  ///< The directions of x and y of the world, in body axes.

  bool is_grid() const { return grid.heights != nullptr; }
};

/// Bounds of the elevation over a box of a body [m].
struct ElevationRange {
  double low, high;
};
/// Of a grid; those of all the sea where the box is large.
ElevationRange grid_over(const WaterSurface& surface, const double* centre, const double* half);

}  // namespace hydro::kernel

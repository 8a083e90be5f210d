#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "hydro/air.h"

/// @file
/// The sea: the height of its surface, the velocity of its water, and the air above it.
///
/// The surface is a height field z = ξ(x, y, t) in W; it is given, not simulated. Below waves the
/// water moves and its pressure decays as linear theory has it (airy_waves.h). Elsewhere it moves
/// with the current alone, and pressure is hydrostatic below the local surface. The current is
/// uniform, or it changes with the depth as a table tells (`Sea::profile`).
/// Units SI; heights are in W (not relative to `level`) unless a name says otherwise.

namespace hydro {

/// Still water: ξ = level.
struct FlatSurface {};

/// Bounds that the surface never leaves [m].
struct SurfaceBounds {
  double lowest = 0;   ///< Lower bound [m].
  double highest = 0;  ///< Upper bound [m].
};

/// A grid of heights above the still water level, bilinear between its points and constant in time.
/// Outside the grid the height of the nearest point of its edge holds. `make_height_field` builds
/// it.
struct HeightField {
  Eigen::MatrixXd heights;  ///< rows × columns [m]; row index = y, column index = x.
  double cell = 1;          ///< Distance between neighbouring grid points [m], > 0.
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< Place of heights(0, 0), in W [m].
  double deviation = 0;                              ///< Standard deviation of the heights [m].
  double bend = 0;       ///< Largest second difference of neighbouring heights [m].
  SurfaceBounds bounds;  ///< Bounds of the heights.
};

/// Makes a height field with its bounds. Arguments as its fields.
/// @throws std::invalid_argument if the grid is empty, a height is not finite or cell is not > 0.
HeightField make_height_field(Eigen::MatrixXd heights, double cell, const Eigen::Vector2d& origin);

/// One long-crested wave: height above level = amplitude·cos(kx·x + ky·y − omega·t + phase).
/// `linear_wave` (airy_waves.h) makes one that obeys the dispersion relation.
struct WaveComponent {
  double amplitude = 0;  ///< [m]
  double kx = 0;         ///< Wave number along x [rad/m].
  double ky = 0;         ///< Wave number along y [rad/m].
  double omega = 0;      ///< Angular frequency for an observer at rest [rad/s].
  double phase = 0;      ///< [rad]

  friend bool operator==(const WaveComponent&, const WaveComponent&) = default;
};

/// |k| of a wave [rad/m].
inline double wave_number(const WaveComponent& w) { return std::sqrt(w.kx * w.kx + w.ky * w.ky); }

/// The model of the water below waves.
enum class Kinematics {
  airy,        ///< Linear waves: pressure and motion decay with depth.
  hydrostatic  ///< The thesis's: pressure by the height of the water above, and no motion.
};

/// A sum of linear waves.
///
/// With a ramp the amplitudes grow from 0 at time 0 to their values. Elevation, pressure, velocity
/// and acceleration of the waves at a time are those of waves of the amplitudes at that time: the
/// pressure's gradient gives the acceleration, and the velocity is not its integral by the ratio of
/// a wave's period to the ramp.
struct WaveSurface {
  std::vector<WaveComponent> components;     ///< The waves.
  Kinematics kinematics = Kinematics::airy;  ///< Model of the water below them.
  double ramp = 0;                           ///< Time over which the amplitudes grow [s], >= 0.

  friend bool operator==(const WaveSurface&, const WaveSurface&) = default;
};

/// Factor of the amplitudes at a time [-]: ½ (1 − cos πt/ramp) during the ramp, 0 before and 1
/// after it; 1 without a ramp.
double amplitude_factor(const WaveSurface& waves, double time);

/// A row of the table of a current that changes with depth.
struct CurrentRow {
  double depth = 0;                                    ///< Below the still water level [m], >= 0.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< Velocity of the water there, in W [m/s].

  friend bool operator==(const CurrentRow&, const CurrentRow&) = default;
};

/// The sea: constant over a simulation. The functions below take any time.
struct Sea {
  double density = 1000;                                   ///< [kg/m^3]
  double gravity = 9.80665;                                ///< [m/s^2]
  double level = 0;                                        ///< z of the still water [m].
  double depth = std::numeric_limits<double>::infinity();  ///< Depth of the still water [m], > 0.
  /// Velocity of the water [m/s]. Where there is a profile it is that of its first row, as waves
  /// travel on the current of the surface.
  Eigen::Vector3d current = Eigen::Vector3d::Zero();
  /// The current by depth; without rows it is `current` everywhere. The depths rise from row to
  /// row. The velocity is linear between two rows, and above the first and below the last it is
  /// that of the row; it does not follow the waves up and down. The surface is flat or has Airy
  /// waves.
  std::vector<CurrentRow> profile;
  /// Flat, a grid of heights, or waves.
  std::variant<FlatSurface, HeightField, WaveSurface> surface;
  std::optional<Air> air;  ///< None: nothing acts on what is above the water.
};

/// Velocity of a current by its table, which has at least one row, at a depth below the still water
/// level [m/s].
Eigen::Vector2d velocity_at(const std::vector<CurrentRow>& profile, double depth);

/// Velocity of the water without its waves at a height z [m/s].
Eigen::Vector3d current_at(const Sea& sea, double z);

/// Height ξ of the water surface over (x, y) at a time [m].
double surface_height(const Sea& sea, double x, double y, double time);

/// Height of the water surface above the still water level [m]: no digits are lost where level is
/// large.
double surface_elevation(const Sea& sea, double x, double y, double time);

/// (∂ξ/∂x, ∂ξ/∂y) over (x, y) at a time [-]; on a cell edge of a height field, the slope of one
/// side.
Eigen::Vector2d surface_slope(const Sea& sea, double x, double y, double time);

/// Bounds of the surface height in W [m].
SurfaceBounds surface_bounds(const Sea& sea);

/// True if the surface is z = level everywhere and always.
bool is_flat(const Sea& sea);

/// True for waves; the other surfaces are constant in time.
bool changes_with_time(const Sea& sea);

/// Time over which the mean velocity of a body is its speed ahead [s]: two periods of the longest
/// waves of the sea, or of waves as long as the body, whichever are longer. Waves of less than a
/// tenth of the highest amplitude do not count.
/// @param length   Length of the body [m], > 0.
double time_of_mean_speed(const Sea& sea, double length);

}  // namespace hydro

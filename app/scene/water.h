#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "hydro/sea.h"

/// @file
/// The block `water` of a scene.

namespace scene {

/// Still water.
struct Flat {};
/// A fixed surface or ground by heights on a grid.
struct HeightField {
  std::filesystem::path file;  ///< CSV or 16-bit grey PNG; resolved against the scene's folder.
  double cell = 1;             ///< [m], > 0.
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< Place of the first height [m].
  std::optional<std::array<double, 2>> range;        ///< Heights of black and white [m]; PNG only.
};
/// A linear wave.
struct Wave {
  double amplitude = 0;  ///< [m], >= 0.
  /// Exactly one of these two is given.
  std::optional<double> wavelength;  ///< [m], > 0.
  std::optional<double> period;      ///< Seen by an observer at rest [s], > 0.
  double heading = 0;                ///< [rad]
  double phase = 0;                  ///< [rad]
};
/// Irregular waves by a spectrum.
struct Spectrum {
  /// The formula of the spectrum, or a table.
  enum class Type { jonswap, pierson_moskowitz, bretschneider, tma, file };
  Type type = Type::jonswap;                  ///< Formula or table.
  std::optional<std::filesystem::path> file;  ///< Table of the type `file`, which has no formula.
  double significant_height = 0;              ///< Significant height of a formula [m], > 0.
  double peak_period = 0;                     ///< Peak period of a formula [s], > 0.
  std::optional<double> gamma = 3.3;          ///< [-], 1 … 10; none: by height and period.
  double heading = 0;                         ///< [rad]
  double spreading = 0;                       ///< Exponent s of cos^2s(θ/2); 0: long-crested.
  int seed = 1;                               ///< Seed of the random phases.
  int components = 64;                        ///< Number of waves that represent the spectrum.
};
/// Waves with a measured elevation at one point.
struct Elevation {
  std::filesystem::path file;                    ///< Table of times and elevations.
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< Place of the gauge in W [m].
  double heading = 0;                            ///< [rad]
  std::optional<double> start;  ///< Time in the file at time 0 [s]; none: the first one.
  /// Lower end of the band of frequencies [rad/s], > 0; none: by the peak.
  std::optional<double> lowest;
  std::optional<double> highest;  ///< Upper end of the band [rad/s], > 0; none: by the peak.
  int components = 1024;          ///< Largest number of waves.
};
/// How bodies move the water.
struct SimulatedWater {
  /// Effect of bodies on the water.
  enum class Kind {
    none,     ///< The water is as it is given.
    picture,  ///< Bodies make waves, which are drawn and not felt.
    felt      ///< Bodies make waves and feel those of all bodies.
  };
  Kind kind = Kind::none;  ///< Effect of bodies.
  // The grid of water that is felt; what is not given follows from the bodies.
  std::optional<std::array<int, 2>> size;  ///< Cells along x and y: equal powers of two.
  std::optional<double> spacing;           ///< Side of a cell [m], > 0.
  std::optional<double> edge;              ///< Width of the edge that absorbs waves [m], > 0.
};
/// The surface of the water: flat, heights on a grid, one or more waves, a spectrum, or a record.
using Surface = std::variant<Flat, HeightField, std::vector<Wave>, Spectrum, Elevation>;

/// The block `water`.
struct Water {
  double density = 1000;         ///< [kg/m^3], > 0.
  double viscosity = 1.0034e-6;  ///< Kinematic [m^2/s], > 0.
  double level = 0;              ///< z of the still water [m].
  std::optional<double> depth;   ///< Depth of the still water [m], > 0; none: deep.
  /// The current, or that in the first row of a table, in W [m/s].
  Eigen::Vector3d current = Eigen::Vector3d::Zero();
  std::vector<hydro::CurrentRow> current_profile;  ///< It has no rows if it is uniform.
  Surface surface;                                 ///< Shape of the surface.
  /// Kinematics of the waves, however given.
  hydro::Kinematics kinematics = hydro::Kinematics::airy;
  double ramp = 0;           ///< Time over which the waves grow from rest [s], >= 0.
  SimulatedWater simulated;  ///< How bodies move the water.
};

}  // namespace scene

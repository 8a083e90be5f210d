#pragma once

#include <optional>
#include <vector>

#include "hydro/airy_waves.h"

/// @file
/// Long-crested waves that have a measured elevation at one point.
///
/// A record of N elevations at the interval Δt is a Fourier series of N/2 waves of the frequencies
/// ω_j = 2πj/(NΔt), which has its values at all times of the record. The waves of a band of
/// frequencies travel in one direction. Below the band are drift of the gauge and long waves that
/// are bound to groups, above it noise and harmonics that are bound to waves; none of these obeys
/// the dispersion relation of free waves. The series repeats after the record's length.

namespace hydro {

/// Elevations at equal intervals.
struct ElevationRecord {
  double start = 0;                ///< Time of the first one [s].
  double interval = 0;             ///< Δt [s], > 0.
  std::vector<double> elevations;  ///< Above the still water [m]; at least kFewestElevations.

  /// Period of the series [s].
  double length() const { return interval * static_cast<double>(elevations.size()); }
};

/// Least number of elevations of a record.
constexpr int kFewestElevations = 8;

/// The waves that a record becomes.
struct ElevationChoice {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< Place of the gauge in W [m].
  double heading = 0;             ///< Direction of travel, counter-clockwise from +x [rad].
  std::optional<double> lowest;   ///< End of the band [rad/s]; none: kLowest times the peak's.
  std::optional<double> highest;  ///< End of the band [rad/s]; none: kHighest times the peak's.
  int components = 1024;          ///< Largest number of waves: those of the largest energy.

  static constexpr double kLowest = 0.3;  ///< Lower end of the band over the peak's [-].
  static constexpr double kHighest = 3;   ///< Upper end of the band over the peak's [-].
};

/// How well the waves have the elevation of the record. Energies are parts of that of the record
/// about its mean.
struct ElevationFit {
  double lowest = 0;              ///< End of the band [rad/s].
  double highest = 0;             ///< End of the band [rad/s].
  double significant_height = 0;  ///< 4 standard deviations of the record [m].
  double peak_period = 0;         ///< By the largest mean energy over a tenth of its frequency [s].
  double mean = 0;                ///< Mean of the record, which is left out [m].
  double below = 0;               ///< Energy below the band.
  double above = 0;               ///< Energy above the band.
  double dropped = 0;             ///< Energy in the band of waves beyond the largest number.
  double stopped = 0;             ///< Energy in the band of waves that the current stops.
  /// Root mean square of the difference between waves and record over that of the record about its
  /// mean, at the times of the record.
  double residual = 0;
  /// From the last elevation to the first, as a part of the largest step, or more.
  double jump = 0;
};

/// Waves and their fit.
struct MeasuredSea {
  std::vector<WaveComponent> components;  ///< The waves.
  ElevationFit fit;                       ///< Difference between waves and record.
};

/// Returns waves with the elevation of the record at its times.
/// @param sea   Its depth, gravity and current. Frequencies are those of an observer at rest.
/// @throws std::invalid_argument if the record is constant, or no frequency of it is in the band
MeasuredSea sea_of_record(const ElevationRecord& record, const ElevationChoice& choice,
                          const Sea& sea);

}  // namespace hydro

#pragma once

#include <cstddef>
#include <vector>

#include "app/logs/hdf5_file.h"

/// @file
/// The log of a run as HDF5: T times of N bodies.
///
///     time                T                                   [s]
///     body                N names
///     position            T × N × 3: x, y, z                  [m]
///     orientation         T × N × 4: qw, qx, qy, qz
///     linear_velocity     T × N × 3: vx, vy, vz               [m/s]
///     angular_velocity    T × N × 3: wx, wy, wz               [rad/s]
///     buoyancy, …         T × N × 6: <load>_fx … _fz [N], <load>_tx … _tz [N m]
///     wetted_area, …      T × N, each further column of forces.csv
///     probe               P names, and then of P probes
///     probe_elevation     T × P                               [m]
///     probe_position      T × P × 3: x, y, z                  [m]
///     probe_velocity      T × P × 3: vx, vy, vz               [m/s]
///     probe_acceleration  T × P × 3: ax, ay, az               [m/s^2]
///
/// A number that a probe does not measure (probes.h) is NaN.
///
/// Each dataset holds all bodies: a group for each of a thousand bodies takes longer than the CSV
/// files. Datasets have the attributes `units` and `columns`, which has the CSV names of the
/// entries of their last dimension. The file has the attributes `format`, `plimsoll`, `scene` and
/// `title`.

namespace app {

/// Returns the datasets of the motion of `bodies` bodies, in the order of the columns of
/// trajectory.csv.
std::vector<Hdf5Series> state_series(std::size_t bodies);

/// Returns the datasets of the forces, in the order of force_columns(); the six columns of a load
/// form one dataset.
std::vector<Hdf5Series> force_series(std::size_t bodies);

/// Returns the datasets of `probes` probes, in the order of kProbeColumnNames.
std::vector<Hdf5Series> probe_series(std::size_t probes);

/// Returns the count of numbers per body or probe in a row of the series.
std::size_t width_of(const Hdf5Series& series);

}  // namespace app

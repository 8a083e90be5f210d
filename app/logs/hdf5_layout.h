#pragma once

#include <cstddef>
#include <vector>

#include "app/logs/hdf5_file.h"
#include "app/logs/table_log.h"

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
///     line                L names: the first column of lines.csv after the time
///     line_tension        T × L                               [N]
///     line_force          T × L × 3: fx, fy, fz               [N]
///
/// and so on for each series of lines.csv and of the other tables, which are joint, machine,
/// set_point (rig_log.h) and probe (probes.h). A number that is an empty field as CSV is NaN.
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

/// Returns the datasets of `names` names of a table, in the order of its columns.
std::vector<Hdf5Series> table_series(const TableLayout& layout, std::size_t names);

/// Returns the count of numbers per body or name in a row of the series.
std::size_t width_of(const Hdf5Series& series);

}  // namespace app

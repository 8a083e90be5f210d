#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/sea.h"

/// @file
/// A current that changes with depth, as the kernel reads it.

namespace hydro::kernel {

/// The velocity that the current at the height z above the centre of mass has more than
/// `Sea::current`, in body axes:
///
///     first + Σ change · min(1, max(0, (top − z) rate)),                                     (1)
///
/// the sum over the layers between two rows of the table.
struct Shear {
  struct Layer {
    double top;        ///< [m]
    double rate;       ///< 1 over the thickness [1/m].
    double change[3];  ///< From top to bottom [m/s].
  };

  bool moves = false;         ///< There is a table.
  double first[3] = {};       ///< Above all layers [m/s].
  std::vector<Layer> layers;  ///< Layers that a hull may be in, one below the other.
  std::vector<double> bends;  ///< Heights where (1) is not straight [m].
  double fastest = 0;         ///< A bound of the size of (1) [m/s].

  /// True if (1) is straight from one height to another above it.
  bool straight(double low, double high) const;
};

/// The shear around a hull whose vertices are no farther from its centre of mass than `radius`.
Shear make_shear(const Sea& sea, const Eigen::Vector3d& p_WB, const Eigen::Matrix3d& R_WB,
                 double radius);

}  // namespace hydro::kernel

#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "app/scene/reader_map.h"
#include "app/scene/variables.h"

/// @file
/// Repeated entries of lists: `repeat: {count: 200, jitter: [5, 5, 0]}` in a map of a list.

namespace scene {

/// How often and where an entry is repeated.
struct Repeat {
  std::optional<int> count;
  std::optional<std::array<int, 3>> grid;             ///< Copies along x, y and z.
  Eigen::Vector3d spacing = Eigen::Vector3d::Zero();  ///< Spacing of the grid [m].
  Eigen::Vector3d jitter = Eigen::Vector3d::Zero();   ///< Largest random shift each way [m].
  int seed = 1;                                       ///< Seed of the shifts.

  int copies() const { return grid ? (*grid)[0] * (*grid)[1] * (*grid)[2] : count.value_or(1); }
};
void read(MapReader& map, Repeat& repeat);

/// Replaces the variables of all values below a tree, and each entry of a list that has `repeat` by
/// its copies. In a copy `${i}` is its number from 0, `${ix}`, `${iy}` and `${iz}` are its numbers
/// in the grid, and `${dx}`, `${dy}` and `${dz}` its shift [m]. A `name` without variables gets its
/// number, as `crate_7`, and the `position` of a body its shift. Faults go to `reading`.
void expand(const Variables& variables, YamlNode& root, Reading& reading);

}  // namespace scene

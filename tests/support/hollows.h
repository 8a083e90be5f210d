#pragma once

#include <array>
#include <functional>
#include <map>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// Hollow bodies of blocks.

namespace support {

/// The closed surface of the blocks of a rectangular grid for which `solid` holds, two triangles to
/// a side of a block. Blocks of one body must not touch in an edge or a corner alone.
/// @param planes   Coordinates of the grid's planes along x, y and z, ascending [m].
/// @param solid    Takes the indices of a block.
inline hydro::TriMesh blocks(const std::array<std::vector<double>, 3>& planes,
                             const std::function<bool(int, int, int)>& solid) {
  const auto filled = [&](const std::array<int, 3>& b) {
    for (int axis = 0; axis < 3; ++axis)
      if (b[axis] < 0 || b[axis] + 1 >= static_cast<int>(planes[axis].size())) return false;
    return solid(b[0], b[1], b[2]);
  };
  std::map<std::array<int, 3>, int> place;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3i> faces;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [found, is_new] = place.try_emplace(p, static_cast<int>(vertices.size()));
    if (is_new) vertices.emplace_back(planes[0][p[0]], planes[1][p[1]], planes[2][p[2]]);
    return found->second;
  };
  const auto add_side = [&](std::array<int, 3> b, int axis, int side) {
    b[axis] += side;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<std::array<int, 3>, 4> corner = {b, b, b, b};
    for (const int i : {1, 2}) ++corner[i][u];
    for (const int i : {2, 3}) ++corner[i][v];
    if (side == 0) std::swap(corner[1], corner[3]);
    const int a = vertex(corner[0]), c = vertex(corner[2]);
    faces.emplace_back(a, vertex(corner[1]), c);
    faces.emplace_back(a, c, vertex(corner[3]));
  };
  std::array<int, 3> b{};
  for (b[0] = 0; b[0] + 1 < static_cast<int>(planes[0].size()); ++b[0])
    for (b[1] = 0; b[1] + 1 < static_cast<int>(planes[1].size()); ++b[1])
      for (b[2] = 0; b[2] + 1 < static_cast<int>(planes[2].size()); ++b[2])
        for (int axis = 0; filled(b) && axis < 3; ++axis)
          for (const int side : {0, 1}) {
            std::array<int, 3> next = b;
            next[axis] += 2 * side - 1;
            if (!filled(next)) add_side(b, axis, side);
          }
  hydro::TriMesh mesh{Eigen::Matrix3Xd(3, vertices.size()), Eigen::Matrix3Xi(3, faces.size())};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    mesh.vertices.col(static_cast<Eigen::Index>(i)) = vertices[i];
  for (std::size_t i = 0; i < faces.size(); ++i)
    mesh.faces.col(static_cast<Eigen::Index>(i)) = faces[i];
  return mesh;
}

/// A box, open at the top, with its bottom at z = 0: 2 × 1 × 1 m outside, walls of 0.05 m.
inline hydro::TriMesh open_box() {
  return blocks({{{-1, -0.95, 0.95, 1}, {-0.5, -0.45, 0.45, 0.5}, {0, 0.05, 1}}},
                [](int i, int j, int k) { return i != 1 || j != 1 || k == 0; });
}

/// That box with a wall across its middle, 0.05 m thick, up to `height` [m] above its bottom.
inline hydro::TriMesh divided_box(double height) {
  return blocks(
      {{{-1, -0.95, -0.025, 0.025, 0.95, 1}, {-0.5, -0.45, 0.45, 0.5}, {0, 0.05, height, 1}}},
      [](int i, int j, int k) {
        return i == 0 || i == 4 || j != 1 || k == 0 || (i == 2 && k == 1);
      });
}

/// The same box closed at the top by a deck of 0.05 m: its hollow is a void.
inline hydro::TriMesh closed_box() {
  return blocks({{{-1, -0.95, 0.95, 1}, {-0.5, -0.45, 0.45, 0.5}, {0, 0.05, 0.95, 1}}},
                [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; });
}

}  // namespace support

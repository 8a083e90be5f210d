#pragma once

#include <array>
#include <cassert>
#include <cstdint>

#include "hydro/loads/kernel/panels.h"

/// @file
/// Triangles that wait to be split or cut. Each leaf has few of them; they are collected, so that
/// they fill the lanes of a vector.

namespace hydro::kernel {

/// Pieces of faces in the plane coordinates of their face.
struct TriangleQueue {
  static constexpr int kRoom = 8 * kLeafFaces;

  alignas(64) std::int64_t face[kRoom];  ///< `place_of` the face.
  alignas(64) double x[3][kRoom];        ///< [m]
  alignas(64) double y[3][kRoom];
  alignas(64) double depth[3][kRoom];  ///< The depths at the vertices; depth is linear between them
                                       ///< [m].
  int count = 0;

  TriangleQueue() {
  }  // The arrays stay unset: they are large, and each place is written before it is read.
};

/// Repeats the last piece up to `lanes` pieces, so that a vector of them holds proper numbers.
void pad(TriangleQueue& pieces, int lanes);

/// The place of a face among the lanes of all leaves.
inline std::int64_t place_of(std::int64_t leaf, int lane) { return leaf * kLeafFaces + lane; }

/// Adds a whole face with the depths at its vertices.
inline void put_face(const Panels& panels, std::int64_t leaf, int lane,
                     const std::array<double, 3>& depth, TriangleQueue& pieces) {
  const FaceBlock& faces = panels.leaves[static_cast<std::size_t>(leaf)].block(lane);
  const int at = lane % kMostLanes;
  assert(pieces.count < TriangleQueue::kRoom);
  const int to = pieces.count++;
  pieces.face[to] = place_of(leaf, lane);
  for (int i = 0; i < 2; ++i) {
    pieces.x[i][to] = faces.x[i][at];
    pieces.y[i][to] = faces.y[i][at];
  }
  pieces.x[2][to] = -(faces.x[0][at] + faces.x[1][at]);
  pieces.y[2][to] = -(faces.y[0][at] + faces.y[1][at]);
  for (int i = 0; i < 3; ++i) pieces.depth[i][to] = depth[static_cast<std::size_t>(i)];
}

}  // namespace hydro::kernel

#pragma once

#include <functional>

#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"

/// @file
/// The water of a given sea that the wet surface of a moving body displaces.

namespace hydro {

/// A source of water.
struct WaterSource {
  Eigen::Vector2d place;  ///< In W [m].
  double height;          ///< Above the given surface [m], <= 0.
  double rate;            ///< (V − u)·n of a piece of the surface [m^3/s].
};

/// Finds the sources of the wet part of a body: pieces of its triangles that are no longer than a
/// cell, with the velocity V of the surface and that of the sea, u, which is taken as linear in
/// place about the body.
/// @param mesh_B   Closed, outward, about the centre of mass; its vertices are within `radius` [m].
/// @param cell     [m]
/// @param deepest  Bodies deeper than this below the surface have no sources [m].
void find_sources(const TriMesh& mesh_B, double radius, const BodyState& state, const Sea& sea,
                  double time, double cell, double deepest,
                  const std::function<void(const WaterSource&)>& take);

}  // namespace hydro

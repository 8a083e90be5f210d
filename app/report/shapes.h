#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/spec.h"
#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"

namespace app {

/// Meshes of the bodies, each stored once, and the assignment of meshes to bodies.
struct Shapes {
  struct Shape {
    hydro::TriMesh mesh_B;      ///< Mesh as it is shown.
    Eigen::Index of_faces = 0;  ///< Number of faces of the body's own mesh.
  };
  std::vector<Shape> shapes;
  std::vector<std::size_t> of_body;  ///< Index of its shape, per body.
};

/// @param most_faces   Limit for all shapes together; larger shapes are coarsened, each to its
///     share.
Shapes find_shapes(const std::vector<engine::BodySpec>& bodies, Eigen::Index most_faces);

/// Returns the mesh with at most `most_faces` faces: vertices in a cell of a cubic grid are merged
/// at their mean, and faces that lose a corner are removed. A mesh with few enough faces is
/// returned unchanged.
hydro::TriMesh coarsened(const hydro::TriMesh& mesh, Eigen::Index most_faces);

/// Returns the field with at most `most` (>= 4) heights, taken from every n-th row and column. A
/// field with few enough heights is returned unchanged.
hydro::HeightField coarsened(const hydro::HeightField& field, Eigen::Index most);

}  // namespace app

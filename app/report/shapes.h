#pragma once

#include <cstddef>
#include <vector>

#include "engine/spec.h"
#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"

namespace app {

/// The meshes of bodies, each once, and which body has which.
struct Shapes {
  struct Shape {
    hydro::TriMesh mesh_B;      ///< As it is shown.
    Eigen::Index of_faces = 0;  ///< That the body itself has.
  };
  std::vector<Shape> shapes;
  std::vector<std::size_t> of_body;  ///< Index of its shape, per body.
};

/// @param most_faces   Of all shapes together; larger ones are made coarser, each by its share.
Shapes find_shapes(const std::vector<engine::BodySpec>& bodies, Eigen::Index most_faces);

/// The mesh with about `most_faces` at most: vertices within a cell of a cubic grid become one, at
/// their mean; faces that lose a corner go. A mesh that has no more stays as it is.
hydro::TriMesh coarsened(const hydro::TriMesh& mesh, Eigen::Index most_faces);

/// The field with at most `most` (>= 4) heights, on wider cells: those of every so many rows and
/// columns. A field that has no more stays as it is.
hydro::HeightField coarsened(const hydro::HeightField& field, Eigen::Index most);

}  // namespace app

#pragma once

#include <vector>

#include "hydro/added_mass/bem/element.h"

/// @file
/// The surface on which a potential is sought: the faces of a closed mesh, split into panels.

namespace hydro::bem {

/// A conforming subdivision of a mesh; the surface is unchanged.
struct Split {
  TriMesh mesh;
  std::vector<int> parent;  ///< For each face, the face of the original mesh that contains it.
};

/// The edges of a closed mesh.
struct Edges {
  std::vector<std::array<int, 3>> of_face;  ///< Edge e of a face runs from corner e to e + 1.
  std::vector<std::array<int, 2>> faces;    ///< The two faces beside each edge.
};

Edges edges_of(const TriMesh& mesh);

/// Halves the marked edges. A face with several is halved at the longest of them first. No other
/// edges are halved, so panels become thin where only some of their edges are marked.
Split bisected(const Split& split, const Edges& edges, const std::vector<bool>& marked);

/// The parts of a mesh connected by vertices, in the order of their first vertex.
struct Parts {
  std::vector<int> of_vertex;
  std::vector<double> volume;  ///< Signed volume, negative for a cavity [m^3].
};
Parts parts_of(const TriMesh& mesh);

/// A mesh with the data that its equations need.
struct Surface {
  TriMesh mesh;
  std::vector<Element> elements;
  Edges edges;
  Parts parts;

  Eigen::Index vertex_count() const { return mesh.vertex_count(); }
  std::size_t face_count() const { return elements.size(); }
  int vertex(std::size_t face, std::size_t corner) const {
    return mesh.faces(static_cast<Eigen::Index>(corner), static_cast<Eigen::Index>(face));
  }
  int part_of_face(std::size_t face) const {
    return parts.of_vertex[static_cast<std::size_t>(vertex(face, 0))];
  }
};
Surface make_surface(const TriMesh& mesh);

}  // namespace hydro::bem

#pragma once

#include "hydro/mesh/mesh.h"

/// @file
/// Orients the faces of a mesh consistently and outward.

namespace hydro {

/// Turns faces over so that neighbours agree across each edge with two faces. In each set of faces
/// that such edges connect the majority stays as it is. A surface with one side only, as a Möbius
/// strip, keeps an edge on which two faces disagree.
TriMesh turned_consistently(TriMesh mesh);

/// Meaning of a closed part inside another one.
enum class Nested {
  cavity,   ///< A hollow of the other.
  as_drawn  ///< A hollow only if its faces look the other way than those of the largest part.
};

/// Turns each closed part outward, or inward if it is a cavity: if it lies inside an odd number of
/// parts that it does not cut. Open parts are turned so that they face away from what they enclose
/// when their loops are filled; flat ones stay as they are. Neighbours must agree.
TriMesh turned_outward(TriMesh mesh, Nested nested = Nested::cavity);

}  // namespace hydro

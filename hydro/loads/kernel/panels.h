#pragma once

#include <cstdint>
#include <vector>

#include "hydro/loads/kernel/load_inputs.h"
#include "hydro/mesh/mesh.h"

/// @file
/// The faces of a hull as the kernel reads them. A leaf has kLeafFaces neighbouring faces; numbers
/// of one kind lie side by side.
///
/// A face is kept as its centroid c, its unit normal n, a unit vector e_1 in its plane and, with
/// e_2 = n × e_1, the plane coordinates (x, y) of its vertices r_i = c + x_i e_1 + y_i e_2. Axes
/// are those of the body: when the body moves, the water is turned and not the faces.
///
/// All fields that a load is made of are polynomials of (x, y). With Σ x_i = Σ y_i = 0, for linear
/// functions f, g, h that vanish at the centroid,
///
///     ∫ f g dA = (A/12) Σ f_i g_i          ∫ f g h dA = (A/30) Σ f_i g_i h_i              (1)
///
/// [EM73] Eisenberg, Malvern. On finite element integration in natural co-ordinates.
///        Int. J. Numer. Methods Eng. 7 (1973) 574-575.

namespace hydro::kernel {

/// The number of faces of a leaf. It is a multiple of the lanes of every vector unit.
inline constexpr int kLeafFaces = 32;

/// Faces in body axes about the centre of mass [m, m^2].
struct alignas(64) FaceBlock {
  double c[3][kMostLanes];   ///< Centroids.
  double n[3][kMostLanes];   ///< Unit normals, out of the body.
  double e1[3][kMostLanes];  ///< Unit vectors along each face's longest side.
  double area[kMostLanes];
  double x[2][kMostLanes];  ///< x of the first two vertices; the three add up to 0.
  double y[2][kMostLanes];
};

/// A leaf's faces in blocks, so that memory is read in its order. A leaf that is not full repeats
/// its last face with an area of 0. Lanes are counted through all blocks of a leaf.
struct Leaf {
  FaceBlock blocks[kLeafFaces / kMostLanes];

  FaceBlock& block(int lane) { return blocks[lane / kMostLanes]; }
  const FaceBlock& block(int lane) const { return blocks[lane / kMostLanes]; }
};

/// One face of a leaf.
struct Face {
  Eigen::Vector3d c, n, e1, e2;
  double area;
  Eigen::Vector3d x, y;  ///< Plane coordinates of the vertices.

  Eigen::Vector3d corner(int i) const { return c + x[i] * e1 + y[i] * e2; }
};

Face face_of(const Leaf& leaf, int lane);

/// Vertices of a leaf's faces. With φ the function that is 1 at the vertex, 0 at the others and
/// linear over each face, and J = (n, r × n), a function h that is linear over each face has
/// ∫ h J dS = Σ h_i ∫ φ_i J dS.
struct alignas(64) VertexBlock {
  double r[3][kMostLanes];  ///< [m]
  double j[6][kMostLanes];  ///< ∫ φ J dS over the leaf's faces.
};

/// The places of a leaf's vertices. A leaf has each vertex once.
struct alignas(64) LeafVertices {
  std::int64_t of_face[3][kLeafFaces] = {};  ///< The place of each face's corners among them.
  int first = 0, last = 0;                   ///< The leaf has blocks [first, last).
};

/// All faces of a mesh that have an area.
struct Panels {
  std::vector<Leaf> leaves;
  std::vector<LeafVertices> vertices;  ///< There is one for each leaf.
  std::vector<VertexBlock> blocks;
  std::vector<int> face;    ///< Index in the mesh, in the order of the leaves.
  double longest_edge = 0;  ///< [m]
};

/// Orders the faces so that any run of them of a power of two leaves is compact in place and
/// normal, and lays them out.
Panels make_panels(const TriMesh& mesh_B);

}  // namespace hydro::kernel

#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"

/// @file
/// Closed meshes for tests, with outward normals unless a name says otherwise.

namespace support {

/// Returns the tetrahedron with a corner at the origin and the others on the axes at `edges` [m].
inline hydro::TriMesh corner_tetrahedron(const Eigen::Vector3d& edges) {
  hydro::TriMesh mesh{Eigen::Matrix3Xd::Zero(3, 4), Eigen::Matrix3Xi(3, 4)};
  mesh.vertices.rightCols(3) = edges.asDiagonal();
  mesh.faces << 0, 0, 0, 1,  //
      2, 1, 3, 2,            //
      1, 3, 2, 3;
  return mesh;
}

/// Returns a mesh of a torus about z, with vertices on the smooth torus at equal angles.
inline hydro::TriMesh make_torus(double radius, double tube, int around, int across) {
  hydro::TriMesh mesh{Eigen::Matrix3Xd(3, around * across),
                      Eigen::Matrix3Xi(3, 2 * around * across)};
  const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across;
      const double rho = radius + tube * std::cos(v);
      mesh.vertices.col(at(i, j)) << rho * std::cos(u), rho * std::sin(u), tube * std::sin(v);
      mesh.faces.col(2 * at(i, j)) << at(i, j), at(i + 1, j), at(i + 1, j + 1);
      mesh.faces.col(2 * at(i, j) + 1) << at(i, j), at(i + 1, j + 1), at(i, j + 1);
    }
  }
  return mesh;
}

/// Returns a random star-shaped solid of radius 0.6 … 1.4 m: every vertex of an icosphere is moved
/// along its ray. No two faces intersect.
inline hydro::TriMesh random_star(Random& random, int subdivisions = 2) {
  hydro::TriMesh mesh = hydro::make_icosphere(1, subdivisions);
  for (Eigen::Index i = 0; i < mesh.vertex_count(); ++i)
    mesh.vertices.col(i) *= random.uniform(0.6, 1.4);
  return mesh;
}

/// Returns a random rotation about the origin with a translation by up to `distance` along each
/// axis.
inline Eigen::Isometry3d random_pose(Random& random, double distance) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = random.rotation().toRotationMatrix();
  X.translation() = random.vector(distance);
  return X;
}

/// Returns both meshes as one, without shared vertices.
inline hydro::TriMesh united(const hydro::TriMesh& a, const hydro::TriMesh& b) {
  hydro::TriMesh mesh{Eigen::Matrix3Xd(3, a.vertex_count() + b.vertex_count()),
                      Eigen::Matrix3Xi(3, a.face_count() + b.face_count())};
  mesh.vertices << a.vertices, b.vertices;
  mesh.faces << a.faces, b.faces.array() + static_cast<int>(a.vertex_count());
  return mesh;
}

/// A prism along x whose section is a wedge of half-breadth 1 under a wall of the same height.
inline hydro::TriMesh wedge(double deadrise, double length) {
  const double keel = -std::tan(deadrise);
  const std::array<Eigen::Vector2d, 5> section{
      Eigen::Vector2d(0, keel), {1, 0}, {1, 1}, {-1, 1}, {-1, 0}};
  hydro::TriMesh mesh;
  mesh.vertices.resize(3, 10);
  for (int i = 0; i < 5; ++i)
    for (const int end : {0, 1})
      mesh.vertices.col(i + 5 * end) << (end - 0.5) * length, section[i].x(), section[i].y();
  std::vector<Eigen::Vector3i> faces;
  for (int i = 0; i < 5; ++i) {
    const int j = (i + 1) % 5;
    faces.push_back({i, j, i + 5});
    faces.push_back({j, j + 5, i + 5});
  }
  for (int i = 1; i < 4; ++i) {
    faces.push_back({0, i + 1, i});
    faces.push_back({5, 5 + i, 5 + i + 1});
  }
  mesh.faces.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t i = 0; i < faces.size(); ++i)
    mesh.faces.col(static_cast<Eigen::Index>(i)) = faces[i];
  return mesh;
}

}  // namespace support

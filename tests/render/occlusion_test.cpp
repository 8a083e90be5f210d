#include "app/render/occlusion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/mesh/primitives.h"
#include "tests/render/pictures.h"

namespace {

using render::openness;

TEST(Openness, OfAConvexBodyIsOneEverywhere) {
  for (const hydro::TriMesh& mesh : {hydro::make_box({1, 2, 3}, 3), hydro::make_icosphere(1, 3)}) {
    const Eigen::RowVectorXf open = openness(mesh, render::make_shaded_mesh(mesh));
    EXPECT_EQ(open.minCoeff(), 1);
  }
}

/// Two parallel squares face each other closely: hardly any light comes to their middles.
TEST(Openness, IsSmallInANarrowGap) {
  hydro::TriMesh mesh = hydro::make_box({4, 4, 0.2}, 16);
  hydro::TriMesh other = mesh;
  const Eigen::Index count = mesh.vertex_count();
  mesh.vertices.conservativeResize(3, 2 * count);
  mesh.vertices.rightCols(count) = other.vertices.colwise() + Eigen::Vector3d(0, 0, 0.4);
  mesh.faces.conservativeResize(3, 2 * other.face_count());
  mesh.faces.rightCols(other.face_count()) = other.faces.array() + static_cast<int>(count);
  const render::ShadedMesh skin = render::make_shaded_mesh(mesh);
  const Eigen::RowVectorXf open = openness(mesh, skin);
  for (Eigen::Index v = 0; v < open.size(); ++v) {
    const Eigen::Vector3d p = skin.vertices.col(v), n = skin.normals.col(v);
    if (p.head<2>().norm() > 0.5 || std::abs(n.z()) < 0.99) continue;
    const bool in_gap = (p.z() > 0.05 && p.z() < 0.15) || (p.z() > 0.25 && p.z() < 0.35);
    if (in_gap) {
      EXPECT_LT(open[v], 0.1);
    } else {
      EXPECT_EQ(open[v], 1);
    }
  }
}

/// From the innermost circle of a torus the other side is seen; from the outermost nothing is.
TEST(Openness, OfATorusIsLeastInside) {
  const hydro::TriMesh mesh = pictures::make_torus(1, 0.4, 48, 24);
  const render::ShadedMesh skin = render::make_shaded_mesh(mesh);
  const Eigen::RowVectorXf open = openness(mesh, skin);
  for (Eigen::Index v = 0; v < open.size(); ++v) {
    const double out = skin.vertices.col(v).head<2>().norm();
    if (out > 1.39) {
      EXPECT_EQ(open[v], 1);
    } else if (out < 0.61) {
      EXPECT_LT(open[v], 0.75);
    }
  }
}

}  // namespace

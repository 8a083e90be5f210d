#include "hydro/mesh/primitives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "hydro/mesh/mass_properties.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using hydro::TriMesh;

struct Primitive {
  const char* name;
  TriMesh mesh;
};

std::vector<Primitive> all_primitives() {
  return {{"coarse box", hydro::make_box({1, 2, 3})},
          {"box of 4", hydro::make_box({1, 2, 3}, 4)},
          {"box of 7", hydro::make_box({3, 1, 2}, 7)},
          {"least sphere", hydro::make_sphere(2, 3, 2)},
          {"sphere", hydro::make_sphere(2, 14, 9)},
          {"ellipsoid", hydro::make_ellipsoid({1, 2, 0.5}, 12, 8)},
          {"icosahedron", hydro::make_icosphere(1.5, 0)},
          {"icosphere", hydro::make_icosphere(1.5, 3)},
          {"least cylinder", hydro::make_cylinder(1, 100, 3, 1)},
          {"cylinder", hydro::make_cylinder(1, 2, 24, 8)}};
}

/// How often each directed edge occurs.
std::map<std::pair<int, int>, int> directed_edges(const TriMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& face : mesh.faces.colwise())
    for (int i = 0; i < 3; ++i) ++edges[{face[i], face[(i + 1) % 3]}];
  return edges;
}

/// The mesh's faces as sets of positions, mirrored in the plane through the origin across `axis`.
/// Zero is added to turn −0 into 0.
using Point = std::array<double, 3>;
std::set<std::set<Point>> face_positions(const TriMesh& mesh, int axis, double sign) {
  std::set<std::set<Point>> faces;
  for (const auto& face : mesh.faces.colwise()) {
    std::set<Point> corners;
    for (const int vertex : face) {
      Eigen::Vector3d p = mesh.vertices.col(vertex);
      p[axis] *= sign;
      corners.insert({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0});
    }
    faces.insert(corners);
  }
  return faces;
}

TEST(Primitives, EveryEdgeHasItsOppositeOnceSoThatTheSurfaceIsClosedAndOneSided) {
  for (const Primitive& c : all_primitives()) {
    const auto edges = directed_edges(c.mesh);
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1) << c.name;
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << c.name;
    }
  }
}

TEST(Primitives, VerticesAreSharedSoThatEulersFormulaHoldsForOneSphere) {
  for (const Primitive& c : all_primitives()) {
    EXPECT_EQ(c.mesh.vertex_count() * 2 - c.mesh.face_count(), 4) << c.name;
    std::set<Point> places;
    for (const auto& p : c.mesh.vertices.colwise()) places.insert({p.x(), p.y(), p.z()});
    EXPECT_EQ(static_cast<Eigen::Index>(places.size()), c.mesh.vertex_count()) << c.name;
    EXPECT_EQ(c.mesh.faces.minCoeff(), 0) << c.name;
    EXPECT_EQ(c.mesh.faces.maxCoeff() + 1, c.mesh.vertex_count()) << c.name;
  }
}

TEST(Primitives, NormalsPointAwayFromTheCentre) {
  for (const Primitive& c : all_primitives())
    for (Eigen::Index f = 0; f < c.mesh.face_count(); ++f)
      EXPECT_GT(area_vector(c.mesh, f).dot(c.mesh.vertices.col(c.mesh.faces(0, f))), 0)
          << c.name << " face " << f;
}

TEST(Primitives, CountsAreAsDocumented) {
  EXPECT_EQ(hydro::make_box({1, 1, 1}, 5).face_count(), 12 * 25);
  EXPECT_EQ(hydro::make_box({1, 1, 1}, 5).vertex_count(), 6 * 25 + 2);
  EXPECT_EQ(hydro::make_sphere(1, 50, 50).face_count(), 4900);
  EXPECT_EQ(hydro::make_sphere(1, 50, 50).vertex_count(), 50 * 49 + 2);
  EXPECT_EQ(hydro::make_ellipsoid({1, 2, 3}, 7, 4).face_count(), 2 * 7 * 3);
  for (int n = 0; n <= 4; ++n)
    EXPECT_EQ(hydro::make_icosphere(1, n).face_count(), 20 * (1 << (2 * n)));
  const int rings = hydro::cylinder_cap_rings(1, 2, 48, 8);
  EXPECT_EQ(rings, 4);
  EXPECT_EQ(hydro::make_cylinder(1, 2, 48, 8).face_count(), 2 * 48 * (8 + 2 * rings - 1));
}

TEST(Primitives, VerticesLieOnTheSmoothSurface) {
  // Two roundings of the coordinates and one each of square, sum and root.
  const double rounding = support::tolerance(4 * std::numeric_limits<double>::epsilon());
  for (const TriMesh& mesh : {hydro::make_sphere(2, 33, 17), hydro::make_icosphere(2, 4)})
    for (const auto& p : mesh.vertices.colwise()) EXPECT_NEAR(p.norm() / 2, 1, rounding);
  const Eigen::Vector3d semi_axes(3, 1, 0.2);
  const TriMesh ellipsoid = hydro::make_ellipsoid(semi_axes, 15, 10);
  for (const auto& p : ellipsoid.vertices.colwise())
    EXPECT_NEAR(p.cwiseQuotient(semi_axes).norm(), 1, rounding);
  const TriMesh cylinder = hydro::make_cylinder(2, 3, 15, 4);
  for (const auto& p : cylinder.vertices.colwise())
    EXPECT_TRUE(std::abs(p.head<2>().norm() / 2 - 1) <= rounding || std::abs(p.z()) == 1.5);
}

TEST(Primitives, BoxHasItsExactExtentVolumeAndInertia) {
  const Eigen::Vector3d size(1, 2, 3);
  for (const int divisions : {1, 2, 5}) {
    const TriMesh box = hydro::make_box(size, divisions);
    EXPECT_EQ(bounding_box(box).min(), -size / 2);
    EXPECT_EQ(bounding_box(box).max(), size / 2);
    const hydro::SolidProperties solid = solid_properties(box);
    // 12·25 terms of the same sign.
    const double rounding = support::tolerance(1e-14);
    EXPECT_NEAR(solid.volume / 6, 1, rounding);
    EXPECT_NEAR(solid.inertia(0, 0) / (6 * (4 + 9) / 12.0), 1, rounding);
  }
}

TEST(Primitives, CylinderIsAPrismOnItsPolygon) {
  const double radius = 1.5, height = 4;
  for (const int slices : {3, 8, 48}) {
    const double polygon = slices * radius * radius / 2 * std::sin(2 * M_PI / slices);
    const double volume = solid_properties(hydro::make_cylinder(radius, height, slices, 6)).volume;
    // Round-off of a plain sum of up to 1248 terms; random signs give its root, 35 epsilon.
    EXPECT_NEAR(volume / (polygon * height), 1, support::tolerance(1e-13)) << slices;
  }
}

TEST(Primitives, MeshesOfEvenCountsAreTheirOwnMirrorImages) {
  const std::vector<Primitive> even = {{"box", hydro::make_box({1, 2, 3}, 4)},
                                       {"sphere", hydro::make_sphere(2, 12, 8)},
                                       {"ellipsoid", hydro::make_ellipsoid({1, 2, 3}, 8, 6)},
                                       {"cylinder", hydro::make_cylinder(1, 2, 16, 6)}};
  for (const Primitive& c : even)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(face_positions(c.mesh, axis, -1), face_positions(c.mesh, axis, 1))
          << c.name << " across axis " << axis;
}

TEST(Primitives, PolesOfTheSphereAreOnZ) {
  const TriMesh sphere = hydro::make_sphere(2, 5, 4);
  EXPECT_EQ(bounding_box(sphere).max().z(), 2);
  EXPECT_EQ(sphere.vertices.col(0), Eigen::Vector3d(0, 0, 2));
  EXPECT_EQ(sphere.vertices.rightCols(1), Eigen::Vector3d(0, 0, -2));
}

TEST(Primitives, CylinderCapsHaveNoRingFinerThanTheSide) {
  EXPECT_EQ(hydro::cylinder_cap_rings(1, 100, 48, 1), 1);   // long side panels: a fan
  EXPECT_EQ(hydro::cylinder_cap_rings(10, 0.1, 44, 1), 7);  // a disc: 44 / 2π of the arc's length
  EXPECT_EQ(hydro::cylinder_cap_rings(1, 2, 200, 20), 10);  // square panels of 0.1
}

TEST(Primitives, ImpossibleSizesAndCountsAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(hydro::make_box({1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(hydro::make_box({1, 1, nan}), std::invalid_argument);
  EXPECT_THROW(hydro::make_box({1, 1, 1}, 0), std::invalid_argument);
  EXPECT_THROW(hydro::make_box({1, 1, 1}, 100000), std::invalid_argument);
  EXPECT_THROW(hydro::make_sphere(-1, 5, 5), std::invalid_argument);
  EXPECT_THROW(hydro::make_sphere(1, 2, 5), std::invalid_argument);
  EXPECT_THROW(hydro::make_sphere(1, 3, 1), std::invalid_argument);
  EXPECT_THROW(hydro::make_sphere(1, 2000000000, 2000000000), std::invalid_argument);
  EXPECT_THROW(hydro::make_icosphere(1, -1), std::invalid_argument);
  EXPECT_THROW(hydro::make_icosphere(1, 10), std::invalid_argument);
  EXPECT_THROW(hydro::make_cylinder(1, 0, 8, 1), std::invalid_argument);
  EXPECT_THROW(hydro::make_cylinder(1, 1, 8, 0), std::invalid_argument);
  EXPECT_THROW(hydro::make_cylinder(1, 1e-9, 2000000000, 1), std::invalid_argument);
}

TEST(LongestEdge, OfABoxIsTheDiagonalOfItsLargestSide) {
  support::Random random(3);
  hydro::TriMesh box = hydro::make_box({1, 3, 4});
  box.vertices = (random.rotation().toRotationMatrix() * box.vertices).colwise() + random.vector(9);
  EXPECT_NEAR(hydro::longest_edge(box), 5, support::tolerance(1e-13));
  EXPECT_EQ(hydro::longest_edge({}), 0);
}

}  // namespace

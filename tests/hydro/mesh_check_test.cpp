#include "hydro/mesh/mesh_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "hydro/mesh/weld.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

namespace {

using hydro::MeshReport;
using hydro::TriMesh;
using support::Random;
using testing::ElementsAre;
using testing::IsEmpty;

TriMesh cube(const Eigen::Vector3d& corner = Eigen::Vector3d::Zero(), double size = 1) {
  const Eigen::Vector3d edges = Eigen::Vector3d::Constant(size);
  return translated(hydro::make_box(edges), corner + edges / 2);
}

TriMesh without_face(TriMesh mesh, Eigen::Index face) {
  mesh.faces.col(face) = Eigen::Vector3i(mesh.faces.rightCols(1));
  mesh.faces.conservativeResize(3, mesh.face_count() - 1);
  return mesh;
}

TriMesh with_face(TriMesh mesh, int a, int b, int c) {
  mesh.faces.conservativeResize(3, mesh.face_count() + 1);
  mesh.faces.rightCols(1) << a, b, c;
  return mesh;
}

/// The place lies on the edge of some face: its distance from that edge's line and ends.
bool on_some_edge(const TriMesh& mesh, const Eigen::Vector3d& p) {
  for (const auto& face : mesh.faces.colwise()) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d a = mesh.vertices.col(face[i]),
                            b = mesh.vertices.col(face[(i + 1) % 3]);
      if ((p - (a + b) / 2).norm() < 1e-12) return true;
    }
  }
  return false;
}

TEST(MeshCheck, SoundSolidsHaveNothingToReportInAnyPose) {
  Random random(1);
  const TriMesh solids[] = {hydro::make_box({1, 2, 3}, 9),
                            hydro::make_box({100, 1, 0.001}, 4),
                            hydro::make_sphere(1, 50, 50),
                            hydro::make_icosphere(1, 4),
                            hydro::make_cylinder(1, 2, 48, 8),
                            hydro::make_cylinder(0.01, 10, 600, 1),
                            hydro::make_ellipsoid({5, 1, 0.1}, 40, 30),
                            support::make_torus(2, 0.7, 30, 20),
                            support::random_star(random, 3),
                            support::corner_tetrahedron({1, 2, 3})};
  for (const TriMesh& solid : solids) {
    for (const double distance : {0.0, 10.0, 1e5}) {
      const MeshReport report =
          check_mesh(transformed(solid, support::random_pose(random, distance)));
      EXPECT_THAT(describe(report), IsEmpty());
      EXPECT_GT(report.volume, 0);
      EXPECT_TRUE(report.closed() && report.sound());
    }
  }
}

TEST(MeshCheck, CoordinatesRoundedToFloatsDoNotMakeASolidUnsound) {
  Random random(2);
  for (const TriMesh& solid :
       {hydro::make_box({1, 2, 3}, 20), hydro::make_cylinder(1, 2, 60, 10)}) {
    TriMesh mesh = transformed(solid, support::random_pose(random, 3));
    mesh.vertices = mesh.vertices.cast<float>().cast<double>();
    EXPECT_THAT(describe(check_mesh(mesh)), IsEmpty());
  }
}

TEST(MeshCheck, VolumeIsThatOfTheSolid) {
  Random random(3);
  const TriMesh mesh = transformed(support::random_star(random), support::random_pose(random, 10));
  EXPECT_NEAR(check_mesh(mesh).volume / solid_properties(mesh).volume, 1,
              support::tolerance(1e-13));  // two sums of 320 terms, round-off
}

TEST(MeshCheck, AMissingFaceOpensThreeEdgesWhereverItIs) {
  Random random(4);
  const TriMesh mesh = support::random_star(random, 1);
  for (Eigen::Index f = 0; f < mesh.face_count(); f += 7) {
    const MeshReport report = check_mesh(without_face(mesh, f));
    EXPECT_EQ(report.open_edges.count, 3);
    EXPECT_TRUE(on_some_edge(mesh, report.open_edges.first));
    EXPECT_FALSE(report.closed());
    EXPECT_EQ(report.misoriented_edges.count, 0);
    EXPECT_FALSE(report.inward);
  }
}

TEST(MeshCheck, AFaceTurnedOverIsAgainstItsThreeNeighbours) {
  Random random(5);
  TriMesh mesh = support::random_star(random, 1);
  mesh.faces.col(11).reverseInPlace();
  const MeshReport report = check_mesh(mesh);
  EXPECT_EQ(report.misoriented_edges.count, 3);
  EXPECT_TRUE(on_some_edge(mesh, report.misoriented_edges.first));
  EXPECT_TRUE(report.closed());
  EXPECT_FALSE(report.inward);
}

TEST(MeshCheck, ARepeatedFaceCrowdsItsEdges) {
  const TriMesh mesh = cube();
  const auto face = mesh.faces.col(5);
  for (const MeshReport& report : {check_mesh(with_face(mesh, face[0], face[1], face[2])),
                                   check_mesh(with_face(mesh, face[2], face[1], face[0]))}) {
    EXPECT_EQ(report.duplicate_faces.count, 1);
    EXPECT_EQ(report.crowded_edges.count, 3);
    EXPECT_EQ(report.self_overlaps.count, 0);
    EXPECT_FALSE(report.closed());
  }
}

TEST(MeshCheck, CubesThatShareAnEdgeOrAFaceAreNotOneSolid) {
  const TriMesh edge = welded(support::united(cube(), cube({1, 1, 0})), 1e-9);
  EXPECT_EQ(check_mesh(edge).crowded_edges.count, 1);
  const TriMesh face = welded(support::united(cube(), cube({1, 0, 0})), 1e-9);
  EXPECT_GE(check_mesh(face).crowded_edges.count, 4);
}

TEST(MeshCheck, FacesWithoutAreaAreFoundHoweverTheyAreMade) {
  const TriMesh mesh = cube();
  EXPECT_EQ(check_mesh(with_face(mesh, 0, 1, 1)).degenerate_faces.count, 1);
  EXPECT_TRUE(check_mesh(with_face(mesh, 0, 1, 1)).closed());
  TriMesh row = cube();
  row.vertices.conservativeResize(3, 9);
  row.vertices.col(8) = (row.vertices.col(0) + row.vertices.col(1)) / 2;
  const MeshReport report = check_mesh(with_face(row, 0, 1, 8));
  EXPECT_EQ(report.degenerate_faces.count, 1);
}

TEST(MeshCheck, ASliverWithAreaIsNotDegenerate) {
  // Flat to 1e-9: far below what matters, far above round-off.
  const MeshReport report = check_mesh(support::corner_tetrahedron({1, 1, 1e-9}));
  EXPECT_EQ(report.degenerate_faces.count, 0);
  EXPECT_FALSE(report.empty);
}

TEST(MeshCheck, VerticesThatAreNotFiniteAreNamed) {
  TriMesh mesh = cube();
  mesh.vertices(1, 3) = std::numeric_limits<double>::infinity();
  mesh.vertices(2, 6) = std::numeric_limits<double>::quiet_NaN();
  const MeshReport report = check_mesh(mesh);
  EXPECT_EQ(report.not_finite.count, 2);
  EXPECT_EQ(report.not_finite.first, mesh.vertices.col(3));
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.volume, 0);
}

TEST(MeshCheck, AFaceThatNamesNoVertexIsRefused) {
  EXPECT_THROW(check_mesh(with_face(cube(), 0, 1, 8)), std::invalid_argument);
  EXPECT_THROW(check_mesh(with_face(cube(), 0, 1, -1)), std::invalid_argument);
}

TEST(MeshCheck, AMeshWithoutVolumeIsEmpty) {
  TriMesh flat{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 4)};
  flat.vertices << 0, 1, 1, 0, 0, 0, 1, 1, 2, 2, 2, 2;
  flat.faces << 0, 0, 1, 3, 1, 2, 0, 2, 2, 3, 3, 1;
  const MeshReport report = check_mesh(flat);
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.empty);
  EXPECT_TRUE(check_mesh(TriMesh{}).empty);
}

TEST(MeshCheck, AnInwardMeshIsTurnedAndTheNoteSaysSo) {
  Random random(7);
  const TriMesh hollow =
      support::united(hydro::make_box({4, 4, 4}), flipped(support::random_star(random)));
  for (const TriMesh& mesh : {cube(), support::random_star(random), hollow}) {
    EXPECT_FALSE(check_mesh(mesh).inward);
    EXPECT_TRUE(check_mesh(flipped(mesh)).inward);
    EXPECT_EQ(check_mesh(flipped(mesh)).misturned_parts.count, 0);
    const hydro::RepairedMesh turned = repaired(flipped(mesh));
    EXPECT_EQ(turned.notes.size(), 1u);
    EXPECT_EQ(turned.mesh.faces, mesh.faces);
    EXPECT_TRUE(turned.report.sound());
    EXPECT_EQ(turned.report.volume, -check_mesh(flipped(mesh)).volume);
  }
}

TEST(MeshCheck, NothingElseIsRepaired) {
  TriMesh mesh = flipped(cube());
  EXPECT_THAT(repaired(cube()).notes, IsEmpty());
  mesh.faces.col(0).reverseInPlace();
  EXPECT_THAT(repaired(mesh).notes, IsEmpty());
  EXPECT_EQ(repaired(mesh).mesh.faces, mesh.faces);
  EXPECT_THAT(repaired(without_face(flipped(cube()), 2)).notes, IsEmpty());
}

TEST(MeshCheck, PartsAlternateInwardFromTheOutside) {
  Random random(8);
  const Eigen::Isometry3d X = support::random_pose(random, 5);
  const TriMesh shells[] = {cube({0, 0, 0}, 8), cube({1, 1, 1}, 6), cube({2, 2, 2}, 4)};
  for (int turned = 0; turned < 8; ++turned) {
    TriMesh mesh;
    int wrong = 0;
    for (int i = 0; i < 3; ++i) {
      const bool inward = turned >> i & 1;
      if (inward != (i == 1)) ++wrong;
      mesh = support::united(mesh, inward ? flipped(shells[i]) : shells[i]);
    }
    const MeshReport report = check_mesh(transformed(mesh, X));
    EXPECT_EQ(report.inward, wrong == 3) << turned;
    EXPECT_EQ(report.misturned_parts.count, wrong == 3 ? 0 : wrong) << turned;
  }
}

TEST(MeshCheck, PartsSideBySideMustAllFaceOutward) {
  Random random(9);
  const Eigen::Isometry3d X = support::random_pose(random, 5);
  const TriMesh apart = support::united(cube(), cube({3, 0, 0}));
  EXPECT_TRUE(check_mesh(transformed(apart, X)).sound());
  const TriMesh turned = support::united(cube(), flipped(cube({3, 0, 0})));
  EXPECT_EQ(check_mesh(transformed(turned, X)).misturned_parts.count, 1);
}

TEST(MeshCheck, DescriptionsCountInPlainWordsAndSayWhere) {
  EXPECT_THAT(describe(check_mesh(without_face(cube(), 0))),
              ElementsAre(testing::MatchesRegex(
                  "3 edges are open \\(one face only\\), the first at \\(.*, .*, .*\\)")));
  MeshReport report;
  report.open_edges = {1, {0.5, 0, 1}};
  report.self_overlaps = {7, {-2, 0, 0}};
  report.inward = true;
  EXPECT_THAT(describe(report),
              ElementsAre("1 edge is open (one face only), at (0.5, 0, 1)",
                          "7 pairs of faces cut through each other, the first at (-2, 0, 0)",
                          "the normals point into the solid"));
}

}  // namespace

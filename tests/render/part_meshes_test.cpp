#include "app/render/part_meshes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Index;
using Eigen::Vector3d;

const double kRoundOff = support::tolerance(1e-12);

double length_of(const Eigen::Matrix3Xd& points) {
  double length = 0;
  for (Index i = 1; i < points.cols(); ++i) length += (points.col(i) - points.col(i - 1)).norm();
  return length;
}

/// Volume inside a closed mesh by the divergence theorem [m^3].
double volume_of(const hydro::TriMesh& mesh) {
  double volume = 0;
  for (Index f = 0; f < mesh.face_count(); ++f)
    volume += hydro::area_vector(mesh, f).dot(mesh.vertices.col(mesh.faces(0, f))) / 3;
  return volume;
}

/// The sum of area vectors, zero for a closed mesh.
Vector3d open_area(const hydro::TriMesh& mesh) {
  Vector3d sum = Vector3d::Zero();
  for (Index f = 0; f < mesh.face_count(); ++f) sum += hydro::area_vector(mesh, f);
  return sum;
}

TEST(Helix, HasTheLengthOfItsTurns) {
  const Vector3d from(1, -2, 3), to(4, 2, 3);
  const double radius = 0.4;
  const int turns = 9;
  const Eigen::Matrix3Xd points = render::helix(from, to, radius, turns);
  EXPECT_EQ(points.leftCols<1>(), from);
  EXPECT_EQ(points.rightCols<1>(), to);
  // Eight tenths of the distance of 5 m are coil; a straight end and a spoke lie on either side.
  const double coil = std::hypot(2 * M_PI * radius * turns, 4.0);
  // Chords of sixteen to a turn fall short of the arc by 1 − sinc(π/16) = 0.64 % at most.
  EXPECT_NEAR(length_of(points), coil + 2 * 0.5 + 2 * radius, support::tolerance(0.0065) * coil);
  EXPECT_LT(length_of(points), coil + 2 * 0.5 + 2 * radius);
}

TEST(Helix, LiesOnItsCylinder) {
  const Vector3d from(1, -2, 3), to(-4, 2, 5), along = (to - from).normalized();
  const Eigen::Matrix3Xd points = render::helix(from, to, 0.3, 5);
  for (Index i = 2; i < points.cols() - 2; ++i) {
    const Vector3d r = points.col(i) - from;
    EXPECT_NEAR((r - r.dot(along) * along).norm(), 0.3, kRoundOff);
  }
}

TEST(Helix, BetweenEqualEndsIsARing) {
  const Eigen::Matrix3Xd points = render::helix({1, 2, 3}, {1, 2, 3}, 0.5, 3);
  EXPECT_TRUE(points.allFinite());
}

TEST(TubeMesh, OfAStraightLineIsAPrism) {
  support::Random random(3);
  const Vector3d from = random.vector(3), to = random.vector(3);
  Eigen::Matrix3Xd ends(3, 2);
  ends << from, to;
  const hydro::TriMesh mesh = render::tube_mesh(ends, 0.2);
  const double area = 0.5 * render::kTubeSides * 0.04 * std::sin(2 * M_PI / render::kTubeSides);
  EXPECT_NEAR(volume_of(mesh), area * (to - from).norm(), kRoundOff);
  EXPECT_LE(open_area(mesh).norm(), kRoundOff);
}

TEST(TubeMesh, SurvivesDoublePointsAndALineThatTurnsBack) {
  Eigen::Matrix3Xd points(3, 5);
  points << 0, 0, 0, 0, 0,  //
      0, 0, 0, 0, 0,        //
      2, 0, 0, 0, 2;
  const hydro::TriMesh mesh = render::tube_mesh(points, 0.1);
  EXPECT_EQ(mesh.vertex_count(), 3 * render::kTubeSides);
  EXPECT_TRUE(mesh.vertices.allFinite());
  EXPECT_EQ(render::tube_mesh(points.leftCols<0>(), 0.1).face_count(), 0);
}

TEST(ScrewMesh, DrivesAheadAsItTurnsByTheRightHandRule) {
  for (const bool right_handed : {true, false}) {
    const hydro::TriMesh mesh = render::screw_mesh({.diameter = 3,
                                                    .blades = 4,
                                                    .area_ratio = 0.6,
                                                    .pitch_ratio = 1,
                                                    .right_handed = right_handed});
    EXPECT_GT(volume_of(mesh), 0);
    EXPECT_LE(open_area(mesh).norm(), kRoundOff);
    // Where a blade's face looks astern (n_x < 0) it moves toward the water there as it turns: a
    // thrust of the sign of the turn. Sum n_x n_t over the surface, t along the turn.
    double product = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const Vector3d a = hydro::area_vector(mesh, f);
      const Vector3d at = mesh.vertices.col(mesh.faces(0, f));
      const double r = std::hypot(at.y(), at.z());
      if (r < 0.5 || a.norm() == 0) continue;
      const Vector3d along = Vector3d::UnitX().cross(at) / r;
      product += a.x() * a.dot(along) / a.norm();
    }
    EXPECT_LT(right_handed ? product : -product, -0.1);
  }
}

TEST(ScrewMesh, FillsItsDisc) {
  const hydro::TriMesh mesh = render::screw_mesh({.diameter = 3, .blades = 5});
  const double reach = mesh.vertices.bottomRows<2>().colwise().norm().maxCoeff();
  EXPECT_NEAR(reach, 1.5, support::tolerance(0.01));
  EXPECT_LT(mesh.vertices.row(0).cwiseAbs().maxCoeff(), 0.75);
}

TEST(WingMesh, HasTheQuarterPointOfItsChordAtTheOrigin) {
  const hydro::TriMesh mesh = render::wing_mesh(4, 2, 0.15);
  const Eigen::AlignedBox3d box = hydro::bounding_box(mesh);
  EXPECT_NEAR(box.max().x(), 0.5, kRoundOff);
  EXPECT_NEAR(box.min().x(), -1.5, kRoundOff);
  EXPECT_NEAR(box.max().z(), 2, kRoundOff);
  EXPECT_NEAR(box.min().z(), -2, kRoundOff);
  // The section is symmetric and 15 % thick; the polygon of its points misses the thickest place.
  EXPECT_NEAR(box.sizes().y(), 0.3, support::tolerance(0.005));
  EXPECT_NEAR(box.center().y(), 0, kRoundOff);
  EXPECT_GT(volume_of(mesh), 0);
  EXPECT_LE(open_area(mesh).norm(), kRoundOff);
}

TEST(AnchorMesh, HasItsSizeAndItsRingAtTheOrigin) {
  const hydro::TriMesh mesh = render::anchor_mesh(2);
  EXPECT_GT(volume_of(mesh), 0);
  EXPECT_LE(open_area(mesh).norm(), kRoundOff);
  const Eigen::AlignedBox3d box = hydro::bounding_box(mesh);
  EXPECT_NEAR(box.min().x(), -2.1, support::tolerance(0.1));
  EXPECT_NEAR(box.max().x(), 0.25, support::tolerance(0.1));
}

}  // namespace

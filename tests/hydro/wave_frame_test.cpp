#include "hydro/radiation/wave_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/mesh/mesh.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"

namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using hydro::Matrix6d;
using hydro::MeanPose;
using hydro::Vector6d;
using hydro::WaveFrame;
using hydro::WaveFrameRule;
using Slides = WaveFrameRule::Slides;

/// Added mass about a point c from where it has no coupling, in the axes of H.
Matrix6d about(const Vector3d& c, const Vector6d& diagonal) {
  return WaveFrame{.origin = c}.tensor_out(Matrix6d(diagonal.asDiagonal()));
}
Vector6d six(double a, double b, double c, double d, double e, double f) {
  return (Vector6d() << a, b, c, d, e, f).finished();
}

Quaterniond about_z(double angle) { return Quaterniond(AngleAxisd(angle, Vector3d::UnitZ())); }

/// A mesh whose origin, the centre of mass, lies `c` below or beside its middle, as seen from H.
Eigen::Matrix3Xd vertices(const hydro::TriMesh& mesh, const Quaterniond& R_HB, const Vector3d& c) {
  return (R_HB.conjugate().toRotationMatrix() *
          ((R_HB.toRotationMatrix() * mesh.vertices).colwise() + c))
      .eval();
}

TEST(WaveFrame, OfAShipTurnsWithIt) {
  const hydro::TriMesh box = hydro::make_box({10, 2, 1}, 4);
  const MeanPose pose{.orientation = Quaterniond(AngleAxisd(0.1, Vector3d::UnitY()))};
  // A roll of a box of this section moves a twelfth of what sway does, in beams.
  const WaveFrameRule rule(pose, box.vertices, about(Vector3d::Zero(), six(1, 8, 20, 3, 150, 60)));
  EXPECT_EQ(rule.slides(), Slides::none);
  EXPECT_TRUE(rule.turns_water());
  const Quaterniond turn = about_z(0.8) * Quaterniond(AngleAxisd(0.7, Vector3d::UnitX()));
  const WaveFrame frame = rule.at(turn * pose.orientation);
  EXPECT_LT(frame.R_WH.angularDistance(turn), 1e-12);
  EXPECT_EQ(frame.origin, Vector3d::Zero());
}

TEST(WaveFrame, HeadingIsTheTurnAboutTheVertical) {
  for (const double turn : {-3.0, 0.7, 3.1}) {
    EXPECT_NEAR(WaveFrame{.R_WH = about_z(turn)}.heading(), turn, 1e-14);
    // A small roll about any horizontal axis does not change it.
    const Quaterniond roll(AngleAxisd(0.2, Vector3d(0.6, 0.8, 0)));
    EXPECT_NEAR(WaveFrame{.R_WH = roll * about_z(turn)}.heading(), turn, 1e-14);
  }
}

// A ball with ballast below its middle: H stays upright however it rolls, at the height and place
// where the centre of mass hangs at rest.
TEST(WaveFrame, OfABallStaysUprightBelowItsMiddle) {
  const hydro::TriMesh ball = hydro::make_icosphere(1, 3);
  support::Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Quaterniond R_HB = random.rotation();
    const MeanPose pose{.orientation = R_HB};
    const Vector3d middle(0.1, -0.05, 0.4);
    const WaveFrameRule rule(pose, vertices(ball, R_HB, middle),
                             about(middle, six(0.3, 0.3, 0.5, 0, 0, 0)));
    ASSERT_EQ(rule.slides(), Slides::all);
    EXPECT_FALSE(rule.turns_water());
    const Quaterniond turn = random.rotation();
    const WaveFrame frame = rule.at(turn * R_HB);
    EXPECT_LT(frame.R_WH.angularDistance(Quaterniond::Identity()), 1e-12);
    EXPECT_LT((frame.origin + middle - turn * middle).norm(), 1e-12);
  }
}

TEST(WaveFrame, OfASparTurnsWithItThoughTurnsAboutTheVerticalMoveNoWater) {
  const hydro::TriMesh spar = hydro::make_cylinder(1, 20, 32, 8);
  const Vector3d middle(0, 0, 3);
  const Matrix6d A = about(middle, six(60, 60, 2, 800, 800, 0));
  const WaveFrameRule rule({}, vertices(spar, Quaterniond::Identity(), middle), A);
  EXPECT_EQ(rule.slides(), Slides::none);
  EXPECT_FALSE(rule.turns_water());
}

TEST(WaveFrame, OfALogTurnsWithItsAxisAlone) {
  const hydro::TriMesh log = hydro::make_cylinder(0.5, 8, 32, 8);
  // The cylinder stands along B's z; in its mean pose it lies at 0.4 rad from H's x axis.
  const Quaterniond R_HB = about_z(0.4) * Quaterniond(AngleAxisd(M_PI / 2, Vector3d::UnitY()));
  const MeanPose pose{.orientation = R_HB};
  const Vector3d middle(0, 0, 0.1);
  Matrix6d A =
      WaveFrame{.R_WH = about_z(0.4)}.tensor_out(Matrix6d(six(0.2, 3, 4, 0, 20, 15).asDiagonal()));
  A = WaveFrame{.origin = middle}.tensor_out(A);
  const WaveFrameRule rule(pose, vertices(log, R_HB, middle), A);
  ASSERT_EQ(rule.slides(), Slides::about_axis);
  EXPECT_FALSE(rule.turns_water());
  const Vector3d along = about_z(0.4) * Vector3d::UnitX();
  const Quaterniond roll(AngleAxisd(2, along)), yaw = about_z(1.1);
  const Quaterniond pitch(AngleAxisd(0.3, about_z(0.4) * Vector3d::UnitY()));
  const WaveFrame frame = rule.at(yaw * pitch * roll * R_HB);
  EXPECT_LT(frame.R_WH.angularDistance(yaw * pitch), 1e-12);
  EXPECT_LT((frame.origin + yaw * pitch * middle - yaw * pitch * roll * middle).norm(), 1e-12);
}

// The power of a load is the same in both frames, and tensors are those of loads and velocities.
TEST(WaveFrame, CarriesVelocitiesInAndLoadsOut) {
  support::Random random(2);
  for (int i = 0; i < 20; ++i) {
    const WaveFrame frame{.R_WH = random.rotation(), .origin = random.vector(2)};
    Vector6d u, load;
    u << random.vector(1), random.vector(1);
    load << random.vector(1), random.vector(1);
    EXPECT_NEAR(frame.velocity_in(u).dot(load), u.dot(frame.load_out(load)), 1e-13);
    const Matrix6d tensor = load * load.transpose();
    EXPECT_LT((frame.tensor_out(tensor) * u - frame.load_out(tensor * frame.velocity_in(u))).norm(),
              1e-12);
  }
}

}  // namespace

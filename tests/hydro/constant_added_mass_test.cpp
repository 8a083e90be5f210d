#include "hydro/added_mass/constant_added_mass.h"

#include <gtest/gtest.h>

#include "hydro/airy_waves.h"
#include "hydro/mesh/primitives.h"

namespace {

using Eigen::Vector3d;
using hydro::BodyState;
using hydro::ConstantAddedMass;
using hydro::Matrix6d;
using hydro::Sea;

Matrix6d some_matrix() {
  Matrix6d matrix = hydro::Vector6d(1, 2, 3, 4, 5, 6).asDiagonal();
  matrix(0, 4) = matrix(4, 0) = -0.5;
  return matrix;
}

TEST(ConstantAddedMass, IsAsGivenWhileAnyOfTheBodyIsWet) {
  const ConstantAddedMass model(hydro::make_box({2, 2, 2}, 1), some_matrix());
  for (const double z : {-5.0, 0.0, 0.999999}) {
    EXPECT_EQ(model.at({.position = {0, 0, z}}, {.density = 500}, 0), some_matrix()) << z;
    EXPECT_EQ(model.at({.position = {0, 0, z + 7}}, {.level = 7}, 0), some_matrix()) << z;
  }
  EXPECT_EQ(model.at({.position = {0, 0, 1}}, Sea{}, 0), Matrix6d::Zero());
  EXPECT_EQ(model.at({.position = {0, 0, 9}}, Sea{}, 0), Matrix6d::Zero());
  // On edge the box reaches √2 down.
  const Eigen::Quaterniond heel(Eigen::AngleAxisd(M_PI / 4, Vector3d::UnitX()));
  EXPECT_EQ(model.at({.position = {0, 0, 1.41}, .orientation = heel}, Sea{}, 0), some_matrix());
  EXPECT_EQ(model.at({.position = {0, 0, 1.42}, .orientation = heel}, Sea{}, 0), Matrix6d::Zero());
}

TEST(ConstantAddedMass, SeesACrestBetweenTheCornersOfAFace) {
  // A wave of 2 m with its crest under the middle of the bottom, troughs at the corners.
  const ConstantAddedMass model(hydro::make_box({2, 2, 2}, 1), some_matrix());
  Sea sea;
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.2, 2, 0, 0, sea.gravity)}};
  EXPECT_EQ(model.at({.position = {0, 0, 1.19}}, sea, 0), some_matrix());
  EXPECT_EQ(model.at({.position = {0, 0, 1.21}}, sea, 0), Matrix6d::Zero());
  EXPECT_EQ(model.at({.position = {1, 0, 1.19}}, sea, 0), some_matrix());
  // Half a wave further the crest runs through the corners.
  EXPECT_TRUE(hydro::is_wet(hydro::make_hull(hydro::make_box({2, 2, 2}, 1)),
                            {.position = {1, 0, 1.19}}, sea, 0));
}

TEST(ConstantAddedMass, HasNoNegativeEigenvalues) {
  Matrix6d matrix = some_matrix();
  matrix(2, 2) = -1e-12;
  const ConstantAddedMass model(hydro::make_box({2, 2, 2}, 1), matrix);
  EXPECT_GE(model.matrix()(2, 2), 0);
  EXPECT_LT((model.matrix() - matrix).cwiseAbs().maxCoeff(), 2e-12);
}

}  // namespace

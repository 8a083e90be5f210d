#include "engine/contacts/ode_handles.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <thread>

#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using support::tolerance;

/// From ODE's dMatrix3: three rows of four numbers.
Eigen::Matrix3d from_ode(const double* m) {
  Eigen::Matrix3d matrix;
  for (int row = 0; row < 3; ++row) matrix.row(row) << m[4 * row], m[4 * row + 1], m[4 * row + 2];
  return matrix;
}

TEST(Conversions, AgreeWithTheLayoutOfTheLibrary) {
  engine::open_ode();
  support::Random random(7);
  const Eigen::Quaterniond q = random.rotation();
  dMatrix3 matrix;
  dQtoR(engine::to_ode(q).data(), matrix);
  EXPECT_LT((from_ode(matrix) - q.toRotationMatrix()).norm(), tolerance(1e-15));
}

TEST(Conversions, ThereAndBackChangeNothing) {
  support::Random random(8);
  const Eigen::Quaterniond q = random.rotation();
  const Eigen::Matrix3d matrix = q.toRotationMatrix();
  EXPECT_EQ(from_ode(engine::to_ode(matrix).data()), matrix);
  EXPECT_EQ(engine::quaternion_from_ode(engine::to_ode(q).data()).coeffs(), q.coeffs());
}

TEST(Faults, OfTheLibraryAreThrownOutOfIt) {
  engine::open_ode();
  EXPECT_THROW(dError(1, "number %d", 5), engine::OdeFault);
  try {
    dDebug(2, "number %d", 5);
    FAIL();
  } catch (const engine::OdeFault& fault) {
    EXPECT_STREQ(fault.what(), "ODE: number 5");
  }
}

TEST(Warnings, AreKeptUntilTaken) {
  engine::open_ode();
  dMessage(3, "number %d", 6);
  EXPECT_EQ(engine::take_ode_warning(), "number 6");
  EXPECT_EQ(engine::take_ode_warning(), "");
}

TEST(Library, CanBeOpenedOnEveryThread) {
  engine::open_ode();
  engine::open_ode();
  bool opened = false;
  std::thread([&opened] {
    engine::open_ode();
    opened = true;
  }).join();
  EXPECT_TRUE(opened);
}

}  // namespace

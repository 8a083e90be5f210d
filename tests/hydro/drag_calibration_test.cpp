#include "hydro/loads/drag_calibration.h"

#include <gtest/gtest.h>

#include "hydro/loads/loads.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::PressureDrag;

constexpr double kDensity = 1000;

/// The pressure drag of a wholly submerged body in a given motion, body axes.
hydro::Wrench drag(const hydro::TriMesh& mesh, const hydro::Coefficients& coefficients,
                   const Vector3d& velocity, const Vector3d& angular_velocity = Vector3d::Zero()) {
  const hydro::BodyState state{
      .position = {0, 0, -100}, .linear_velocity = velocity, .angular_velocity = angular_velocity};
  return hydro::compute_loads(hydro::make_hull(mesh), state, {.density = kDensity}, 0, coefficients)
      .pressure_drag;
}

hydro::Coefficients calibrated(const hydro::TriMesh& mesh, const Vector3d& tabulated) {
  hydro::Coefficients c{.pressure_drag = {0.7, 0.3}};
  c.calibration = hydro::calibrate_drag(mesh, c.pressure_drag, tabulated);
  return c;
}

TEST(FrontalArea, OfABoxIsItsSide) {
  const hydro::TriMesh box = hydro::make_box({2, 3, 5}, 3);
  EXPECT_NEAR(hydro::frontal_area(box, 0), 15, 1e-10);
  EXPECT_NEAR(hydro::frontal_area(box, 1), 10, 1e-10);
  EXPECT_NEAR(hydro::frontal_area(box, 2), 6, 1e-10);
}

TEST(FrontalArea, OfAConvexBodyIsHalfOfItsProjectedSurface) {
  const hydro::TriMesh mesh = hydro::make_icosphere(1.3, 3);
  for (int axis = 0; axis < 3; ++axis) {
    double projected = 0;
    for (Eigen::Index face = 0; face < mesh.face_count(); ++face)
      projected += 0.5 * std::abs(hydro::area_vector(mesh, face)[axis]);
    EXPECT_NEAR(hydro::frontal_area(mesh, axis) / projected, 1, support::tolerance(1e-6));
  }
}

TEST(FrontalArea, CountsWhatStandsBehindOnce) {
  const hydro::TriMesh box = hydro::make_box({1, 1, 1});
  const hydro::TriMesh two = support::united(box, hydro::translated(box, {3, 0.5, 0}));
  // An edge may be off by one scan line of the 4,096, for each box.
  EXPECT_NEAR(hydro::frontal_area(two, 0), 1.5, support::tolerance(5e-4));
  EXPECT_NEAR(hydro::frontal_area(two, 2), 2, support::tolerance(1e-3));
}

TEST(DragCalibration, GivesTheTabulatedDragAlongEachAxisWhateverTheMesh) {
  support::Random random(51);
  const Vector3d tabulated(1.1, 0.4, 0.9);
  for (const hydro::TriMesh& mesh :
       {hydro::make_box({1, 2, 3}), hydro::make_box({1, 2, 3}, 7), support::random_star(random)}) {
    const hydro::Coefficients c = calibrated(mesh, tabulated);
    for (int axis = 0; axis < 3; ++axis) {
      const double v = 2.5;
      const double area = hydro::frontal_area(mesh, axis);
      const double ahead = -drag(mesh, c, v * Vector3d::Unit(axis)).force[axis];
      const double astern = drag(mesh, c, -v * Vector3d::Unit(axis)).force[axis];
      EXPECT_NEAR((ahead + astern) / 2 / (0.5 * kDensity * area * v * v), tabulated[axis],
                  support::tolerance(1e-12));
    }
  }
}

TEST(DragCalibration, WithThePanelsOwnDragChangesNothing) {
  support::Random random(52);
  const hydro::TriMesh mesh = support::random_star(random);
  const hydro::Coefficients plain{.pressure_drag = {0.7, 0.3}};
  Vector3d own;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d e = Vector3d::Unit(axis);
    own[axis] = (-drag(mesh, plain, e).force[axis] + drag(mesh, plain, -e).force[axis]) /
                (kDensity * hydro::frontal_area(mesh, axis));
  }
  const hydro::Coefficients c = calibrated(mesh, own);
  for (int i = 0; i < 10; ++i) {
    const Vector3d v = random.vector(3), w = random.vector(3);
    const hydro::Wrench a = drag(mesh, plain, v, w);
    const hydro::Wrench b = drag(mesh, c, v, w);
    EXPECT_LT((a.force - b.force).norm(), support::tolerance(1e-12) * a.force.norm());
    EXPECT_LT((a.moment - b.moment).norm(), support::tolerance(1e-12) * a.force.norm());
  }
}

TEST(DragCalibration, MixesItsFactorsBetweenTheAxes) {
  const hydro::DragCalibration c =
      hydro::calibrate_drag(hydro::make_box({1, 1, 1}), {0.5, 0.5}, {0.5, 1, 2});
  // A cube's panels have C_d = 1, so the factors are the tabulated values themselves.
  EXPECT_NEAR((c.factor - Vector3d(0.5, 1, 2)).norm(), 0, 1e-12);
  EXPECT_NEAR(hydro::drag_factor(c, {.linear = {3, 3, 0}}), 0.75, 1e-12);
  EXPECT_NEAR(hydro::drag_factor(c, {.linear = {1, 2, 2}}), (0.5 + 4 + 8) / 9, 1e-12);
  // Turning about z moves the surface along x and y alike.
  EXPECT_NEAR(hydro::drag_factor(c, {.angular = {0, 0, 4}}), 0.75, 1e-12);
  EXPECT_EQ(hydro::drag_factor(c, {}), 1);
}

TEST(DragCalibration, RefusesABodyWithoutDragToScale) {
  EXPECT_THROW(hydro::calibrate_drag(hydro::make_box({1, 1, 1}), {0, 0}, {1, 1, 1}),
               std::invalid_argument);
}

TEST(PressureDrag, HasItsOwnCoefficientInFrontAndBehind) {
  // A cube face on: the front gives front·A, the back back·A.
  const hydro::TriMesh cube = hydro::make_box({2, 2, 2});
  const hydro::Coefficients c{.pressure_drag = {0.9, 0.2}};
  EXPECT_NEAR(drag(cube, c, {3, 0, 0}).force.x(), -0.5 * kDensity * (0.9 + 0.2) * 4 * 9, 1e-8);
  const hydro::Coefficients front{.pressure_drag = {0.9, 0}};
  EXPECT_NEAR(drag(cube, front, {-3, 0, 0}).force.x(), 0.5 * kDensity * 0.9 * 4 * 9, 1e-8);
}

}  // namespace

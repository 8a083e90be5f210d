#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/SVD>

#include "hydro/added_mass/surface_added_mass.h"
#include "hydro/added_mass/surface_solve.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/tolerance.h"
#include "tests/support/water_planes.h"

/// How near the interpolated added mass at the surface comes to the solutions it stands for.

namespace hydro {
namespace {

using Eigen::Vector3d;
using support::plane_at;
using support::Random;
using support::tolerance;

/// Of solutions in tests that are about the grid, not about their accuracy.
constexpr int kFewPatches = 40;

TriMesh barge() { return make_box({4, 2, 1}, 2); }

/// The largest |x·ΔA·y| over vectors of one in the scale of the whole body's A and a tenth of its
/// displaced fluid's inertia, as the deep solution's error is told.
double error_of(const Matrix6d& difference, const TriMesh& mesh_B, int patches) {
  const SolidProperties solid = solid_properties(mesh_B);
  Matrix6d scale = solve_under(mesh_B, {}, patches).matrix;
  scale.topLeftCorner<3, 3>() += 0.1 * solid.volume * Eigen::Matrix3d::Identity();
  scale.bottomRightCorner<3, 3>() += 0.1 * solid.inertia;
  const Matrix6d root = Matrix6d(scale.llt().matrixL()).inverse();
  return Eigen::JacobiSVD<Matrix6d>(root * difference * root.transpose()).singularValues()[0];
}

// The error of a linear interpolation of cos 2θ, as a body's anisotropy goes, over steps of up to
// 12.5° is h²/8 · 4 = 2.4 % of its amplitude. A single pose of a sharp body may have twice that,
// where a whole edge goes under within a step.
TEST(SurfaceAddedMass, InterpolationErrorIsSmall) {
  Random random(5);
  for (const TriMesh& mesh : {make_ellipsoid({2, 1, 1}, 24, 12), barge()}) {
    const SurfaceAddedMass model(mesh, {}, 120);
    double sum = 0, worst = 0;
    constexpr int kPoses = 12;
    for (int i = 0; i < kPoses; ++i) {
      const WaterPlane plane =
          plane_at(mesh, random.vector(1).normalized(), random.uniform(0.1, 1.2));
      const Matrix6d difference =
          model.under(plane) - solve_under(mesh, model.risen(plane), 120).matrix;
      const double error = error_of(difference, mesh, 120);
      sum += error;
      worst = std::max(worst, error);
    }
    EXPECT_LT(sum / kPoses, tolerance(0.024));
    EXPECT_LT(worst, tolerance(2 * 0.024));
  }
}

// Over 0.2 mm the matrix may change by its slope: it changes by its own size over about a metre.
TEST(SurfaceAddedMass, ChangesWithoutJumps) {
  const TriMesh mesh = barge();
  const SurfaceAddedMass model(mesh, {}, kFewPatches);
  const double scale = model.under({}).norm();
  const Vector3d up = Vector3d(0.3, 0.2, 1).normalized();
  Matrix6d before = model.under(plane_at(mesh, up, 0.95));
  for (int i = 1; i <= 1000; ++i) {
    const Matrix6d A = model.under(plane_at(mesh, up, 0.95 + 1e-4 * i));
    EXPECT_LT((A - before).norm(), tolerance(5e-3 * scale)) << i;
    before = A;
  }
}

// Added mass grows with draught: the potential, taken as 0 above the water, is one that a higher
// surface allows as well. A flat ellipsoid meets the surface at small angles, where the solution
// alone fails. Interpolation keeps it; solutions may break it by their error of 1 %.
TEST(SurfaceAddedMass, HeaveOfAFlatBodyGrowsWithDraught) {
  const TriMesh mesh = make_ellipsoid({2, 2, 0.3}, 48, 24);
  const SurfaceAddedMass model(mesh, {}, 120);
  const double whole = model.under({})(2, 2);
  double before = 0;
  for (int i = 1; i <= 50; ++i) {
    const double heave = model.under(plane_at(mesh, Vector3d::UnitZ(), 0.04 * i))(2, 2);
    EXPECT_GE(heave, before - tolerance(0.01 * whole)) << i;
    EXPECT_LE(heave, (1 + tolerance(0.01)) * whole) << i;
    before = heave;
  }
}

// Beyond all depths there is one node: the body in unbounded fluid.
TEST(SurfaceAddedMass, DeepBodyTendsToTheUnboundedOne) {
  const TriMesh mesh = barge();
  const SurfaceAddedMass model(mesh, {}, kFewPatches);
  const Matrix6d whole = solve_under(mesh, {}, kFewPatches).matrix;
  const Matrix6d deep = model.under({Vector3d(0.6, 0, 0.8), 100});
  EXPECT_LT((deep - whole).norm(), tolerance(1e-4 * whole.norm()));
}

}  // namespace
}  // namespace hydro

#include "hydro/loads/bluntness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/loads/clip.h"
#include "hydro/loads/loads.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using hydro::BodyState;
using hydro::Coefficients;
using hydro::Hull;
using hydro::TriMesh;
using support::tolerance;

/// The bluntness from which on no test's blunt body is spared drag.
constexpr double kBlunt = 0.30;

/// A spheroid about x, `ratio` times as long as its diameter of 1 m.
TriMesh spheroid(double ratio) { return hydro::make_ellipsoid({0.5 * ratio, 0.5, 0.5}, 96, 96); }

Matrix3d shape_of(const TriMesh& mesh) { return hydro::drag_shape(hydro::bluntness(mesh), kBlunt); }

/// w along the mesh's axis nearest to e_x.
double bluntness_along_x(const TriMesh& mesh) {
  const hydro::Bluntness b = hydro::bluntness(mesh);
  Eigen::Index nearest;
  b.axes.row(0).cwiseAbs().maxCoeff(&nearest);
  return b.along[nearest];
}

/// With e = (a/b)², n_x² is (1 − s)/(1 − s + s e) at the part s of the frontal area.
double spheroid_bluntness(double ratio) {
  const double e = ratio * ratio;
  return ratio == 1 ? 0.5 : (e * std::log(e) - (e - 1)) / ((e - 1) * (e - 1));
}

TEST(Bluntness, OfSpheroidsIsThatOfTheClosedForm) {
  // The facets' normals depart from those of the surface by 2 % of a radian: a few thousandths.
  for (const double ratio : {1.0, 2.0, 4.0, 8.0})
    EXPECT_NEAR(bluntness_along_x(spheroid(ratio)), spheroid_bluntness(ratio), tolerance(2e-3))
        << ratio;
}

TEST(Bluntness, OfCylindersIsOneAlongAndTwoThirdsAcross) {
  const hydro::Bluntness b = hydro::bluntness(hydro::make_cylinder(0.5, 4, 240, 2));
  for (int i = 0; i < 3; ++i) {
    const bool along = std::abs(b.axes(2, i)) > 0.5;
    EXPECT_NEAR(b.along[i], along ? 1 : 2.0 / 3, tolerance(2e-4));
  }
}

TEST(Bluntness, OfBoxesIsOneAlongEachAxis) {
  for (const double length : {1.0, 3.0}) {
    const hydro::Bluntness b = hydro::bluntness(hydro::make_box({length, 1, 1}));
    EXPECT_LT((b.along - Vector3d::Ones()).norm(), tolerance(1e-12));
    EXPECT_LT((b.axes.cwiseAbs().rowwise().maxCoeff() - Vector3d::Ones()).norm(), tolerance(1e-7));
  }
}

TEST(DragShape, SparesNoBluntBody) {
  for (const TriMesh& mesh :
       {hydro::make_icosphere(1, 3), hydro::make_sphere(1, 12, 12), hydro::make_box({4, 1, 0.2}),
        hydro::make_cylinder(0.5, 8, 24, 8), support::make_torus(1, 0.3, 24, 12), TriMesh{}})
    EXPECT_EQ(shape_of(mesh), Matrix3d::Identity());
}

TEST(DragShape, OfZeroBluntnessAskedForIsUnity) {
  EXPECT_EQ(hydro::drag_shape(hydro::bluntness(spheroid(8)), 0), Matrix3d::Identity());
}

TEST(DragShape, TurnsWithTheMesh) {
  support::Random random(91);
  const TriMesh mesh = hydro::make_ellipsoid({4, 1, 0.4}, 24, 24);
  const Matrix3d K = shape_of(mesh);
  EXPECT_LT(K(0, 0), 0.5);
  for (int i = 0; i < 10; ++i) {
    const Matrix3d R = random.rotation().toRotationMatrix();
    TriMesh turned = mesh;
    turned.vertices = R * mesh.vertices;
    // The tie-break of 1e-9 turns the axes by 1e-9 over the distance of the eigenvalues.
    EXPECT_LT((shape_of(turned) - R * K * R.transpose()).norm(), tolerance(1e-7));
  }
}

/// Drag of a spheroid of 8:1 over ½ρAv² in flow at an angle to its axis, body axes.
/// A sphere of 1 m whose upper and lower halves are drawn out, the lower one cut off flat where its
/// section has the given part of the largest, at the nearest row of vertices.
TriMesh drawn_out(double above, double below, double part) {
  TriMesh mesh = spheroid(1);
  const double row = M_PI / 96, angle = row * std::round(std::asin(std::sqrt(part)) / row);
  for (auto v : mesh.vertices.colwise())
    v.z() = std::max(v.z(), -0.5 * std::cos(angle)) * (v.z() < 0 ? below : above);
  return mesh;
}

// With the flow closed behind it, a round bow costs no more than a fine one, and a transom its part
// of what a flat end does.
TEST(DragShape, IsThatOfTheFinerEnd) {
  EXPECT_NEAR(shape_of(drawn_out(1, 4, 0))(2, 2), spheroid_bluntness(4) / kBlunt, tolerance(0.01));
  EXPECT_NEAR(shape_of(drawn_out(1, 4, 0))(1, 1), 1, tolerance(1e-12));
  EXPECT_NEAR(std::pow(shape_of(drawn_out(4, 4, 0.12))(2, 2), 3), 0.12, tolerance(5e-3));
}

TEST(DragShape, OfABodyWithABluntEndAndNoFineOneIsUnity) {
  EXPECT_EQ(shape_of(drawn_out(1, 1, 0)), Matrix3d::Identity());
  EXPECT_EQ(shape_of(drawn_out(1, 1, 1)), Matrix3d::Identity());
}

Vector3d drag_of_spheroid(const Matrix3d& K, double angle) {
  const Hull hull = hydro::make_hull(spheroid(8));
  Coefficients c{.drag_shape = K};
  const double speed = 2;
  const BodyState state{.position = {0, 0, -20},
                        .linear_velocity = speed * Vector3d(std::cos(angle), std::sin(angle), 0)};
  const hydro::Sea sea;
  return hydro::compute_loads(hull, state, sea, 0, c).pressure_drag.force /
         (-0.5 * sea.density * speed * speed * M_PI / 4);
}

TEST(DragShape, CubesTheDragAlongASlenderAxis) {
  const Matrix3d K = shape_of(spheroid(8));
  EXPECT_NEAR(K(0, 0), spheroid_bluntness(8) / kBlunt, tolerance(2e-3));
  const double plain = drag_of_spheroid(Matrix3d::Identity(), 0).x();
  EXPECT_NEAR(drag_of_spheroid(K, 0).x(), std::pow(K(0, 0), 3) * plain, tolerance(1e-12));
}

TEST(DragShape, KeepsTheCrossFlow) {
  const Matrix3d K = shape_of(spheroid(8));
  const Vector3d across = drag_of_spheroid(Matrix3d::Identity(), M_PI / 2);
  EXPECT_LT((drag_of_spheroid(K, M_PI / 2) - across).norm(), tolerance(1e-6 * across.norm()));
  // The cross-flow principle has sin² of the angle of it; without K there is half as much again.
  const double angle = 10 * M_PI / 180;
  const double principle = std::pow(std::sin(angle), 2) * across.y();
  EXPECT_NEAR(drag_of_spheroid(K, angle).y(), principle, tolerance(0.03 * principle));
  EXPECT_GT(drag_of_spheroid(Matrix3d::Identity(), angle).y(), 1.3 * principle);
}

/// ½ρ ∫ C_p |u|³ dS over the wetted surface: u is linear on a panel, and the mean of the cube of a
/// linear function is a tenth of the sum of its vertex values' products of three, each once.
double power_taken(const Hull& hull, const BodyState& state, const hydro::Sea& sea,
                   const Coefficients& c) {
  const Matrix3d R = state.orientation.toRotationMatrix();
  const Matrix3d K = R * c.drag_shape * R.transpose();
  double sum = 0;
  for (const auto& face : hull.mesh_B.faces.colwise()) {
    const hydro::Panel panel = {R * hull.mesh_B.vertices.col(face[0]),
                                R * hull.mesh_B.vertices.col(face[1]),
                                R * hull.mesh_B.vertices.col(face[2])};
    Vector3d depth;
    for (int i = 0; i < 3; ++i) depth[i] = sea.level - state.position.z() - panel[i].z();
    const Vector3d n = hydro::area_vector(panel).normalized();
    for (const hydro::PanelPart& wet : hydro::positive_part(panel, depth)) {
      Vector3d u;
      for (int i = 0; i < 3; ++i)
        u[i] = n.dot(K * state.linear_velocity + state.angular_velocity.cross(wet.panel[i]));
      for (const double sign : {1.0, -1.0})
        for (const hydro::PanelPart& part : hydro::positive_part(wet.panel, sign * u)) {
          const auto& [f, g, h] = std::tuple(part.value[0], part.value[1], part.value[2]);
          const double mean =
              (f * f * (f + g + h) + g * g * (f + g + h) + h * h * (f + g + h) + f * g * h) / 10;
          const double C_p = sign > 0 ? c.pressure_drag.front : c.pressure_drag.back;
          sum += 0.5 * sea.density * C_p * mean * hydro::area_vector(part.panel).norm();
        }
    }
  }
  return sum;
}

TEST(DragShape, LetsPressureDragTakeThePowerOfTheCubeOfTheNormalSpeed) {
  support::Random random(92);
  const Hull hull = hydro::make_hull(hydro::make_ellipsoid({2, 0.5, 0.3}, 24, 24));
  for (int i = 0; i < 40; ++i) {
    BodyState state = random.state(0.4, 2);
    // Turning and moving are of the same speed, or one of them is far slower.
    state.angular_velocity *= std::pow(10, random.uniform(-4, 4));
    const Coefficients c{.drag_shape = i % 2 ? random.drag_shape() : shape_of(hull.mesh_B)};
    const hydro::Sea sea;
    const hydro::Wrench drag = hydro::compute_loads(hull, state, sea, 0, c).pressure_drag;
    const double linear = drag.force.dot(state.linear_velocity);
    const double angular = drag.moment.dot(state.angular_velocity);
    EXPECT_NEAR(linear + angular, -power_taken(hull, state, sea, c),
                tolerance(1e-12) * (std::abs(linear) + std::abs(angular)));
  }
}

}  // namespace

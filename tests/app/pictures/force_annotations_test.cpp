#include "app/pictures/force_annotations.h"

#include <gtest/gtest.h>

#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"

namespace {

using app::centre_of_buoyancy;
using Eigen::Vector3d;

constexpr double kSumRoundOff = 1e-11;

TEST(CentreOfBuoyancy, OfAHalfSphereIsThreeEighthsOfItsRadiusDown) {
  support::Random random(71);
  const hydro::TriMesh mesh = hydro::make_icosphere(2, 5);
  const hydro::BodyState state{.position = {300, -7, 0}, .orientation = random.rotation()};
  const auto centre = centre_of_buoyancy(mesh, state, {}, 0);
  ASSERT_TRUE(centre);
  // 20,480 flat triangles within the sphere.
  EXPECT_LT((*centre - Vector3d(300, -7, -0.75)).norm(), 2e-3);
}

TEST(CentreOfBuoyancy, OfASubmergedBodyIsItsCentroid) {
  support::Random random(72);
  hydro::TriMesh mesh = hydro::make_box({1, 2, 3}, 2);
  mesh.vertices.colwise() += Vector3d(0.3, -0.2, 0.5);
  for (int i = 0; i < 5; ++i) {
    const hydro::BodyState state{.position = Vector3d(0, 0, -20) + random.vector(5),
                                 .orientation = random.rotation()};
    const Vector3d centroid = state.position + state.orientation * Vector3d(0.3, -0.2, 0.5);
    const auto centre = centre_of_buoyancy(mesh, state, {}, 0);
    ASSERT_TRUE(centre);
    EXPECT_LT((*centre - centroid).norm(), 20 * kSumRoundOff);
  }
}

/// The buoyancy of still water acts there: its moment about the centre of mass is that of the arm.
TEST(CentreOfBuoyancy, IsOnTheLineOfTheForce) {
  support::Random random(73);
  const hydro::TriMesh mesh = hydro::make_cylinder(0.5, 3, 24, 4);
  const hydro::Hull hull = hydro::make_hull(mesh);
  for (int i = 0; i < 10; ++i) {
    const hydro::BodyState state{.position = random.vector(0.6), .orientation = random.rotation()};
    const hydro::Wrench load = hydro::compute_loads(hull, state, {}, 0, {}).buoyancy;
    const auto centre = centre_of_buoyancy(mesh, state, {}, 0);
    ASSERT_TRUE(centre);
    const Vector3d moment = (*centre - state.position).cross(load.force);
    EXPECT_LT((moment - load.moment).norm(), kSumRoundOff * load.force.norm());
  }
}

TEST(CentreOfBuoyancy, IsNoneOfADryBody) {
  EXPECT_FALSE(centre_of_buoyancy(hydro::make_box({1, 1, 1}), {.position = {0, 0, 2}}, {}, 0));
}

struct Floating {
  engine::SimulationSpec spec;
  scene::Render look;
  app::Shot shot;
};

/// A cube half in the water, half its density.
Floating floating_cube() {
  Floating cube;
  cube.spec.sea = hydro::Sea{};
  engine::BodySpec& body = cube.spec.bodies.emplace_back();
  body.mesh_B = hydro::make_box({1, 1, 1});
  body.mass = 500;
  cube.shot = {.time = 0, .states = {hydro::BodyState{}}};
  return cube;
}

render::Annotations notes_of(const Floating& cube, double picture_size) {
  app::ForceAnnotations notes(cube.look, cube.spec);
  notes.include(cube.shot);
  return notes.of(cube.shot, picture_size);
}

TEST(ForceAnnotations, ShowForcesInOneScaleAtTheirPlaces) {
  Floating cube = floating_cube();
  cube.look.show.forces = true;
  const double picture_size = 7;
  const render::Annotations found = notes_of(cube, picture_size);
  ASSERT_EQ(found.arrows.size(), 2);
  ASSERT_EQ(found.legend.size(), 2);
  EXPECT_EQ(found.legend[0].name, "weight");
  EXPECT_EQ(found.legend[1].name, "buoyancy");
  const double longest = 0.2 * picture_size;
  EXPECT_LT((found.arrows[0].from_W).norm(), kSumRoundOff);
  EXPECT_LT((found.arrows[0].to_W - Vector3d(0, 0, -longest)).norm(), kSumRoundOff);
  EXPECT_LT((found.arrows[1].from_W - Vector3d(0, 0, -0.25)).norm(), kSumRoundOff);
  EXPECT_LT((found.arrows[1].to_W - Vector3d(0, 0, -0.25 + longest)).norm(), 1e-9);
  EXPECT_EQ(found.scale_name, "2 kN");
  EXPECT_NEAR(found.scale_length, longest * 2000 / (500 * cube.spec.gravity), kSumRoundOff);
  EXPECT_TRUE(found.marks.empty());
}

TEST(ForceAnnotations, ScaleGrowsWithWhatIsIncludedAndWithThePicture) {
  Floating cube = floating_cube();
  cube.look.show.forces = true;
  app::ForceAnnotations notes(cube.look, cube.spec);
  notes.include(cube.shot);
  const auto weight = [&](double picture_size) {
    const render::Arrow arrow = notes.of(cube.shot, picture_size).arrows.at(0);
    return (arrow.to_W - arrow.from_W).norm();
  };
  const double before = weight(7);
  EXPECT_NEAR(weight(70), 10 * before, 10 * kSumRoundOff);
  app::Shot under = cube.shot;  // Twice the buoyancy.
  under.states[0].position.z() = -5;
  notes.include(under);
  EXPECT_NEAR(weight(7), before / 2, kSumRoundOff);
}

TEST(ForceAnnotations, ShowCentres) {
  Floating cube = floating_cube();
  cube.look.show.centres = true;
  const render::Annotations found = notes_of(cube, 7);
  ASSERT_EQ(found.marks.size(), 2);
  EXPECT_EQ(found.marks[0].letter, "G");
  EXPECT_EQ(found.marks[1].letter, "B");
  EXPECT_TRUE(found.arrows.empty());
  EXPECT_TRUE(found.legend.empty());
}

TEST(ForceAnnotations, AreNoneUnlessASceneAsks) {
  const Floating cube = floating_cube();
  const render::Annotations found = notes_of(cube, 7);
  EXPECT_TRUE(found.arrows.empty() && found.marks.empty() && found.legend.empty());
}

}  // namespace

#include "app/assembly/build.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <regex>

#include "app/scene/diagnostics.h"
#include "hydro/airy_waves.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/statics/equilibrium.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using assembly::BuiltScene;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using engine::BodySpec;
using support::tolerance;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A scene of one body, its keys as given, in water.
std::string wet_scene(const std::string& body) {
  return "plimsoll: 1\nduration: 1\nwater: {}\nbodies:\n  - {name: a, " + body + "}\n";
}

/// As above, dry.
std::string dry_scene(const std::string& body) {
  return "plimsoll: 1\nduration: 1\nbodies:\n  - {name: a, " + body + "}\n";
}

std::string data_mesh(const std::string& file) {
  return fmt::format("mesh: {{file: {}/tests/data/bad_meshes/{}}}", PLIMSOLL_SOURCE_DIR, file);
}

BuiltScene assembled(const std::string& text) {
  return assembly::build_without_added_mass(support::read_scene_text(text));
}

BodySpec body_of(const std::string& text) { return assembled(text).spec.bodies.at(0); }

/// Faults that are found when meshes are loaded, without the scene's name.
std::vector<std::string> faults_of(const std::string& text) {
  const scene::Scene scene = support::read_scene_text(text);
  std::vector<std::string> faults;
  try {
    assembly::build_without_added_mass(scene);
  } catch (const scene::InputError& error) {
    for (const scene::Fault& fault : error.faults())
      faults.push_back(scene::to_string(fault).substr(scene.file.string().size() + 1));
  }
  return faults;
}

/// A scene of water alone.
std::string sea_scene(const std::string& water) {
  return "plimsoll: 1\nduration: 1\nwater: {" + water + "}\n";
}

hydro::Sea sea_of(const std::string& water) { return *assembled(sea_scene(water)).spec.sea; }

const std::vector<hydro::WaveComponent>& waves_of(const hydro::Sea& sea) {
  return std::get<hydro::WaveSurface>(sea.surface).components;
}

Matrix3d box_inertia(double mass, const Vector3d& size) {
  const Vector3d s = size.cwiseAbs2();
  return mass / 12 * Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal();
}

TEST(Assemble, DensityAndMassOfTheSameSolidAreTheSameBody) {
  const BodySpec by_density = body_of(wet_scene("box: {size: [2, 3, 4]}, density: 500"));
  const BodySpec by_mass = body_of(wet_scene("box: {size: [2, 3, 4]}, mass: 12000"));
  // Sums over 12 tetrahedra of the box.
  EXPECT_NEAR(by_density.mass, 12000, tolerance(1e-10));
  EXPECT_EQ(by_mass.mass, 12000);
  const Matrix3d expected = box_inertia(12000, {2, 3, 4});
  EXPECT_LT((by_density.inertia_B - expected).norm(), tolerance(1e-12 * expected.norm()));
  EXPECT_LT((by_mass.inertia_B - expected).norm(), tolerance(1e-12 * expected.norm()));
}

TEST(Assemble, LoadsAreSummedWithTheTolerancesOfTheBody) {
  const std::string box = "box: {size: [2, 3, 4]}, density: 500";
  EXPECT_EQ(body_of(wet_scene(box)).summation.wave_tolerance, 1e-4);
  EXPECT_EQ(body_of(wet_scene(box + ", hydro: {wave_tolerance: 0.01}")).summation.wave_tolerance,
            0.01);
}

/// Coefficients of an ellipsoid 8:1 along z with more keys.
hydro::Coefficients slender_coefficients(const std::string& more = "") {
  return assembled(wet_scene("ellipsoid: {semi_axes: [0.5, 0.5, 4]}, density: 500" + more))
      .spec.bodies[0]
      .coefficients;
}

TEST(Assemble, ASlenderMeshIsSparedDragAlongItsAxisUnlessItIsCalibrated) {
  const Matrix3d K = slender_coefficients().drag_shape;
  EXPECT_LT(K(2, 2), 0.2);
  EXPECT_NEAR(K(0, 0), 1, tolerance(1e-12));
  EXPECT_NEAR(K(1, 1), 1, tolerance(1e-12));
  EXPECT_EQ(slender_coefficients(", hydro: {pressure_drag: {blunt: 0}}").drag_shape,
            Matrix3d::Identity());
  EXPECT_EQ(slender_coefficients(", hydro: {preset: thesis}").drag_shape, Matrix3d::Identity());
  const hydro::Coefficients calibrated = slender_coefficients(", calibrate: {drag: [1, 1, 0.1]}");
  EXPECT_EQ(calibrated.drag_shape, Matrix3d::Identity());
  EXPECT_TRUE(calibrated.calibration.has_value());
}

TEST(Assemble, TheFrictionLineHasTheLengthOfTheMeshUnlessItIsGiven) {
  const double viscosity = scene::Water{}.viscosity;
  EXPECT_NEAR(slender_coefficients().viscous_drag.reynolds_per_speed, 8 / viscosity,
              tolerance(1e-12) * 8 / viscosity);
  EXPECT_NEAR(slender_coefficients(", hydro: {length: 2}").viscous_drag.reynolds_per_speed,
              2 / viscosity, tolerance(1e-12) * 2 / viscosity);
}

TEST(Assemble, InertiaIsTakenAsGiven) {
  const BodySpec body =
      body_of(wet_scene("box: {size: [1, 1, 1]}, mass: 10, inertia: [2, 3, 4, 0.1, 0.2, 0.3]"));
  Matrix3d expected;
  expected << 2, 0.1, 0.2, 0.1, 3, 0.3, 0.2, 0.3, 4;
  EXPECT_EQ(body.inertia_B, expected);
}

TEST(Assemble, TheGyradiiOfAUniformBoxMakeItsInertia) {
  // k^2 = (b^2 + c^2)/12; the digits of the text leave 1e-15.
  const BodySpec body =
      body_of(wet_scene("box: {size: [2, 3, 4]}, mass: 12000, gyration: [1.4433756729740645, "
                        "1.2909944487358056, 1.0408329997330663]"));
  const Matrix3d expected = box_inertia(12000, {2, 3, 4});
  EXPECT_LT((body.inertia_B - expected).norm(), tolerance(1e-14 * expected.norm()));
}

/// The corner tetrahedron with edges of 4 m, its centroid at (1, 1, 1).
std::string tetrahedron_file() {
  const std::string file = testing::TempDir() + "assemble_tetrahedron.obj";
  std::ofstream(file) << "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\n"
                         "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  return "mesh: {file: " + file + "}";
}

TEST(Assemble, PositionPlacesTheMeshFramesOriginAndTheStateIsTheCentreOfMass) {
  const std::string placed =
      tetrahedron_file() +
      ", density: 600, position: [10, 20, 30], orientation: {euler_deg: [0, 0, 90]}";
  const BuiltScene built = assembled(wet_scene(placed));
  const BodySpec& body = built.spec.bodies[0];
  // A quarter turn about z takes (1, 1, 1) to (-1, 1, 1).
  EXPECT_LT((built.centers_of_mass[0] - Vector3d(1, 1, 1)).norm(), tolerance(1e-14));
  EXPECT_LT((body.initial.position - Vector3d(9, 21, 31)).norm(), tolerance(1e-14));
  // The mesh's own origin comes back to where it was placed.
  const Vector3d origin_W = body.initial.position + body.initial.orientation * Vector3d(-1, -1, -1);
  EXPECT_LT((origin_W - Vector3d(10, 20, 30)).norm(), tolerance(1e-13));
  EXPECT_LT(hydro::solid_properties(body.mesh_B).centroid.norm(), tolerance(1e-14));
}

TEST(Assemble, AGivenCentreOfMassReplacesThatOfTheSolid) {
  const BodySpec body = body_of(wet_scene(
      "box: {size: [2, 2, 2]}, mass: 5, center_of_mass: [0, 0, -0.5], position: [1, 2, 3]"));
  EXPECT_EQ(body.initial.position, Vector3d(1, 2, 2.5));
  EXPECT_EQ(hydro::bounding_box(body.mesh_B).min().z(), -0.5);
  EXPECT_EQ(hydro::bounding_box(body.mesh_B).max().z(), 1.5);
}

TEST(Assemble, VelocityAndLoadsAreOfTheCentreOfMass) {
  const BodySpec body =
      body_of(wet_scene("box: {size: [2, 2, 2]}, mass: 5, center_of_mass: [0, 0, 0.25], "
                        "linear_velocity: [1, 2, 3], forces: [{force: [1, 0, 0], at: [0, 0, 1]}, "
                        "{force: [1, 0, 0]}]"));
  EXPECT_EQ(body.initial.linear_velocity, Vector3d(1, 2, 3));
  EXPECT_EQ(body.loads[0].at_B, Vector3d(0, 0, 0.75));
  EXPECT_EQ(body.loads[1].at_B, Vector3d::Zero());
}

TEST(Assemble, AnOpenMeshInWaterIsRefusedAtItsKeyWithTheEdges) {
  EXPECT_THAT(
      faults_of(wet_scene(data_mesh("open.obj") +
                          ", mass: 1, center_of_mass: [0, 0, 0], inertia: [1, 1, 1, 0, 0, 0]")),
      ElementsAre(
          "5:21: bodies[0].mesh: 3 edges are open (one face only), "
          "the first at (1, 0, 0.5); with `cap: true` beside `file` it is a solid of 1 m^3"));
}

TEST(Assemble, AnOpenMeshIsFineWhereNothingAsksForASolid) {
  const std::string mass = ", mass: 1, center_of_mass: [0, 0, 0], inertia: [1, 1, 1, 0, 0, 0]";
  const std::string no_loads =
      ", hydro: {buoyancy: false, pressure_drag: false, lift: false, viscous_drag: false}";
  EXPECT_THAT(faults_of(dry_scene(data_mesh("open.obj") + mass)), IsEmpty());
  EXPECT_THAT(faults_of(wet_scene(data_mesh("open.obj") + mass + no_loads)), IsEmpty());
}

TEST(Assemble, AnOpenMeshWhoseMassIsToFollowFromItIsRefusedDryToo) {
  for (const std::string mass :
       {", density: 500", ", mass: 1", ", mass: 1, center_of_mass: [0, 0, 0]",
        ", mass: 1, inertia: [1, 1, 1, 0, 0, 0]"})
    EXPECT_THAT(faults_of(dry_scene(data_mesh("open.obj") + mass)),
                ElementsAre(HasSubstr("bodies[0].mesh: 3 edges are open")))
        << mass;
}

TEST(Assemble, AMeshTurnedInwardIsTurnedOutwardAndNoted) {
  const BuiltScene built = assembled(wet_scene(data_mesh("inward.obj") + ", density: 500"));
  EXPECT_NEAR(built.spec.bodies[0].mass, 500, tolerance(1e-10));
  EXPECT_THAT(built.notes, ElementsAre("bodies[0].mesh: the normals pointed into the solid; "
                                       "all faces were turned over"));
}

TEST(Assemble, CopiesOfABodyAreMadeOnce) {
  const BuiltScene built =
      assembled(wet_scene(data_mesh("inward.obj") + ", density: 500, repeat: {count: 3}"));
  ASSERT_EQ(built.spec.bodies.size(), 3u);
  EXPECT_EQ(built.notes.size(), 1u);  // on the mesh, which is turned over once
}

/// A teapot, which is hollow, with more keys.
std::string teapot(const std::string& keys) {
  return fmt::format("mesh: {{file: {}/scenes/meshes/teapot.obj}}, {}", PLIMSOLL_SOURCE_DIR, keys);
}

TEST(Assemble, ABodyIsTheSameAfterOnesThatAreAlikeInPartOrInWhole) {
  const std::vector<std::string> bodies = {
      teapot("density: 500"),
      teapot("density: 500, position: [9, 2, 3], forces: [{force: [1, 0, 0]}], lock: [z]"),
      teapot("density: 500, position: [0, 9, 0], orientation: {euler_deg: [180, 0, 0]}"),
      teapot("density: 700"),
      teapot("density: 500, interior: wet"),
      teapot("density: 500, hydro: {pressure_drag: {front: 1}}"),
      teapot("mass: 3, center_of_mass: [0, 0, 0.01]"),
      teapot("density: 500, position: [1, 1, 0]")};
  std::string text = "plimsoll: 1\nduration: 1\nwater: {}\nbodies:\n";
  for (std::size_t i = 0; i < bodies.size(); ++i)
    text += fmt::format("  - {{name: b{}, {}}}\n", i, bodies[i]);
  const BuiltScene together = assembled(text);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BuiltScene alone = assembled(wet_scene(bodies[i]));
    const BodySpec &a = together.spec.bodies[i], &b = alone.spec.bodies[0];
    EXPECT_EQ(a.name, fmt::format("b{}", i));
    EXPECT_TRUE(hydro::same_mesh(a.mesh_B, b.mesh_B)) << i;
    EXPECT_TRUE(hydro::same_mesh(engine::outside_B(a), engine::outside_B(b))) << i;
    EXPECT_TRUE(hydro::same_mesh(together.solids[i].mesh_C, alone.solids[0].mesh_C)) << i;
    EXPECT_EQ(together.solids[i].com_C, alone.solids[0].com_C) << i;
    EXPECT_EQ(together.centers_of_mass[i], alone.centers_of_mass[0]) << i;
    EXPECT_EQ(together.mesh_sources[i].size(), 1u) << i;
    EXPECT_EQ(a.mass, b.mass) << i;
    EXPECT_EQ(a.inertia_B, b.inertia_B) << i;
    EXPECT_EQ(a.interior, b.interior) << i;
    EXPECT_TRUE(a.initial == b.initial) << i;
    EXPECT_EQ(a.locked, b.locked) << i;
    EXPECT_EQ(a.loads.size(), b.loads.size()) << i;
    EXPECT_EQ(a.coefficients.drag_shape, b.coefficients.drag_shape) << i;
    EXPECT_TRUE(a.coefficients.pressure_drag == b.coefficients.pressure_drag) << i;
    EXPECT_TRUE(a.coefficients.viscous_drag == b.coefficients.viscous_drag) << i;
    EXPECT_EQ(together.radiation[i].choice.reason, alone.radiation[0].choice.reason) << i;
  }
}

TEST(Assemble, FacesWithoutAreaAreDroppedWithANote) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "fins.obj";
  std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 0\nf 1 3 2\nf 1 2 4\nf 1 4 3\n"
                         "f 2 3 4\nf 1 2 5\nf 3 3 4\n";
  const std::string body =
      fmt::format("mesh: {{file: {}}}, density: 500, repeat: {{count: 2}}", file.string());
  EXPECT_THAT(assembled(wet_scene(body)).notes,
              ElementsAre("bodies[0].mesh: 2 faces without area were dropped"));
  std::filesystem::remove(file);
}

TEST(Assemble, MeshesThatBoundNoSolidAreRefused) {
  const auto fault = [](const std::string& file) {
    return testing::PrintToString(faults_of(wet_scene(data_mesh(file) + ", density: 500")));
  };
  EXPECT_THAT(fault("flat.obj"), HasSubstr("the mesh encloses no volume"));
  EXPECT_THAT(fault("degenerate.obj"), HasSubstr("no area"));
  EXPECT_THAT(fault("crowded.obj"), HasSubstr("more than two faces"));
  EXPECT_THAT(fault("misoriented.obj"), HasSubstr("turned against each other"));
  EXPECT_THAT(fault("overlapping.obj"), HasSubstr("through each other"));
}

TEST(Assemble, AMeshFileThatCannotBeReadIsAFaultAtItsKey) {
  EXPECT_THAT(
      faults_of(wet_scene(data_mesh("truncated.stl") + ", density: 500")),
      ElementsAre(AllOf(HasSubstr("5:28: bodies[0].mesh.file: "), HasSubstr("truncated.stl: "))));
}

TEST(Assemble, SeveralShapesAreOneBodyOfTheirUnion) {
  // Two floats of 4 x 1 x 1 m under a deck of 4 x 5 x 0.5 m, which one of them touches upside down.
  const BodySpec body =
      body_of(wet_scene("shapes: [{box: {size: [4, 1, 1]}, position: [0, -2, 0]}, "
                        "{box: {size: [4, 1, 1]}, position: [0, 2, 0], "
                        "orientation: {euler_deg: [180, 0, 0]}}, "
                        "{box: {size: [4, 5, 0.5]}, position: [0, 0, 0.75]}], density: 500"));
  EXPECT_NEAR(body.mass, 500 * 18, tolerance(1e-6));
  EXPECT_EQ(body.collision, engine::CollisionShape::mesh);
  EXPECT_TRUE(hydro::check_mesh(body.mesh_B).sound());
  // About the centre of mass at z = 10·0.75/18.
  const double z = 7.5 / 18;
  const auto slab = [](double mass, double a, double b, double y, double z_off) {
    return mass * ((a * a + b * b) / 12 + y * y + z_off * z_off);
  };
  EXPECT_NEAR(body.inertia_B(0, 0), 2 * slab(2000, 1, 1, 2, z) + slab(5000, 5, 0.5, 0, 0.75 - z),
              tolerance(1e-5));
  EXPECT_NEAR(body.inertia_B(1, 1), 2 * slab(2000, 4, 1, 0, z) + slab(5000, 4, 0.5, 0, 0.75 - z),
              tolerance(1e-5));
}

TEST(Assemble, ShapesThatOverlapAreAFaultThatNamesBothAndHowDeep) {
  const auto faults = faults_of(
      wet_scene("density: 500, shapes: [{box: {size: [1, 1, 1]}}, {sphere: {radius: 0.2}, "
                "position: [5, 0, 0]}, {box: {size: [1, 1, 1]}, position: [0.9, 0, 0]}]"));
  EXPECT_THAT(faults, ElementsAre(AllOf(HasSubstr("bodies[0].shapes[2]: overlaps "
                                                  "bodies[0].shapes[0] by 0.1 m along x"),
                                        HasSubstr("move one of them"))));
  EXPECT_THAT(faults_of(wet_scene("density: 500, shapes: [{box: {size: [1, 1, 1]}}, {" +
                                  data_mesh("open.obj") + "}]")),
              ElementsAre(HasSubstr("bodies[0].shapes[1].mesh: 3 edges are open")));
  // Two boxes on a third have an edge in common, and so four faces meet there.
  EXPECT_THAT(
      faults_of(
          wet_scene("density: 500, shapes: [{box: {size: [2, 2, 1]}}, {box: {size: [1, 1, 1]}, "
                    "position: [0.5, 0.5, 1]}, {box: {size: [1, 1, 1]}, position: [-0.5, "
                    "-0.5, 1]}]")),
      ElementsAre(HasSubstr("bodies[0].shapes: touch in a way that gives no solid: 1 edge has")));
}

/// A mesh of 3200 x 800 x 1200 units.
std::string large_mesh(const std::string& keys) {
  return fmt::format("mesh: {{file: {}/tests/data/meshes/hull_mm.obj{}}}", PLIMSOLL_SOURCE_DIR,
                     keys);
}

TEST(Assemble, AHullInMillimetresIsAWarningWithTheRemedy) {
  const auto warnings = [](const std::string& mesh, const std::string& mass) {
    std::vector<std::string> lines =
        assembled(wet_scene(mesh + ", " + mass + ", hydro: {radiation: none}")).warnings;
    // Such sizes lie outside the envelope as well.
    std::erase_if(lines, [](const std::string& line) { return line.starts_with("outside the"); });
    return lines;
  };
  EXPECT_THAT(warnings(large_mesh(""), "density: 500"),
              ElementsAre(AllOf(HasSubstr("bodies[0].mesh: hull_mm.obj is 3200 m long"),
                                HasSubstr("with 'unit: mm' it is 3.2 m"))));
  // The author has thought of the unit.
  for (const char* keys : {", unit: mm", ", unit: m", ", scale: 0.5"})
    EXPECT_THAT(warnings(large_mesh(keys), "density: 500"), IsEmpty()) << keys;
  // A model ship of 320 mm and 10 kg is short enough for metres, but lighter than gas.
  EXPECT_THAT(warnings(large_mesh(", unit: m, scale: 0.1"), "mass: 10"),
              ElementsAre(HasSubstr("less than any gas has: is the file in millimetres?")));
  EXPECT_THAT(warnings(large_mesh(", unit: mm, scale: 0.001"), "mass: 10"),
              ElementsAre(HasSubstr("more than any metal has: is the file in metres?")));
}

TEST(Assemble, FindsTheFaultsOfAllBodies) {
  const std::string text =
      wet_scene(data_mesh("open.obj") + ", density: 500") + "  - {name: b, " +
      data_mesh("flat.obj") + ", density: 500}\n" +
      "  - {name: c, box: {size: [1, 1, 1]}, density: 1.0e+40}\n" +
      "  - {name: d, box: {size: [1, 1, 1]}, density: 1, position: [1e+12, 0, 0]}\n";
  const std::vector<std::string> faults = faults_of(text);
  ASSERT_EQ(faults.size(), 4u);
  EXPECT_THAT(faults[0], HasSubstr("bodies[0].mesh: 3 edges are open"));
  EXPECT_THAT(faults[1], HasSubstr("bodies[1].mesh: the mesh encloses no volume"));
  EXPECT_THAT(faults[2], HasSubstr("bodies[2]: its mass comes to 1e+40 kg"));
  EXPECT_THAT(faults[3], HasSubstr("bodies[3]: body 'd': initially, the position's x is 1e+12"));
}

TEST(Assemble, BodiesOfAMicrometreAndOfThreeHundredMetresAreBodies) {
  for (const double size : {1e-6, 300.0}) {
    const BodySpec body =
        body_of(wet_scene(fmt::format("box: {{size: [{0}, {0}, {0}]}}, density: 500", size)));
    const double mass = 500 * size * size * size;
    EXPECT_NEAR(body.mass / mass, 1, tolerance(1e-12));
    EXPECT_NEAR(body.inertia_B(0, 0) / (mass * size * size / 6), 1, tolerance(1e-12));
  }
}

TEST(Assemble, ARunOfMoreStepsThanCanBeTakenIsRefused) {
  const auto fault = [](const std::string& keys) {
    return faults_of("plimsoll: 1\n" + keys + "bodies: []\n");
  };
  EXPECT_THAT(fault("duration: 1e+300\nstep: 1e-300\n"),
              ElementsAre("2:11: duration: 1e+300 s in steps of 1e-300 s are inf steps, "
                          "expected at most 1e+11"));
  EXPECT_THAT(fault("duration: 1e+9\nstep: 1e-4\n"), ElementsAre(HasSubstr("are 1e+13 steps")));
  EXPECT_THAT(fault("duration: 1e+8\nstep: 1e-3\n"), IsEmpty());
}

/// The file of a table of heights, as a block.
std::string heights(const std::string& table, const std::string& more = "") {
  const std::string file = testing::TempDir() + "assemble_heights_" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
  std::ofstream(file) << table;
  return "{heightfield: {file: " + file + more + "}}";
}

TEST(Assemble, AHeightFieldMakesTheSea) {
  const std::string surface = heights("0, 1, 2\n3, 4, 5\n", ", cell: 2, origin: [10, 20]");
  const BuiltScene built =
      assembled("plimsoll: 1\nduration: 1\nwater: {level: 100, surface: " + surface + "}\n");
  const hydro::Sea& sea = *built.spec.sea;
  // Rows count along y, columns along x; between the points the surface is bilinear.
  EXPECT_EQ(hydro::surface_height(sea, 10, 20, 0), 100);
  EXPECT_EQ(hydro::surface_height(sea, 14, 20, 0), 102);
  EXPECT_EQ(hydro::surface_height(sea, 10, 22, 0), 103);
  EXPECT_EQ(hydro::surface_height(sea, 11, 21, 0), 102);
}

TEST(Assemble, AHeightFieldMakesTheGround) {
  const std::string ground = heights("0, 1\n2, 3\n", ", cell: 4, origin: [1, 1]");
  const BuiltScene built = assembled("plimsoll: 1\nduration: 1\nground: " + ground + "\n");
  const auto& mesh = std::get<engine::MeshGround>(built.spec.ground).mesh_W;
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(hydro::bounding_box(mesh).min(), Vector3d(1, 1, 0));
  EXPECT_EQ(hydro::bounding_box(mesh).max(), Vector3d(5, 5, 3));
}

TEST(Assemble, AHeightOfOnePointIsASeaButNoGround) {
  const std::string point = heights("2\n");
  EXPECT_THAT(faults_of("plimsoll: 1\nduration: 1\nwater: {surface: " + point + "}\n"), IsEmpty());
  EXPECT_THAT(faults_of("plimsoll: 1\nduration: 1\nground: " + point + "\n"),
              ElementsAre(HasSubstr("3:23: ground.heightfield: the height field has 1 x 1")));
}

TEST(Assemble, GroundBeyondAllBoundsIsRefused) {
  for (const std::string& ground : {std::string("{z: 1e+300}"), heights("0, 1e+300\n2, 3\n")})
    EXPECT_THAT(faults_of("plimsoll: 1\nduration: 1\nground: " + ground + "\n"),
                ElementsAre(HasSubstr("ground: the ground reaches beyond all bounds")));
}

TEST(Assemble, JointsNameTheirBodiesByIndexAndHaveUnitAxes) {
  const BuiltScene built = assembled(
      "plimsoll: 1\nduration: 1\nbodies:\n"
      "  - {name: a, box: {size: [1, 1, 1]}, density: 500}\n"
      "  - {name: b, box: {size: [1, 1, 1]}, density: 500, position: [2, 0, 0]}\n"
      "joints:\n"
      "  - {type: universal, bodies: [b, world], anchor: [1, 2, 3], axis: [0, 0, 5]}\n"
      "  - {type: slider, bodies: [a, b], axis: [3, 4, 0]}\n");
  const std::vector<engine::JointSpec>& joints = built.spec.joints;
  EXPECT_EQ(joints[0].type, engine::JointSpec::Type::universal);
  EXPECT_EQ(joints[0].first, 1);
  EXPECT_EQ(joints[0].second, engine::kWorld);
  EXPECT_EQ(joints[0].anchor_W, Vector3d(1, 2, 3));
  EXPECT_EQ(joints[0].axis_W, Vector3d::UnitZ());
  EXPECT_EQ(joints[0].axis2_W.dot(joints[0].axis_W), 0);
  EXPECT_EQ(joints[0].axis2_W.norm(), 1);
  EXPECT_EQ(joints[1].type, engine::JointSpec::Type::slider);
  EXPECT_LT((joints[1].axis_W - Vector3d(0.6, 0.8, 0)).norm(), tolerance(1e-15));
}

TEST(Assemble, ContactsNameTheirBodiesByIndexAndTheGroundAsTheWorld) {
  const engine::SimulationSpec spec =
      assembled(
          "plimsoll: 1\nduration: 1\nground: {z: -1, friction: 0.2, restitution: 0.3}\n"
          "bodies:\n"
          "  - {name: a, box: {size: [1, 1, 1]}, density: 500, friction: 0, restitution: 1}\n"
          "  - {name: b, box: {size: [1, 1, 1]}, density: 500, position: [2, 0, 0]}\n"
          "contacts:\n"
          "  - {bodies: [b, a], friction: 0.6}\n"
          "  - {bodies: [world, b], restitution: 0.7}\n")
          .spec;
  EXPECT_EQ(spec.ground_friction, 0.2);
  EXPECT_EQ(spec.ground_restitution, 0.3);
  EXPECT_EQ(spec.bodies[0].friction, 0);
  EXPECT_EQ(spec.bodies[0].restitution, 1);
  EXPECT_EQ(spec.bodies[1].friction, engine::BodySpec().friction);
  ASSERT_EQ(spec.contacts.size(), 2U);
  EXPECT_EQ(spec.contacts[0].first, 1);
  EXPECT_EQ(spec.contacts[0].second, 0);
  EXPECT_EQ(spec.contacts[0].friction, 0.6);
  EXPECT_EQ(spec.contacts[0].restitution, std::nullopt);
  EXPECT_EQ(spec.contacts[1].first, engine::kWorld);
  EXPECT_EQ(spec.contacts[1].second, 1);
  EXPECT_EQ(spec.contacts[1].restitution, 0.7);
}

TEST(Assemble, WaterLeavesABodyWithoutLoadsAlone) {
  const std::string off = ", hydro: {buoyancy: false, pressure_drag: 0, lift: 0, viscous_drag: 0}";
  const std::string box = "box: {size: [1, 1, 1]}, density: 500";
  EXPECT_FALSE(body_of(wet_scene(box + off)).wet);
  EXPECT_TRUE(body_of(wet_scene(box)).wet);
  EXPECT_FALSE(body_of(dry_scene(box)).wet);
}

TEST(Assemble, DepthAndKinematicsAreThoseOfTheSea) {
  const std::string waves = "surface: {waves: [{amplitude: 1, wavelength: 50}]";
  const hydro::Sea deep = sea_of(waves + "}");
  EXPECT_EQ(deep.depth, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(hydro::has_airy_waves(deep));
  const hydro::Sea shallow = sea_of("depth: 4, " + waves + ", kinematics: hydrostatic}");
  EXPECT_EQ(shallow.depth, 4);
  EXPECT_FALSE(hydro::has_airy_waves(shallow));
  EXPECT_TRUE(hydro::has_airy_waves(
      sea_of("surface: {spectrum: {type: jonswap, significant_height: 1, peak_period: 7}}")));
}

TEST(Assemble, AWaveGivenByItsLengthObeysTheDispersionRelationOfItsWater) {
  const double k = 2 * M_PI / 30, heading = 110 * M_PI / 180;
  const hydro::Sea sea = sea_of(
      "depth: 5, current: [0.7, -0.4, 0], surface: {waves: [{amplitude: 0.5, wavelength: 30, "
      "heading_deg: 110, phase_deg: 20}]}");
  const hydro::WaveComponent& wave = waves_of(sea).at(0);
  EXPECT_NEAR(std::hypot(wave.kx, wave.ky), k, tolerance(1e-15));
  EXPECT_NEAR(wave.phase, 20 * M_PI / 180, tolerance(1e-15));
  const double along = 0.7 * std::cos(heading) - 0.4 * std::sin(heading);
  EXPECT_NEAR(wave.omega, std::sqrt(9.80665 * k * std::tanh(5 * k)) + k * along, tolerance(1e-14));
}

TEST(Assemble, APeriodIsThatSeenByAnObserverAtRest) {
  // Deep water: ω = √(gk) + kU is a quadratic in √k.
  const double omega = 2 * M_PI / 6, g = 9.80665;
  for (const double along : {1.5, -1.5}) {
    const hydro::Sea sea = sea_of(fmt::format(
        "current: [0, {}, 3], surface: {{waves: [{{amplitude: 0.5, period: 6, heading_deg: 90}}]}}",
        along));
    const hydro::WaveComponent& wave = waves_of(sea).at(0);
    const double root = 2 * omega / (std::sqrt(g) + std::sqrt(g + 4 * omega * along));
    EXPECT_NEAR(wave.ky, root * root, tolerance(1e-13));
    EXPECT_NEAR(wave.omega, omega, tolerance(1e-13));
  }
}

TEST(Assemble, ATableOfTheCurrentIsUniformIfAllRowsAre) {
  const hydro::Sea uniform =
      sea_of("current: {depths: [1, 4], velocities: [[1, 2, 0], [1, 2, 0]]}");
  EXPECT_EQ(uniform.current, Eigen::Vector3d(1, 2, 0));
  EXPECT_TRUE(uniform.profile.empty());
  const hydro::Sea sheared =
      sea_of("current: {depths: [1, 4], velocities: [[1, 2, 0], [0, 2, 0]]}");
  EXPECT_EQ(sheared.current, Eigen::Vector3d(1, 2, 0));
  EXPECT_EQ(hydro::current_at(sheared, -2.5), Eigen::Vector3d(0.5, 2, 0));
}

TEST(Assemble, PeriodAndLengthOfOneWaveAreTheSameWave) {
  const std::string water = "depth: 8, current: [-1, 0, 0], surface: {waves: [{amplitude: 0.5, ";
  const hydro::WaveComponent by_length = waves_of(sea_of(water + "wavelength: 25}]}"))[0];
  const hydro::WaveComponent by_period =
      waves_of(sea_of(water + fmt::format("period: {:.17g}}}]}}", 2 * M_PI / by_length.omega)))[0];
  EXPECT_NEAR(by_period.kx, by_length.kx, tolerance(1e-13));
}

TEST(Assemble, APeriodThatNoWaveHasAgainstTheCurrentIsRefusedAtItsKey) {
  // The current stops waves shorter than g/(4U) in frequency: 0.817 rad/s, 7.69 s, at 3 m/s.
  const std::string water = "current: [-3, 0, 0], surface: {waves: [{amplitude: 0.5, period: ";
  EXPECT_THAT(faults_of(sea_scene(water + "7.6}]}")),
              ElementsAre("3:73: water.surface.waves[0].period: a wave of this period, 7.6 s, "
                          "cannot travel against this current, which is -3 m/s along its heading"));
  EXPECT_THAT(faults_of(sea_scene(water + "7.8}]}")), IsEmpty());
}

TEST(Assemble, TypesOfSpectraDifferInTheirPeakAlone) {
  const auto waves = [](const std::string& keys) {
    std::vector<double> frequencies;
    const hydro::Sea sea = sea_of(
        "depth: 15, surface: {spectrum: {significant_height: 2, peak_period: 6, " + keys + "}}");
    for (const hydro::WaveComponent& w : waves_of(sea)) frequencies.push_back(w.omega);
    return frequencies;
  };
  const auto flat_peak = waves("type: jonswap, gamma: 1");
  EXPECT_EQ(waves("type: pierson_moskowitz"), flat_peak);
  EXPECT_EQ(waves("type: bretschneider"), flat_peak);
  EXPECT_NE(waves("type: tma, gamma: 1"), flat_peak);
  EXPECT_NE(waves("type: jonswap"), flat_peak);
  // 6/√2 = 4.243 lies on the slope of γ.
  EXPECT_EQ(waves("type: jonswap, gamma: auto"),
            waves(fmt::format("type: jonswap, gamma: {:.17g}",
                              std::exp(5.75 - 1.15 * 6 / std::sqrt(2.0)))));
}

TEST(Assemble, ASpectrumBeyondAllNumbersIsRefused) {
  EXPECT_THAT(faults_of(sea_scene("surface: {spectrum: {type: jonswap, significant_height: 1, "
                                  "peak_period: 1e-200}}")),
              ElementsAre(HasSubstr("water.surface.spectrum: its periods are too ")));
}

TEST(Assemble, WavesOfAnyKindHaveTheRamp) {
  const std::string file = (support::data_folder() / "elevation.csv").string();
  for (const std::string& waves :
       {std::string("waves: [{amplitude: 0.1, period: 4}]"),
        std::string("spectrum: {type: jonswap, significant_height: 1, peak_period: 7}"),
        "elevation: {file: " + file + "}"}) {
    const hydro::Sea sea = sea_of("surface: {" + waves + ", ramp: 9}");
    EXPECT_EQ(std::get<hydro::WaveSurface>(sea.surface).ramp, 9);
  }
}

/// A sea by a record of two periods of a wave of 1 s.
std::string recorded_sea(const std::string& keys) {
  return fmt::format(
      "plimsoll: 1\nduration: 1\nwater: {{surface: {{elevation: {{file: {}{}}}}}}}\n",
      (support::data_folder() / "elevation.csv").string(), keys);
}

TEST(Assemble, AMeasuredElevationIsThatOfTheSeaAtTheGauge) {
  const BuiltScene built = assembled(recorded_sea(", at: [3, 4], heading_deg: 50, start: 0.5"));
  const double measured[] = {0, 0.7, 1, 0.7, 0, -0.7, -1, -0.7};
  for (int i = 0; i < 24; ++i)
    EXPECT_NEAR(hydro::surface_elevation(*built.spec.sea, 3, 4, 0.125 * i - 0.5), measured[i % 8],
                0.02)
        << i;
  EXPECT_THAT(built.notes, ElementsAre(HasSubstr("have the elevation of elevation.csv")));
  ASSERT_TRUE(built.irregular_sea && built.irregular_sea->fit);
  EXPECT_LT(built.irregular_sea->fit->residual, 0.02);
  EXPECT_NEAR(built.irregular_sea->peak_period, 1, tolerance(1e-12));
}

TEST(Assemble, ARecordThatDoesNotSuitItsKeysIsRefusedAtThem) {
  EXPECT_THAT(
      faults_of(recorded_sea(", start: 3")),
      ElementsAre(HasSubstr("elevation.start: found 3, expected a time of the record, which "
                            "is from 0 to 2 s")));
  EXPECT_THAT(faults_of(recorded_sea(", highest_frequency_hz: 4")),
              ElementsAre(HasSubstr("elevation.highest_frequency_hz: found 4, expected less than "
                                    "half the sampling frequency of 8 Hz")));
  EXPECT_THAT(faults_of(recorded_sea(", lowest_frequency_hz: 1.1, highest_frequency_hz: 1.2")),
              ElementsAre(HasSubstr("elevation: no frequency of the record is in the band")));
  const std::string shallow =
      std::regex_replace(recorded_sea(""), std::regex("water: \\{"), "water: {depth: 2, ");
  EXPECT_THAT(faults_of(shallow),
              ElementsAre(HasSubstr("elevation.file: its significant height is 2.81 m, expected "
                                    "less than the depth of 2 m")));
}

TEST(Assemble, ARecordThatEndsBeforeTheRunIsWarnedOf) {
  const std::string longer =
      std::regex_replace(recorded_sea(""), std::regex("duration: 1"), "duration: 5");
  EXPECT_THAT(assembled(longer).warnings,
              testing::Contains(HasSubstr("elevation.file: the record ends at 2 s of a run of 5 s, "
                                          "and the waves then repeat")));
}

TEST(Assemble, ASpectrumInAFileIsThatOfTheSea) {
  const BuiltScene built = assembled(
      sea_scene(fmt::format("surface: {{spectrum: {{type: file, file: {}, components: 30}}}}",
                            (support::data_folder() / "spectrum.csv").string())));
  EXPECT_EQ(waves_of(*built.spec.sea).size(), 30u);
  EXPECT_THAT(built.notes, ElementsAre(HasSubstr("spectrum.csv has a significant height of 2.713 m "
                                                 "and a peak period of 5 s in 3 rows")));
  EXPECT_NEAR(built.irregular_sea->significant_height, 4 * std::sqrt(0.46), tolerance(1e-14));
}

/// A raft of 4 x 2 x 1 m that floats with its middle at the water, with more keys and blocks.
std::string settling_raft(const std::string& keys, const std::string& blocks = "") {
  return "plimsoll: 1\nduration: 1\nwater: {density: 1000}\nbodies:\n  - {name: a, box: {size: "
         "[4, 2, 1]}, density: 500, collision: none, start: equilibrium, " +
         keys + "}\n" + blocks;
}

TEST(Equilibrium, CountsLinesAndLoads) {
  // A spring of the raft's own stiffness in heave, 8 m2 of waterplane, that is 0.2 m too short.
  const double stiffness = 1000 * 9.80665 * 8;
  const std::string spring = fmt::format(
      "springs: [{{name: s, bodies: [a, world], points: [[0, 0, 0], [0, 0, -3]], length: 2.8,"
      " stiffness: {}}}]\n",
      stiffness);
  EXPECT_NEAR(body_of(settling_raft("position: [0, 0, 0.3]", spring)).initial.position.z(), -0.1,
              1e-6);
  const BodySpec loaded = body_of(settling_raft(
      fmt::format("position: [0, 0, 0.3], forces: [{{force: [0, 0, {}]}}]", -0.1 * stiffness)));
  EXPECT_NEAR(loaded.initial.position.z(), -0.1, 1e-6);
}

// A hinge along y through the middle of one side at the water, where the raft is at rest level; it
// is let go at 10°.
TEST(Equilibrium, CountsJoints) {
  const double a = 10 * M_PI / 180;
  const BodySpec body = body_of(
      settling_raft(fmt::format("position: [{}, 0, {}], orientation: {{euler_deg: [0, 10, 0]}}",
                                2 * std::cos(a), -2 * std::sin(a)),
                    "joints: [{type: hinge, name: pin, bodies: [world, a], anchor: [0, 0, 0],"
                    " axis: [0, 1, 0]}]\n"));
  EXPECT_LT(body.initial.orientation.angularDistance(Eigen::Quaterniond::Identity()), 1e-6);
  EXPECT_LT((body.initial.position - Vector3d(2, 0, 0)).norm(), 1e-6);
}

TEST(Equilibrium, KeepsALockedRollAndFindsTheRest) {
  const BodySpec body = body_of(
      settling_raft("position: [0, 0, 0.4], orientation: {euler_deg: [8, 5, 0]}, lock: [roll]"));
  const Vector3d angles = hydro::euler_angles(body.initial.orientation);
  EXPECT_NEAR(angles[0], 8 * M_PI / 180, 1e-3);
  // A locked rotation is a condition on the velocity, so that the rest is not exactly level.
  EXPECT_NEAR(angles[1], 0, 2e-4);
  EXPECT_NEAR(body.initial.position.z(), 0, 1e-4);
}

TEST(Equilibrium, IsLeftByTheHeelThatTheSceneGives) {
  const BodySpec body = body_of(settling_raft(
      "position: [0, 0, 0.4], orientation: {euler_deg: [3, 2, 30]}, heel: {roll_deg: 12}"));
  const Vector3d angles = hydro::euler_angles(body.initial.orientation);
  EXPECT_LT((angles - Vector3d(12, 0, 30) * M_PI / 180).norm(), 1e-9);
  EXPECT_NEAR(body.initial.position.z(), 0, 1e-9);
}

TEST(Equilibrium, OfABodyThatNothingNearHoldsIsAFault) {
  EXPECT_THAT(faults_of(settling_raft("position: [0, 0, 0], forces: [{force: [500, 0, 0]}]")),
              ElementsAre(HasSubstr("held by a constant load, does not come to rest within ten")));
}

TEST(RigFaults, ALineWithInertiaHasAMassAndAStiffnessForTheStep) {
  const auto of_rope = [](const std::string& keys) {
    return faults_of(
        "plimsoll: 1\nduration: 1\nstep: 0.01\nwater: {}\nbodies:\n"
        "  - {name: a, box: {size: [1, 1, 1]}, density: 500}\n"
        "  - {name: b, box: {size: [1, 1, 1]}, density: 500, position: [5, 0, 0]}\n"
        "ropes: [{name: r, bodies: [a, b], points: [[0, 0, 0], [0, 0, 0]], " +
        keys + "}]\n");
  };
  EXPECT_THAT(of_rope("stiffness: 1e5, weight: 1"), IsEmpty());
  EXPECT_THAT(of_rope("stiffness: 1e5, weight: -1"),
              ElementsAre(HasSubstr("ropes[0].weight: leaves the line no mass")));
  EXPECT_THAT(of_rope("stiffness: 1e5, weight: -1, mass: 2"), IsEmpty());
  // 0.5 √(m/2k): half a radian of two bodies of 500 kg.
  EXPECT_THAT(of_rope("stiffness: 1e6, weight: 1"),
              ElementsAre(HasSubstr("needs a step of 0.00791 s or less; the scene's is 0.01 s")));
}

TEST(RigWarnings, ATautLineIsToldUnlessItsBodyRestsOnIt) {
  const auto warnings = [](const std::string& start) {
    return assembly::build_without_added_mass(
               support::read_scene_text(
                   "plimsoll: 1\nduration: 1\nwater: {depth: 60}\nbodies:\n"
                   "  - {name: spar, cylinder: {radius: 4, height: 24}, mass: 690000, "
                   "center_of_mass: [0, 0, -8], position: [0, 0, -6], start: " +
                   start +
                   "}\nmoorings:\n  - {name: tendon, body: spar, fairlead: [0, 0, -12], anchor: "
                   "[0, 0, -60], length: 41.95, weight: 300, stiffness: 6e8, bottom: false}\n"))
        .warnings;
  };
  EXPECT_THAT(warnings("given"),
              testing::Contains(testing::HasSubstr(
                  "moorings[0].length: 41.95 m is less than the distance of 42")));
  EXPECT_THAT(warnings("equilibrium"),
              testing::Not(testing::Contains(testing::HasSubstr("length"))));
}

}  // namespace

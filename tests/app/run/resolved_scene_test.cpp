#include "app/run/resolved_scene.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/assembly/build.h"
#include "app/base/progress.h"
#include "app/run/resolved_rig.h"
#include "tests/app/scene_text.h"

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A line without the spaces that align it.
std::string squeezed(const std::string& line) {
  std::string text;
  for (const char c : line)
    if (c != ' ' || (!text.empty() && text.back() != ' ')) text += c;
  return text;
}

/// What is told of a scene, spaces squeezed.
std::vector<std::string> told_of(const std::string& text, const std::string& no_pictures = "") {
  const scene::Scene scene = support::read_scene_text(text);
  assembly::AddedMassStore store(assembly::cache_folder());
  const assembly::BuiltScene built = assembly::build(scene, store);
  const engine::Simulation simulation(built.spec);
  std::vector<std::string> lines;
  for (const std::string& line : app::resolved_scene(scene, built, simulation.skips(), no_pictures))
    lines.push_back(squeezed(line));
  return lines;
}

const std::string kHead = "plimsoll: 1\nduration: 2\nstep: 0.01\n";

TEST(RunReport, TellsWhatABodyIs) {
  const auto lines =
      told_of(kHead +
              "water: {density: 1025, level: 1}\n"
              "bodies:\n"
              "  - {name: raft, box: {size: [3, 2, 1]}, density: 500,"
              " position: [0, 0, 1.1], hydro: {added_mass: none, viscous_drag: false}}\n");
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_THAT(lines[0],
              HasSubstr(": 1 body; 2 s in steps of 0.01 s; water of 1025 kg/m^3 (flat); 1 thread"));
  EXPECT_EQ(lines[1], "body triangles size m volume m^3 mass kg start draught m freeboard m");
  EXPECT_EQ(lines[2], "raft 12 3 x 2 x 1 6 3000 given 0.4 0.6");
  EXPECT_EQ(
      lines[3],
      "not computed: collisions (nothing can collide); viscous_drag of raft (switched off); added "
      "mass of raft (added_mass: none)");
}

TEST(RunReport, TellsTheAxisAndTheUnitOfAMeshFileThatIsTurnedOrScaled) {
  const auto lines =
      told_of(kHead + "bodies:\n  - {name: a, density: 500, mesh: {file: " + PLIMSOLL_SOURCE_DIR +
              "/tests/data/meshes/hull_mm.obj, up: y, unit: mm}}\n");
  ASSERT_GE(lines.size(), 5u);
  EXPECT_EQ(lines[2], "a 12 3.2 x 1.2 x 0.8 3.072 1536 given");
  EXPECT_EQ(lines[3], "mesh files up unit scale");
  EXPECT_EQ(lines[4], "a hull_mm.obj y mm 1");
}

TEST(RunReport, TellsTheWavesAndTheDepth) {
  const auto water = [](const std::string& block) {
    return told_of(kHead + "water: " + block + "\n")[0];
  };
  const std::string waves = "{waves: [{amplitude: 1, wavelength: 50}]}";
  EXPECT_THAT(water("{surface: " + waves + "}"), HasSubstr("kg/m^3 (1 wave);"));
  EXPECT_THAT(water("{depth: 12.5, surface: " + waves + "}"),
              HasSubstr("kg/m^3 (1 wave, 12.5 m deep);"));
  EXPECT_THAT(water("{surface: {waves: [{amplitude: 1, period: 4}], kinematics: hydrostatic}}"),
              HasSubstr("kg/m^3 (1 wave with hydrostatic pressure);"));
  EXPECT_THAT(water("{depth: 3}"), HasSubstr("kg/m^3 (flat, 3 m deep);"));
}

TEST(RunReport, TellsTheDraughtInEquilibrium) {
  const auto lines =
      told_of(kHead +
              "water: {density: 1000}\n"
              "bodies:\n"
              "  - {name: raft, box: {size: [3, 2, 1]}, density: 250,"
              " position: [0, 0, 9], start: equilibrium, hydro: {added_mass: none}}\n");
  EXPECT_EQ(lines[2], "raft 12 3 x 2 x 1 6 1500 afloat 0.25 0.75");
}

TEST(RunReport, TellsOfWhatIsFixedToABodyInEquilibriumThatItIsAfloat) {
  const auto lines =
      told_of(kHead +
              "water: {density: 1000}\n"
              "bodies:\n"
              "  - {name: raft, box: {size: [3, 2, 1]}, density: 250,"
              " position: [0, 0, 9], start: equilibrium, hydro: {added_mass: none}}\n"
              "  - {name: box, box: {size: [1, 1, 1]}, mass: 300,"
              " position: [0, 0, 10], hydro: {added_mass: none}}\n"
              "joints: [{type: fixed, bodies: [raft, box]}]\n");
  EXPECT_EQ(lines[2], "raft 12 3 x 2 x 1 6 1500 afloat 0.3 0.7");
  EXPECT_THAT(lines[3], HasSubstr("box 12 1 x 1 x 1 1 300 afloat"));
}

TEST(RunReport, TellsHowFarABodyIsFromTheWater) {
  const auto lines =
      told_of(kHead +
              "water: {}\n"
              "hydro: {added_mass: none}\n"
              "bodies:\n"
              "  - {name: high, box: {size: [1, 1, 1]}, mass: 1, position: [0, 0, 3]}\n"
              "  - {name: low, box: {size: [1, 1, 1]}, mass: 2, position: [0, 0, -3]}\n");
  EXPECT_EQ(lines[2], "high 12 1 x 1 x 1 1 1 given 2.5 above 3.5");
  EXPECT_EQ(lines[3], "low 12 1 x 1 x 1 1 2 given 3.5 2.5 below");
}

TEST(RunReport, TellsTheAddedMassAndItsSource) {
  const std::string matrix =
      "[[10, 0, 0, 0, 0, 0], [0, 20, 0, 0, 0, 0], [0, 0, 123456, 0, 0, 0],"
      " [0, 0, 0, 4, 0, 0], [0, 0, 0, 0, 5.25, 0], [0, 0, 0, 0, 0, 6]]";
  const auto lines = told_of(
      kHead +
      "water: {}\n"
      "bodies:\n"
      "  - {name: given, box: {size: [1, 1, 1]}, density: 5, hydro: {added_mass: {matrix: " +
      matrix +
      "}}}\n"
      "  - {name: held, box: {size: [1, 1, 1]}, density: 5, lock: all}\n");
  EXPECT_THAT(lines, testing::Contains("added mass surge sway heave kg roll pitch yaw kg m^2"));
  EXPECT_THAT(lines, testing::Contains("given given 10 20 123456 4 5.25 6"));
  EXPECT_EQ(lines.back(), "not computed: added mass of held (held in all six)");
}

TEST(RunReport, TellsThatMethodOdeHasNoAddedMass) {
  const auto lines = told_of(kHead +
                             "integrator: {method: ode}\n"
                             "water: {}\n"
                             "bodies:\n"
                             "  - {name: box, box: {size: [1, 1, 1]}, density: 5}\n");
  EXPECT_EQ(lines.size(), 4u);
  EXPECT_THAT(lines.back(), HasSubstr("added mass of box (method ode has none)"));
}

TEST(RunReport, TellsInHowManySegmentsALineHasInertia) {
  assembly::BuiltScene built;
  built.spec.bodies = {{.name = "buoy"}};
  engine::LineSpec line{.name = "tow",
                        .kind = engine::LineSpec::Kind::rope,
                        .first = {.body = 0},
                        .second = {.at = {30, 0, 0}},
                        .length = 20,
                        .stiffness = 100};
  built.spec.lines = {line};
  line.inertia = engine::LineInertia{.segments = 1, .mass = 2};
  built.spec.lines.push_back(line);
  line = {.name = "7",
          .kind = engine::LineSpec::Kind::mooring,
          .first = {.body = 0},
          .second = {.at = {30, 0, -40}},
          .length = 40,
          .stiffness = 4e5,
          .inertia = engine::LineInertia{.segments = 20, .mass = 2}};
  built.spec.lines.push_back(line);
  const std::vector<std::string> lines = app::resolved_rig(scene::Scene(), built);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(squeezed(lines[1]), "tow rope buoy to world 20 30 100 1000");
  EXPECT_EQ(squeezed(lines[2]), "tow rope buoy to world, dynamic, 1 segment 20 30 100 1000");
  EXPECT_THAT(squeezed(lines[3]),
              StartsWith("7 mooring buoy to anchor, dynamic, 20 segments 40 50 10000 "));
}

TEST(RunReport, OfADrySceneHasNoDraught) {
  const auto lines = told_of(support::kSmallScene, "--no-render");
  EXPECT_THAT(lines[0], HasSubstr("; no water; "));
  EXPECT_THAT(lines[1], EndsWith("mass kg start"));
  EXPECT_EQ(lines.back(),
            "not computed: water (there is none); collisions (nothing can collide); pictures "
            "(--no-render)");
}

TEST(RunReport, TellsFrictionAndRestitutionThatAreNotTheUsual) {
  const std::string scene = kHead +
                            "ground: {z: 0, friction: 0.8}\n"
                            "bodies:\n"
                            "  - {name: a, box: {size: [1, 1, 1]}, mass: 1, restitution: 0.25}\n"
                            "  - {name: b, box: {size: [1, 1, 1]}, mass: 1, position: [3, 0, 0]}\n";
  const std::string told = "contacts: a: restitution 0.25; ground: friction 0.8";
  EXPECT_THAT(told_of(scene), testing::Contains(testing::EndsWith(told)));
  EXPECT_THAT(told_of(scene + "contacts: [{bodies: [b, world], friction: 0.1}]\n"),
              testing::Contains(testing::EndsWith(told + "; b and ground: friction 0.1")));
  EXPECT_THAT(told_of(support::kSmallScene), Not(testing::Contains(HasSubstr("contacts"))));
}

TEST(RunReport, CountsTheBodiesOfReasonsThatAreTooManyToRead) {
  std::string scene = kHead + "water: {}\nbodies:\n";
  for (int i = 0; i < 9; ++i)
    scene += fmt::format(
        "  - {{name: b{}, icosphere: {{radius: 1, subdivisions: 1}}, density: 500,"
        " position: [{}, 0, {}]}}\n",
        i, 9 * i, 1.1 + 0.05 * i);
  const std::string last = told_of(scene).back();
  EXPECT_THAT(last, HasSubstr("radiation of b0 (it starts as if it were let go "));
  EXPECT_THAT(last, HasSubstr("radiation of 5 bodies (for reasons like these)"));
  EXPECT_THAT(last, Not(HasSubstr("of b8 (it")));
}

TEST(RunReport, OfAThousandBodiesIsADozenLines) {
  std::string scene = kHead + "water: {}\nhydro: {added_mass: none}\nbodies:\n";
  for (int i = 0; i < 1000; ++i)
    scene += fmt::format(
        "  - {{name: b{0}, box: {{size: [1, 1, 1]}}, mass: {1}, position: [{2}, 0, {3}]}}\n", i,
        i < 900 ? 100 : i, 2 * i, 0.0001 * i);
  const auto lines = told_of(scene);
  ASSERT_LE(lines.size(), 12u);
  EXPECT_THAT(lines[0], HasSubstr(": 1000 bodies; "));
  EXPECT_EQ(lines[2], "900 like b0 12 1 x 1 x 1 1 100 given 0.41 to 0.5 0.5 to 0.59");
  EXPECT_EQ(lines[5], "and 98 bodies of 98 more kinds: 12 triangles, 902 to 999 kg");
  EXPECT_EQ(lines.back(), "not computed: added mass of all bodies (added_mass: none)");
}

TEST(RunReport, AlignsItsColumns) {
  const scene::Scene scene =
      support::read_scene_text(kHead +
                               "bodies:\n"
                               "  - {name: a, box: {size: [1, 1, 1]}, mass: 1}\n"
                               "  - {name: long name, box: {size: [100, 1, 1]}, mass: 123456}\n");
  const assembly::BuiltScene built = assembly::build_without_added_mass(scene);
  const auto lines = app::resolved_scene(scene, built, {}, "");
  EXPECT_EQ(lines[1], "  body       triangles       size m  volume m^3  mass kg  start");
  EXPECT_EQ(lines[2], "  a                 12    1 x 1 x 1           1        1  given");
  EXPECT_EQ(lines[3], "  long name         12  100 x 1 x 1         100   123456  given");
}

TEST(ProgressText, TellsTimeSpeedAndWhatIsLeft) {
  EXPECT_EQ(app::progress_text("box", 2, 8, 0.5),
            "box: 2.00 of 8 s   25 %  4 x real time  2 s left");
  EXPECT_THAT(app::progress_text("box", 1, 101, 6), EndsWith(" 10 min left"));
  EXPECT_THAT(app::progress_text("box", 1, 101, 360), EndsWith(" 10.0 h left"));
}

}  // namespace

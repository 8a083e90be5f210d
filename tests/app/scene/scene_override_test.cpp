#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/scene_text.h"

namespace {

using support::faults_of;
using support::kSmallScene;
using support::read_scene_text;
using testing::ElementsAre;

/// Two bodies and two waves.
const char* const kSeaScene =
    "plimsoll: 1\n"
    "duration: 1\n"
    "water:\n"
    "  surface:\n"
    "    waves: [{amplitude: 1, wavelength: 10}, {amplitude: 2, wavelength: 20}]\n"
    "bodies:\n"
    "  - {name: hull, sphere: {radius: 1}, density: 500}\n"
    "  - {name: mast 2.0, sphere: {radius: 1}, density: 500}\n";

/// The fault of `parse_override`, empty if there is none.
std::string parse_fault(const std::string& argument) {
  try {
    scene::parse_override(argument);
    return "";
  } catch (const scene::InputError& error) {
    return error.what();
  }
}

TEST(SceneOverride, SplitsAtTheFirstEqualsSignOutsideBrackets) {
  const scene::Override plain = scene::parse_override("title=a=b");
  EXPECT_EQ(plain.key_path, "title");
  EXPECT_EQ(plain.value, "a=b");
  const scene::Override named = scene::parse_override("bodies[a=b].density=5");
  EXPECT_EQ(named.key_path, "bodies[a=b].density");
  EXPECT_EQ(named.value, "5");
}

TEST(SceneOverride, WithoutKeyOrEqualsSignIsAFault) {
  for (const std::string argument : {"", "=5", "density", "bodies[0", "bodies[a=b]"})
    EXPECT_EQ(parse_fault(argument), "--set found " + (argument.empty() ? "nothing" : argument) +
                                         ", expected KEY.PATH=VALUE, as in bodies[0].density=700");
}

TEST(SceneOverride, ReplacesAValue) {
  EXPECT_EQ(read_scene_text(kSmallScene, {"bodies[0].density=700"}).bodies[0].density, 700);
}

TEST(SceneOverride, TheLastOfSeveralHolds) {
  EXPECT_EQ(read_scene_text(kSmallScene, {"step=0.1", "step=0.2"}).step, 0.2);
}

TEST(SceneOverride, ReplacesAValueInANestedList) {
  const scene::Scene scene = read_scene_text(kSeaScene, {"water.surface.waves[1].amplitude=0.1"});
  const auto& waves = std::get<std::vector<scene::Wave>>(scene.water->surface);
  EXPECT_EQ(waves[0].amplitude, 1);
  EXPECT_EQ(waves[1].amplitude, 0.1);
}

TEST(SceneOverride, FindsABodyByItsName) {
  const scene::Scene scene =
      read_scene_text(kSeaScene, {"bodies[mast 2.0].density=7", "bodies[hull].sphere.radius=3"});
  EXPECT_EQ(scene.bodies[1].density, 7);
  EXPECT_EQ(std::get<scene::Sphere>(scene.bodies[0].shape).radius, 3);
}

TEST(SceneOverride, MakesTheBlocksThatAreNotThere) {
  const scene::Scene scene = read_scene_text(kSmallScene, {"render.camera.fov_deg=90"});
  ASSERT_TRUE(scene.render.has_value());
  EXPECT_DOUBLE_EQ(scene.render->camera.field_of_view, std::acos(0.0));
}

TEST(SceneOverride, MayBeAWholeBlock) {
  const scene::Scene scene = read_scene_text(kSmallScene, {"water={level: 2, density: 1025}"});
  EXPECT_EQ(scene.water->level, 2);
  EXPECT_EQ(scene.water->density, 1025);
}

TEST(SceneOverride, OfAnAliasLeavesTheOriginalAlone) {
  const std::string text =
      "plimsoll: 1\nduration: 1\nbodies:\n"
      "  - &first {name: a, sphere: {radius: 1}, density: 500}\n"
      "  - {<<: *first, name: b}\n";
  const scene::Scene scene = read_scene_text(text, {"bodies[b].sphere.radius=2"});
  EXPECT_EQ(std::get<scene::Sphere>(scene.bodies[0].shape).radius, 1);
  EXPECT_EQ(std::get<scene::Sphere>(scene.bodies[1].shape).radius, 2);
}

TEST(SceneOverride, CanMendAFault) {
  EXPECT_THAT(faults_of("plimsoll: 1\nduration: -1\n"),
              ElementsAre("2:11: duration: found -1, expected a number >= 0 [s]"));
  EXPECT_THAT(faults_of("plimsoll: 1\nduration: -1\n", {"duration=1"}), ElementsAre());
}

TEST(SceneOverride, IsCheckedLikeTheFile) {
  EXPECT_THAT(faults_of(kSmallScene, {"bodies[a].densty=3"}),
              ElementsAre("--set bodies[0].densty: unknown key; did you mean density?"));
  EXPECT_THAT(
      faults_of(kSmallScene, {"bodies[a].density=-3"}),
      ElementsAre("--set bodies[0].density: found -3, expected a positive number [kg/m^3]"));
  EXPECT_THAT(faults_of(kSmallScene, {"bodies[0].mass=3"}),
              ElementsAre("--set bodies[0].mass: given beside density, expected only one of "
                          "density and mass"));
  EXPECT_THAT(faults_of(kSmallScene, {"water={level: 1, level: 2}"}),
              ElementsAre("--set water.level: given twice"));
  EXPECT_THAT(faults_of(kSmallScene, {"title="}),
              ElementsAre("--set title: found nothing, expected a text"));
}

TEST(SceneOverride, ThatLeadsNowhereSaysWhatIsThere) {
  const auto fault = [](const std::string& argument) { return faults_of(kSeaScene, {argument}); };
  EXPECT_THAT(fault("bodies[2].density=3"),
              ElementsAre("--set bodies[2].density: bodies has 2 entries, the last is bodies[1]"));
  EXPECT_THAT(fault("bodies[hulk].density=3"),
              ElementsAre("--set bodies[hulk].density: bodies has no entry named hulk; did you "
                          "mean hull?"));
  EXPECT_THAT(fault("joints[0].type=ball"),
              ElementsAre("--set joints[0].type: joints has no entries"));
  EXPECT_THAT(fault("bodies.density=3"),
              ElementsAre("--set bodies.density: bodies is no map, so it has no key density"));
  EXPECT_THAT(fault("duration[0]=3"),
              ElementsAre("--set duration[0]: duration is no list, so it has no entry 0"));
}

TEST(SceneOverride, ThatIsNoKeyPathOrNoYamlIsAFault) {
  const auto fault = [](const std::string& argument) { return faults_of(kSeaScene, {argument}); };
  EXPECT_THAT(fault("water..level=3"),
              ElementsAre("--set water..level: not a key path: a key or index is empty"));
  EXPECT_THAT(fault("bodies[0]name=3"),
              ElementsAre("--set bodies[0]name: not a key path: expected a key"));
  EXPECT_THAT(fault("bodies[]=3"),
              ElementsAre("--set bodies[]: not a key path: a key or index is empty"));
  EXPECT_THAT(fault("title={a"),
              ElementsAre("--set title: found {a: not valid YAML: end of map flow not found"));
}

}  // namespace

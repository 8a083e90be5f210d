#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "app/scene/key_catalogue.h"
#include "tests/app/scene_text.h"

/// Overrides against the whole catalogue: every key is reached, also where the scene has none of
/// the blocks that it stands in.

namespace {

using Kind = scene::ValueShape::Kind;
using support::faults_of;
using support::kSmallScene;
using support::read_scene_text;
using testing::ElementsAre;

const char* const kEmptyScene = "plimsoll: 1\nduration: 1\n";

/// A number within the limits that is no default; in a list they grow.
std::string number_for(const scene::ValueShape& shape, std::size_t entry) {
  const bool low = std::isfinite(shape.lo), high = std::isfinite(shape.hi);
  if (low && high) return shape.kind == Kind::whole ? std::to_string(std::lround(shape.hi)) : "1";
  return std::to_string(3 + entry);
}

/// A value of a shape, as YAML. Entries are told apart, for lists that ask for it.
std::string value_for(const scene::ValueShape& shape, std::size_t entry = 0) {
  switch (shape.kind) {
    case Kind::number:
    case Kind::whole:
      return number_for(shape, entry);
    case Kind::word:
      return shape.words[entry % shape.words.size()];
    case Kind::truth:
    case Kind::off:
      return "false";
    case Kind::text:
      return "text" + std::to_string(entry);
    case Kind::file:
      return (support::data_folder() / "shore.obj").string();
    case Kind::map:
      return "{}";
    case Kind::list:
      break;
  }
  std::string list;
  for (std::size_t i = 0; i < std::max<std::size_t>({shape.count, shape.least, 1}); ++i)
    list += (list.empty() ? "[" : ", ") + value_for(shape.item.front(), i);
  return list + "]";
}

std::string with_entries(const std::string& path, const std::string& entry) {
  return std::regex_replace(path, std::regex(R"(\[\])"), entry);
}

/// The faults of a key and of what stands in it, or of an override that was not applied.
std::vector<std::string> faults_at(const std::string& key_path, const std::string& value) {
  const std::string met = "--set " + with_entries(key_path, "[0]");
  std::vector<std::string> faults;
  for (const std::string& fault :
       faults_of(kEmptyScene, {with_entries(key_path, "[+]") + "=" + value}))
    if (fault.starts_with(met + ":") || fault.starts_with(met + "[") ||
        fault.find("[+]") != std::string::npos)
      faults.push_back(fault);
  return faults;
}

/// What a value that is made from its shape alone cannot be right about.
bool needs_others(const std::string& fault) {
  for (const char* reason : {"missing, ",
                             "found a zero",
                             "is no map of keys",
                             "copies, expected at most",
                             "expected a symmetric matrix",
                             "found the principal moments",
                             "there is no body named",
                             "is only used with",
                             "not used by",
                             "needs water",
                             "wind is horizontal",
                             "of a table is horizontal",
                             "expected a greater depth",
                             "one for each depth",
                             "a list of at least 2",
                             "the unknown name text",
                             "no quantity named",
                             "makes an angle of",
                             "does not include 0",
                             "no set point named",
                             "no propeller named",
                             "needs air",
                             "a table from 0 or less",
                             "does not fall in its last",
                             "expected a number from -0.9 to 0.9"})
    if (fault.find(reason) != std::string::npos) return true;
  return false;
}

TEST(SceneOverride, ReachesEveryKeyOfASceneWithoutBlocks) {
  for (const scene::KeyDescription& key : scene::key_catalogue().keys)
    for (const scene::ValueShape& shape : key.shapes)
      for (const std::string& fault : faults_at(key.path, value_for(shape)))
        EXPECT_TRUE(needs_others(fault)) << fault;
}

TEST(SceneOverride, IsHeldToTheRulesOfEveryKey) {
  for (const scene::KeyDescription& key : scene::key_catalogue().keys) {
    if (key.path == "plimsoll") continue;  // of another version nothing else is said
    const auto may_be = [&](Kind kind) {
      return std::ranges::any_of(key.shapes, [=](const auto& shape) { return shape.kind == kind; });
    };
    const std::string wrong = !may_be(Kind::map) ? "{a: 1}" : may_be(Kind::list) ? "a" : "[]";
    EXPECT_FALSE(faults_at(key.path, wrong).empty()) << key.path;
  }
}

TEST(SceneOverride, AddsAnEntryToAList) {
  const scene::Scene scene = read_scene_text(
      kSmallScene, {"bodies[+].name=b", "bodies[b].sphere.radius=2", "bodies[b].mass=7",
                    "bodies[a].forces[+].force=[1, 2, 3]", "bodies[a].forces[+].start=4"});
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(std::get<scene::Sphere>(scene.bodies[1].shape).radius, 2);
  EXPECT_EQ(scene.bodies[1].mass, 7);
  ASSERT_EQ(scene.bodies[0].forces.size(), 2u);
  EXPECT_EQ(scene.bodies[0].forces[1].start, 4);
}

TEST(SceneOverride, TakesAwayAKeyOrAnEntry) {
  const scene::Scene scene =
      read_scene_text(kSmallScene, {"bodies[a].density=null", "bodies[a].mass=7"});
  EXPECT_FALSE(scene.bodies[0].density.has_value());
  EXPECT_EQ(scene.bodies[0].mass, 7);
  EXPECT_TRUE(read_scene_text(kSmallScene, {"bodies[a]=null"}).bodies.empty());
}

TEST(SceneOverride, CannotTakeAwayWhatIsNotThere) {
  EXPECT_THAT(faults_of(kSmallScene, {"bodies[0].densty=null"}),
              ElementsAre("--set bodies[0].densty: does not exist, so it cannot be removed"));
  EXPECT_THAT(faults_of(kSmallScene, {"bodies[1]=null"}),
              ElementsAre("--set bodies[1]: bodies has 1 entry, the last is bodies[0]"));
  EXPECT_THAT(faults_of(kSmallScene, {"render.camera.fov_deg=null"}),
              ElementsAre("--set render.camera.fov_deg: does not exist, so it cannot be removed"));
}

}  // namespace

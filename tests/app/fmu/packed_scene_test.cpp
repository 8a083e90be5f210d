#include "app/fmu/packed_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/assembly/build.h"
#include "app/assembly/pending_solutions.h"
#include "app/base/atomic_file.h"
#include "app/fmu/companion_files.h"
#include "app/fmu/unit.h"
#include "app/scene/reader.h"
#include "tests/app/fmu/units.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

const char* const kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A folder of a test's own with a scene in `scenes` that includes a file in `parts`, whose bodies
/// have a mesh in `meshes`.
class PackedScene : public testing::Test {
 protected:
  PackedScene() {
    fs::remove_all(place);
    write("meshes/four faces.obj", kTetrahedron);
    write("meshes/other.obj", kTetrahedron);
    write("parts/fleet.yaml",
          "variables: {side: 2}\n"
          "bodies:\n"
          "  - name: boat\n"
          "    repeat: {grid: [3, 1, 1], spacing: [\"${side}\", 0, 0]}\n"
          "    mesh: {file: ../meshes/four faces.obj}\n"
          "    density: 400\n"
          "    position: [0, 0, 1]\n");
    write("scenes/fleet.yaml",
          "plimsoll: 1\nduration: 1\nstep: 0.01\nwater: {}\ninclude: ../parts/fleet.yaml\n"
          "hydro: {radiation: none}\n"
          "bodies:\n"
          "  - {name: other, mesh: {file: ../meshes/other.obj}, density: 400, position: [0, 5, "
          "1]}\n");
  }
  ~PackedScene() override { fs::remove_all(place); }

  void write(const fs::path& file, const std::string& text) const {
    app::write_whole(place / file, text);
  }

  fs::path place = fs::path(testing::TempDir()) /
                   (std::string("plimsoll_packed_scene_") +
                    testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::path scene = place / "scenes/fleet.yaml";
};

TEST_F(PackedScene, HasItsFilesInFoldersOfTheirOwn) {
  const fmu::PackedScene packed = fmu::packed_scene(scene, {{"duration", "7"}});
  EXPECT_THAT(packed.files,
              UnorderedElementsAre(Field(&fmu::PackedFile::name, "files/1/other.obj"),
                                   Field(&fmu::PackedFile::name, "files/0/four faces.obj")));
  EXPECT_THAT(packed.text, HasSubstr("files/0/four faces.obj"));
  EXPECT_THAT(packed.text, HasSubstr("duration: 7"));
  EXPECT_THAT(packed.text, Not(HasSubstr("..")));
  EXPECT_THAT(packed.text, Not(HasSubstr("include")));
}

TEST_F(PackedScene, IsTheSceneThatItWasMadeOf) {
  fmu::write_resources({.file = scene}, place / "resources");
  fs::rename(place / "meshes", place / "elsewhere");
  fs::remove_all(place / "parts");
  const fmu::LoadedScene loaded = fmu::load_scene(place / "resources", app::quiet());
  ASSERT_EQ(loaded.built.spec.bodies.size(), 4U);
  EXPECT_EQ(loaded.built.spec.bodies[3].name, "other");
  EXPECT_EQ(loaded.built.spec.bodies[2].name, "boat_2");
  EXPECT_NEAR(loaded.built.spec.bodies[2].mass, 400.0 / 6, 1e-9);
}

TEST_F(PackedScene, HasItsSolutionsWithIt) {
  fmu::write_resources({.file = scene}, place / "resources");
  const fs::path solutions = place / "resources/solutions";
  EXPECT_THAT(support::files_in(solutions), Not(IsEmpty()));
  const scene::Scene packed = scene::read(place / "resources/scene.yaml");
  EXPECT_THAT(
      assembly::pending_solutions(packed, assembly::build_without_added_mass(packed), solutions, 1),
      IsEmpty());
}

TEST_F(PackedScene, HasATokenThatChangesWithWhatItIs) {
  const auto token = [&](const std::vector<scene::Override>& overrides) {
    fs::remove_all(place / "resources");
    fmu::write_resources({.file = scene, .overrides = overrides}, place / "resources");
    return fmu::token_of(place / "resources");
  };
  const std::string first = token({});
  EXPECT_THAT(first, testing::StartsWith("plimsoll-"));
  EXPECT_EQ(token({}), first);
  EXPECT_NE(token({{"step", "0.02"}}), first);
  write("meshes/other.obj", std::string(kTetrahedron) + "# another file\n");
  EXPECT_NE(token({}), first);
}

TEST_F(PackedScene, TellsTheFaultsOfTheScene) {
  write("scenes/fleet.yaml", "plimsoll: 1\nduration: -1\nbodies: []\n");
  EXPECT_THAT([&] { fmu::write_resources({.file = scene}, place / "resources"); },
              testing::ThrowsMessage<scene::InputError>(HasSubstr("fleet.yaml:2:11: duration: ")));
}

TEST_F(PackedScene, FindsWhatAFileNeedsBesideIt) {
  write("m/a.gltf", R"({"buffers": [{"uri": "a.bin"}, {"uri": "../b.bin"}, {"uri": "none.bin"},
                        {"uri": "data:,x"}, {}]})");
  write("m/a.bin", "1");
  write("b.bin", "2");
  const auto names = [&](const fs::path& file) {
    std::vector<std::string> all;
    for (const fmu::Companion& one : fmu::companions_of(place / file)) all.push_back(one.name);
    return all;
  };
  EXPECT_THAT(names("m/a.gltf"), ElementsAre("a.bin"));
  write("m/broken.gltf", "{");
  EXPECT_THAT(names("m/broken.gltf"), IsEmpty());
  for (const char* file : {"w/hull.1", "w/hull.3", "w/hull.hst", "w/hull.out"}) write(file, "");
  EXPECT_THAT(names("w/hull.1"), ElementsAre("hull.3", "hull.hst"));
  for (const char* file : {"Nemoh.cal", "results/RadiationCoefficients.tec",
                           "results/ExcitationForce.tec", "results/notes.txt"})
    write(fs::path("n") / file, "");
  EXPECT_THAT(names("n/results/RadiationCoefficients.tec"),
              ElementsAre("ExcitationForce.tec", "Nemoh.cal"));
  EXPECT_THAT(names("meshes/other.obj"), IsEmpty());
}

}  // namespace

#include "app/assembly/mesh_mending.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "app/assembly/build.h"
#include "app/assembly/mesh_io.h"
#include "app/assembly/mesh_writer.h"
#include "app/scene/diagnostics.h"
#include "hydro/mesh/mass_properties.h"
#include "tests/app/build_fault.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"
#include "tests/support/wild_meshes.h"

namespace {

namespace fs = std::filesystem;
using assembly::RemedyWords;
using hydro::TriMesh;
using support::WildMesh;
using testing::AllOf;
using testing::HasSubstr;

/// A folder for the files of one test, removed with it.
class MeshFiles : public testing::Test {
 protected:
  MeshFiles() { fs::create_directories(folder_); }
  ~MeshFiles() override { fs::remove_all(folder_); }

  fs::path written(const std::string& name, const TriMesh& mesh) const {
    assembly::write_mesh(folder_ / name, mesh);
    return folder_ / name;
  }
  /// A scene with one body of a mesh file and more keys of its mesh.
  static std::string floating(const fs::path& file, const std::string& keys) {
    return "plimsoll: 1\nduration: 1\nwater: {density: 1000}\n"
           "hydro: {added_mass: none, radiation: none}\nbodies:\n"
           "  - {name: hull, density: 500, start: equilibrium, mesh: {file: " +
           file.string() + keys + "}}\n";
  }

 private:
  fs::path folder_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TriMesh open_box() {
  return support::without(support::box_at({4, 2, 1}, {0, 0, 0.5}, 4),
                          [](const Eigen::Vector3d& p) { return p.z() > 1 - 1e-9; });
}

TEST_F(MeshFiles, AreReadAsTheyWereWritten) {
  const TriMesh mesh =
      transformed(support::make_torus(2, 0.7, 12, 9),
                  Eigen::Isometry3d(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized())));
  EXPECT_TRUE(same_mesh(assembly::read_mesh(written("a.obj", mesh)), mesh));
  const TriMesh floats = assembly::read_mesh(written("a.STL", mesh));
  EXPECT_EQ(floats.face_count(), mesh.face_count());
  EXPECT_NEAR(hydro::solid_properties(floats).volume, hydro::solid_properties(mesh).volume,
              support::tolerance(1e-5));
}

TEST_F(MeshFiles, FromTheWildAreSolidsAfterTheirRepairInAnyFormat) {
  for (const WildMesh& wild : support::wild_meshes()) {
    for (const char* const name : {"wild.stl", "wild.obj"}) {
      const TriMesh read = assembly::read_mesh(written(name, wild.mesh));
      const hydro::MendedMesh mended = hydro::mended(read, wild.options);
      EXPECT_THAT(describe(mended.report), testing::IsEmpty()) << wild.name << " " << name;
      EXPECT_NEAR(mended.report.volume / wild.volume, 1, support::tolerance(1e-3)) << wild.name;
      // What was written is read as a solid, without a repair.
      const TriMesh again = assembly::read_solid(written("mended.obj", mended.mesh), app::quiet());
      EXPECT_NEAR(hydro::solid_properties(again).volume / wild.volume, 1, support::tolerance(1e-3))
          << wild.name;
    }
  }
}

TEST_F(MeshFiles, FromTheWildFloatInScenesWithTheKeys) {
  for (const WildMesh& wild : support::wild_meshes()) {
    const fs::path file = written("wild.obj", wild.mesh);
    hydro::MendOptions options = wild.options;
    if (options == hydro::MendOptions()) options.weld = hydro::default_weld(wild.mesh);
    const std::string keys = ", " + assembly::words_of(options, wild.mesh, RemedyWords::keys);
    const assembly::BuiltScene built =
        assembly::build_without_added_mass(support::read_scene_text(floating(file, keys)));
    ASSERT_EQ(built.spec.bodies.size(), 1) << wild.name;
    EXPECT_NEAR(built.spec.bodies[0].mass / (500 * wild.volume), 1, support::tolerance(1e-3))
        << wild.name;
    ASSERT_EQ(built.mesh_sources[0].size(), 1);
    ASSERT_TRUE(built.mesh_sources[0][0].mended);
    EXPECT_NEAR(built.mesh_sources[0][0].mended->volume_after / wild.volume, 1,
                support::tolerance(1e-3));
  }
}

TEST_F(MeshFiles, ThatAreOpenAreRefusedWithTheKeyOrTheCommandThatHelps) {
  const fs::path file = written("open.obj", open_box());
  EXPECT_THAT(support::build_fault(floating(file, "")),
              AllOf(HasSubstr("16 edges are open"),
                    HasSubstr("with `cap: true` beside `file` it is a solid of 8 m^3")));
  try {
    assembly::read_solid(file, app::quiet());
    ADD_FAILURE() << "an open mesh was read";
  } catch (const scene::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("plimsoll mesh " + file.string() +
                                        " --repair --cap -o solid.obj` makes a solid of 8 m^3"));
  }
}

TEST_F(MeshFiles, KeysThatCannotBeServedAreFaults) {
  const fs::path file = written("box.obj", support::box_at({4, 2, 1}, {0, 0, 0.5}));
  EXPECT_THAT(support::build_fault(floating(file, ", mirror: y")),
              HasSubstr("bodies[0].mesh: the mesh lies on both sides of the plane y = 0"));
  EXPECT_THAT(
      support::build_fault("plimsoll: 1\nduration: 1\nground: {mesh: {file: " + file.string() +
                           ", cap: true}}\n"
                           "bodies: [{name: a, box: {size: [1, 1, 1]}, density: 500}]\n"),
      HasSubstr("ground.mesh: is a surface"));
}

TEST(RemedyWords, AreThoseOfScenesAndOfTheCommand) {
  const TriMesh box = support::box_at({4, 2, 1}, {0, 0, 0.5});
  const hydro::MendOptions all = {
      .weld = 1e-3, .cap = true, .mirror = 1, .unite = true, .thickness = 0.02};
  EXPECT_EQ(words_of(all, box, RemedyWords::keys),
            "weld: 0.001, cap: true, mirror: y, unite: true, thickness: 0.02");
  EXPECT_EQ(words_of(all, box, RemedyWords::options),
            "--repair --weld 0.001 --cap --mirror y --unite --thickness 0.02");
  EXPECT_EQ(words_of({.weld = 5e-5}, box, RemedyWords::options), "--repair");
  EXPECT_EQ(words_of({.weld = 5e-5}, box, RemedyWords::keys), "weld: 5e-05");
}

}  // namespace

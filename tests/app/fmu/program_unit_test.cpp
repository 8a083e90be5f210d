#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/fmu/archive.h"
#include "app/logs/read_log.h"
#include "tests/app/fmu/units.h"
#include "tests/app/fmu/unpacked.h"
#include "tests/app/program/program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using support::Importer;
using support::kTow;
using testing::AllOf;
using testing::HasSubstr;

/// Loads the library of a unit, as an importer does.
support::UnitFunctions loaded(const fs::path& library) {
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw std::runtime_error(dlerror());
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, name));
    if (function == nullptr) throw std::runtime_error(dlerror());
  };
  support::UnitFunctions functions;
  find(functions.instantiate, "fmi3InstantiateCoSimulation");
  find(functions.free_instance, "fmi3FreeInstance");
  find(functions.enter_initialization, "fmi3EnterInitializationMode");
  find(functions.exit_initialization, "fmi3ExitInitializationMode");
  find(functions.set, "fmi3SetFloat64");
  find(functions.get, "fmi3GetFloat64");
  find(functions.do_step, "fmi3DoStep");
  find(functions.terminate, "fmi3Terminate");
  find(functions.reset, "fmi3Reset");
  return functions;
}

/// A scene in the folder of a test, where the program can export it.
class ProgramUnit : public testing::Test {
 protected:
  ProgramUnit() : scene(place.write("tow.yaml", kTow)) {}

  void SetUp() override {
    if (!fmu::why_no_archives().empty()) GTEST_SKIP() << fmu::why_no_archives();
    if (!fs::exists(fs::path(PLIMSOLL_PROGRAM).parent_path() / "fmu/plimsoll_unit.so"))
      GTEST_SKIP() << "the library of units is not built";
  }

  std::string fault(const std::vector<std::string>& words) const {
    const support::Outcome done = place.run(words);
    EXPECT_EQ(done.code, 2) << done.err;
    return done.err;
  }

  support::Workplace place;
  std::string scene;
};

TEST_F(ProgramUnit, RunsInAnImporterAsTheProgramRunsIt) {
  const support::Outcome done = place.run({"export", scene, "unit.fmu"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.err, AllOf(HasSubstr("unit.fmu: "), HasSubstr("steps of 0.02 s")));
  ASSERT_EQ(place.run({"run", scene, "--out", "run", "--no-render", "--quiet"}).code, 0);
  support::unpack(place / "unit.fmu", place / "unit");
  const support::Description description =
      support::described(place.read("unit/modelDescription.xml"));
  const fs::path binaries = place / "unit/binaries";
  const fs::path platform = binaries / support::files_in(binaries).at(0);
  Importer unit(loaded(platform / (description.identifier + ".so")), description,
                place / "unit/resources");
  unit.initialize(true);
  unit.step(20, 0.1);
  const auto log = app::read_trajectory(place / "run/trajectory.csv");
  for (const char* body : {"tug", "barge"}) {
    const hydro::BodyState& last = log.tracks.at(body).states.back();
    const std::string name = std::string(body) + ".";
    EXPECT_EQ(unit.get(name + "x"), last.position.x());
    EXPECT_EQ(unit.get(name + "y"), last.position.y());
    EXPECT_EQ(unit.get(name + "qz"), last.orientation.z());
    EXPECT_EQ(unit.get(name + "vz"), last.linear_velocity.z());
    EXPECT_EQ(unit.get(name + "wx"), last.angular_velocity.x());
  }
  // A second instance of the library is another one, and goes the same way.
  Importer other(loaded(platform / (description.identifier + ".so")), description,
                 place / "unit/resources");
  other.initialize();
  other.step(50, 0.04);
  EXPECT_THAT(other.outputs(), testing::ContainerEq(unit.outputs()));
}

TEST_F(ProgramUnit, HasTheSameBytesInEveryExport) {
  ASSERT_EQ(place.run({"export", scene, "one.fmu", "--quiet"}).code, 0);
  ASSERT_EQ(place.run({"export", scene, "a/two.fmu", "--quiet"}, {"TZ=Asia/Tokyo"}).code, 0);
  EXPECT_EQ(place.read("one.fmu"), place.read("a/two.fmu"));
  ASSERT_EQ(place.run({"export", scene, "three.fmu", "--quiet", "--set", "step=0.01"}).code, 0);
  support::unpack(place / "three.fmu", place / "three");
  EXPECT_EQ(support::described(place.read("three/modelDescription.xml")).step, 0.01);
}

TEST_F(ProgramUnit, TellsWhatIsWrong) {
  place.write("wrong.yaml", std::string(kTow) + "watre: {}\n");
  EXPECT_THAT(fault({"export", "wrong.yaml", "unit.fmu"}),
              AllOf(HasSubstr("watre: unknown key"), HasSubstr("1 problem.")));
  EXPECT_THAT(fault({"export", scene, "unit.fmu", "--set", "bodies[tug].mass=-1"}),
              HasSubstr("--set bodies[0].mass: found -1"));
  fs::create_directories(place / "run");
  EXPECT_THAT(fault({"export", "run", "unit.fmu"}),
              HasSubstr("run: is no scene (.yaml), of which alone a unit is made"));
  EXPECT_THAT(fault({"export", scene, "unit.fmu", "--fps", "5"}),
              HasSubstr("unit.fmu: is a unit, for which there is no --fps"));
  place.write("file", "");
  EXPECT_THAT(fault({"export", scene, "file/unit.fmu"}), HasSubstr("file"));
  EXPECT_FALSE(fs::exists(place / "unit.fmu"));
}

TEST_F(ProgramUnit, NeedsTheLibraryBesideTheProgram) {
  fs::copy_file(PLIMSOLL_PROGRAM, place / "plimsoll");
  const support::Outcome done = place.shell("./plimsoll export tow.yaml unit.fmu");
  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, AllOf(HasSubstr("error: the library of units is missing: it is neither "),
                              HasSubstr("/fmu/plimsoll_unit.so nor ")));
}

}  // namespace

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "tests/app/program/program.h"

/// @file
/// Files and names that were made to do harm.

namespace {

using support::Outcome;
using support::Workplace;
using testing::HasSubstr;
using testing::Not;

class ProgramHostile : public testing::Test {
 protected:
  Workplace work;
};

const std::string kTetrahedronObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// The same as an AC3D file, a format that is read on request only.
const std::string kTetrahedronAc =
    "AC3Db\nMATERIAL \"\" rgb 1 1 1  amb 0.2 0.2 0.2  emis 0 0 0  spec 0.5 0.5 0.5  shi 10  trans "
    "0\n"
    "OBJECT world\nkids 1\nOBJECT poly\nnumvert 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\nnumsurf 4\n"
    "SURF 0x0\nmat 0\nrefs 3\n0 0 0\n2 0 0\n1 0 0\nSURF 0x0\nmat 0\nrefs 3\n0 0 0\n1 0 0\n3 0 0\n"
    "SURF 0x0\nmat 0\nrefs 3\n0 0 0\n3 0 0\n2 0 0\nSURF 0x0\nmat 0\nrefs 3\n1 0 0\n2 0 0\n3 0 0\n"
    "kids 0\n";

std::string scene_with(const std::string& mesh) {
  return "plimsoll: 1\nduration: 0.1\nstep: 0.05\nbodies:\n  - name: a\n    mesh: {file: " + mesh +
         "}\n    density: 500\n";
}

TEST_F(ProgramHostile, AMeshOfAnotherFormatNamesItsPlaceAndTheOption) {
  work.write("a.ac", kTetrahedronAc);
  const std::string scene = work.write("scene.yaml", scene_with("a.ac"));
  const Outcome refused = work.run({"check", scene});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("scene.yaml:6:18: bodies[0].mesh.file: "));
  EXPECT_THAT(refused.err, HasSubstr("--any-format"));
  EXPECT_EQ(work.run({"check", scene, "--any-format"}).code, 0);
  EXPECT_EQ(work.run({"probe", scene, "--any-format"}).code, 0);
  EXPECT_EQ(work.run({"hydrostatics", "a.ac", "--mass", "10", "--any-format"}).code, 0);
  EXPECT_EQ(work.run({"hydrostatics", "a.ac", "--mass", "10"}).code, 2);
}

TEST_F(ProgramHostile, ARunRemembersThatItReadAnyFormat) {
  work.write("a.ac", kTetrahedronAc);
  const std::string scene = work.write("scene.yaml", scene_with("a.ac"));
  EXPECT_EQ(work.run({"run", scene, "--out", "out", "--quiet", "--any-format"}).code, 0);
  EXPECT_THAT(work.read("out/summary.json"), HasSubstr("\"any_format\": true"));
  work.write("b.obj", kTetrahedronObj);
  const std::string common = work.write("common.yaml", scene_with("b.obj"));
  EXPECT_EQ(work.run({"run", common, "--out", "common", "--quiet"}).code, 0);
  EXPECT_THAT(work.read("common/summary.json"), Not(HasSubstr("any_format")));
}

TEST_F(ProgramHostile, ASweepHandsTheOptionToItsRuns) {
  work.write("a.ac", kTetrahedronAc);
  const std::string scene = work.write("scene.yaml", scene_with("a.ac"));
  const Outcome swept =
      work.run({"sweep", scene, "--out", "s", "--vary", "bodies[0].density=500,600", "--any-format",
                "--quiet", "-j", "1"});
  EXPECT_EQ(swept.code, 0) << swept.err;
}

TEST_F(ProgramHostile, APipeInPlaceOfAMeshDoesNotBlock) {
  ASSERT_EQ(::mkfifo((work / "pipe.obj").c_str(), 0600), 0);
  const std::string scene = work.write("scene.yaml", scene_with("pipe.obj"));
  const Outcome refused = work.run({"check", scene});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("found pipe.obj, expected a file"));
}

TEST_F(ProgramHostile, NamesInAJunitReportAreNoMarkup) {
  const std::string name = "</testcase><x y='z'>]]>&\x01\xff";
  const std::string row = "0," + name + ",0,0,0,1,0,0,0,0,0,0,0,0,0\n";
  work.write("a.csv", support::kTrajectoryHeader + row);
  work.write("b.csv", support::kTrajectoryHeader + row);
  EXPECT_EQ(work.run({"compare", "a.csv", "b.csv", "--junit", "report.xml", "--json"}).code, 0);
  const std::string report = work.read("report.xml");
  EXPECT_THAT(report, HasSubstr("classname=\"&lt;/testcase&gt;&lt;x y='z'&gt;]]&gt;&amp;"
                                "\xEF\xBF\xBD\xEF\xBF\xBD\""));
}

TEST_F(ProgramHostile, AFileNameInATableIsQuoted) {
  const std::string mesh = work.write("a,\"b\".obj", kTetrahedronObj);
  const Outcome table = work.run({"hydrostatics", mesh, "--mass", "10", "--csv"});
  EXPECT_EQ(table.code, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("\n\"a,\"\"b\"\"\",body,"));
  EXPECT_THAT(table.out, Not(HasSubstr("\na,")));
}

TEST_F(ProgramHostile, EscapesOfSceneFileNameAndLogReachNoTerminal) {
  const std::string scene =
      work.write("\x1b[1m.yaml", "plimsoll: 1\nduration: 0\n\"\\e]0;owned\\a\\e[31mred\": 1\n");
  const Outcome fault = work.run({"check", scene});
  EXPECT_THAT(fault.err, HasSubstr("\\x1b[1m.yaml:3:1: \\x1b]0;owned\\x07\\x1b[31mred: unknown"));
  const std::string mesh = work.write("\x1b[31m\xc2\x9b.obj", kTetrahedronObj);
  const Outcome table = work.run({"hydrostatics", mesh, "--mass", "10"});
  const Outcome printed = work.run({"hydrostatics", mesh, "--mass", "10", "--json"});
  EXPECT_THAT(table.out, HasSubstr("\\x1b[31m\\u009b"));
  EXPECT_THAT(printed.out, HasSubstr("\\u001b[31m\\u009b"));
  const std::string row = "0,\x1b[31mred,0,0,0,1,0,0,0,0,0,0,0,0,0\n";
  work.write("a.csv", support::kTrajectoryHeader + row);
  const Outcome compared = work.run({"compare", "a.csv", "a.csv"});
  EXPECT_THAT(compared.out, HasSubstr("\\x1b[31mred"));
  for (const Outcome& outcome : {fault, table, printed, compared})
    EXPECT_THAT(outcome.out + outcome.err,
                Not(testing::AnyOf(HasSubstr("\x1b"), HasSubstr("\a"), HasSubstr("\x9b"))));
}

TEST_F(ProgramHostile, AFileNameThatIsNoUtf8DoesNotEndACommand) {
  const std::string mesh = work.write("a\xff.obj", kTetrahedronObj);
  const Outcome printed = work.run({"hydrostatics", mesh, "--mass", "10", "--json"});
  EXPECT_EQ(printed.code, 0) << printed.err;
  EXPECT_THAT(printed.out, HasSubstr("\"a\xEF\xBF\xBD\""));
}

TEST_F(ProgramHostile, AFolderCannotPutCommandsIntoASlurmScript) {
  work.write("b.obj", kTetrahedronObj);
  const std::string scene = work.write("scene.yaml", scene_with("b.obj"));
  const std::string folder = "s\ntouch pwned\n$(touch pwned)`touch pwned`'\"";
  const Outcome made =
      work.run({"sweep", scene, "--out", folder, "--vary", "bodies[0].density=500,600", "--slurm"});
  EXPECT_EQ(made.code, 0) << made.err;
  // Task 0 of the array is done as Slurm does it.
  const Outcome done =
      work.shell("for script in s*/sweep.sbatch; do SLURM_ARRAY_TASK_ID=0 bash \"$script\"; done");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_FALSE(std::filesystem::exists(work / "pwned"));
  EXPECT_TRUE(std::filesystem::exists(work / std::filesystem::path(folder) / "runs/0000"));
}

}  // namespace

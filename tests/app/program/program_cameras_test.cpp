#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/program/page.h"
#include "tests/app/program/program.h"
#include "tests/support/files.h"

/// Pictures by cameras that move, and by several.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::files_in;
using support::Outcome;
using support::Workplace;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kOne = "render: {size: [160, 120], every: 0.2}\n";
const std::string kTwo =
    "render: {size: [160, 120], every: 0.2, cameras: {"
    "side: {from: [6, -8, 3], to: [0, 0, 0], follow: box}, "
    "Top-1: {from: [1, 0, 9], orbit: 90}}}\n";

class ProgramCameras : public testing::Test {
 protected:
  /// Runs a falling box into the folder `o`. @return what it says
  std::string run_box(const std::string& render, const std::vector<std::string>& more = {}) {
    here.write("box.yaml", falling_box("0.6", render));
    std::vector<std::string> words = {"run", "box.yaml", "--out", "o"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = here.run(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.err;
  }

  Workplace here;
};

TEST_F(ProgramCameras, HaveAFolderAndASheetEach) {
  EXPECT_THAT(run_box(kTwo), HasSubstr("o: 8 pictures, by the cameras side and Top-1\n"));
  EXPECT_THAT(files_in(here / "o"), ElementsAre("frames", "sheet_Top-1.png", "sheet_side.png",
                                                "summary.json", "trajectory.csv"));
  EXPECT_THAT(files_in(here / "o/frames"), ElementsAre("Top-1", "side"));
  EXPECT_THAT(files_in(here / "o/frames/side"),
              ElementsAre("frame_0000.png", "frame_0001.png", "frame_0002.png", "frame_0003.png"));
  EXPECT_NE(here.read("o/sheet_side.png"), here.read("o/sheet_Top-1.png"));
  const json pictures = json::parse(here.read("o/summary.json"))["pictures"];
  EXPECT_EQ(pictures["frames"], 8);
  EXPECT_EQ(pictures["cameras"], json({"side", "Top-1"}));
}

TEST_F(ProgramCameras, OnABodySeeItAlwaysAtTheSamePlace) {
  // All that tells where the camera is, is a body that turns, and no light but that of the sky.
  here.write("dry.yaml",
             "plimsoll: 1\nduration: 0.5\nstep: 0.1\ngravity: 0\nbodies:\n"
             "  - {name: box, box: {size: [1, 1, 1]}, density: 500, angular_velocity: [0, 0, 2],"
             " linear_velocity: [3, 1, 0]}\n"
             "render: {size: [100, 80], every: 0.4}\n");
  const auto sees_the_same = [&](const std::string& camera) {
    EXPECT_EQ(here.run({"run", "dry.yaml", "--out", "o", "--set", "render.camera=" + camera}).code,
              0);
    return here.read("o/frames/frame_0001.png") == here.read("o/frames/frame_0000.png");
  };
  EXPECT_TRUE(sees_the_same("{on: box, from: [4, 3, 2], to: [0, 0, 0]}"));
  EXPECT_FALSE(sees_the_same("{follow: box, from: [4, 3, 2], to: [0, 0, 0]}"));
}

TEST_F(ProgramCameras, AreDrawnFromALogAsInTheRun) {
  run_box(kTwo);
  const Outcome again = here.run({"render", "o", "--scene", "box.yaml", "--out", "again"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("again: 8 of 8 pictures and a sheet for each of 2 cameras"));
  for (const char* file : {"frames/side/frame_0002.png", "frames/Top-1/frame_0002.png"})
    EXPECT_EQ(here.read(fs::path("again") / file), here.read(fs::path("o") / file)) << file;
}

TEST_F(ProgramCameras, AloneNeedsNoFolderOfItsOwn) {
  run_box(kTwo, {"--set", "render.cameras.Top-1=null"});
  EXPECT_THAT(files_in(here / "o/frames"),
              ElementsAre("frame_0000.png", "frame_0001.png", "frame_0002.png", "frame_0003.png"));
  EXPECT_TRUE(fs::exists(here / "o/sheet.png"));
}

TEST_F(ProgramCameras, LeaveNoPicturesToALaterRun) {
  run_box(kTwo);
  fs::create_directories(here / "o/frames/mine");
  here.write("o/frames/side/notes.txt", "mine");
  run_box(kOne);
  EXPECT_THAT(files_in(here / "o"),
              ElementsAre("frames", "sheet.png", "summary.json", "trajectory.csv"));
  EXPECT_THAT(files_in(here / "o/frames/side"), ElementsAre("notes.txt"));
  EXPECT_FALSE(fs::exists(here / "o/frames/Top-1"));
  fs::remove_all(here / "o/frames/side");
  run_box(kTwo);
  EXPECT_THAT(files_in(here / "o/frames"), ElementsAre("Top-1", "side"));
  EXPECT_FALSE(fs::exists(here / "o/sheet.png"));
  run_box(kTwo, {"--no-render"});
  EXPECT_THAT(files_in(here / "o"), ElementsAre("summary.json", "trajectory.csv"));
}

TEST_F(ProgramCameras, ThatFollowSeeTheBodyWhereItWasAtFirst) {
  // Without water all that tells where the camera is is the body; a picture of this size has no
  // time on it.
  here.write("dry.yaml",
             "plimsoll: 1\nduration: 0.5\nstep: 0.1\ngravity: 0\nbodies:\n"
             "  - {name: box, box: {size: [1, 1, 1]}, density: 500, linear_velocity: [3, 1, 0]}\n"
             "render: {size: [100, 80], every: 0.4}\n");
  const auto sees_the_same = [&](const std::string& key) {
    EXPECT_EQ(here.run({"run", "dry.yaml", "--out", "o", "--set", "render.camera." + key}).code, 0);
    return here.read("o/frames/frame_0001.png") == here.read("o/frames/frame_0000.png");
  };
  EXPECT_TRUE(sees_the_same("follow=box"));
  EXPECT_FALSE(sees_the_same("fov_deg=40"));
  EXPECT_FALSE(sees_the_same("orbit=45"));
}

TEST_F(ProgramCameras, AreInTheReportByTheFirst) {
  support::lay_out_page(here, "page.html");
  run_box(kTwo);
  ASSERT_EQ(here.shell("bin/plimsoll report o").code, 0);
  const json page = support::data_in_page(here.read("o/report.html"));
  EXPECT_EQ(page["frames"]["of"], 4);
  EXPECT_EQ(page["camera"]["from"], json({6, -8, 3}));
  const std::string bytes = here.read("o/frames/side/frame_0002.png");
  const auto shown = support::packed_numbers<char>(page["frames"]["images"][2]);
  EXPECT_EQ(std::string(shown.begin(), shown.end()), bytes);
}

}  // namespace

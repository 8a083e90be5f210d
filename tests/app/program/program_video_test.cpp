#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/render/png.h"
#include "tests/app/program/program.h"
#include "tests/support/files.h"

/// Videos that `run` and `render` make, as another program reads them, and what happens where none
/// can be made.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::falling_box;
using support::files_in;
using support::lines_of;
using support::Outcome;
using support::Workplace;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kSmallPictures = "render: {size: [160, 120], every: 0.2}\n";

class ProgramVideo : public testing::Test {
 protected:
  ProgramVideo() { here.write("box.yaml", falling_box("0.6", kSmallPictures)); }

  Outcome run(const std::vector<std::string>& more, const std::vector<std::string>& with = {}) {
    std::vector<std::string> words = {"run", "box.yaml", "--out", "o"};
    words.insert(words.end(), more.begin(), more.end());
    return here.run(words, with);
  }

  /// The same with a program of that text as the only ffmpeg there is.
  Outcome run_with(const std::string& ffmpeg, const std::vector<std::string>& more) {
    here.write("bin/ffmpeg", ffmpeg);
    fs::permissions(here / "bin/ffmpeg", fs::perms::owner_all);
    return run(more, {"PATH=" + (here / "bin").string() + ":/usr/bin:/bin"});
  }

  /// A line on standard error, exit code 2, and nothing run.
  std::string fault_of(const Outcome& outcome) const {
    EXPECT_EQ(outcome.code, 2);
    EXPECT_FALSE(fs::exists(here / "o"));
    const std::vector<std::string> lines = lines_of(outcome.err);
    EXPECT_EQ(lines.size(), 2u) << outcome.err;
    return lines.empty() ? "" : lines[0];
  }

  std::string fault_of(const std::vector<std::string>& more) { return fault_of(run(more)); }

  Workplace here;
};

/// Those that need the programs.
class ProgramVideoMade : public ProgramVideo {
 protected:
  void SetUp() override {
    if (here.shell("command -v ffmpeg && command -v ffprobe").code != 0)
      GTEST_SKIP() << "there is no ffmpeg";
  }

  /// The one stream of a video.
  json stream(const std::string& file) const {
    const Outcome outcome =
        here.shell("ffprobe -v error -count_frames -show_streams -of json " + file);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const json streams = json::parse(outcome.out)["streams"];
    EXPECT_EQ(streams.size(), 1u);
    return streams[0];
  }

  double duration(const std::string& file) const {
    return std::stod(
        here.shell("ffprobe -v error -show_entries format=duration -of csv=p=0 " + file).out);
  }

  void expect_video(const std::string& file, const std::string& codec, int pictures,
                    double seconds) const {
    const json video = stream(file);
    EXPECT_EQ(video["codec_name"], codec);
    EXPECT_EQ(video["nb_read_frames"], std::to_string(pictures));
    EXPECT_NEAR(duration(file), seconds, 2e-3);  // a .webm counts milliseconds
  }
};

TEST_F(ProgramVideoMade, PlayInRealTimeBesideTheFrames) {
  const Outcome outcome = run({"--video", "drop.mp4"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("\ndrop.mp4: 0.6 s, 15 pictures at 25 a second\n"));
  expect_video("drop.mp4", "h264", 15, 0.6);
  EXPECT_EQ(stream("drop.mp4")["pix_fmt"], "yuv420p");
  EXPECT_EQ(files_in(here / "o/frames").size(), 4u);
  EXPECT_EQ(files_in(here / ".").size(), 5u);  // with the scene, the folder and what was said
  const json videos = json::parse(here.read("o/summary.json"))["pictures"]["videos"];
  EXPECT_EQ(videos, json::parse(R"([{"file": "drop.mp4", "pictures": 15, "fps": 25}])"));
}

TEST_F(ProgramVideoMade, AreOfThreeKindsAndTellTheirColours) {
  for (const auto& [file, codec] : {std::pair("drop.mp4", "h264"), std::pair("drop.webm", "vp9"),
                                    std::pair("drop.gif", "gif")}) {
    const Outcome outcome = run({"--video", file, "--fps", "10"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    expect_video(file, codec, 6, 0.6);
    const render::Image first = render::read_png(here / "o/frames/frame_0000.png");
    here.shell(std::string("ffmpeg -v error -i ") + file +
               " -vf scale=sws_flags=accurate_rnd+full_chroma_int -frames:v 1 -f rawvideo "
               "-pix_fmt rgb24 -y first.rgb");
    const std::string shown = here.read("first.rgb");
    ASSERT_EQ(shown.size(), first.rgb.size());
    std::array<double, 3> difference = {};  // of the means of red, green and blue
    for (std::size_t i = 0; i < shown.size(); ++i)
      difference[i % 3] += (static_cast<unsigned char>(shown[i]) - first.rgb[i]) / (160.0 * 120);
    // The wrong matrix makes 2.3, 1.1 and 1.6 of them.
    for (const double d : difference) EXPECT_NEAR(d, 0, 0.5) << file;
  }
}

TEST_F(ProgramVideoMade, MayBeOfAnOddSize) {
  for (const auto& [file, even] :
       {std::pair("drop.mp4", 1), std::pair("drop.webm", 0), std::pair("drop.gif", 0)}) {
    const Outcome outcome = run({"--video", file, "--set", "render.size=[131, 97]"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(stream(file)["width"], 131 + even) << file;
    EXPECT_EQ(stream(file)["height"], 97 + even) << file;
  }
}

TEST_F(ProgramVideoMade, AreOneForEachCamera) {
  const Outcome outcome = run({"--video", "drop.mp4", "--set", "render.cameras={a: {}, B: {}}"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_FALSE(fs::exists(here / "drop.mp4"));
  expect_video("drop-a.mp4", "h264", 15, 0.6);
  expect_video("drop-B.mp4", "h264", 15, 0.6);
}

TEST_F(ProgramVideoMade, IsThatOfOneCameraIfItIsNamed) {
  const std::vector<std::string> two = {"--set", "render.cameras={a: {}, B: {}}"};
  EXPECT_EQ(run({"--video", "B=drop.mp4", two[0], two[1]}).code, 0);
  expect_video("drop.mp4", "h264", 15, 0.6);
  EXPECT_FALSE(fs::exists(here / "drop-a.mp4"));
  const json pictures = json::parse(here.read("o/summary.json"))["pictures"];
  EXPECT_EQ(pictures["frames"], 8);
  EXPECT_EQ(pictures["videos"].size(), 1u);
}

TEST_F(ProgramVideoMade, LieInTheFolderOfTheRunThatIsNotThereYet) {
  const Outcome outcome = run({"--video", "o/drop.gif", "--threads", "1"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  expect_video("o/drop.gif", "gif", 15, 0.6);
}

TEST_F(ProgramVideoMade, AreMadeFromALogHoweverRarelyItWasWritten) {
  run({"--no-render", "--set", "log.every=0.1"});
  const Outcome outcome = here.run(
      {"render", "o", "--scene", "box.yaml", "--out", "p", "--video", "later.mp4", "--fps", "50"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("later.mp4: 0.6 s, 30 pictures at 50 a second"));
  expect_video("later.mp4", "h264", 30, 0.6);
  EXPECT_EQ(files_in(here / "p/frames").size(), 4u);  // with the final state
}

TEST_F(ProgramVideoMade, ThatAreInterruptedPlayWhatWasDrawn) {
  here.write("long.yaml", falling_box("60", "render: {size: [64, 48], every: 0.01}\n"));
  const pid_t process = here.start({"run", "long.yaml", "--out", "o", "--video", "long.mp4"});
  ASSERT_TRUE(support::wait_until([&] { return fs::exists(here / "o/frames/frame_0020.png"); }));
  ::kill(process, SIGINT);
  const Outcome outcome = here.finish(process);
  EXPECT_EQ(outcome.code, 130);
  const json video = json::parse(here.read("o/summary.json"))["pictures"]["videos"][0];
  EXPECT_GT(video["pictures"], 3);
  EXPECT_LT(video["pictures"], 1500);
  expect_video("long.mp4", "h264", video["pictures"], video["pictures"].get<double>() / 25);
}

TEST_F(ProgramVideoMade, ThatFillTheDiskLeaveNothingAndSayWhy) {
  here.write("drop.mp4", "an earlier one");
  const Outcome outcome = here.shell(
      "trap '' XFSZ; ulimit -f 192; exec $PLIMSOLL run box.yaml --out o --video drop.mp4 --set "
      "render='{size: [160, 120], every: 9}' --set duration=20 --set log.every=1 --set "
      "water.surface='{waves: [{amplitude: 0.3, wavelength: 3}]}'");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(support::after_scene(outcome.err), HasSubstr("error: drop.mp4: ffmpeg failed: "));
  EXPECT_THAT(outcome.err, HasSubstr("File too large"));
  EXPECT_EQ(here.read("drop.mp4"), "an earlier one");
  EXPECT_EQ(files_in(here / ".").size(), 5u);
}

TEST_F(ProgramVideo, OfACameraNeedsACameraOfThatName) {
  EXPECT_THAT(fault_of({"--video", "bw=drop.mp4", "--set", "render.cameras={bow: {}, stern: {}}"}),
              HasSubstr("--video: there is no camera bw; did you mean bow?"));
  EXPECT_THAT(fault_of({"--video", "bow=drop.mp4"}),
              HasSubstr("--video: the scene's camera has no name, expected drop.mp4 without bow="));
}

TEST_F(ProgramVideo, ThatCannotBeMadeStopBeforeTheRun) {
  EXPECT_EQ(fault_of({"--video", "drop.avi"}),
            "--video: found drop.avi, expected a file that ends in .mp4, .webm or .gif");
  EXPECT_THAT(fault_of({"--video", "drop"}), HasSubstr("found drop, expected"));
  EXPECT_EQ(fault_of({"--video", "a/drop.mp4"}), "--video: there is no folder a for drop.mp4");
  EXPECT_EQ(fault_of({"--video", "/proc/drop.mp4"}),
            "--video: /proc/drop.mp4 cannot be written: No such file or directory");
  EXPECT_EQ(fault_of({"--video", "drop.mp4", "--no-render"}),
            "--video: needs pictures, and --no-render draws none");
  EXPECT_EQ(fault_of({"--video", "drop.mp4", "--set", "render=null"}),
            "box.yaml: has no render block, so there are no pictures for --video; `render: {}` "
            "adds one");
  EXPECT_EQ(fault_of({"--video", "drop.gif", "--fps", "60"}),
            "--fps: found 60, expected at most 50 for a .gif, of which more are shown slowly");
  fs::create_directories(here / "folder.mp4");
  EXPECT_EQ(fault_of({"--video", "folder.mp4"}),
            "--video: folder.mp4 is a folder, expected a file");
}

TEST_F(ProgramVideo, HasPicturesASecondOnlyIfItIsWanted) {
  EXPECT_THAT(fault_of({"--fps", "30"}), HasSubstr("--fps requires --video"));
  for (const char* fps : {"0", "121", "-1", "x", "2.5"})
    EXPECT_THAT(fault_of({"--video", "drop.mp4", "--fps", fps}), StartsWith("--fps: ")) << fps;
}

TEST_F(ProgramVideo, NeedsFfmpegAndSaysHowToInstallIt) {
  const std::string missing =
      "--video: the program ffmpeg is not installed, which makes videos: apt-get install ffmpeg";
  EXPECT_EQ(fault_of(run({"--video", "drop.mp4"}, {"PATH="})), missing);
  fs::create_directories(here / "bin/ffmpeg");
  EXPECT_EQ(fault_of(run({"--video", "drop.mp4"}, {"PATH=" + (here / "bin").string()})), missing);
  const Outcome outcome = here.run(
      {"render", "t.csv", "--scene", "box.yaml", "--out", "o", "--video", "drop.mp4"}, {"PATH="});
  EXPECT_EQ(fault_of(outcome), missing);
}

TEST_F(ProgramVideo, TriesTheEncoderBeforeTheRun) {
  const Outcome outcome = run_with("#!/bin/sh\necho \"Unknown encoder 'libx264'\" >&2\nexit 1\n",
                                   {"--video", "drop.mp4"});
  EXPECT_EQ(fault_of(outcome), "--video: ffmpeg cannot make drop.mp4: Unknown encoder 'libx264'");
}

/// Takes a trial, and of a video some bytes.
const std::string kFailing =
    "#!/bin/sh\nfor word; do last=$word; done\n"
    "[ \"$last\" = - ] && exec cat > /dev/null\n"
    "head -c 100000 > /dev/null\n"
    "echo begun > \"${last#file:}\"\n"
    "printf 'No space left on device\\nConversion failed!\\n' >&2\nexit 1\n";

TEST_F(ProgramVideo, ThatFailsMidwayLeavesNothingAndSaysWhy) {
  here.write("drop.mp4", "an earlier one");
  for (const std::string threads : {"1", "2"}) {
    const Outcome outcome = run_with(kFailing, {"--video", "drop.mp4", "--threads", threads});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(support::after_scene(outcome.err),
                StartsWith("error: drop.mp4: ffmpeg failed: No space left on device\n"));
    EXPECT_EQ(here.read("drop.mp4"), "an earlier one");
    EXPECT_THAT(files_in(here / "."),
                ElementsAre("bin", "box.yaml", "drop.mp4", "err.txt", "o", "out.txt"));
    const json summary = json::parse(here.read("o/summary.json"));
    EXPECT_EQ(summary["ended"], "failed");
    EXPECT_EQ(summary["skipped"]["pictures"], "they could not be drawn");
  }
}

TEST_F(ProgramVideo, IsWrittenWholeByAnyProgramOfThatName) {
  const std::string copying =
      "#!/bin/sh\nfor word; do last=$word; done\n"
      "[ \"$last\" = - ] && exec cat > /dev/null\nexec cat > \"${last#file:}\"\n";
  const Outcome outcome = run_with(copying, {"--video", "drop.mp4"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  // 15 pictures of 160 x 120 pixels, the first of which is the first frame.
  const std::string bytes = here.read("drop.mp4");
  ASSERT_EQ(bytes.size(), 15u * 160 * 120 * 3);
  const render::Image first = render::read_png(here / "o/frames/frame_0000.png");
  EXPECT_EQ(bytes.substr(0, first.rgb.size()), std::string(first.rgb.begin(), first.rgb.end()));
}

}  // namespace

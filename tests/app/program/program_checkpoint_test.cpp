#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/app/program/program.h"
#include "tests/support/repeats.h"

/// A run that is killed and resumed writes what a run that is not stopped writes.

namespace {

using nlohmann::json;
using support::Outcome;
using support::Workplace;

/// Boxes that fall, float, and touch, with forces and probes logged; long enough to be killed on
/// its way.
std::string long_scene(const std::string& more = "") {
  return "plimsoll: 1\nduration: " + std::to_string(support::repeats(60)) +
         "\nstep: 0.005\nwater: {density: 1000}\n"
         "bodies:\n"
         "  - {name: a, box: {size: [1, 1, 1]}, density: 500, position: [0, 0, 1],\n"
         "     orientation: {axis: [1, 2, 3], angle_deg: 40}}\n"
         "  - {name: b, box: {size: [1, 1, 1]}, density: 300, position: [0.3, 0, 2.6]}\n"
         "log: {every: 0.05, forces: true, probes: [{name: p, wave: [3, 0], depth: 1},\n"
         "      {name: q, body: b, at: [0.5, 0, 0]}]}\n" +
         more;
}

/// A tug under an autopilot with a barge in tow, a moored and tethered float, a crane with a motor
/// and a winch, a pump that switches: all that remembers something from step to step.
std::string rigged_scene(const Workplace& place) {
  place.write("winch.csv", "time,length\n0,6\n20,2\n40,7\n");
  return "plimsoll: 1\nduration: " + std::to_string(support::repeats(40)) + R"yaml(
step: 0.01
water: {density: 1025, surface: {waves: [{amplitude: 0.2, wavelength: 20}]}}
hydro: {added_mass: none, radiation: none}
bodies:
  - {name: tug, box: {size: [8, 3, 2]}, mass: 24000}
  - {name: barge, box: {size: [12, 5, 2]}, mass: 60000, position: [-24, 0, 0]}
  - {name: float, box: {size: [2, 2, 2]}, density: 400, position: [0, 30, 0]}
  - {name: arm, box: {size: [4, 0.3, 0.3]}, mass: 300, position: [2, -30, 8]}
  - {name: load, box: {size: [1, 1, 1]}, mass: 700, position: [4, -30, 1.5]}
joints:
  - {name: shoulder, type: hinge, bodies: [arm, world], anchor: [0, -30, 8], axis: [0, 0, 1],
     limits_deg: [-60, 60], motor: {speed: 0.2, max_torque: 4e4}, friction: 20}
springs:
  - {name: tether, bodies: [float, world], points: [[1, 0, 0], [6, 30, 0]], length: 4,
     stiffness: 2e3, damping: 300}
ropes:
  - {name: tow, bodies: [tug, barge], points: [[-4, 0, 1], [6, 0, 1]], length: 15, stiffness: 1e6,
     damping: 1e4}
  - {name: winch, bodies: [arm, load], points: [[2, 0, 0], [0, 0, 0.5]], length: 6,
     stiffness: 1e6, damping: 1e4}
moorings:
  - {name: chain, body: float, fairlead: [0, 0, -1], anchor: [-30, 30, -20], length: 42, weight: 60,
     stiffness: 1e7}
propellers:
  - {name: main, body: tug, at: [-4, 0, -1], diameter: 1.4, speed_rps: 0,
     model: {wageningen: {blades: 4, area_ratio: 0.7, pitch_ratio: 1}}}
rudders:
  - {name: rudder, body: tug, at: [-4.8, 0, -1], span: 1.4, chord: 1, behind: main}
controls:
  - {set: "propellers[main].speed_rps", formula: 4*smooth(t/5), rate: 1}
  - {set: "rudders[rudder].angle_deg", rate: 10,
     pid: {of: tug.heading_deg, target: 25*sin(t/4), kp: 2, ki: 0.1, kd: 5, limits: [-35, 35]}}
  - {set: "ropes[winch].length", file: winch.csv}
  - {set: "joints[shoulder].motor.speed",
     relay: {of: "joints[shoulder].angle_deg", low: -20, high: 20, values: [0.2, -0.2]}}
log: {every: 0.05, forces: true}
)yaml";
}

/// Starts the scene with frequent checkpoints and ends it by a signal once one is written.
Outcome stop_by(const Workplace& place, int signal, std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--out", "cut", "--checkpoint", "0.01"});
  const pid_t process = place.start(arguments);
  EXPECT_TRUE(support::wait_for_bytes(place / "cut/checkpoint.bin", 100));
  EXPECT_TRUE(support::wait_for_bytes(place / "cut/trajectory.csv", 10000));
  ::kill(process, signal);
  return place.finish(process);
}

TEST(ProgramCheckpoint, AKilledRunGoesOnToTheSameBytes) {
  const Workplace place;
  const std::string scene =
      place.write("scene.yaml",
                  long_scene("joints: [{name: h, type: hinge, bodies: [a, world], anchor: [0.4, 0, "
                             "1], axis: [0, 1, 0]}]\n"));
  ASSERT_EQ(place.run({"run", scene, "--out", "whole", "--quiet"}).code, 0);
  ASSERT_EQ(stop_by(place, SIGKILL, {"run", scene}).code, -SIGKILL);
  place.write("scene.yaml", "edited: meanwhile\n");
  const Outcome resumed = place.run({"run", "--resume", "cut", "--threads", "1"});
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(place.read(place / "cut/trajectory.csv"), place.read(place / "whole/trajectory.csv"));
  for (const std::string table : {"forces.csv", "probes.csv", "joints.csv"}) {
    EXPECT_GT(place.read(place / "whole" / table).size(), 10000u) << table;
    EXPECT_EQ(place.read(place / "cut" / table), place.read(place / "whole" / table)) << table;
  }
  const json cut = json::parse(place.read(place / "cut/summary.json"));
  const json whole = json::parse(place.read(place / "whole/summary.json"));
  EXPECT_TRUE(cut.contains("resumed_at_seconds"));
  EXPECT_GT(whole["overlaps"]["pairs"], 0);
  for (const char* key : {"overlaps", "joints", "warnings"}) EXPECT_EQ(cut[key], whole[key]) << key;
  EXPECT_FALSE(std::filesystem::exists(place / "cut/checkpoint.bin"));
}

TEST(ProgramCheckpoint, AKilledRunWithLinesMachinesAndControlsGoesOnToTheSameBytes) {
  const Workplace place;
  const std::string scene = place.write("scene.yaml", rigged_scene(place));
  const Outcome whole = place.run({"run", scene, "--out", "whole", "--quiet", "--threads", "1"});
  ASSERT_EQ(whole.code, 0) << whole.err;
  ASSERT_EQ(stop_by(place, SIGKILL, {"run", scene}).code, -SIGKILL);
  const Outcome resumed = place.run({"run", "--resume", "cut", "--threads", "2"});
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  for (const std::string table : {"trajectory.csv", "forces.csv", "lines.csv", "joints.csv",
                                  "machines.csv", "controls.csv"}) {
    EXPECT_GT(place.read(place / "whole" / table).size(), 10000u) << table;
    EXPECT_EQ(place.read(place / "cut" / table), place.read(place / "whole" / table)) << table;
  }
}

TEST(ProgramCheckpoint, AControlWhoseTableHasChangedIsToldBeforeGoingOn) {
  const Workplace place;
  const std::string scene = place.write("scene.yaml", rigged_scene(place));
  ASSERT_EQ(stop_by(place, SIGTERM, {"run", scene}).code, 130);
  place.write("winch.csv", "time,length\n0,6\n20,3\n");
  const Outcome resumed = place.run({"run", "--resume", "cut"});
  EXPECT_EQ(resumed.code, 2);
  EXPECT_NE(resumed.err.find("has changed since the checkpoint"), std::string::npos) << resumed.err;
}

TEST(ProgramCheckpoint, AnInterruptedRunSaysHowToGoOnAndLosesNoStep) {
  const Workplace place;
  const std::string scene = place.write("scene.yaml", long_scene());
  ASSERT_EQ(place.run({"run", scene, "--out", "whole", "--quiet"}).code, 0);
  const Outcome stopped = stop_by(place, SIGTERM, {"run", scene});
  ASSERT_EQ(stopped.code, 130);
  EXPECT_NE(stopped.err.find("plimsoll run --resume cut"), std::string::npos) << stopped.err;
  const std::string before = place.read(place / "cut/trajectory.csv");
  ASSERT_EQ(place.run({"run", "--resume", "cut", "--quiet"}).code, 0);
  const std::string after = place.read(place / "cut/trajectory.csv");
  EXPECT_TRUE(after.starts_with(before));
  EXPECT_EQ(after, place.read(place / "whole/trajectory.csv"));
}

TEST(ProgramCheckpoint, PicturesOfAResumedRunAreThoseOfTheWholeOne) {
  const Workplace place;
  const std::string scene =
      place.write("scene.yaml", long_scene("render: {every: 4, size: [64, 48]}\n"));
  ASSERT_EQ(place.run({"run", scene, "--out", "whole", "--quiet"}).code, 0);
  ASSERT_EQ(stop_by(place, SIGKILL, {"run", scene}).code, -SIGKILL);
  ASSERT_EQ(place.run({"run", "--resume", "cut", "--quiet"}).code, 0);
  for (const char* frame :
       {"frames/frame_0000.png", "frames/frame_0001.png", "frames/frame_0002.png"}) {
    const std::string whole = place.read(place / "whole" / frame);
    ASSERT_FALSE(whole.empty()) << frame;
    EXPECT_EQ(place.read(place / "cut" / frame), whole) << frame;
  }
}

TEST(ProgramCheckpoint, WhatCannotBeResumedIsToldInOneLine) {
  const Workplace place;
  const std::string scene = place.write("scene.yaml", support::falling_box("1"));
  ASSERT_EQ(place.run({"run", scene, "--out", "done", "--checkpoint", "100", "--quiet"}).code, 0);
  const Outcome ended = place.run({"run", "--resume", "done"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.err.find("done/checkpoint.bin: is missing"), std::string::npos) << ended.err;
  place.write("done/checkpoint.bin", "{\"checkpoint\": 7}\nnothing");
  EXPECT_EQ(place.run({"run", "--resume", "done"}).code, 2);
  EXPECT_EQ(place.run({"run", scene, "--resume", "done"}).code, 2);
  EXPECT_EQ(place.run({"run"}).code, 2);
}

TEST(ProgramCheckpoint, ALogThatHasChangedSinceIsRefused) {
  const Workplace place;
  const std::string scene = place.write("scene.yaml", long_scene());
  ASSERT_EQ(stop_by(place, SIGTERM, {"run", scene}).code, 130);
  for (const std::string log : {"trajectory.csv", "forces.csv", "probes.csv"}) {
    const std::string whole = place.read(place / "cut" / log);
    std::string changed = whole;
    char& digit = changed[changed.find_first_of("123456789", 1000)];
    digit = digit == '1' ? '2' : '1';
    place.write("cut/" + log, changed);
    const Outcome refused = place.run({"run", "--resume", "cut"});
    EXPECT_EQ(refused.code, 2) << log;
    EXPECT_NE(refused.err.find("cut/" + log + ": has changed since its checkpoint was written"),
              std::string::npos)
        << refused.err;
    EXPECT_EQ(place.read(place / "cut" / log), changed);
    place.write("cut/" + log, whole);
  }
  EXPECT_EQ(place.run({"run", "--resume", "cut", "--quiet"}).code, 0);
}

TEST(ProgramCheckpoint, ACheckpointCutShortAtAnyPlaceIsRefused) {
  const Workplace place;
  const std::string scene = place.write("scene.yaml", long_scene());
  ASSERT_EQ(stop_by(place, SIGTERM, {"run", scene}).code, 130);
  const std::string whole = place.read(place / "cut/checkpoint.bin");
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{20}, whole.size() / 2, whole.size() - 1}) {
    place.write("cut/checkpoint.bin", whole.substr(0, length));
    const Outcome outcome = place.run({"run", "--resume", "cut"});
    EXPECT_EQ(outcome.code, 2) << length;
    EXPECT_NE(outcome.err.find("checkpoint.bin"), std::string::npos) << outcome.err;
  }
}

}  // namespace

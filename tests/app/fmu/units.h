#pragma once

#include <filesystem>
#include <string>

#include "tests/app/fmu/importer.h"

namespace support {

/// A tug with a propeller and a rudder that a control drives tows a barge past a pier; the tug has
/// an instrument.
inline const char* const kTow = R"(plimsoll: 1
title: A tug & "her" <barge>
duration: 2
step: 0.02
water: {density: 1025, surface: {waves: [{amplitude: 0.2, wavelength: 20}]}}
hydro: {added_mass: none, radiation: none}
bodies:
  - {name: tug, box: {size: [8, 3, 2]}, mass: 24000}
  - {name: barge, box: {size: [12, 5, 2]}, mass: 60000, position: [-24, 0, 0]}
  - {name: pier, box: {size: [2, 2, 9]}, density: 2000, position: [0, 30, 0], lock: all}
ropes:
  - {name: tow, bodies: [tug, barge], points: [[-4, 0, 1], [6, 0, 1]], length: 14.5,
     stiffness: 1e5, damping: 1e4}
propellers:
  - {name: main, body: tug, at: [-4, 0, -1], diameter: 1.4, speed_rps: 2,
     model: {wageningen: {blades: 4, area_ratio: 0.7, pitch_ratio: 1}}}
rudders:
  - {name: rudder, body: tug, at: [-4.8, 0, -1], span: 1.4, chord: 1, behind: main}
  - {name: skeg, body: barge, at: [-5, 0, -1], span: 1, chord: 1, angle_deg: 20}
controls:
  - {set: "rudders[rudder].angle_deg", rate: 10,
     pid: {of: tug.heading_deg, target: "20", kp: 2, kd: 5, limits: [-35, 35]}}
log: {every: 0.02, probes: [{name: imu, body: tug, at: [2, 0, 1]}, {name: gauge, wave: [2, 1]}]}
)";

/// A unit in a folder of the running test's own.
struct UnitFolder {
  std::filesystem::path folder;
  std::filesystem::path resources;
  std::string xml;  ///< Its modelDescription.xml.
  Description description;
};

/// Packs the text of a scene. @param file   Name of the scene's file.
UnitFolder packed_unit(const std::string& scene, const std::string& file = "tow.yaml");

}  // namespace support

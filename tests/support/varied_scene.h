#pragma once

#include <string>

namespace support {

/// A valid scene with something of everything, for tests that damage it.
inline const std::string kVariedScene =
    "plimsoll: 1\n"
    "title: \"Fuzz\"\n"
    "duration: 3.6  # s\n"
    "water:\n"
    "  current: [0, 0.5, 0]\n"
    "  surface: {waves: [{amplitude: 0.3, wavelength: 12, heading_deg: -30}]}\n"
    "air: {density: 1.2, wind: {speed: 9, heading_deg: 40, exponent: 0.2}}\n"
    "hydro: &none {lift: false, viscous_drag: thesis}\n"
    "bodies:\n"
    "  - name: a\n"
    "    box: {size: [1, 2, 3], divisions: 2}\n"
    "    mass: 5\n"
    "    inertia: [1, 1, 1, 0, 0, 0]\n"
    "    orientation: {euler_deg: [10, 20, 30]}\n"
    "    lock: [x, yaw]\n"
    "  - {name: b, sphere: {radius: 1}, density: 5e2, hydro: {<<: *none, buoyancy: true}}\n"
    "joints:\n"
    "  - {type: hinge, bodies: [a, b], anchor: [0, 0, 1], axis: [0, 1, 0]}\n"
    "ropes: [{name: r, bodies: [a, b], points: [[0, 0, 0], [0, 0, 1]], length: 1, stiffness: 1}]\n"
    "propellers: [{name: p, body: a, at: [0, 0, 0], axis: [1, 0, 0], diameter: 1, speed_rps: 1,\n"
    "  model: {wageningen: {blades: 4, area_ratio: 0.7, pitch_ratio: 1}}}]\n"
    "render: {size: [320, 240], pressure: {min: 0, max: auto}}\n";

}  // namespace support

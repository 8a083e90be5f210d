#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/databases/body_data.h"
#include "app/scene/diagnostics.h"
#include "app/scene/scene.h"
#include "engine/spec.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// Which bodies make waves, by `hydro.radiation`.
///
/// Linear theory knows the waves of a body that moves little about the pose in which it floats at
/// rest, on water of one depth, without forward speed and with no other body near. With `auto` or a
/// file the body must be able to float. Without the key it has radiation unless its added mass is
/// given, if it starts
/// - free, without joints;
/// - displacing its mass within a quarter, and at most 15° from the attitude at which it comes to
///   rest; a sphere, to which the attitude does not matter, keeps that of its start;
/// - slower than a Froude number of 0.1 in the water, by its length on the water;
/// - over ground that is at or below `water.depth`, or deeper than four of its draughts and half
/// its
///   length;
/// - with no other body within its radius and the other's.

namespace assembly {

/// A database of `hydro.radiation.file` for one body.
struct RadiationDatabase {
  std::filesystem::path file;
  std::string format;
  std::string body;  ///< Name or number in the file.
  databases::BodyData found;
};

/// Whether a body makes waves.
struct RadiationChoice {
  std::optional<hydro::MeanPose> pose;  ///< The mean pose; none: the body makes no waves.
  bool written = false;                 ///< The scene has the key for the body.
  std::string reason;  ///< Why it makes none; empty if this key or `added_mass` says so.
  double draught = 0;  ///< In the mean pose [m].
  double length = 0;   ///< Largest horizontal extent in the mean pose [m].
  std::shared_ptr<const RadiationDatabase> database;  ///< Of its file (radiation_database.h).
};

/// Returns the choice for each body. A body that cannot have the radiation which its key asks for
/// is a fault at the key.
/// @param spec   Of the same scene, with bodies, sea, ground and joints.
std::vector<RadiationChoice> radiation_choices(const scene::Scene& scene,
                                               const engine::SimulationSpec& spec,
                                               scene::Faults& faults);

/// Returns warnings of bodies whose written `radiation` assumes what does not hold: forward speed,
/// and other bodies that make waves within ten of their lengths.
std::vector<std::string> radiation_warnings(const engine::SimulationSpec& spec,
                                            const std::vector<RadiationChoice>& choices);

/// Tells which bodies make waves and why others do not, in one line for all that are alike. Bodies
/// without a reason are not mentioned.
std::vector<std::string> radiation_lines(const engine::SimulationSpec& spec,
                                         const std::vector<RadiationChoice>& choices);

}  // namespace assembly

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/databases/body_data.h"
#include "app/scene/diagnostics.h"
#include "app/scene/scene.h"
#include "engine/base/spec.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// Which bodies make waves, by `hydro.radiation`.
///
/// Linear theory knows the waves of a hull that moves little about its mean pose, in which it
/// floats at rest, on water of one depth, without forward speed and with no other body near. Away
/// from the mean pose its terms are still nearer to the truth than none, and they vanish as the
/// hull leaves the water. Bodies that fixed joints hold together are one hull, of which the first
/// carries them.
///
/// With `auto` or a file the hull must be able to float, or be held in the water. Without the key
/// it has radiation unless its added mass is given, if
/// - it is not held in all six degrees of freedom;
/// - it starts at most 45° from its attitude at rest, and no higher or faster than from where it
///   would just touch the water with its keel or deck: it is not dropped or thrown;
/// - it starts within 15° of the rest, displacing there a quarter more or less at most, if
///   something else than the water holds it: joints, lines, locks or constant loads;
/// - ground is at or below `water.depth`, or deeper than four of its draughts and half its length.

namespace assembly {

/// Largest Froude number of a body with radiation: below it encounter effects are small [-].
inline constexpr double kLargestFroudeNumber = 0.1;

/// Froude number of a body at a speed in the water [m/s], by its length on it [m].
double froude_number(const hydro::Sea& sea, double speed, double length);

/// A database of `hydro.radiation.file` for one body.
struct RadiationDatabase {
  std::filesystem::path file;  ///< Path of the file.
  std::string format;          ///< Name of its format.
  std::string body;            ///< Name or number in the file.
  databases::BodyData found;   ///< Its data, in the frame of the body.
};

/// Whether a body makes waves.
struct RadiationChoice {
  std::optional<hydro::MeanPose> pose;  ///< The mean pose; none: the body makes no waves.
  /// The surface of the hull that the body leads, in its frame; null: its own alone.
  std::shared_ptr<const hydro::TriMesh> joined_B;
  /// The body that carries the waves of the hull in its place.
  std::optional<engine::BodyId> lead;
  bool written = false;  ///< The scene has the key for the body.
  std::string reason;    ///< Why it makes none; empty if this key or `added_mass` says so.
  /// The reason lies in the start, the method or the surface, so that its author may expect waves.
  bool unexpected = false;
  bool simulated = false;  ///< Simulated water has its waves, in the place of a solution.
  std::string held;        ///< Holder besides the water in the mean pose; empty: none.
  double draught = 0;      ///< In the mean pose [m].
  double length = 0;       ///< Largest horizontal extent in the mean pose [m].
  /// Database of its file (radiation_database.h).
  std::shared_ptr<const RadiationDatabase> database;
};

/// Returns the choice for each body. A body that cannot have the radiation which its key asks for
/// is a fault at the key.
/// @param spec   Specification of the same scene, with bodies, sea, ground and joints.
std::vector<RadiationChoice> radiation_choices(const scene::Scene& scene,
                                               const engine::SimulationSpec& spec,
                                               scene::Faults& faults);

/// The surface that makes the waves of a body, in its frame.
inline const hydro::TriMesh& radiating_mesh(const RadiationChoice& choice,
                                            const engine::BodySpec& body) {
  return choice.joined_B ? *choice.joined_B : outside_B(body);
}

/// Returns warnings of bodies with a written `radiation` that make waves within ten of their
/// lengths of each other, and of bodies that have none although they float near their
/// rest (RadiationChoice::unexpected).
std::vector<std::string> radiation_warnings(const engine::SimulationSpec& spec,
                                            const std::vector<RadiationChoice>& choices);

/// Tells which bodies make waves and why others do not, in one line for all that are alike. Bodies
/// without a reason are not mentioned.
std::vector<std::string> radiation_lines(const engine::SimulationSpec& spec,
                                         const std::vector<RadiationChoice>& choices);

}  // namespace assembly

#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "hydro/radiation/linear_response.h"

/// @file
/// The natural periods of bodies afloat, by the natural modes of linear theory
/// (hydro/radiation/linear_response.h), as commands print them.

namespace app {

/// A natural mode without damping.
struct NaturalPeriod {
  /// Motions with a fifth or more of its potential energy, that with the most first: `heave`, or
  /// `pitch + heave` of a mode of both.
  std::vector<std::string> motions;
  double period = 0;  ///< [s]
  /// Motion along the horizontal axes of the body's heading, 1 in the first of `motions` [m, rad].
  hydro::Vector6d shape = hydro::Vector6d::Zero();

  /// @param between   ` + ` of a text, `_` of a key.
  std::string name(const std::string& between) const;
};

struct NaturalPeriods {
  std::vector<NaturalPeriod> modes;   ///< By descending period.
  std::string added_mass;             ///< The added mass that they have, in words.
  std::vector<std::string> left_out;  ///< Loads and motions that they leave out.
  std::string missing;                ///< Reason why they are not known; else empty.
};

/// @param body      With M and A∞; in axes in which the body's x axis has this heading [rad].
/// @param excess    A(ω) − A∞ in those axes; null: zero.
NaturalPeriods natural_periods(const hydro::LinearBody& body, double heading,
                               const std::function<hydro::Matrix6d(double)>& excess);

/// The natural periods of a body whose waves are solved for: with A(ω) of the memory that runs
/// have.
/// @param body      With M alone; its heading is that of the axes, as above.
/// @param memory    In H, for water of density 1, as A∞ is.
NaturalPeriods natural_periods(const hydro::LinearBody& body, double heading, double density,
                               const hydro::Matrix6d& infinite_added_mass,
                               const hydro::RadiationMemory& memory);

/// The natural periods of a body of a scene, by the added mass that it has without a solution of
/// its own: of its radiation, from a database or the store, or as the scene gives it, or of the
/// model `deep` from the store.
/// @param rest   Pose in which it floats at rest; a mean pose of its radiation takes its place.
NaturalPeriods known_natural_periods(const scene::Scene& scene, const assembly::BuiltScene& built,
                                     engine::BodyId body, const hydro::MeanPose& rest);

/// Two lines that end in a line break, each indented by two spaces.
std::string natural_periods_text(const NaturalPeriods& periods);

/// Returns `{"modes": [{"motion", "period", "shape"}], "added_mass", "left_out"}`, or `{"modes":
/// [], "missing"}`.
nlohmann::ordered_json natural_periods_json(const NaturalPeriods& periods);

}  // namespace app

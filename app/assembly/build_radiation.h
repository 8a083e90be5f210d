#pragma once

#include "app/assembly/built_scene.h"
#include "app/assembly/radiation_store.h"
#include "app/base/reporter.h"
#include "app/scene/scene.h"

/// @file
/// Builds the waves of the bodies that `radiation_choices` has chosen.

namespace assembly {

/// Gives each chosen body its added mass, memory and diffraction, solved or from the store. Bodies
/// with equal meshes and mean poses share them. A body that has radiation by default and for which
/// there is no solution has none, and its report tells why.
/// @throws InputError for a body that the scene gives radiation and that has no solution
void add_radiation(const scene::Scene& scene, BuiltScene& built, RadiationStore& store,
                   app::Reporter& reporter);

/// The problem whose solution a body with a mean pose and without a database has. It refers to the
/// mesh of the body or of its hull.
RadiationProblem radiation_problem(const RadiationChoice& choice, const engine::BodySpec& body,
                                   const hydro::Sea& sea);

/// Judges a solution by its own measure of its error, RadiationSolution::mismatch: above 10 % it is
/// doubtful, which is told, and above 30 % useless.
/// @throws std::invalid_argument for one that is useless.
void check_mismatch(const std::string& name, double mismatch, app::Reporter& reporter);

/// The added mass in the mean pose, where the body is present in full.
AddedMassReport added_mass_report(const hydro::FloatingBody& model, const hydro::Sea& sea);

/// Assumptions of linear theory about bodies that make waves.
/// @param simulated   Their waves are in simulated water.
std::vector<std::string> assumptions(const hydro::LinearWater& water, bool simulated);

}  // namespace assembly

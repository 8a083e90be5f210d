#pragma once

#include <string>
#include <vector>

#include "app/assembly/radiation_choice.h"
#include "app/scene/diagnostics.h"
#include "app/scene/scene.h"
#include "engine/base/spec.h"

namespace assembly {

/// Reads the databases of the chosen bodies into their choices. Bodies with equal keys, meshes and
/// mean poses share one. A file that is refused is a fault at its key.
/// @param spec   Specification of the same scene, with bodies and sea.
void read_databases(const scene::Scene& scene, const engine::SimulationSpec& spec,
                    std::vector<RadiationChoice>& choices, scene::Faults& faults);

/// Tells what was taken and what is slightly wrong in the databases, one line for each finding.
std::vector<std::string> database_notes(const engine::SimulationSpec& spec,
                                        const std::vector<RadiationChoice>& choices);

}  // namespace assembly

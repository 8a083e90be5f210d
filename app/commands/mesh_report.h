#pragma once

#include <string>
#include <vector>

#include "hydro/mesh/mending/diagnosis.h"
#include "hydro/mesh/mesh.h"

namespace app {

/// Returns the lines that say what a mesh is: its parts, open loops and faults.
std::vector<std::string> diagnosis_lines(const hydro::TriMesh& mesh,
                                         const hydro::MeshDiagnosis& diagnosis);

/// Formats a volume, or says that there is none: `8 m^3`, `open`.
std::string volume_text(const std::optional<double>& volume);

}  // namespace app

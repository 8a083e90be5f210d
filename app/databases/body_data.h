#pragma once

#include <string>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// Radiation data of a database, as they fit a body.

namespace databases {

/// The body to which a database is put.
struct FloatingMesh {
  const hydro::TriMesh& mesh_B;  ///< Its origin is the centre of mass.
  hydro::MeanPose pose;          ///< Mean pose.
  hydro::LinearWater water;      ///< Depth and gravity.
  bool waves = true;             ///< The water has waves, whose loads are needed.
};

/// One check of a database and what it found.
struct Check {
  std::string name;  ///< Name of the check.
  double value = 0;  ///< Relative to what it is compared with [-].
};

/// Data as a run takes it, and what was found on the way.
struct BodyData {
  hydro::RadiationData data;       ///< In the frame H of the body, for ρ = 1.
  std::vector<Check> checks;       ///< All checks, with their results.
  std::vector<std::string> notes;  ///< Data left out, assumed or slightly wrong.
};

}  // namespace databases

#pragma once

#include <string>
#include <vector>

#include "engine/base/spec.h"
#include "hydro/radiation/linear_response.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// The terms of linear theory (hydro/radiation/linear_response.h) that a body of a scene has
/// without the water's added mass and waves.

namespace assembly {

/// The body in its mean pose, over the place of its start.
struct LinearTerms {
  /// Its own inertia M, the hydrostatic stiffness, that of springs, ropes and moorings with their
  /// damping, and the locks; in W axes.
  hydro::LinearBody body;
  double heading = 0;                 ///< Heading of H in W [rad].
  std::vector<std::string> left_out;  ///< Loads and motions that these terms leave out.
};

/// @param pose   Mean pose of the body.
LinearTerms linear_terms(const engine::SimulationSpec& spec, engine::BodyId body,
                         const hydro::MeanPose& pose);

/// −∂(F, M)/∂ξ of a hydrostatic body in H. @param sea   Its density and gravity count.
hydro::Matrix6d hydrostatic_stiffness(const hydro::TriMesh& mesh_B, const hydro::MeanPose& pose,
                                      const hydro::Sea& sea);

/// True if the body has a joint, so that linear theory of a body by itself is not that of it.
bool has_joint(const engine::SimulationSpec& spec, engine::BodyId body);

}  // namespace assembly

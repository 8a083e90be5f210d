#pragma once

#include <functional>
#include <string>

#include "app/assembly/build_shape.h"
#include "engine/base/spec.h"

namespace assembly {

/// Returns the attachment point of a body by its name and the place in the frame of its mesh [m].
using Attach =
    std::function<engine::AttachmentPoint(const std::string& body, const Eigen::Vector3d& point)>;

/// Gives the specification the lines of the scene's file of MoorDyn, if it names one. Its bodies
/// must be there. A warning of MoorDyn becomes a warning of the build.
///
/// Faults go to the log, at their keys: a build without MoorDyn, a file that MoorDyn cannot read or
/// that asks for unsupported features, a number of bodies that is not that of its coupled points.
void build_moordyn(engine::SimulationSpec& spec, BuildLog& log, const Attach& attach);

}  // namespace assembly

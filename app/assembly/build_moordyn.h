#pragma once

#include <functional>
#include <string>

#include "app/assembly/build_shape.h"
#include "engine/base/spec.h"

namespace assembly {

/// Returns the attachment point of a body by its name and the place in the frame of its mesh [m].
using Attach =
    std::function<engine::AttachmentPoint(const std::string& body, const Eigen::Vector3d& point)>;

/// Gives the specification the lines of the scene's file for MoorDyn, if it names one, as lines
/// with inertia named by their numbers. Its bodies must be there. What the file asks for and is not
/// computed becomes a warning.
///
/// Faults go to the log, at their keys: a file that cannot be read or that asks for unsupported
/// features, a number of bodies that is not that of its coupled points.
void build_moordyn(engine::SimulationSpec& spec, BuildLog& log, const Attach& attach);

}  // namespace assembly

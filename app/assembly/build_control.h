#pragma once

#include "app/assembly/build_shape.h"
#include "engine/base/spec.h"

namespace assembly {

/// Adds the controls of a scene to a specification that has all set points and lines: those of the
/// block `controls`, then those of loads with a formula or file. A fault of a command file goes to
/// the log.
void add_controls(engine::SimulationSpec& spec, BuildLog& log);

}  // namespace assembly

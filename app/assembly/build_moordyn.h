#pragma once

#include "app/assembly/build_shape.h"
#include "app/assembly/built_scene.h"

namespace assembly {

/// Gives the specification the lines of the scene's file of MoorDyn, if it names one. Its bodies
/// must be there. What MoorDyn warns of becomes a warning.
///
/// Faults go to the log, at their keys: a build without MoorDyn, a file that MoorDyn cannot read or
/// that asks for what is not supported, a number of bodies that is not that of its coupled points.
void build_moordyn(BuiltScene& built, BuildLog& log);

}  // namespace assembly

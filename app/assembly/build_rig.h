#pragma once

#include "app/assembly/build_shape.h"
#include "app/assembly/built_scene.h"

/// @file
/// Builds the lines, drives of joints, machines, set points and controls of a scene.

namespace assembly {

/// Gives the specification the scene's set points, in the order of `scene::set_points`; its lines,
/// springs before ropes before moorings; its machines, rudders before sails; and its controls,
/// those of loads after those of the block `controls`. Its bodies and joints must be there.
///
/// Faults go to the log, at their keys: a command file that cannot be read, a machine outside the
/// validity of its model, a mooring whose anchor is out of reach or whose fairlead lies below it,
/// a line that breaks at the start, a file for MoorDyn that cannot be read, a stiff line with
/// inertia between two bodies that the step does not resolve.
void build_rig(BuiltScene& built, BuildLog& log);

/// Returns the index of a body by its name; engine::kWorld for `world`.
engine::BodyId body_id(const scene::Scene& scene, const std::string& name);

/// Place of an attachment point at the start [m].
Eigen::Vector3d place_at_start(const engine::SimulationSpec& spec,
                               const engine::AttachmentPoint& point);

/// The shape of a mooring at rest at the start.
hydro::CatenarySolution catenary_at_start(const engine::SimulationSpec& spec,
                                          const engine::LineSpec& line);

/// Tension of a line at the start [N]; negative for a spring that pushes.
double tension_at_start(const engine::SimulationSpec& spec, const engine::LineSpec& line);

}  // namespace assembly

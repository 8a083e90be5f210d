#pragma once

#include "app/assembly/built_scene.h"
#include "app/logs/log.h"
#include "app/scene/scene.h"

namespace app {

/// True if a body may have pockets.
bool may_be_hollow(const engine::SimulationSpec& spec);

/// True if the simulation has lines, joints, machines or controls.
bool has_rig(const engine::SimulationSpec& spec);

/// Returns what a run of the scene logs. Its tables are those of RigLog, then that of the probes.
LogSubject log_subject(const scene::Scene& scene, const assembly::BuiltScene& built);

}  // namespace app

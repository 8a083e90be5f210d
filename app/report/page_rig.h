#pragma once

#include <nlohmann/json.hpp>

#include "app/pages/thinning.h"
#include "app/report/logged_run.h"

namespace app {

/// Number of columns of page_rig.
std::size_t rig_columns(const LoggedRun& run);

/// Returns what was logged of lines, joints, machines and controls, over the rows that a thinning
/// keeps. Angles are in degrees; `bodies` are indices of bodies, those of the world are left out.
///
///     lines       [{name, bodies, broken_at, columns: {tension, distance, length, resting}}]
///     joints      [{name, type, bodies, columns: {coordinate, speed, effort, power, force}}]
///     propellers  [{name, bodies, columns: {setting, angle, thrust, torque, advance, wetted}}]
///     foils       [{name, bodies, fluid, columns: {angle, attack, flow, force}}]
///     controls    [{name, columns: {value}}]
///
/// `resting` is that of moorings, the coordinate, speed and effort those of hinges and sliders;
/// their `power` [W] is that which the effort absorbs. `force` is the size of the force.
/// `broken_at` is the first logged time, or null.
nlohmann::ordered_json page_rig(const LoggedRun& run, const Thinning& thinning);

}  // namespace app

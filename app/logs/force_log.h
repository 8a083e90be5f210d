#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/record/body_forces.h"

/// @file
/// The forces on bodies over time, and the columns of their log.
///
/// Each load has the columns `<load>_fx` … `_fz` [N] and `<load>_tx` … `_tz` [N m], about the
/// centre of mass, in W. The others are `wetted_area` [m^2], `displaced_volume` [m^3];
/// `kinetic_energy`, `added_kinetic_energy`, `potential_energy` [J]; `work_<load>` [J] since the
/// start, then `work_brake`. The loads are buoyancy, pressure_drag, viscous_drag, lift,
/// wave_inertia, added_mass, applied, weight and constraint; the columns of wind and its work come
/// last, and after them those of diffraction, of radiation, of the water inside, of lines, of
/// machines, of the resistance along the motion, of the lift of the hull and of simulated water
/// with theirs. engine/record/body_forces.h says what each means.

namespace app {

/// Returns the names of the columns.
std::vector<std::string> force_columns();

/// Returns the numbers of one body at one time, in the order of force_columns().
std::vector<double> force_row(const engine::BodyForces& forces);

/// The loads on one body over time.
struct ForceTrack {
  std::vector<double> times;                 ///< [s]
  std::vector<std::vector<double>> columns;  ///< In the order of force_columns().
};

using ForceLog = std::map<std::string, ForceTrack>;  ///< The key is the body's name.

}  // namespace app

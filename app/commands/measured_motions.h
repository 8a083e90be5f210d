#pragma once

#include <vector>

#include "app/assembly/added_mass_store.h"
#include "app/base/reporter.h"
#include "app/commands/linear_motions.h"
#include "app/scene/scene.h"

/// @file
/// Motions of a scene's bodies in regular waves, measured in runs: with drag, the shape of the hull
/// above and below the water, joints and lines as they are.

namespace app {

/// The first harmonics of six motions over the amplitude of the wave, as LinearMotions::in gives
/// them: along the axes of the body's heading, over the elevation a e^{−iωt} at its mean place.
struct MeasuredMotions {
  hydro::Vector6cd first;
  /// Largest change of an amplitude from the middle third of the run to the last, over the largest
  /// amplitude of its kind [-]: far above 0 while free oscillations last.
  double change = 0;
};

/// Runs the scene in one regular wave that grows from rest, for 30 of its periods, of which the
/// last ten are fitted, each motion by its mean, drift and two harmonics.
/// @param slope    Amplitude times wave number [-].
/// @param bodies   Bodies of the same scene: the result is in their order.
std::vector<MeasuredMotions> measured_motions(const scene::Scene& scene, const RegularWave& wave,
                                              double slope,
                                              const std::vector<LinearMotions>& bodies,
                                              assembly::AddedMassStore& store, Reporter& reporter);

}  // namespace app

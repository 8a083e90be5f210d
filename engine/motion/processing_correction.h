#pragma once

#include <optional>

#include "engine/motion/body.h"

/// @file
/// The difference between the state that the update (E5) moves on and the one that is reported.
///
/// For loads that depend on the pose alone a substep by (E5) is P N P⁻¹, with N of fourth order
/// [R91]. P⁻¹ and P cancel between consecutive substeps, so only the reported state needs the
/// correction. With the acceleration a and its rate a' at an instant, the reported state (x, u) and
/// the state moved on differ by
///
///     x + (h²/24) a,      u − (h²/24) a'                                                   (E9)
///
/// where the last substeps show a smooth motion (acceleration_history.h). The energy of a bobbing
/// body then neither drifts nor oscillates. Lines with inertia are no loads of the pose alone:
/// their bodies have no correction.
///
/// [R91] Rowlands. A numerical algorithm for Hamiltonian systems. J. Comp. Phys. 97 (1991).

namespace engine {

/// In W, for the pose (Δx, Δθ) and the velocity.
struct ProcessingCorrection {
  Vector6d pose;
  Vector6d velocity;
};

/// True if the loads on the body can show a smooth motion.
bool shows_trend(const Body& body, const Motion& motion);

/// (E9) for a substep of length h [s]; none where the motion is not smooth.
std::optional<ProcessingCorrection> find_correction(const Body& body, const Motion& motion,
                                                    double h);

/// Adds `sign` times the correction to the motion.
void correct(const Body& body, const ProcessingCorrection& correction, double sign, Motion& motion);

}  // namespace engine

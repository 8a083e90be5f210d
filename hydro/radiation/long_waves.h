#pragma once

#include <vector>

#include "hydro/radiation/radiation_data.h"
#include "hydro/radiation/radiation_memory.h"

/// @file
/// Radiation and diffraction in waves that are much longer than the body.
///
/// There the body sees one velocity u_w of the water, and only its own relative to that one makes
/// waves:
///
///     X_D = −(iωA − B) u_w + R,      u_w = (gk/ω) (cos β, sin β, −i tanh kh, 0, 0, 0),      (1)
///
/// for a wave of unit elevation, with a remainder R/k that vanishes as k. So the waves that a body
/// makes and those that it scatters cancel under one that follows the water, and what is left of
/// two large loads drifts it. That takes two measures. Below the lowest frequency of the data
///
///     A = A₁,      B/ωk = B₁/ω₁k₁,      R/k² = R₁/k₁²                                       (2)
///
/// continue those of it; the damping is Haskind's for a force that goes as the amplitude. And the
/// diffraction is (1) with A and B of the fitted memory, whose error so acts on the relative
/// velocity alone.

namespace hydro {

/// A(ω) and B(ω) of the data, and its X_D where it has one, with (2) at lower frequencies before
/// them. Data of one frequency, which tell no change, stay as they are.
RadiationData with_long_waves(const RadiationData& data);

/// X_D of the data with (2) at lower frequencies before it, balanced with the memory of the same
/// data: the difference between the memory's A and B and the data's acts on u_w times the wave's
/// head at a depth of ∛volume. Data without headings stay without.
RadiationData balanced_diffraction(const RadiationData& data, const RadiationMemory& memory);

}  // namespace hydro

#pragma once

#include <optional>
#include <vector>

#include "hydro/spatial.h"

namespace databases {

/// A∞ and how well it is known.
struct InfiniteAddedMass {
  hydro::Matrix6d matrix = hydro::Matrix6d::Zero();
  /// Root mean square of the differences between the frequencies.
  hydro::Matrix6d spread = hydro::Matrix6d::Zero();
};

/// A∞ by Ogilvie's relation,
///
///     A∞ = A(ω) − (2/π) ⨍₀^∞ B(ν)/(ν² − ω²) dν,
///
/// in the mean over the frequencies below 0.7 of the highest. B is cubic between the frequencies,
/// linear below the lowest one, and a power of ν above the highest.
/// @return none for fewer than 6 frequencies
std::optional<InfiniteAddedMass> infinite_added_mass(const std::vector<double>& frequencies,
                                                     const std::vector<hydro::Matrix6d>& added_mass,
                                                     const std::vector<hydro::Matrix6d>& damping);

}  // namespace databases

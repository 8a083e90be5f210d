#pragma once

#include <optional>

#include "hydro/sea.h"

/// @file
/// The error that a sum over a hull may make in the head of Airy waves, and the waves that it may
/// leave out.

namespace hydro {

/// The error that a sum over a hull may make.
struct HeadError {
  double tolerance = 0;         ///< Part of the wholly submerged hull's buoyancy [-], > 0.
  double volume_over_area = 0;  ///< Volume over area of the hull [m].

  /// ℓ: three times volume over area, the radius of a sphere [m].
  double size() const { return 3 * volume_over_area; }
};

/// Part of the waves' own load that a sum may miss at most [-].
inline constexpr double kPartOfWaves = 5e-3;

/// The root mean square over the hull of the error of the head that leaves the force within the
/// tolerance, and within kPartOfWaves of the waves' part of it [m].
/// @param deviation   Standard deviation of the surface [m].
double allowed_head_error(const HeadError& error, double deviation);

/// Factor of the error of the head of a wave: over a body that is long against the wave it cancels
/// [-].
inline double cancelled(double wave_number, const HeadError& error) {
  return 1 / (1 + wave_number * error.size());
}

/// The sea without the waves that are too short or too low to move a hull: their loads are some
/// 1/(1
/// + (kℓ)^1.5) of those of long waves, as the Froude–Krylov force on a sphere is, and those of all
/// left out are together, in the root mean square, below a fifth of what may be missed. None where
/// all waves stay, or where they are few.
std::optional<Sea> without_weak_waves(const Sea& sea, const HeadError& error);

}  // namespace hydro

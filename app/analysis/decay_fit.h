#pragma once

#include <optional>
#include <vector>

/// @file
/// Damping of a free decay, as of
///
///     x'' + p1 x' + p2 |x'| x' + ω² (x − x0) = 0                                    (1)
///
/// The amplitude after each half cycle is half the distance between two extremes, which needs no
/// x0. To first order in the damping it falls per cycle by da/dn = −(δ a + (8/3) p2 a²), with the
/// logarithmic decrement δ = p1 T/2: the work of the quadratic term over a cycle is
/// (8/3) p2 ω² a³. So the decrement of a cycle is a line over its mean amplitude, of which δ is the
/// value at 0 and (8/3) p2 the slope. [Faltinsen, Sea Loads on Ships and Offshore Structures, 1990,
/// ch. 7, fits decays likewise.]

namespace app {

/// A cycle of a decay: from an extreme to the next but one.
struct DecayCycle {
  double start = 0;      ///< [s]
  double period = 0;     ///< [s]
  double amplitude = 0;  ///< Mean over the cycle.
  double decrement = 0;  ///< ln of the amplitude over that a cycle later.
};

struct DecayFit {
  std::vector<DecayCycle> cycles;  ///< One from each extreme, so that they overlap by half.
  double period = 0;               ///< Mean [s].
  double equilibrium = 0;          ///< x0, from the last extremes.
  double decrement = 0;            ///< δ, of small amplitudes [-].
  double damping_ratio = 0;        ///< ζ of the linear part: share of the critical damping.
  double linear = 0;               ///< p1 [1/s]
  double quadratic = 0;            ///< p2 [1 / unit of the signal]
};

/// Fits the damping to a signal that decays freely: whose swings grow smaller from the first to the
/// last, three cycles or more, of about one period. Swings below 1 % of the largest are left out.
/// @return none if the signal does not
std::optional<DecayFit> fitted_decay(const std::vector<double>& times,
                                     const std::vector<double>& values);

}  // namespace app

#pragma once

#include <array>

/// @file
/// Open-water characteristics of the Wageningen B-series of screws.
///
/// Polynomials of 39 and 47 terms fitted to the tests of about 120 models, at Re = 2e6 [OO75]:
///
///     K_T, K_Q = Σ c J^s (P/D)^t (A_E/A_0)^u Z^v                                             (1)
///
/// with T = ρ n² D⁴ K_T, Q = ρ n² D⁵ K_Q, J = V_a/(nD). They hold for J from 0 to about that of
/// zero thrust; neither the Reynolds number nor cavitation changes them.
///
/// [OO75] Oosterveld, van Oossanen, Further computer-analyzed data of the Wageningen B-screw
///        series, Int. Shipbuilding Progress 22 (1975) 251-262.

namespace hydro {

/// A screw of the series.
struct WageningenB {
  int blades = 4;           ///< Z, 2 to 7.
  double area_ratio = 0.7;  ///< Expanded blade area over disc area, A_E/A_0, 0.3 to 1.05 [-].
  double pitch_ratio = 1;   ///< P/D, 0.5 to 1.4 [-].
};

/// Thrust and torque of a screw in open water.
struct OpenWater {
  double thrust_coefficient = 0;  ///< K_T [-]
  double torque_coefficient = 0;  ///< K_Q [-]
};

/// The polynomials of one screw in J: the coefficients of J^0 … J^3.
struct OpenWaterCubics {
  std::array<double, 4> thrust = {};  ///< Coefficients of K_T.
  std::array<double, 4> torque = {};  ///< Coefficients of K_Q.
};

/// The polynomials of a screw.
/// @throws std::invalid_argument  if the screw is outside the series.
OpenWaterCubics open_water_cubics(const WageningenB& screw);

/// Equation (1).
///
/// @param advance_ratio  J [-]; above that of zero thrust the polynomials extrapolate.
/// @throws std::invalid_argument  if the screw is outside the series.
OpenWater open_water(const WageningenB& screw, double advance_ratio);

}  // namespace hydro

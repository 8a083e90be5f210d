#pragma once

#include <Eigen/Core>
#include <vector>

/// @file
/// Forces on rudders, fins, keels and sails, as on one element in a uniform flow; and the race of a
/// screw, in which a rudder stands.
///
/// The lift of the attached flow grows as C_L = a sin α, and induces drag C_D = C_D0 + 1.1
/// C_L²/(πΛ). The slope a depends on the effective aspect ratio Λ:
///
///     soding            a = 2πΛ(Λ + 1)/(Λ + 2)²               [Sö82]
///     fujii             a = 6.13Λ/(Λ + 2.25)                  [Fu60]                         (1)
///     whicker_fehlner   a = 1.8πΛ/(√(Λ² + 4) + 1.8)           [WF58], without sweep
///
/// Beyond the angle `stall` the flow separates: over 0.2 rad the coefficients go, with the weight
/// 3s² − 2s³, to those of a plate behind which the water is at rest [Ra76], scaled to 1.2 across
/// the flow:
///
///     C_N = 1.2 (4 + π) sin α/(4 + π sin α),   C_L = C_N cos α,   C_D = C_D0 + C_N sin α     (2)
///
/// A foil in flow from behind has the forces of the same foil turned round. The component of
/// the flow along the span has no effect. Added mass, unsteady lift and the free surface are left
/// out; a foil near a hull has up to twice its own aspect ratio.
///
/// [Sö82] Söding, Prediction of ship steering capabilities, Schiffstechnik 29 (1982) 3-29.
/// [Fu60] Fujii, Experimental researches on rudder performance, J. Zosen Kiokai 107 (1960).
/// [WF58] Whicker, Fehlner, Free-stream characteristics of a family of low-aspect-ratio,
///        all-movable control surfaces, DTMB report 933, 1958.
/// [Ra76] Rayleigh, On the resistance of fluids, Phil. Mag. 2 (1876) 430-441.

namespace hydro {

/// A foil of rectangular plan.
struct Foil {
  /// Source of lift slope and coefficients: a formula, or the table.
  enum class Law { soding, fujii, whicker_fehlner, table };

  /// Coefficients over the angle of attack, linear between the rows. A table that starts at 0 is
  /// that of a symmetric foil. Beyond its ends (2) follows within 0.2 rad: at ±π it has no jump if
  /// it ends that much before, or has equal values there.
  struct Table {
    std::vector<double> angle = {};  ///< α, increasing within [-π, π], two rows or more [rad].
    std::vector<double> lift = {};   ///< C_L [-]
    std::vector<double> drag = {};   ///< C_D, >= 0 [-]
  };

  Law law = Law::whicker_fehlner;  ///< Formula or table.
  double span = 1;                 ///< Along its axis, > 0 [m].
  double chord = 1;                ///< Along the flow, > 0 [m].
  double aspect_ratio = 0;         ///< Effective Λ; 0: span/chord [-].
  double drag_zero = 0.01;         ///< C_D0, >= 0 [-].
  double stall = 0.44;  ///< Angle of attack at which the flow starts to separate, 0 to 1.3 [rad].
  Table table;          ///< Used by Law::table alone.
};

/// Lift and drag over ½ρ U² times span times chord [-].
struct FoilCoefficients {
  double lift = 0;  ///< C_L [-]
  double drag = 0;  ///< C_D [-]
};

/// Checks a foil.
/// @throws std::invalid_argument  if a field is out of the range that is given above. The functions
///                                below take a foil that has passed.
void check_foil(const Foil& foil);

/// dC_L/dα at α = 0 [1/rad], (1).
double lift_slope(const Foil& foil);

/// C_L and C_D at any angle of attack in [-π, π] [rad]; continuous, C_D >= 0.
FoilCoefficients foil_coefficients(const Foil& foil, double angle_of_attack);

/// Force of the fluid on the foil [N], in the frame of the arguments.
///
/// It never does work on the foil: force · flow >= 0.
///
/// @param flow        Velocity of the fluid relative to the foil [m/s]. α is positive if it has a
///                    component along span_axis × chord_axis; so then has the lift.
/// @param chord_axis  Unit vector from the trailing to the leading edge.
/// @param span_axis   Unit vector normal to it.
/// @param density     ρ [kg/m³].
Eigen::Vector3d foil_force(const Foil& foil, const Eigen::Vector3d& flow,
                           const Eigen::Vector3d& chord_axis, const Eigen::Vector3d& span_axis,
                           double density);

/// The race of a screw where the rudder stands.
struct Race {
  double speed = 0;     ///< Mean axial speed over the part of the rudder in the race [m/s].
  double diameter = 0;  ///< Diameter of the race there [m].
};

/// Speed and contraction of the race by momentum theory.
///
/// With V_2 = √(V_a² + 2T/(ρA)) far behind and V_1 = ½(V_a + V_2) in the disc [MT07, section 3.6]
///
///     u = V_a + K_R (V_2 − V_a),   K_R = ½ + ½/(1 + 0.15 D/Δx),   d = D √(V_1/u)              (3)
///
/// so that u = V_1 in the disc. A screw without thrust ahead has no race: u = V_a and d = D.
/// Against V_a < 0 the race is that of a screw at rest, and V_a is added to its speed.
///
/// [MT07] Molland, Turnock, Marine Rudders and Control Surfaces, 2007.
///
/// @param inflow    V_a [m/s].
/// @param thrust    T, in open water [N].
/// @param distance  Δx from the disc to the rudder, its amount counts [m].
Race propeller_race(double inflow, double thrust, double diameter, double distance, double density);

}  // namespace hydro

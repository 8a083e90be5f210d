#pragma once

#include <Eigen/Core>
#include <array>
#include <variant>
#include <vector>

#include "hydro/machines/wageningen.h"

/// @file
/// Thrust and torque of a screw that turns and moves either way.
///
/// With the speed of advance V_a and the rate of revolution n, the angle β and the speed V_r of the
/// flow at 0.7 of the radius and the coefficients C_T*, C_Q* are
///
///     β = atan2(V_a, 0.7π n D),    V_r² = V_a² + (0.7π n D)²
///     T = ½ρ V_r² (πD²/4) C_T*(β),    Q = ½ρ V_r² (πD³/4) C_Q*(β)                            (1)
///
/// finite and regular at n = 0 and V_a = 0 [La69]. As the flow gets 2πnQ − T V_a from the screw,
/// and a screw takes no energy from water at rest, every β has
///
///     C_Q* cos β ≥ 0.35 C_T* sin β                                                           (2)
///
/// K_T(J) and K_Q(J) give C* = 8 cos²β K(0.7π tan β)/(0.49π³) while they hold: from J = 0, or the
/// first row of a table, to the J_0 of zero thrust, or the last row if that is beyond. On either
/// side, up to |β| = π/2, C* turns with the weight 3s² − 2s³ from its tangent to that of blades as
/// flat plates at the angle φ, tan φ = J_0/(0.7π), with the normal force 1.2 A_E/A_0 sin(φ − β):
///
///     C_T* = 1.2 (A_E/A_0) sin(φ − β) cos φ,    C_Q* = 0.35 C_T* tan φ                       (3)
///
/// which opposes the flow through a stopped screw. Where the tangent would break (2), C_Q* is
/// raised to fulfil it. A screw that turns astern has −C*(β ± π) times r + (1 − r) sin²β, with r
/// the `reverse` of the screw. So only the first quadrant is measured; the others are estimates.
///
/// Sign     Axis, thrust and V_a are positive ahead; n is positive as the screw drives ahead.
/// Validity No cavitation, no cross flow, no history: the flow is that of steady motion.
///
/// [La69] van Lammeren, van Manen, Oosterveld, The Wageningen B-screw series, Trans. SNAME 77
/// (1969)
///        269-317.

namespace hydro {

/// Measured characteristics, linear between the rows.
///
/// J increases from a first value <= 0, at which the screw thrusts. If K_T does not come down to
/// zero, the last interval's lines go on until it does; so it must fall there.
struct OpenWaterTable {
  std::vector<double> advance_ratio;       ///< J [-]
  std::vector<double> thrust_coefficient;  ///< K_T [-]
  std::vector<double> torque_coefficient;  ///< K_Q [-]
  double area_ratio = 0.7;  ///< A_E/A_0 [-], > 0: what a stopped screw has of resistance.
};

/// Measured in four quadrants, linear between the rows and periodic.
struct FourQuadrantTable {
  std::vector<double> beta;    ///< β, increasing within [-π, π], two rows or more [rad].
  std::vector<double> thrust;  ///< C_T* [-]
  std::vector<double> torque;  ///< C_Q*, with D as its length [-].
};

/// The curves of a screw: a series, or one of two kinds of tables.
using PropellerModel = std::variant<WageningenB, OpenWaterTable, FourQuadrantTable>;

/// A screw and how it works behind its hull.
struct Propeller {
  PropellerModel model = {};  ///< Its curves.
  double diameter = 1;        ///< D, > 0 [m].
  double wake = 0;            ///< Wake fraction w, below 1: V_a = (1 − w) V [-].
  double deduction = 0;  ///< Thrust deduction t, below 1: what acts on the body is (1 − t) T [-].
  /// η_R, > 0: the torque is that in open water over η_R [-] (ITTC).
  double rotative_efficiency = 1;
  double reverse = 0.7;  ///< Bollard thrust astern over that ahead, > 0, for models from K_T [-].
};

/// The loads and the torque of a screw.
struct PropellerLoad {
  double thrust = 0;  ///< On the body, along the axis, after deduction [N].
  double torque = 0;  ///< Torque that the screw absorbs, with the sign of n as it is driven [N m].
  double open_thrust = 0;    ///< Before deduction [N].
  double inflow = 0;         ///< V_a [m/s]
  double advance_ratio = 0;  ///< J = V_a/(nD); 0 if n = 0 [-].
};

/// C_T* and C_Q* at one β.
struct QuadrantCoefficients {
  double thrust = 0;  ///< C_T* [-]
  double torque = 0;  ///< C_Q* [-]
};

/// The curves of a screw, prepared once.
class PropellerCurves {
 public:
  /// Prepares the curves of a screw.
  /// @throws std::invalid_argument  if a parameter is out of the range that is given above.
  explicit PropellerCurves(const Propeller& propeller);

  /// Equation (1), behind the hull.
  ///
  /// @param rps           n [1/s].
  /// @param speed         V of the hull through the water about the screw, along the axis [m/s].
  /// @param density       ρ [kg/m³].
  /// @param wetted_share  Share of the disc under water, 0 to 1 [-]; thrust and torque are
  ///     proportional to it.
  PropellerLoad load(double rps, double speed, double density, double wetted_share) const;

  /// C_T* and C_Q* in open water; beta in [-π, π] [rad].
  QuadrantCoefficients coefficients(double beta) const;

 private:
  /// K(J) = Σ k_i J^i from the advance ratio `from` up to the next piece's.
  struct Piece {
    double from = 0;
    std::array<double, 4> thrust = {}, torque = {};
  };

  /// C* and its derivative to β at an end of the range in which K_T and K_Q hold.
  struct End {
    double beta = 0;
    QuadrantCoefficients value, slope;
  };

  void prepare(const WageningenB& screw);
  void prepare(const OpenWaterTable& table);
  void prepare(const FourQuadrantTable& table);
  void prepare_ends(double zero_thrust, double area_ratio);
  const Piece& piece_at(double advance_ratio) const;
  End end_at(double advance_ratio) const;
  QuadrantCoefficients ahead(double beta) const;
  QuadrantCoefficients beyond(const End& end, double border, double beta) const;

  Propeller propeller_;
  std::vector<Piece> pieces_;  ///< Pieces of K_T and K_Q; none for a table of four quadrants.
  double last_ = 0;  ///< The largest J at which K_T and K_Q hold; pieces_ starts at the least.
  End lower_, upper_;
  double pitch_angle_ = 0;  ///< φ [rad].
  double plate_ = 0;        ///< 1.2 A_E/A_0 [-].
};

/// Share of a screw's disc below a level surface [0 to 1].
///
/// It is the exact area of a segment of the circle. A disc that lies flat is taken to reach a
/// twentieth of its radius up and down, so that the share has no jump.
///
/// @param center_W        In W [m].
/// @param axis_W          Unit vector, in W.
/// @param surface_height  z of the water surface there, in W [m].
double wetted_share(const Eigen::Vector3d& center_W, const Eigen::Vector3d& axis_W, double diameter,
                    double surface_height);

}  // namespace hydro

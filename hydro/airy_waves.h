#pragma once

#include <optional>
#include <vector>

#include "hydro/sea.h"

/// @file
/// Linear (Airy) waves: the dispersion relation, and the water under them.
///
/// On water of depth h that moves with the current U, the one of the surface, a wave of amplitude
/// a, wave vector k = k (cos β, sin β) and phase θ = k·x − ωt + φ obeys
///
///     ω = σ + k·U,        σ² = g k tanh kh,                                                  (1)
///
/// with σ its frequency for an observer who drifts with the current. With the functions of depth
///
///     C(z) = cosh k(z + h) / cosh kh,        S(z) = sinh k(z + h) / cosh kh                  (2)
///
/// (both e^{kz} in deep water), the elevation ξ, the head Φ of the dynamic pressure, and velocity
/// and acceleration of the water relative to the current on the spot are sums over the waves:
///
///     ξ = Σ a cos θ,       Φ = Σ a C cos θ,                                                  (3)
///     u = Σ a (g k/σ) (C cos θ cos β, C cos θ sin β, S sin θ),        u̇ = −g ∇Φ              (4)
///
/// Linear theory ends at the level. Wheeler's stretching [W70] takes C and S at z* = h (z − ξ)/(h +
/// ξ), in deep water z − ξ. At the depth s = ξ − z below the instantaneous surface the pressure is
///
///     p/(ρg) = s − Σ a (1 − C(z*)) cos θ,                                                    (5)
///
/// zero at s = 0 to the last bit. The field is harmonic in (x, y, z*), not in z: mass is conserved
/// to first order in the steepness, and no second-order effect of the waves is claimed.
///
/// [W70] Wheeler. Method for calculating forces produced by irregular waves. J. Petroleum
///       Technology 22 (1970) 359-367.

namespace hydro {

/// Frequency σ of a wave in the frame of the water [rad/s], by (1).
/// @param depth   May be infinite.
double intrinsic_frequency(double wave_number, double depth, double gravity);

/// The smallest wave number k > 0 with ω = σ(k) + k U, to round-off [rad/m].
/// @param frequency   ω, seen by an observer at rest [rad/s], > 0.
/// @param along       U: component of the current along the direction of travel [m/s].
/// @return none if the current stops the wave
std::optional<double> wave_number(double frequency, double depth, double gravity, double along = 0);

/// A wave on a sea: ω follows from the wave number, the sea's depth and its current.
/// @param heading   Direction of travel, counter-clockwise from +x [rad].
WaveComponent linear_wave(const Sea& sea, double amplitude, double wave_number, double heading,
                          double phase);

/// A wave in deep water without current, of the given length [m].
WaveComponent deep_water_wave(double amplitude, double wavelength, double heading, double phase,
                              double gravity);

/// True if pressure and motion of the water are those of linear waves. False in still water, over a
/// height field and for waves with `Kinematics::hydrostatic`.
bool has_airy_waves(const Sea& sea);

/// The water at a point.
struct WaterMotion {
  double head = 0;                                         ///< p/(ρg) [m].
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< In W, the current included [m/s].
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< u̇ [m/s^2].
};

/// The waves and the current of a sea at one time.
class AiryWaves {
 public:
  /// One wave at this time.
  struct Wave {
    double amplitude;       ///< Amplitude that the ramp leaves at this time [m].
    double k, kx, ky;       ///< [rad/m]
    double phase;           ///< θ at x = y = 0 [rad].
    double velocity_scale;  ///< g/σ [m/s].
    double weight;          ///< 1/(1 + e^{−2kh}) [-]: 1 in deep water.
  };

  /// Without waves where the sea has no Airy waves.
  AiryWaves(const Sea& sea, double time);

  /// The water at a point `s` below the surface [m]; above it, s < 0, that of the surface with a
  /// head of s. The surface may be an approximation: its place, not its equation, is told by s.
  WaterMotion at(const Eigen::Vector3d& p_W, double s) const;

  /// Mean velocity [m/s] of the water at the depth `s` over a box about a point, in closed form.
  /// A current that changes with depth is taken at the point.
  /// @param half_sides   From the middle of the box to its sides, in W, in columns [m].
  Eigen::Vector3d mean_velocity(const Eigen::Vector3d& p_W, double s,
                                const Eigen::Matrix3d& half_sides) const;

  /// The waves at this time.
  const std::vector<Wave>& waves() const { return waves_; }
  /// False if all of the water moves with `Sea::current`.
  bool moves() const { return !waves_.empty() || !profile_.empty(); }
  /// True in water of infinite depth.
  bool deep() const { return !(depth_ < kDeepest); }
  /// Depth of the still water [m].
  double depth() const { return depth_; }

  /// Depth from which on water is taken as infinitely deep [m].
  static constexpr double kDeepest = 1e300;

 private:
  /// Adds a wave's part of the water at a depth z* = −`down`, times a factor.
  void add(const Wave& w, const Eigen::Vector3d& p_W, double down, double factor,
           WaterMotion& water) const;
  /// Velocity of the water at a height z without its waves [m/s].
  Eigen::Vector3d current(double z) const;

  std::vector<Wave> waves_;
  double depth_, gravity_, level_;
  Eigen::Vector3d current_;
  std::vector<CurrentRow> profile_;
};

/// The water at a point of any sea. Over water without Airy waves it moves with the current.
WaterMotion water_at(const Sea& sea, const Eigen::Vector3d& p_W, double time);

/// AiryWaves::mean_velocity() of a sea at a time, for one box.
Eigen::Vector3d mean_velocity(const Sea& sea, const Eigen::Vector3d& p_W, double s,
                              const Eigen::Matrix3d& half_sides, double time);

}  // namespace hydro

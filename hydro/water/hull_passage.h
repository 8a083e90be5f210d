#pragma once

#include <span>
#include <vector>

#include "hydro/spatial.h"
#include "hydro/water/hull_sources.h"

/// @file
/// A floating hull in the steps of simulated water: its place, the load of the waves on it, and the
/// volumes that its sources give to the water.
///
/// A hull at rest has the sources and the load of hull_sources.h. The mean of its motion over some
/// periods, time_of_mean_speed() of sea.h, is its course, U. Under way a hull that pierces the
/// surface has for this motion the sources of a thin ship,
///
///     σ = U·n,                                                                                (1)
///
/// and the mean of the flow that it meets, which its own waves make, is left out of (1) of
/// hull_sources.h. Solved sources are wrong by −40 to +8 % of the resistance there, since the
/// surface cuts them off at the waterline; those of (1) have Michell's within some per cent. A hull
/// below the surface keeps the solved ones. With the hull goes the rate of the potential, so that
///
///     η − (U·∇)φ_w/g                                                                          (2)
///
/// takes the place of η in the load, which is zero for waves that go with the hull. The load of
/// such waves is that on the sources (Lagally),
///
///     F = −ρ Σ_j σ_j a_j ∇φ_w,                                                                (3)
///
/// the resistance, and what lifts and trims the hull: its power is what the waves get.
///
/// Motions in waves at speed are not right: solved sources end at the waterline, which moves on
/// over the water that they have raised. In head waves of 1.25 lengths at a Froude number of 0.2 a
/// slender hull pitches by 60 % too much.

namespace hydro {

/// The waves at the places of a hull's patches, in H.
struct FlowAtHull {
  Eigen::VectorXd raise;      ///< (2) [m]
  Eigen::Matrix3Xd slope;     ///< Its gradient [-].
  Eigen::VectorXd potential;  ///< φ_w [m^2/s]
  Eigen::Matrix3Xd velocity;  ///< ∇φ_w [m/s]
  Eigen::VectorXd inward;  ///< Through the patches, of the given sea and other hulls, too [m^3/s].

  explicit FlowAtHull(Eigen::Index patches);
};

/// The waves on a hull during a step of the water, in H for ρ = 1.
struct WavesOnHull {
  Vector6d load = Vector6d::Zero();      ///< f of simulated_water.h
  Vector6d momentum = Vector6d::Zero();  ///< −∫ (φ_w N + ψ ∂φ_w/∂n) dS halfway.
};

/// The quantities of a hull that change from step to step.
class HullPassage {
 public:
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< Place of H's origin halfway [cells].
  double heading = 0;                               ///< Heading of H's x axis halfway [rad].
  double presence = 0;                              ///< Root of the hull's presence [-].
  double under_way = 0;                             ///< Part of the course that counts [-].
  Vector6d course = Vector6d::Zero();               ///< U in H [m/s, rad/s].
  Eigen::VectorXd flow;           ///< Flow that the sources must meet in this step [m^3/s].
  Eigen::VectorXd steady;         ///< Mean of the flow [m^3/s].
  Eigen::VectorXd rates, before;  ///< Rates of the sources in the last two steps [m^3/s].

  HullPassage() = default;
  /// @param mean_time   Time over which the course is the mean of the motion [s].
  HullPassage(const HullSources& hull, double mean_time);

  /// The place of a point of H halfway [cells].
  Eigen::Vector2d at(const Eigen::Vector3d& place_H, double cell) const;
  /// U as far as it counts, in W [m/s].
  Eigen::Vector2d velocity() const;
  /// Finds how far the course counts: from 0 at a Froude number by the hull's length of 0.05 to 1
  /// at 0.15.
  void set_course(const HullSources& hull);

  /// The load in a step of a length [s], less half of the answer of what the hull scatters in it.
  WavesOnHull meet(const HullSources& hull, const FlowAtHull& water, double length);
  /// The volumes of the sources in the step, in which the hull has gone the way ξ [m^3].
  Eigen::VectorXd give(const HullSources& hull, const Vector6d& way, double length);

  /// All of it, for states.
  std::vector<std::span<double>> numbers();

 private:
  /// Part by which a mean comes nearer to its subject in a step.
  double part_of_mean(double length) const;

  double mean_time_ = 1;
};

}  // namespace hydro

#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

/// @file
/// The fit of the oscillators of radiation_memory.h, whose equation numbers hold here.
///
/// The frequencies and the damping follow from a rule, and only the residues are fitted, so that
/// there is one solution. With R_k = Σ b bᵀ over the rows b of the port at Ω_k, (3) is
///
///     Ĥ(s) = Σ_k s R_k / (s² + d_k s + Ω_k²),      d_k = 2ζ Ω_k,      R_k ⪰ 0,              (4)
///
/// for frequencies Ω_k that are δ apart in their logarithm, from below the data to above it, and
/// ζ = 1.2 δ; δ is 0.025, and larger for more than three motions that act on each other. The peaks
/// of neighbours overlap: equal residues give a response that is smooth to 2 e^{−2πζ/δ} = 0.1 % of
/// it. The residues are the minimum of the strictly convex function
///
///     ½ Σ_i w_i² ‖Ĥ(iω_i) − H_i‖² − μ Σ_k log det R_k,                                      (5)
///
/// whose second term keeps them positive and, as μ is small, changes the response by less than the
/// error of the fit. Newton's method finds it from any start, and so two processors agree to
/// round-off.

namespace hydro {

/// m oscillators driven by n velocities.
struct Oscillators {
  Eigen::VectorXd frequencies;  ///< Ω, > 0 [rad/s].
  Eigen::VectorXd damping;      ///< d, > 0 [1/s].
  Eigen::MatrixXd port;         ///< B, m × n.
};

/// Ĥ of (3), n × n, at s = iω.
Eigen::MatrixXcd response(const Oscillators& oscillators, double frequency);

/// The oscillators (4) whose response is nearest to H, with each motion in units of its largest
/// |H_ii|. Errors far above the mean frequency of the damping count less. Between given frequencies
/// that are more than δ apart H is the cubic in log ω through the four nearest ones.
///
/// @param frequencies   ω, ascending, > 0 [rad/s].
/// @param H             A symmetric matrix a frequency; no motion has a diagonal of zeros.
Oscillators fit_oscillators(const std::vector<double>& frequencies,
                            const std::vector<Eigen::MatrixXcd>& H);

}  // namespace hydro

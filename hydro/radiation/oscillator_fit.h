#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

/// @file
/// Least squares for the oscillators of radiation_memory.h, whose equation numbers hold here.

namespace hydro {

/// m oscillators driven by n velocities.
struct Oscillators {
  Eigen::VectorXd frequencies;  ///< Ω, > 0 [rad/s].
  Eigen::MatrixXd damping;      ///< D = L Lᵀ [1/s].
  Eigen::MatrixXd port;         ///< B, m × n.
};

/// Ĥ of (3), n × n, at s = iω.
Eigen::MatrixXcd response(const Oscillators& oscillators, double frequency);

/// The oscillators whose response is nearest to H, with each motion in units of its largest |H_ii|:
/// as few as have an error below `wanted`, or 3 a motion, or as many as more are of no use.
///
/// Levenberg and Marquardt's method minimises the error over log Ω, L and B from several starts. A
/// response that rises between two frequencies of the data far above all data is discarded.
///
/// @param frequencies   ω, ascending, > 0 [rad/s].
/// @param H             A symmetric matrix a frequency; no motion has a diagonal of zeros.
/// @param wanted        Relative error, the root mean square over frequencies and motions [-].
Oscillators fit_oscillators(const std::vector<double>& frequencies,
                            const std::vector<Eigen::MatrixXcd>& H, double wanted);

}  // namespace hydro

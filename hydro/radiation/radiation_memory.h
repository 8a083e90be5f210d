#pragma once

#include "hydro/radiation/radiation_data.h"

/// @file
/// The memory of the water for the motions of a floating body, as damped oscillators.
///
/// The waves that a body has sent out act on it later. In the frequency domain the load of a motion
/// with velocity u beyond that of the constant A∞ is −H u with, for real matrices and s = iω,
///
///     H(iω) = B(ω) + iω (A(ω) − A∞).                                                        (1)
///
/// m damped oscillators q that the velocity drives through a port B have the same effect:
///
///     q'' + D q' + Ω² q = B u,      F = −Bᵀ q',      D ≥ 0 and Ω diagonal                   (2)
///     Ĥ(s) = s Bᵀ (s² + s D + Ω²)⁻¹ B                                                       (3)
///
/// For any Ω, D and B this is passive, as the energy ½ (q'² + q·Ω² q) shows, which grows by u·Bᵀq'
/// − q'·D q': the body never gets back more than it has given. (3) is zero for a slow motion and
/// decays as 1/s for a fast one, as the memory of any floating body does [PF08].
///
/// oscillator_fit.h fits them to (1), apart for motions that do not act on each other.
/// The sign of i in the data's e^{−iωt} does not matter, as A and B are real.
///
/// [PF08] Pérez and Fossen. Time- vs. frequency-domain identification of parametric radiation force
/// models for marine structures at zero speed. Modeling, Identification and Control 29 (2008).

namespace hydro {

/// A complex matrix over six components.
using Matrix6cd = Eigen::Matrix<std::complex<double>, 6, 6>;

/// The oscillators (2), in the data's frame H and for water of density 1: B is to be multiplied by
/// the root of the density.
struct RadiationMemory {
  Eigen::VectorXd frequencies;                    ///< Ω, > 0 [rad/s].
  Eigen::VectorXd damping;                        ///< The diagonal of D, > 0 [1/s].
  Eigen::Matrix<double, Eigen::Dynamic, 6> port;  ///< B, a row for each oscillator.

  /// Root mean square of Ĥ − H at the data's frequencies, over the root of the largest |H_ii| times
  /// the largest |H_jj| [-]; zero where a motion makes no waves.
  Matrix6d rms_error = Matrix6d::Zero();
  /// The largest |Ĥ − H|, likewise.
  Matrix6d largest_error = Matrix6d::Zero();

  /// Number of oscillators.
  Eigen::Index size() const { return frequencies.size(); }
};

/// (3) at s = iω, for water of density 1. @param frequency   ω [rad/s]
Matrix6cd response(const RadiationMemory& memory, double frequency);

/// The memory of a body with this data; without oscillators where the body makes no waves.
/// @throws std::invalid_argument if the data has no frequencies, if they do not ascend from above
/// 0, or if a frequency lacks its matrices or a number is not finite.
RadiationMemory fit_memory(const RadiationData& data);

}  // namespace hydro

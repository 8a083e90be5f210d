#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "hydro/radiation/floating_body.h"
#include "hydro/radiation/radiation_data.h"
#include "hydro/radiation/wave_frame.h"
#include "hydro/sea.h"

/// @file
/// The load of the waves that a floating body scatters.
///
/// Over the sea's Airy waves, with the phase θ = k·x − ωt + φ at the origin of the frame H and its
/// heading ψ (wave_frame.h), the scattered waves have the momentum
///
///     p = Σ Re{ρ X_D(σ, β − ψ) a e^{iθ} / iσ}  in H,                                         (1)
///
/// and exert the load that is the rate at which they lose it in axes that turn with H. With the
/// velocity v of H's origin that is
///
///     F = Σ Re{ρ a e^{iθ} (ω − k·v + i ψ' ∂/∂ψ) X_D(σ, β − ψ) / σ}  in H.                    (2)
///
/// For a body that stands still without a current it is ρ X_D a e^{iθ}. The part of v makes the
/// load grow with the frequency of encounter, as strip theory's does [STF]. Both parts make F a
/// total derivative: with the load by which p turns with H it has no mean. X_D is known without
/// current, so σ is the frequency of a wave for an observer who drifts with the water
/// (airy_waves.h). The amplitudes are those of the ramp at the time.
///
/// Over the heading X_D is the trigonometric series through the data. Over the frequency X_D/k is
/// the cubic Hermite interpolant with the slopes of parabolas through three neighbours: continuous
/// with its first derivative, and exact for a parabola. In long waves the water accelerates past
/// the body by gk a, which its added mass meets, so X_D/k has a limit; below the lowest frequency
/// it is linear in k, as the two lowest tell, as e^{kz} is over the draught. Above the highest, X_D
/// keeps its phase and falls as k⁻²: faster than the k⁻¹ of a wall that reflects all waves, as
/// crests along a hull cancel each other.
///
/// [STF] Salvesen, Tuck and Faltinsen. Ship motions and sea loads. Trans. SNAME 78 (1970).

namespace hydro {

/// The loads on one body. Several threads may ask at once, and an answer does not depend on earlier
/// questions. Coefficients are made at the first question for a sea and kept as long as the object.
class DiffractionLoad {
 public:
  /// Data without headings give no load.
  /// @throws std::invalid_argument unless the headings are 0, 2π/n, 4π/n … within 1e-6 rad and each
  ///     frequency has its loads
  explicit DiffractionLoad(const RadiationData& data);
  ~DiffractionLoad();
  DiffractionLoad(const DiffractionLoad&) = delete;
  DiffractionLoad& operator=(const DiffractionLoad&) = delete;

  /// The load (2) on a body about its centre of mass, W axes [N, N m]; zero where the sea has no
  /// Airy waves.
  /// @param position   Position of the centre of mass in W [m].
  /// @param motion     Velocity of H, as of a body about that centre.
  Wrench at(const Eigen::Vector3d& position, const Twist& motion, const WaveFrame& frame,
            const Sea& sea, double time) const;
  /// The momentum (1), with its moment about the centre of mass, W axes [N s, N m s].
  Wrench momentum(const Eigen::Vector3d& position, const WaveFrame& frame, const Sea& sea,
                  double time) const;

  /// X_D for ρ = 1 at a frequency [rad/s] and a direction of travel in H [rad], by the series and
  /// the interpolant above.
  Vector6cd coefficients(double frequency, double heading) const;

 private:
  /// A load as a complex Fourier series in the heading: a column for each of e^{imβ}, m = −M … M.
  using Series = Loads6cd;
  struct Waves;

  /// Σ Re{ρ a e^{iθ} c}, with c by `coefficient` of a wave, its σ, X_D and ∂X_D/∂ψ.
  template <typename Coefficient>
  Wrench sum(const Eigen::Vector3d& position, const WaveFrame& frame, const Sea& sea, double time,
             const Coefficient& coefficient) const;
  /// @param k   Wave number of that frequency in the data's water [rad/m].
  Series series_at(double frequency, double k) const;
  /// X_D/k below the lowest frequency.
  Series below_lowest(double k) const;
  const Waves& waves_of(const Sea& sea) const;

  LinearWater water_;
  std::vector<double> frequencies_;
  std::vector<Series> over_k_;  ///< X_D/k at the frequencies.
  std::vector<Series> slopes_;  ///< Derivatives of X_D/k by frequency.
  mutable std::mutex making_;
  mutable std::atomic<const Waves*> known_ = nullptr;  ///< A list of all seas that were asked for.
};

/// (2) and (1) as a FloatingBody takes them.
struct ScatteredWaves {
  FloatingBody::Diffraction load, momentum;
};

/// Load and momentum for a body with the data; both empty in a sea without Airy waves.
ScatteredWaves scattered_waves(const RadiationData& data, const Sea& sea);

}  // namespace hydro

#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <limits>

/// @file
/// Linear waves on a periodic square of water, advanced exactly.
///
/// With η the elevation, ψ the potential on the still surface, w the vertical velocity that sources
/// below make there, and hats for Fourier coefficients f̂(k) = ∫ f e^{−ik·x} dA, linear waves on
/// water of the depth h obey
///
///     η̂' = k tanh(kh) ψ̂ + ŵ,        ψ̂' = −g η̂,        ω² = g k tanh kh.
///
/// The two are one complex field ζ = η + iχ with χ̂ = (ω/g) ψ̂, which turns:
///
///     ζ̂' = −iω ζ̂ + ŵ,               E = ½ρg ∫ |ζ|² dA.                                      (1)
///
/// A source of the volume q at the depth −z, with its negative image above the surface, adds
///
///     ŵ = q C(k, z) e^{−ik·x},        C = cosh k(z + h) / cosh kh,                           (2)
///
/// e^{kz} in deep water. C is a sum over four layers, Σ c_l(z) C(k, z_l) with Σ c_l = 1, by least
/// squares over the wave numbers that the grid has, so that the cost of sources is that of
/// spreading them over cells of the layers and two transforms for all layers of all sources.
///
/// Sources are spread over 4 × 4 cells by the window e^{β(√(1−s²)−1)}, whose transform is divided
/// out [B19]; wave numbers near the grid's largest one are left out by e^{−(k/0.85k_max)^8}.
///
/// [B19] Barnett, Magland, af Klinteberg. A parallel nonuniform fast Fourier transform library
///       based on an "exponential of semicircle" kernel. SIAM J. Sci. Comput. 41 (2019) C479-C504.

namespace hydro {

/// A periodic square of water.
struct PeriodicSquare {
  int cells = 256;           ///< Along a side; a power of two.
  double cell = 1;           ///< Side of a cell [m], > 0.
  double deepest = 1;        ///< Depth of the sources that the layers are made for [m], > 0.
  double gravity = 9.80665;  ///< [m/s^2]
  double depth = std::numeric_limits<double>::infinity();  ///< Depth of the still water [m].

  double side() const { return cells * cell; }
};

/// The waves. Places are in cells from the square's corner and of any size: the square repeats.
class PeriodicWaves {
 public:
  explicit PeriodicWaves(const PeriodicSquare& square);

  const PeriodicSquare& square() const { return square_; }

  /// Lets the waves go on for a time [s].
  void advance(double time);

  /// Notes a source that has given a volume [m^3] at a height z <= 0 above the still surface [m].
  void add_source(double x, double y, double z, double volume);

  /// Raises the water by what the sources noted since the last call have given.
  void take_sources();

  /// Multiplies elevation and motion by factor_x[column]·factor_y[row].
  void damp(const Eigen::VectorXf& factor_x, const Eigen::VectorXf& factor_y);

  /// The elevation [m] a time [s] from now if nothing is added: rows along y, columns along x.
  Eigen::MatrixXf elevation(double later = 0) const;

  /// Energy over density [m^5/s^2], by (1).
  double energy() const;

  /// ζ̂ by wave numbers along y and x, which is all that changes between two steps.
  const Eigen::MatrixXcd& state() const { return zeta_; }
  void restore(Eigen::MatrixXcd state) { zeta_ = std::move(state); }

 private:
  static constexpr int kLayers = 4;
  static constexpr int kHeights = 128;  ///< Rows of the table of c_l.

  void make_modes();
  void make_layers();
  Eigen::MatrixXcd turn_in(double time) const;
  std::array<double, kLayers> shares_at(double z) const;

  PeriodicSquare square_;
  Eigen::MatrixXd omega_;                      ///< [rad/s]
  std::array<Eigen::MatrixXf, kLayers> gain_;  ///< C(k, z_l), window and filter of each layer.
  Eigen::MatrixXd shares_;                     ///< c_l by height, kLayers × kHeights.
  Eigen::MatrixXcd zeta_;
  std::array<Eigen::MatrixXcf, 2> sources_;  ///< Volumes [m^3]; two layers each.
  double turned_for_ = 0;                    ///< Time of `turn_` [s].
  Eigen::MatrixXcd turn_;                    ///< e^{−iωt}
};

}  // namespace hydro

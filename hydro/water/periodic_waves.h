#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <limits>
#include <vector>

#include "hydro/water/square_transform.h"

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
/// e^{kz} in deep water. C is a sum over some layers, Σ c_l(z) C(k, z_l) with Σ c_l = 1, by least
/// squares over the wave numbers that the grid has, so that the cost of sources is that of
/// spreading them over cells of the layers and a transform for each two layers of all sources.
/// Four layers have C within some per cent; its slope, which fields below the surface have, needs
/// five.
///
/// Sources are spread over 4 × 4 cells by the window e^{β(√(1−s²)−1)}, whose transform is divided
/// out [B19]; wave numbers near the grid's largest one are left out by e^{−(k/0.85k_max)^8}.
///
/// [B19] Barnett, Magland, af Klinteberg. A parallel nonuniform fast Fourier transform library
///       based on an "exponential of semicircle" kernel. SIAM J. Sci. Comput. 41 (2019) C479-C504.

namespace hydro {

class PeriodicWaves;

/// Two real fields f and g that are known by their transforms f̂ + iĝ on the still surface and
/// continue below it as (2): f̂ C(k, z). It is read at places below the surface.
class FieldBelow {
 public:
  /// The fields at a place.
  struct Sample {
    std::complex<double> value = 0;                     ///< f + ig
    Eigen::Vector3cd slope = Eigen::Vector3cd::Zero();  ///< Its gradient [1/m].
  };

  /// The fields at a place.
  /// @param x, y   In cells.  @param z   Above the still surface [m], <= 0.
  Sample at(double x, double y, double z) const;

 private:
  friend class PeriodicWaves;

  const PeriodicWaves* waves_ = nullptr;
  std::vector<Eigen::MatrixXcf> layers_;
  Eigen::MatrixXcf transform_, other_;  ///< Kept for their memory.
};

/// A periodic square of water.
struct PeriodicSquare {
  int cells = 256;           ///< Along a side; a power of two, 16 at least.
  double cell = 1;           ///< Side of a cell [m], > 0.
  double deepest = 1;        ///< Depth of the sources that the layers are made for [m], > 0.
  int layers = 4;            ///< 4 for sources alone, 5 where fields are read as well.
  double gravity = 9.80665;  ///< [m/s^2]
  double depth = std::numeric_limits<double>::infinity();  ///< Depth of the still water [m].

  /// Length of a side [m].
  double side() const { return cells * cell; }
};

/// The waves. Places are in cells from the square's corner and of any size: the square repeats.
class PeriodicWaves {
 public:
  /// Flat and still water.
  explicit PeriodicWaves(const PeriodicSquare& square);

  /// The square.
  const PeriodicSquare& square() const { return square_; }

  /// Lets the waves go on for a time [s].
  void advance(double time);

  /// Notes a source that has given a volume [m^3] at a height z <= 0 above the still surface [m].
  void add_source(double x, double y, double z, double volume);

  /// Raises the water by what the sources noted since the last call have given.
  void take_sources();
  /// Forgets the noted sources.
  void drop_sources();
  /// Makes the water flat and still.
  void calm() { zeta_.setZero(); }

  /// Multiplies elevation and potential by the factors of the cells.
  void damp(const Eigen::MatrixXf& factor);

  /// The elevation [m] a time [s] from now if nothing is added: rows along y, columns along x.
  Eigen::MatrixXf elevation(double later = 0) const;

  /// Makes `field` that of η − (V·∇)φ/g + iφ, less what the filter takes: the first is −1/g times
  /// the rate of φ for an observer who goes with the horizontal velocity V [m/s].
  void read(FieldBelow& field, const Eigen::Vector2d& velocity = Eigen::Vector2d::Zero()) const;
  /// Makes `field` that of ŵ + i g ŵ/ω² by the volumes of the noted sources, the elevation that
  /// they make and the potential of w if it stays as it is; the sources are forgotten.
  void read_sources(FieldBelow& field);

  /// Energy over density [m^5/s^2], by (1).
  double energy() const;

  /// ζ̂ by wave numbers along y and x, which is all that changes between two steps.
  const Eigen::MatrixXcd& state() const { return zeta_; }
  /// Goes back to a state() of waves on an equal square.
  void restore(Eigen::MatrixXcd state) { zeta_ = std::move(state); }

 private:
  static constexpr std::size_t kMostLayers = 5;
  using Shares = std::array<double, kMostLayers>;
  static constexpr int kHeights = 128;  ///< Rows of the table of c_l.

  void make_modes();
  void make_layers();
  Eigen::MatrixXcd turn_in(double time) const;
  friend class FieldBelow;
  struct Cells;
  Cells cells_about(double x, double y) const;
  /// c_l, or dc_l/dz.
  Shares shares_at(double z) const { return look_up(shares_, z); }
  Shares slopes_at(double z) const { return look_up(slopes_, z); }
  Shares look_up(const Eigen::MatrixXd& table, double z) const;
  void transform_sources();
  void find_raise_and_potential(Eigen::MatrixXcf& transform) const;
  void take_advance(const Eigen::Vector2d& velocity, Eigen::MatrixXcf& transform) const;
  void find_layers(FieldBelow& field) const;

  PeriodicSquare square_;
  SquareTransform transform_;
  Eigen::MatrixXd omega_;              ///< [rad/s]
  std::vector<double> heights_;        ///< z_l [m]
  std::vector<Eigen::MatrixXf> gain_;  ///< C(k, z_l), window and filter of each layer.
  Eigen::MatrixXd shares_;             ///< c_l by height, layers × kHeights.
  Eigen::MatrixXd slopes_;             ///< dc_l/dz [1/m].
  Eigen::MatrixXcd zeta_;
  std::vector<Eigen::MatrixXcf> sources_;  ///< Volumes [m^3]; two layers each.
  Eigen::MatrixXcf raised_;                ///< ŵ of the sources times their time.
  Eigen::MatrixXcf field_, other_;         ///< Kept for their memory.
  double turned_for_ = 0;                  ///< Time of `turn_` [s].
  Eigen::MatrixXcd turn_;                  ///< e^{−iωt}
};

}  // namespace hydro

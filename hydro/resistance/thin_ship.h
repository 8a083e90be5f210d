#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// Resistance by the waves of a slender hull that goes ahead on deep, calm water, by thin-ship
/// theory [M98], [T87].
///
/// Each part of the hull is a sheet of sources on its own centre plane y = y_p, of a strength that
/// follows from the slope of its sides. With n of the wetted surface out of the hull, x along the
/// motion, z = 0 the still water, κ = g/U² and λ = sec θ of a wave's direction θ,
///
///     K_p(λ) = −½ ∫_{S_p} n_x e^{κλ²z + iκλx} dS,                                             (1)
///     K_±    = Σ_p K_p e^{±iκλ√(λ²−1) y_p},                                                   (2)
///     R      = (4ρg²/πU²) ∫_1^∞ ½ (|K_+|² + |K_−|²) λ²/√(λ²−1) dλ.                            (3)
///
/// For one hull K is Michell's I + iJ, the integral over the slope of the half-breadth; hulls
/// beside each other interfere by (2). On a triangle the exponent is linear, and (1) a closed form:
/// twice the triangle's area times the second divided difference of exp. The integral (3) is taken
/// over u, λ = cosh u, in pieces of equal change of the phase.
///
/// The theory keeps the terms of the flow that are of first order in the breadth: no lift of a hull
/// that drifts, no viscosity, whose wake weakens the stern's waves. So its humps and hollows below
/// a Froude number of 0.3 are stronger than those of a real hull.
///
/// Its sources and their mirror images above the still water, of the strength U n_x dS, make the
/// flow of low speed, whose pressure draws the hull down. With r and r' from a source to a face,
///
///     F_z = −k U²,    k = ρ ∫ φ_x n_z dS,    φ = −1/(4π) Σ n_x dS (1/r + 1/r').              (4)
///
/// [M98] Michell. The wave resistance of a ship. Phil. Mag. 45 (1898) 106-123.
/// [T87] Tuck. Wave resistance of thin ships and catamarans. Univ. of Adelaide, Applied Mathematics
///       Report T8701 (1987).

namespace hydro {

/// A hull in its mean pose as sources on centre planes.
class ThinShip {
 public:
  struct WetMesh;

  /// A part of the hull that is connected below the water.
  struct Part {
    double length = 0;  ///< Length of the wetted surface along the motion [m].
    double beam = 0;    ///< The same across [m].
    double y = 0;       ///< y_p, about the volume's centre [m].
  };

  /// @param mesh_B   Closed, outward; its origin is the centre of mass. The motion is along the
  ///                 horizontal direction that the wetted sides face the least.
  /// @throws std::invalid_argument if nothing is wet, or a part is less than kLeastThinShip
  /// times
  ///     as long as wide
  ThinShip(const TriMesh& mesh_B, const MeanPose& pose);

  /// R/ρ [m^4/s^2].
  double resistance(double speed, double gravity) const;

  /// The force (4) and where it acts.
  struct Suction {
    double area = 0;                                   ///< k/ρ [m^2]; 0 if it is upward.
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< In the frame of the pose [m].
  };
  Suction suction() const;

  const std::vector<Part>& parts() const { return parts_; }
  double length() const { return length_; }  ///< Length of all parts along the motion [m].
  /// Part of the hull's section across the motion that lies on faces steeper than 45° to the
  /// motion, where the theory does not hold: 0 for fine ends, 1 for a box [-].
  double bluntness() const { return bluntness_; }

  /// All numbers that the resistance depends on.
  std::vector<double> numbers() const;

 private:
  struct Face {
    std::array<std::size_t, 3> corners;
    double source;  ///< −n_x dS [m^2].
    std::size_t part;
    double top = -std::numeric_limits<double>::infinity();  ///< z of the highest corner [m].
  };
  /// A face where it is, for the pressure on it.
  struct Panel {
    Eigen::Vector3d at;  ///< Its middle [m].
    double rise;         ///< n_z dS [m^2]
  };
  void measure_parts(const WetMesh& wet, const std::vector<std::size_t>& part_of);
  void gather_sources(const WetMesh& wet, const std::vector<std::size_t>& part_of);
  /// ½ (|K_+|² + |K_−|²) at κ and λ.
  double amplitude(double k, double lambda) const;

  std::vector<double> x_, z_;  ///< Coordinates of the faces' corners [m].
  std::vector<Face> faces_;    ///< From the highest to the lowest.
  std::vector<Panel> panels_;
  Eigen::Vector2d along_ = Eigen::Vector2d::UnitX();  ///< x in the frame of the pose.
  std::vector<Part> parts_;
  double length_ = 0;
  double width_ = 0;  ///< Distance of the outer centre planes [m].
  double bluntness_ = 0;
};

/// Least length over breadth of a part of the hull [-].
inline constexpr double kLeastThinShip = 4;

/// A resistance over the speed for water of density 1.
struct WaveResistance {
  std::vector<double> speeds;  ///< [m/s], at Froude numbers of 0.1 to 1.
  std::vector<double> forces;  ///< [m^4/s^2]
  ThinShip::Suction suction;
};

/// Tabulates the resistance with six speeds or more from a hump to the next.
WaveResistance wave_resistance(const ThinShip& ship, double gravity);

}  // namespace hydro

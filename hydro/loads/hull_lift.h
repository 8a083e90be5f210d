#pragma once

#include <vector>

#include "hydro/mesh/mesh_section.h"
#include "hydro/spatial.h"

/// @file
/// The lift of a slender hull that drifts or pitches under way: the momentum that its sections give
/// to the water and that leaves with its wake.
///
/// A section of the hull at x along the hull's axis e moves the water across the axis with the
/// momentum ρ a w a length, a being the section's own added mass in plane flow over ρ [m^2] and w
/// its velocity across. In Kirchhoff's equations the stern takes back what the bow has given, which
/// leaves Munk's moment and no force. Behind edges, transoms and steep ends it does not: the flow
/// separates, and the momentum stays in the water [J46, L60, N77 §7.9]. Where a falls by Δa towards
/// the end that the flow leaves, at U = e·v the hull lacks
///
///     F = −ρ |U| Σ κ Δa b (b·u),        b = (d, c × d)                                        (1)
///
/// for both directions d across the axis; u is the velocity of the hull relative to the water and c
/// the point of the section. Δa are the steps of the largest a of all sections from there to the
/// end, so that they add up to the largest of the hull, and
///
///     κ = s² / (s² + s_0²),        s = dR/dx,  π R² = a                                       (2)
///
/// is the part that separates: all of it at a transom, and hardly any on a long run. With U held F
/// is linear in u, and its matrix is symmetric and not positive: the load takes the power
/// ρ |U| Σ κ Δa (b·u)² in any motion. Half of it is the kinetic energy of the wake; the other half
/// would come back as suction along the axis, ½ρ Σ κ Δa (b·u)², if the flow stayed attached about
/// the bow and the bilges. It does not on ships, whose force along the axis does not grow with the
/// drift (the tanker KVLCC2 has X_vv' = −0.04 where suction would give +0.10), so there is none.
///
/// A wet piece of a section that is h high across d and b thick along it has
///
///     a = ¼π h² C f,     C = 1 + 0.561 q/(1 + 0.1 q) g,     q² = b/h,     g = (σ − ¼π)/(1 − ¼π)
///     (3)
///
/// with C = 1 of an ellipse; rectangles of b/h from 0.1 to 10 [DNV] are met within 6 %.
/// σ is the piece's area over b h, and below ¼π a third of g counts. The surface is a wall for
/// motion across (f = 2) and no pressure for motion up and down (f = ½, h being the beam); both
/// fade until the piece is as deep below the surface as it is high. Pieces that the water divides,
/// such as the hulls of a catamaran, count each on its own.
///
/// Valid where the length is many times the largest section: the load vanishes for bodies that are
/// less than kLeastSlenderness as long as they are high (doubled by the surface) or broad, and is
/// whole from kFullSlenderness on. It vanishes, too, as the axis of a body whose upper end is dry
/// becomes upright: a spar bobs along its axis and does not travel. The surface is the level plane
/// at its height over the centre of mass. A body that is longest across its motion has none. The
/// wake is taken to be left behind: of a body that moves to and fro by less than its length too
/// much is shed.
///
/// [J46] Jones. Properties of low-aspect-ratio pointed wings. NACA report 835 (1946).
/// [L60] Lighthill. Note on the swimming of slender fish. J. Fluid Mech. 9 (1960).
/// [N77] Newman. Marine Hydrodynamics (1977).
/// [DNV] DNV-RP-C205, table D-1.

namespace hydro {

/// Length over the largest height or breadth of a wet piece from which on there is some lift, and
/// all of it [-]. Smaller: cubes and short barges have lift that they do not have.
inline constexpr double kLeastSlenderness = 2, kFullSlenderness = 3;
/// s_0 of (2) [-]: the bare hull of the submarine Suboff, whose tail tapers by 1 in 4, sheds 0.28
/// of its largest section. Larger: boats with fine sterns turn off their course more easily.
inline constexpr double kSeparatingSlope = 0.4;

/// The water about a hull.
struct HullWater {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< In W [m/s].
  double surface = 0;                                  ///< Its height over the hull [m].
  double density = 0;                                  ///< [kg/m^3]
};

/// The sections of a hull along the longest side of its box. It is constant.
class HullLift {
 public:
  /// @param mesh_B   Closed; its origin is the centre of mass.
  explicit HullLift(const TriMesh& mesh_B);

  /// False for a body that is slender in no pose.
  bool may_lift() const { return !stations_.empty(); }

  /// (1) in W, its moment about the centre of mass.
  Wrench load(const BodyState& state, const HullWater& water) const;
  /// The derivative of (1) with respect to (v, ω) in W with U held: symmetric, without positive
  /// eigenvalues.
  Matrix6d jacobian(const BodyState& state, const HullWater& water) const;

  /// Σ κ Δa b bᵀ of (1) in body axes [m^2, m^3, m^4].
  /// @param up_B     Unit: the vertical.
  /// @param below    Height of the surface above the centre of mass [m].
  /// @param ahead    The hull moves towards its positive axis, and its lower end is the stern.
  Matrix6d shed(const Eigen::Vector3d& up_B, double below, bool ahead) const;

 private:
  /// Sections lie closer towards the ends, where κ is decided.
  struct Station {
    double at = 0;             ///< Along the axis [m].
    double low = 0, high = 0;  ///< Its slice [m].
    std::vector<SectionLoop> loops;
  };

  int axis_ = 0;
  std::vector<Station> stations_;  ///< From the low end to the high one.
};

}  // namespace hydro

#pragma once

#include <span>

#include "hydro/loads/clip.h"
#include "hydro/spatial.h"

/// @file
/// Viscous drag on a panel that turns in its plane, by closed forms.
///
/// On a flat panel the tangential velocity of a rigid body is that of a rotation about a point of
/// the panel's plane, the pole: v_t = ω_n n × s with ω_n = ω·n and s the position relative to the
/// pole. So |v_t| = |ω_n| d, d = |s|, and with a C_v that depends on the speed alone
///
///     ∫ C_v |v_t| v_t dA        = |ω_n| ω_n n × ∫ C_v d s dA                               (1)
///     ∫ s × C_v |v_t| v_t dA    = |ω_n| ω_n n ∫ C_v d³ dA                                  (2)
///
/// In polar coordinates about the pole both are sums over the edges, with e the unit vector at the
/// angle θ and ρ the distance of the edge there:
///
///     ∫ C_v d s dA = ∮ G(ρ) e dθ,  G(ρ) = ∫_0^ρ C_v r³ dr                                  (3)
///     ∫ C_v d³ dA  = ∮ H(ρ) dθ,    H(ρ) = ∫_0^ρ C_v r⁴ dr                                  (4)
///
/// On an edge at the distance h from the pole, with t along it, ρ² = h² + t² and dθ = h dt/ρ²: for
/// a C_v that is piecewise linear in the speed all integrals are elementary.

namespace hydro {

/// C_v = constant + slope·v for speeds v from `from` on, up to the next piece.
struct DragPiece {
  double from = 0;      ///< [m/s]
  double constant = 0;  ///< [-]
  double slope = 0;     ///< [s/m]
};

/// ∫ C_v |v_t| v_t dA and its moment about the centre of mass, without the factor −½ρ.
///
/// For a pole at the distance D from a panel of size s, rounding errors grow by about (D/s)²;
/// quadrature is better for a panel that hardly turns.
///
/// @param motion   Motion of the body relative to the water; ω·n must not be zero.
/// @param law      Continuous pieces, 1 to 3 of them, by ascending speed; the first starts at 0.
Wrench rotary_drag(const Panel& panel, const Eigen::Vector3d& normal, const Twist& motion,
                   std::span<const DragPiece> law);

}  // namespace hydro

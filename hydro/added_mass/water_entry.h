#pragma once

#include "hydro/added_mass/surface_patches.h"

/// @file
/// The water that rises beside a body that enters it.
///
/// A bottom that meets the surface at a small angle pushes water aside and up along itself. It is
/// wetted to where it would be under a surface that is higher by C h, h its draught [Wag32]. Where
/// the area of its waterplane grows as S ~ h^g, half-breadths grow as h^(1/m) with m = (1 + e)/g,
/// and
///
///     C₀ = √π Γ(m/2 + 1)/Γ((m + 1)/2) − 1         for a long body, e = 0,
///     C₀ = (2/√π) Γ((m + 3)/2)/Γ(m/2 + 1) − 1     for a round one, e = 1;                    (1)
///
/// so a wedge has π/2 − 1, a cylinder 1, a cone 4/π − 1 and a sphere ½. e is here the square of
/// 4π S/P², P the perimeter of the waterplane, and C₀ is taken between the two. With V the wetted
/// volume and c the half-breadth of the waterplane, g is taken as S h/V − 1. Sides that are steeper
/// than a parabola, m > 2, push the less water up the nearer they are to walls. With the deadrise
/// β = atan(h/c),
///
///     C = C₀ min(1, 2/m) (1 − β/75°),                                                        (2)
///
/// fitted to the similarity solutions of wedges of 10° and 30° [ZF93]. Nothing rises at a body that
/// rests, or that leaves the water.
///
/// [Wag32] Wagner. Über Stoß- und Gleitvorgänge an der Oberfläche von Flüssigkeiten. ZAMM 12
/// (1932). [ZF93]  Zhao, Faltinsen. Water entry of two-dimensional bodies. J. Fluid Mech. 246
/// (1993).

namespace hydro {

/// What a plane of water cuts off a body.
struct Waterplane {
  double draught = 0;    ///< Height of the plane above the lowest point [m].
  double volume = 0;     ///< Wetted [m^3].
  double area = 0;       ///< S [m^2]
  double perimeter = 0;  ///< P, with the outlines of holes [m].

  /// S²/P, which added mass near the surface is in proportion to, as that of a flat plate of the
  /// waterplane's shape [m^3].
  double plate() const { return perimeter > 0 ? area * area / perimeter : 0; }
};

/// @param mesh_B   Closed.
Waterplane waterplane(const TriMesh& mesh_B, const WaterPlane& plane);

/// C of (2) [-]; zero for a body that is not cut.
double rise_at_entry(const Waterplane& cut);

}  // namespace hydro

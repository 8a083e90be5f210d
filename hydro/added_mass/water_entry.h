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
/// 4π S/P², P the perimeter of the waterplane, or that of (5), and C₀ is taken between the two.
/// With V the wetted volume and c = (1 + e) S/P the half-breadth of the waterplane, or that of (5),
/// g is taken as S h/V − 1. Sides that are steeper than a parabola, m > 2, push the less water up
/// the nearer they are to walls. With the deadrise β = atan(h/c),
///
///     C = C₀ min(1, 2/m) (1 − β/75°),                                                        (2)
///
/// fitted to the similarity solutions of wedges of 10° and 30° [ZF93]. Nothing rises at a body that
/// rests, or that leaves the water.
///
/// Under the surface that has risen, the added mass along the vertical is near that of a flat plate
/// of the waterplane's shape on one side, less by the deadrise of a bottom that is not flat,
///
///     a = a_0 (1 − min(1, 2/m) atan(min(m, 2) h/c)/185°),                                   (3)
///
/// an angle that is fitted to solutions of surface_solve.h for wedges and spheres. With the radii
/// of gyration of the waterplane r_1 ≥ r_2, q = r_2/r_1, and P its perimeter,
///
///     a_0 = ρ min(4/3 S r_2/(1 + (π/2 − 1) q^{3/2}), 5/4 S²/P).                             (4)
///
/// The first is exact for ellipses to 1 %, 8 % too large for a square and 2 % too small for a
/// strip. It grows with every part that a waterplane gains, while S²/P falls at first: a small
/// second piece has an outline before it has an area. As a body sinks A should not fall, since what
/// (E4) of the engine loses by that is not given back. But of waterplanes that lie apart, as those
/// of a catamaran, the first sees one that fills their gap. S²/P adds up over like ones; it is 1.18
/// of what an ellipse has and 1.27 of what a strip has, so they get half as much again as their own
/// at most. With them
///
///     e = q,      c = (√3 + (2 − √3) q) r_2 · a_0/(4/3 S r_2/(…)).                          (5)
///
/// A draught that does not depend on one low corner follows from the moments of the wetted part:
/// with S ~ h^g all the way up and ∫ d dV the integral of the depth,
///
///     r = S ∫ d dV / V²,      g = r/(1 − r) − 1,      h = (g + 1) V/S.                       (6)
///
/// [Wag32] Wagner. Über Stoß- und Gleitvorgänge an der Oberfläche von Flüssigkeiten. ZAMM 12
/// (1932). [ZF93]  Zhao, Faltinsen. Water entry of two-dimensional bodies. J. Fluid Mech. 246
/// (1993).

namespace hydro {

/// The part of a body that a plane of water cuts off.
struct SurfaceCut {
  double draught = 0;       ///< Height of the plane above the lowest point, or that of (6) [m].
  double volume = 0;        ///< Wetted [m^3].
  double area = 0;          ///< S [m^2]
  double perimeter = 0;     ///< P, with the outlines of holes [m].
  double round = 0;         ///< e: 0 long, 1 round [-].
  double half_breadth = 0;  ///< c [m]
  /// Measure of the added mass on one side of a flat plate of the waterplane's shape in motion
  /// along its normal, for ρ = 1 [m^3]: S²/P, or (4).
  double plate = 0;
};

/// @param mesh_B   Closed.
SurfaceCut surface_cut(const TriMesh& mesh_B, const WaterPlane& plane);

/// C of (2) [-]; zero for a body that is not cut.
double rise_at_entry(const SurfaceCut& cut);

/// a of (3) for ρ = 1 [m^3].
/// @param risen   The cut by the water that has risen.
double heave_at_entry(const SurfaceCut& risen);

}  // namespace hydro

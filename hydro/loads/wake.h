#pragma once

#include "hydro/mesh/mesh.h"
#include "hydro/spatial.h"

/// @file
/// How much of a body's wake is formed.
///
/// The coefficients of pressure drag are those of steady motion, with a wake behind the body. A
/// body that starts, or that moves to and fro by less than its own size, has left no such wake yet:
/// water flows about its round parts without separating, and its edges shed a vortex in every
/// stroke (edge_drag.h). The two differ in how far the body has lately gone through the water, a
/// distance that is forgotten as it goes on,
///
///     d' = u − (|u|/ℓ) d,          |u|² = u·Q u = (1/S) ∫ |v + ω × r|² dS                      (1)
///
/// for the six components of its motion u relative to the water: a displacement and a turn, with
/// the size |d| <= ℓ. In steady motion |d| grows as ℓ (1 − e^(−s/ℓ)) with the way s. In a swing of
/// the amplitude a it stays below a and is small where the body is fast. The part
///
///     f = (|d|/ℓ)⁴                                                                             (2)
///
/// of the wake is formed: 0.43, 0.87 and 0.97 on a straight way of one, two and three times the
/// size of the body from rest, and 1 in steady motion. In swings of a Keulegan–Carpenter number of
/// 3, 10 and 20 pressure drag takes 0.03, 0.50 and 0.82 of the power that it would take at f = 1.
/// The drag of panels is multiplied by f, that of edges by 1 − f.

namespace hydro {

/// ℓ over the size of the body [-]. Larger: a body that starts from rest meets its steady drag
/// later than an impulsively started cylinder, two to four diameters. Smaller: a sphere that is let
/// go from a radius above its rest is slowed by drag that experiments do not show.
inline constexpr double kWakeLength = 0.6;

/// The constants of (1) of a body.
struct WakeScale {
  Matrix6d square = Matrix6d::Zero();  ///< Q in body axes about the centre of mass.
  double length = 0;  ///< ℓ: by the middle one of the sides of the mesh's box [m].
};

WakeScale wake_scale(const TriMesh& mesh_B);

/// d of (1) after a time [s] of the motion u, both in W. It is exact where u is constant.
Vector6d advanced_wake(const WakeScale& scale, const Eigen::Matrix3d& R_WB, const Vector6d& d,
                       const Vector6d& u, double time);

/// d of a body that has long moved as it does: u of the size ℓ. Zero at rest.
Vector6d steady_wake(const WakeScale& scale, const Eigen::Matrix3d& R_WB, const Vector6d& u);

/// f of (2), from 0 to 1: exactly 1 in steady motion.
double formed_wake(const WakeScale& scale, const Eigen::Matrix3d& R_WB, const Vector6d& d);

}  // namespace hydro

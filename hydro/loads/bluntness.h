#pragma once

#include <Eigen/Core>

#include "hydro/mesh/mesh.h"

/// @file
/// How blunt a mesh is along its axes, and the pressure drag that slender bodies are spared.
///
/// A slender body pushes the water aside and lets it close again behind, which keeps most of the
/// pressure in front from being drag. Panels do not know of each other; they lack one number for
/// each axis e_i of the mesh, an eigenvector of ∫ n nᵀ dS: its bluntness
///
///     w_i = ∫ |n·e_i|³ dS / ∫ |n·e_i| dS,                                                     (1)
///
/// the mean of cos² of the angle to the axis over the projected area. It is 1 for a flat face, 2/3
/// for a cylinder across, 1/2 for a sphere and 0.05 for an ellipsoid eight times as long as thick.
/// Pressure drag sees the velocity K v_0 in place of the velocity v_0 of the centre of mass
/// relative to the water, and its force is multiplied by K:
///
///     u = n·(K v_0 + ω × r),     K = Σ_i k_i e_i e_iᵀ,
///     k_i = min(1, w_i / blunt, max(f_i / blunt, ∛p_i)),                                      (2)
///     F = −½ρ K ∫ C_p u|u| n dS,     M = −½ρ ∫ C_p u|u| r × n dS.                             (3)
///
/// A round end in front does no harm where the flow closes behind, as at a tanker: f_i is the
/// bluntness by (1) of the finer one of the two ends. p_i is the greater one of the parts of their
/// projected areas that face the axis within 13° of it, as a transom or the base of a cone does,
/// behind or before which the flow does not close: k_i³, which drag along e_i goes with, is no less
/// than that part. Which end goes ahead does not matter.
///
/// So it takes the power F·v_0 + M·ω = −½ρ ∫ C_p |u|³ dS <= 0 in every motion, and straight motion
/// along e_i meets k_i³ of the drag that it would meet with K = 1. Under waves v_0 − u_water(x)
/// takes the place of v_0.

namespace hydro {

/// The axes of a mesh, orthonormal columns, and its bluntness along each, from 0 to 1 [-].
struct Bluntness {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d along = Eigen::Vector3d::Ones();      ///< w_i of (1).
  Eigen::Vector3d finer_end = Eigen::Vector3d::Ones();  ///< f_i
  Eigen::Vector3d flat = Eigen::Vector3d::Ones();       ///< p_i
};

/// The bluntness by (1). Among axes on which the mesh does not decide, those of the mesh's own
/// frame are taken. A mesh without area counts as blunt.
Bluntness bluntness(const TriMesh& mesh);

/// K of (2) in the axes of the mesh. It is exactly the unit matrix where every k_i is 1.
/// @param blunt   The bluntness from which on k_i = 1; 0 gives K = 1 [-].
Eigen::Matrix3d drag_shape(const Bluntness& bluntness, double blunt);

}  // namespace hydro

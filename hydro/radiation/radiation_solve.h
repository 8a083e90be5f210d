#pragma once

#include "hydro/mesh/mesh.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// Radiation and diffraction of a body at rest in water of constant depth, by boundary elements on
/// its mesh.
///
/// With N = (n, r × n) and G of green_function.h, in water of finite depth of finite_depth_green.h,
/// the potentials ψ_m of the six motions, which send their waves outward, solve on the wetted
/// surface S_w
///
///     ½ψ(x) − (1/4π) ∫_{S_w} ψ n·∇G dS = (1/4π) ∫_{S_w} N G dS,                             (1)
///     ∫_{S_w} ψ_m N_n dS = A_mn + i B_mn/ω,                                                  (2)
///
/// for ρ = 1, with ∇ acting on the point y of the surface. By Haskind's relation they give the
/// diffraction, too: with p₀ and u̇₀ those of the undisturbed wave of amplitude 1,
///
///     X_FK = −∫_{S_w} p₀ N dS,        X_D = ∫_{S_w} ψ (u̇₀·n) dS,                             (3)
///     B_mn = (k / 8π g c_g) ∫₀^{2π} X_m X_n* dβ,                                             (4)
///
/// where k is the wave number and c_g the group velocity, g/2ω in deep water.
///
/// ψ is linear on each of some 250 patches, and (1) holds on each patch in the mean
/// (surface_solve.h); 1/r, 1/r', the 2/r' in ∂(k𝒢)/∂z and the image 1/r'' in the bottom are
/// integrated in closed form, and the smooth rest by its values at three nodes a patch. At the
/// frequencies of sloshing inside the hull (1) has no unique solution. From the lowest such
/// frequency on the equation without ½ψ is asked for at some points of the waterplane inside the
/// hull, and all are met in the least squares.
///
/// Terms that the mirror symmetries of a hull in the vertical planes of H forbid are removed.
///
/// The damping is that of (4), which has no negative eigenvalues; `mismatch` tells how far (2) is
/// from it.

namespace hydro {

/// Options of solve_radiation().
struct RadiationOptions {
  std::vector<double> frequencies;  ///< Ascending, > 0 [rad/s]; none: `radiation_frequencies`.
  int headings = 0;   ///< Number of headings, evenly spaced; even; 0: `radiation_headings`.
  int patches = 250;  ///< About so many patches.
};

/// The data of a body, and how good they are.
struct RadiationSolution {
  RadiationData data;  ///< In the frame H, for ρ = 1.
  int unknowns = 0;    ///< Number of unknowns.
  /// Largest |B_mn| of (2) less (4), over the largest B of its kind; moments have the root of the
  /// wetted area as their lever [-].
  double mismatch = 0;
};

/// A mesh in the frame H of a mean pose.
TriMesh in_frame_H(const TriMesh& mesh_B, const MeanPose& pose);

/// Sixteen frequencies, evenly spaced in their logarithm: from waves of 126 times the body's
/// half-length, or its draught if that is larger, to waves of 1.26 times its half-breadth. In
/// longer waves B is small, and A and X_D/k are near their limits; shorter waves are reflected as
/// by a wall, and A is near A∞. Pitch and waves along a hull have the scale of its length, roll and
/// heave that of its breadth: the range has both. It ends earlier, at waves of 3.9 patches, where
/// patches of a slender hull resolve no shorter ones.
std::vector<double> radiation_frequencies(const TriMesh& mesh_B, const MeanPose& pose,
                                          const LinearWater& water,
                                          int patches = RadiationOptions().patches);

/// Number of headings, at least 36, with which (4) is exact for the interference of waves from both
/// ends of a hull at all frequencies: over the heading it has harmonics up to the product of wave
/// number and length.
int radiation_headings(const TriMesh& mesh_B, const MeanPose& pose, const LinearWater& water,
                       double highest_frequency);

/// Headings from 0 on [rad], a circle divided evenly.
std::vector<double> evenly_spaced_headings(int count);

/// Solves for the waves that a body makes and scatters.
/// @param mesh_B   Closed; its origin is the centre of mass.
/// @throws std::invalid_argument if the body is dry in the pose or reaches the bottom.
RadiationSolution solve_radiation(const TriMesh& mesh_B, const MeanPose& pose,
                                  const LinearWater& water, const RadiationOptions& options = {});

}  // namespace hydro

#pragma once

#include "hydro/added_mass/surface_patches.h"

/// @file
/// Integrals of 1/r over the patches of a wetted hull: closed forms where near, moments where far.

namespace hydro {

/// Moments of a patch for its effect on distant points.
struct PatchMoments {
  Eigen::Matrix3d area;                      ///< ∫ f_k n dS, one column per function k [m^2].
  std::array<Eigen::Matrix3d, 3> lever;      ///< ∫ f_k n (y − centre)ᵀ dS [m^3].
  MotionRow source;                          ///< ∫ N dS.
  Eigen::Matrix<double, 3, 6> source_lever;  ///< ∫ (y − centre) N dS.
  Eigen::Matrix<double, 3, 6> load;          ///< ∫ f_k N dS, one row per function.
};

/// N at a point of a surface with the unit normal there.
MotionRow motions(const Eigen::Vector3d& at, const Eigen::Vector3d& normal);

PatchMoments moments_of(const Patch& patch);

/// Integrals over a patch, seen from x, with r = |y − x|.
struct Seen {
  Eigen::Vector3d twofold = Eigen::Vector3d::Zero();  ///< ∫ f_k n·(y − x)/r³ dS
  MotionRow single = MotionRow::Zero();               ///< ∫ N/r dS
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();  ///< ∫ f_k n/r dS, one column per function k.
};

/// Adds the integrals over a patch times a factor. @param m   Moments of the patch.
void add_seen(const Patch& patch, const PatchMoments& m, const Eigen::Vector3d& x, double factor,
              Seen& seen);

}  // namespace hydro

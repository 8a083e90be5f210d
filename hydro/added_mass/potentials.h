#pragma once

#include <vector>

#include "hydro/added_mass/added_mass.h"
#include "hydro/loads/kernel/panels.h"
#include "hydro/loads/kernel/tree.h"

/// @file
/// The potentials of a body's added mass as the kernel reads them: six functions ψ_m that are
/// linear on each face, and their integrals ∫ ψ_m N_n dS over the branches of a hull's tree, N =
/// (n, r × n).

namespace hydro::kernel {

/// Rows of a face's potentials: with ψ = ψ_c + ψ_x x + ψ_y y in the plane coordinates of the face
/// (panels.h), these are ψ_c, ψ_x and ψ_y of each of the six.
inline constexpr int kPotentialRows = 18;

/// Potentials of the faces of a FaceBlock.
struct alignas(64) PotentialBlock {
  double row[kPotentialRows][kMostLanes] = {};
};

/// The potentials on a hull.
struct Potentials {
  std::vector<PotentialBlock> blocks;  ///< In the order of the leaves' blocks.
  std::vector<Matrix6d> shares;        ///< ∫ ψ_m N_n dS over each node of the tree.
  double largest = 0;  ///< Largest magnitude of the potentials of the three translations [m].
};

/// Lays out potentials for a hull's panels.
/// @param corners   Corner potentials of each face of the mesh.
Potentials make_potentials(const TriMesh& mesh_B, const Panels& panels, const Tree& tree,
                           const std::vector<CornerPotentials>& corners);

}  // namespace hydro::kernel

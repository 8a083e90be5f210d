#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "hydro/added_mass/added_mass_model.h"
#include "hydro/added_mass/attitude_grid.h"
#include "hydro/added_mass/surface_solve.h"

/// @file
/// Added mass with a free surface (surface_solve.h) for any pose, from a grid of solutions.
///
/// The matrix in body axes depends on the vertical's direction in the body and on the draught, not
/// on heading. A node of the grid is solved when a pose near it is first met and kept; between
/// nodes the matrix is interpolated linearly, which keeps it without negative eigenvalues.
///
/// The draught of a body that pierces the surface is the wetted part v of its volume, for attitudes
/// that displace the same are most alike. Nodes stand at v = 1 − (1 − x²)³ for even steps of x:
/// matrices change fastest as the first or the last corner goes under. A wholly submerged body has
/// s = (R/(R + d))³ with its radius R and the depth d of its highest point, for the image's effect
/// fades with the third power of the depth, and nodes at 1 − s = x². The last is the body in
/// unbounded fluid.
///
/// In waves the surface is the level plane at the water's height above the body's centre.

namespace hydro {

/// A solved node. The pair of numbers is its place in the grid, whatever body is asked about.
struct SurfaceNode {
  int attitude = 0;
  int draught = 0;
  Matrix6d matrix = Matrix6d::Zero();  ///< For ρ = 1, body axes about the centre of mass.
};

class SurfaceAddedMass final : public AddedMassModel {
 public:
  /// @param mesh_B   Closed; its origin the centre of mass.
  /// @param known    Nodes that a model of the same mesh has solved before.
  /// @param patches  Of each solution, as in solve_under.
  explicit SurfaceAddedMass(TriMesh mesh_B, const std::vector<SurfaceNode>& known = {},
                            int patches = kSurfacePatches);

  Matrix6d at(const BodyState& state, const Sea& sea, double time) const override;

  /// Interpolated, for ρ = 1.
  Matrix6d under(const WaterPlane& plane) const;

  /// All nodes known so far, in the order of the grid.
  std::vector<SurfaceNode> nodes() const;

  /// Nodes solved by this model.
  int solves() const;

 private:
  /// Heights of the lowest and the highest point along a direction [m].
  struct Reach {
    double low, high;
  };
  Reach reach(const Eigen::Vector3d& up) const;
  double draught_of(const WaterPlane& plane) const;
  WaterPlane plane_of(int attitude, int draught) const;
  const Matrix6d& node(int attitude, int draught) const;
  Matrix6d solved(int attitude, int draught) const;

  TriMesh mesh_B_;
  Eigen::Vector3d middle_;  ///< Of the bounding box.
  double volume_ = 0;       ///< [m^3]
  double radius_ = 0;       ///< Of the mesh about `middle_` [m].
  int patches_;
  AttitudeGrid attitudes_;
  mutable std::mutex mutex_;                               ///< Of all below.
  mutable std::map<std::pair<int, int>, Matrix6d> nodes_;  ///< Addresses stay as more come.
  mutable int solves_ = 0;
};

}  // namespace hydro

#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "hydro/added_mass/added_mass_model.h"
#include "hydro/added_mass/attitude_grid.h"
#include "hydro/added_mass/rigid_wave_load.h"
#include "hydro/added_mass/surface_solve.h"

/// @file
/// Added mass with a free surface (surface_solve.h) for any pose, from a grid of solutions.
///
/// The matrix in body axes depends on the vertical's direction in the body and on the draught, not
/// on heading. A node of the grid is solved when a pose near it first occurs, and its solution is
/// kept. Between nodes the matrix is interpolated linearly, so it has no negative eigenvalues.
///
/// The draught of a surface-piercing body is measured by the wetted fraction v of its volume,
/// because attitudes of equal displacement have the most similar matrices. Nodes are at v = 1 − (1
/// − x²)³ for even steps of x: matrices change fastest as the first or the last corner submerges.
/// For a wholly submerged body of radius R with its highest point at the depth d, the measure is s
/// = (R/(R + d))³, because the effect of the image falls with the third power of the depth; nodes
/// are at 1 − s = x². The last node is the body in unbounded fluid.
///
/// A body that enters the water takes its first impact from small draughts, where added mass goes
/// as that of a plate of the waterplane's shape (water_entry.h). So up to the second node, and in
/// part up to the third, it is the ratio to that which is interpolated, and which is constant below
/// the first. A body is taken as under the water that rises as it enters, by C h (1 − 2v)² with the
/// C of water_entry.h: in full at the first touch, and none from half its volume on, as most bodies
/// at rest are.
///
/// In waves the surface is taken as the level plane at the water's height over the centre of mass.

namespace hydro {

/// A solved node with its two indices in the grid, which is the same for all bodies.
struct SurfaceNode {
  int attitude = 0;
  int draught = 0;
  Matrix6d matrix = Matrix6d::Zero();  ///< A for ρ = 1, body axes about the centre of mass.
};

class SurfaceAddedMass final : public AddedMassModel {
 public:
  /// @param mesh_B   Closed; its origin is the centre of mass.
  /// @param known    Nodes that a model of the same mesh has solved before.
  /// @param patches  Number of patches in each solution, see solve_under.
  explicit SurfaceAddedMass(TriMesh mesh_B, const std::vector<SurfaceNode>& known = {},
                            int patches = kSurfacePatches);

  Matrix6d at(const BodyState& state, const Sea& sea, double time) const override;
  /// The load of rigid_wave_load.h.
  Wrench wave_load(const BodyState& state, const Sea& sea, double time) const override;

  /// Interpolated matrix for ρ = 1: that of the body under the risen water.
  Matrix6d under(const WaterPlane& plane) const;

  /// The plane of the water that rises as the body enters it (water_entry.h); the same plane when
  /// half of the body is immersed.
  WaterPlane risen(const WaterPlane& plane) const;

  /// All nodes known so far, in the order of the grid.
  std::vector<SurfaceNode> nodes() const;

  /// Number of nodes solved by this model.
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
  /// SurfaceCut::plate of a node [m^3].
  double plate(int attitude, int draught) const;
  Matrix6d solved(int attitude, int draught) const;

  TriMesh mesh_B_;
  Eigen::Vector3d middle_;  ///< Centre of the bounding box [m].
  double volume_ = 0;       ///< [m^3]
  double radius_ = 0;       ///< Radius of the mesh about `middle_` [m].
  int patches_;
  AttitudeGrid attitudes_;
  RigidWaveLoad waves_;
  mutable std::mutex mutex_;                               ///< Guards the members below.
  mutable std::map<std::pair<int, int>, Matrix6d> nodes_;  ///< Entries never move.
  mutable std::map<std::pair<int, int>, double> plates_;
  mutable int solves_ = 0;
};

}  // namespace hydro

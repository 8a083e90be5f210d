#pragma once

#include <limits>
#include <vector>

#include "hydro/added_mass/bem/element.h"
#include "hydro/spatial.h"

/// @file
/// The wetted part of a hull under a plane of water, as patches on which a potential is sought.
///
/// A patch is a group of neighbouring flat triangles with similar normals. Large triangles of the
/// mesh are split and small ones grouped, so the accuracy and the cost of a solution depend little
/// on the mesh.

namespace hydro {

/// A level surface of water as the body sees it.
struct WaterPlane {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< Unit vertical, in B.
  /// Height of the surface above the origin of B [m]; infinite for a body in unbounded fluid.
  double height = std::numeric_limits<double>::infinity();

  bool bounded() const { return height < std::numeric_limits<double>::infinity(); }
  double depth(const Eigen::Vector3d& point_B) const { return height - up.dot(point_B); }
  Eigen::Vector3d mirrored(const Eigen::Vector3d& point_B) const {
    return point_B + 2 * depth(point_B) * up;
  }
};

/// Normal velocities of the six unit motions at a point of the surface: N = (n, r × n).
using MotionRow = Eigen::Matrix<double, 1, 6>;

/// A point at which a patch's equation is evaluated, and the area that it represents [m^2].
struct PatchPoint {
  Eigen::Vector3d at;
  double weight;
};

/// ψ on a patch is c_0 + c_1 (y − centre)·g_1 + c_2 (y − centre)·g_2.
struct Patch {
  std::vector<bem::Element> panels;
  std::vector<PatchPoint> points;  ///< Points whose weights sum to the area.
  Eigen::Vector3d centre;          ///< Centroid of the area [m].
  double area = 0;                 ///< [m^2]
  double radius = 0;               ///< Largest distance of a corner from the centre [m].
  /// g_1 and g_2, along the patch's longest extents [1/m]; zero for an extent that it lacks.
  std::array<Eigen::Vector3d, 2> slopes;

  /// Values of the three functions at a point.
  Eigen::Vector3d functions(const Eigen::Vector3d& point_B) const {
    const Eigen::Vector3d offset = point_B - centre;
    return {1, slopes[0].dot(offset), slopes[1].dot(offset)};
  }
};

/// Volume of a closed mesh below a plane [m^3]; the whole volume in unbounded fluid.
double wetted_volume(const TriMesh& mesh_B, const WaterPlane& plane);

/// Area of a mesh below a plane [m^2].
double wetted_area(const TriMesh& mesh_B, const WaterPlane& plane);

/// Returns the wetted part of a closed mesh in about `count` patches; empty if the mesh is dry.
std::vector<Patch> wetted_patches(const TriMesh& mesh_B, const WaterPlane& plane, int count);

}  // namespace hydro

#pragma once

#include <Eigen/Core>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// Meshes of the small parts that pictures show. They are closed, with outward normals, but the
/// solids that a mesh is put together of may overlap. Sizes must be positive [m].

namespace render {

/// Sides of a round tube: their normals turn by less than the crease angle of shaded_mesh.h.
inline constexpr int kTubeSides = 10;

/// Returns a tube along points, with a ring of `kTubeSides` vertices about each and flat ends.
/// @param points   At least two; a point at the place of the one before it is left out.
/// @param radii    Per point [m].
/// @param toward   Where the first vertex of the first ring lies, seen from its point; zero: the
/// ring
///     is turned in any way. A line that moves keeps its vertices apart where it is carried along.
hydro::TriMesh tube_mesh(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& radii,
                         const Eigen::Vector3d& toward = Eigen::Vector3d::Zero());

/// The same with one radius.
hydro::TriMesh tube_mesh(const Eigen::Matrix3Xd& points, double radius);

/// Returns the points of a coil spring from `from` to `to`: straight ends, each a tenth of the
/// distance, and `turns` turns between them. The coil has its axis along the distance.
Eigen::Matrix3Xd helix(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                       int turns);

/// The look of a screw propeller.
struct ScrewShape {
  double diameter = 1;      ///< [m]
  int blades = 4;           ///< >= 1
  double area_ratio = 0.7;  ///< Area of the blades over that of the disc [-].
  double pitch_ratio = 1;   ///< Pitch over diameter [-].
  bool right_handed = true;
};

/// Returns a hub with blades about the x axis, its disc at x = 0; it pushes along +x when it turns
/// by the right-hand rule about x, or the other way if it is left-handed.
hydro::TriMesh screw_mesh(const ScrewShape& shape);

/// Returns a wing of rectangular plan and a symmetric section: the span along z, its middle at
/// z = 0, the leading edge toward +x and a quarter of the chord ahead of the z axis.
/// @param thickness   Largest thickness over the chord [-].
hydro::TriMesh wing_mesh(double span, double chord, double thickness);

/// Returns an anchor of the admiralty pattern: the ring at the origin, the shank along −x with the
/// length `size`, the arms up and down in z and the stock along y.
hydro::TriMesh anchor_mesh(double size);

}  // namespace render

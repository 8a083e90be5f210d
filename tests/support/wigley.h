#pragma once

#include "hydro/mesh/mesh.h"
#include "hydro/mesh/primitives.h"

namespace support {

/// Returns a Wigley hull, |y| = B/2 (1 − (2x/L)²)(1 − (z/T)²) for −T <= z <= 0, with vertical sides
/// above up to a deck at z = `freeboard` [m]. The hull is a deformed box with `divisions` along
/// each edge, an even number so that a row of vertices runs along z = 0. Faces of the box that
/// shrink to a line at keel, stem and stern remain, without area.
inline hydro::TriMesh make_wigley(double length, double beam, double draught, double freeboard,
                                  int divisions) {
  hydro::TriMesh mesh = hydro::make_box({2, 2, 2}, divisions);
  for (Eigen::Index i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector3d u = mesh.vertices.col(i);  // each coordinate from −1 to 1
    const double section = u.z() < 0 ? 1 - u.z() * u.z() : 1;
    mesh.vertices.col(i) << length / 2 * u.x(), beam / 2 * u.y() * (1 - u.x() * u.x()) * section,
        u.z() < 0 ? draught * u.z() : freeboard * u.z();
  }
  return mesh;
}

}  // namespace support

#pragma once

#include <algorithm>
#include <cmath>

#include "hydro/mesh/mesh.h"
#include "hydro/mesh/primitives.h"

namespace support {

/// Returns a full tanker, bow along +x, midships at x = 0, keel at z = −`draught`, deck at z =
/// `freeboard` [m]: a parallel middle body with vertical sides between an entrance of 0.3 L, whose
/// sections are full, and a run of 0.45 L, whose sections narrow towards the keel; stem and stern
/// are upright edges. C_B = 0.81 of L, B and T. The hull is a deformed box with `divisions` along
/// each edge, an even number so that a row of vertices runs along z = 0.
inline hydro::TriMesh make_tanker(double length, double beam, double draught, double freeboard,
                                  int divisions) {
  hydro::TriMesh mesh = hydro::make_box({2, 2, 2}, divisions);
  for (Eigen::Index i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector3d u = mesh.vertices.col(i);  // each coordinate from −1 to 1
    const double x = std::sin(M_PI / 2 * u.x());     // closer towards the ends
    const double deep = std::clamp(-u.z(), 0.0, 1.0);
    const double ahead = std::max(0.0, (x - 0.4) / 0.6), behind = std::max(0.0, (-x - 0.1) / 0.9);
    const double entrance = 1 - std::pow(ahead, 4);
    const double run = 1 - std::pow(behind, 3.7 - 1.85 * deep);
    const double bilge = std::sqrt(1 - std::pow(deep, 12));
    const double breadth = std::max(1e-4, entrance * run) * (0.85 + 0.15 * bilge);
    mesh.vertices.col(i) << length / 2 * x, beam / 2 * u.y() * breadth,
        u.z() < 0 ? draught * u.z() : freeboard * u.z();
  }
  return mesh;
}

}  // namespace support

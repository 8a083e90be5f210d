#pragma once

#include <algorithm>
#include <cmath>

#include "hydro/mesh/mesh.h"
#include "hydro/mesh/primitives.h"

namespace support {

/// Returns a hull with its bow along +x, midships at x = 0, keel at z = −`draught` and deck at z =
/// `freeboard` [m]: a deformed box with `divisions` along each edge, an even number so that a row
/// of vertices runs along z = 0. Faces of the box that shrink to a line remain, without area.
/// @param lines   From a point of the box, with coordinates from −1 to 1, to x over L/2 and the
/// half-breadth over B/2.
template <class Lines>
hydro::TriMesh make_hull_of(double length, double beam, double draught, double freeboard,
                            int divisions, const Lines& lines) {
  hydro::TriMesh mesh = hydro::make_box({2, 2, 2}, divisions);
  for (Eigen::Index i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector3d u = mesh.vertices.col(i);
    const Eigen::Vector2d at = lines(u);
    mesh.vertices.col(i) << length / 2 * at.x(), beam / 2 * u.y() * at.y(),
        u.z() < 0 ? draught * u.z() : freeboard * u.z();
  }
  return mesh;
}

/// Returns a Wigley hull, |y| = B/2 (1 − (2x/L)²)(1 − (z/T)²) for −T <= z <= 0, with vertical sides
/// above.
inline hydro::TriMesh make_wigley(double length, double beam, double draught, double freeboard,
                                  int divisions) {
  return make_hull_of(length, beam, draught, freeboard, divisions,
                      [](const Eigen::Vector3d& u) -> Eigen::Vector2d {
                        const double section = u.z() < 0 ? 1 - u.z() * u.z() : 1;
                        return {u.x(), (1 - u.x() * u.x()) * section};
                      });
}

/// Returns a full tanker: a parallel middle body with vertical sides between an entrance of 0.3 L,
/// whose sections are full, and a run of 0.45 L, whose sections narrow towards the keel; stem and
/// stern are upright edges. C_B = 0.81 of L, B and T.
inline hydro::TriMesh make_tanker(double length, double beam, double draught, double freeboard,
                                  int divisions) {
  return make_hull_of(length, beam, draught, freeboard, divisions,
                      [](const Eigen::Vector3d& u) -> Eigen::Vector2d {
                        const double x = std::sin(M_PI / 2 * u.x());  // closer towards the ends
                        const double deep = std::clamp(-u.z(), 0.0, 1.0);
                        const double ahead = std::max(0.0, (x - 0.4) / 0.6),
                                     behind = std::max(0.0, (-x - 0.1) / 0.9);
                        const double entrance = 1 - std::pow(ahead, 4);
                        const double run = 1 - std::pow(behind, 3.7 - 1.85 * deep);
                        const double bilge = std::sqrt(1 - std::pow(deep, 12));
                        return {x, std::max(1e-4, entrance * run) * (0.85 + 0.15 * bilge)};
                      });
}

}  // namespace support

#include "hydro/water/moving_surface.h"

#include <algorithm>

#include "hydro/airy_waves.h"
#include "hydro/loads/clip.h"
#include "hydro/loads/refine.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// The sea about a body, linear in place.
struct LocalSea {
  double elevation;  ///< Height of the surface in W, at the body's centre [m].
  Vector2d slope;
  Vector3d velocity;      ///< Velocity of the water at the body's centre [m/s].
  Eigen::Matrix3d shear;  ///< Its change along x, y and z, in columns [1/s].
};

LocalSea local_sea(const Vector3d& c, double radius, const Sea& sea, double time) {
  const double d = radius / 2;
  const auto surface = [&](double x, double y) { return surface_height(sea, x, y, time); };
  const auto water = [&](const Vector3d& p) { return water_at(sea, p, time).velocity; };
  LocalSea local{.elevation = surface(c.x(), c.y()),
                 .slope = {(surface(c.x() + d, c.y()) - surface(c.x() - d, c.y())) / (2 * d),
                           (surface(c.x(), c.y() + d) - surface(c.x(), c.y() - d)) / (2 * d)},
                 .velocity = water(c),
                 .shear = {}};
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d step = d * Vector3d::Unit(axis);
    local.shear.col(axis) = (water(c + step) - water(c - step)) / (2 * d);
  }
  return local;
}

/// Hands on the sources of wet pieces, in W axes about the centre of mass, halved to a cell's size.
struct PieceSources {
  const BodyState& state;
  const LocalSea& local;
  double cell;
  const std::function<void(const WaterSource&)>& take;

  void add(const Panel& panel) const {
    const PanelSplit split = longest_split(panel, [&](const Vector3d& a, const Vector3d& b) {
      return (b - a).squaredNorm() > cell * cell ? 0.5 : 0.0;
    });
    if (split.edge >= 0) {
      const Vector3d &a = panel[split.edge], &b = panel[(split.edge + 1) % 3],
                     &c = panel[(split.edge + 2) % 3];
      const Vector3d middle = (a + b) / 2;
      add({a, middle, c});
      add({middle, b, c});
      return;
    }
    const Vector3d r = (panel[0] + panel[1] + panel[2]) / 3;
    const Vector3d velocity =
        state.linear_velocity + state.angular_velocity.cross(r) - local.velocity - local.shear * r;
    const double surface = local.elevation + local.slope.dot(r.head<2>());
    take({.place = (state.position + r).head<2>(),
          .height = std::min(0.0, state.position.z() + r.z() - surface),
          .rate = velocity.dot(area_vector(panel))});
  }
};

}  // namespace

void find_sources(const TriMesh& mesh_B, double radius, const BodyState& state, const Sea& sea,
                  double time, double cell, double deepest,
                  const std::function<void(const WaterSource&)>& take) {
  const LocalSea local = local_sea(state.position, radius, sea, time);
  const double above = state.position.z() - local.elevation;
  if (above > radius * (1 + local.slope.norm()) || -above > deepest) return;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const PieceSources pieces{.state = state, .local = local, .cell = cell, .take = take};
  for (Index face = 0; face < mesh_B.face_count(); ++face) {
    Panel panel = panel_of(mesh_B, face);
    Vector3d depth;
    for (int i = 0; i < 3; ++i) {
      panel[i] = R_WB * panel[i];
      depth[i] = local.slope.dot(panel[i].head<2>()) - above - panel[i].z();
    }
    if (depth.maxCoeff() <= 0) continue;
    if (depth.minCoeff() >= 0)
      pieces.add(panel);
    else
      for (const PanelPart& part : positive_part(panel, depth)) pieces.add(part.panel);
  }
}

}  // namespace hydro

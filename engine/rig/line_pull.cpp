#include "engine/rig/line_pull.h"

#include <algorithm>
#include <cmath>

#include "hydro/airy_waves.h"

namespace engine {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The load of the water on the line, lumped at the fairlead.
void add_drag(const LineSpec& line, double length, const LineEnd& fairlead, const Vector3d& along,
              const hydro::Sea& sea, double time, LinePull& pull) {
  const Vector3d water = hydro::water_at(sea, fairlead.place_W, time).velocity;
  Vector3d across = water - fairlead.velocity_W;
  across -= along.dot(across) * along;
  const double suspended = std::max(0.0, length - pull.catenary->resting);
  const double factor =
      sea.density * line.drag_coefficient * line.drag_diameter * suspended / 4 * across.norm();
  pull.force_W += factor * across;
  pull.damping += factor * (Matrix3d::Identity() - along * along.transpose());
}

LinePull pull_of_mooring(const LineSpec& line, double length, const LineEnd& fairlead,
                         const LineEnd& anchor, const hydro::Sea* sea, double time,
                         const std::optional<Eigen::Vector2d>& start) {
  const CatenaryPlane plane = catenary_plane(fairlead.place_W, anchor.place_W);
  LinePull pull;
  pull.catenary = hydro::solve_catenary(catenary_line(line, length), plane.span, plane.height,
                                        line.on_bottom, start);
  const hydro::CatenarySolution& c = *pull.catenary;
  const Vector3d &e = plane.towards_W, z = Vector3d::UnitZ();
  const Vector3d side = z.cross(e);
  pull.tension = c.tension();
  pull.force_W = c.horizontal * e - c.vertical * z;
  const Eigen::Matrix2d& K = c.stiffness;
  const double sideways = plane.span > 1e-9 * length ? c.horizontal / plane.span : K(0, 0);
  pull.stiffness = K(0, 0) * e * e.transpose() + K(1, 1) * z * z.transpose() -
                   K(0, 1) * (e * z.transpose() + z * e.transpose()) +
                   sideways * side * side.transpose();
  const Vector3d path = anchor.place_W - fairlead.place_W;
  pull.distance = path.norm();
  if (sea && line.drag_diameter > 0 && pull.distance > 0)
    add_drag(line, length, fairlead, path / pull.distance, *sea, time, pull);
  return pull;
}

}  // namespace

LineEnd line_end(const AttachmentPoint& point, const std::vector<hydro::BodyState>& states) {
  if (point.body == kWorld) return {.place_W = point.at};
  const hydro::BodyState& state = states[static_cast<std::size_t>(point.body)];
  const Vector3d r = state.orientation * point.at;
  return {.place_W = state.position + r,
          .velocity_W = state.linear_velocity + state.angular_velocity.cross(r)};
}

CatenaryPlane catenary_plane(const Vector3d& fairlead_W, const Vector3d& anchor_W) {
  const Vector3d path = anchor_W - fairlead_W;
  CatenaryPlane plane{.span = path.head<2>().norm(), .height = -path.z()};
  if (plane.span > 0) plane.towards_W = Vector3d(path.x(), path.y(), 0) / plane.span;
  return plane;
}

hydro::CatenaryLine catenary_line(const LineSpec& line, double length) {
  return {.length = length,
          .weight = line.weight,
          .stiffness = line.stiffness,
          .friction = line.friction};
}

LinePull pull_of(const LineSpec& line, const LineLength& length, const LineEnd& first,
                 const LineEnd& second, const hydro::Sea* sea, double time,
                 const std::optional<Eigen::Vector2d>& start) {
  if (line.kind == LineSpec::Kind::mooring)
    return pull_of_mooring(line, length.length, first, second, sea, time, start);
  LinePull pull;
  const Vector3d path = second.place_W - first.place_W;
  pull.distance = path.norm();
  const double stretch = pull.distance - length.length;
  const bool slack = line.kind == LineSpec::Kind::rope && stretch <= 0;
  if (slack || pull.distance == 0) return pull;
  const Vector3d n = path / pull.distance;
  const double opening = n.dot(second.velocity_W - first.velocity_W) - length.rate;
  pull.tension = line.stiffness * stretch + line.damping * opening;
  if (line.kind == LineSpec::Kind::rope && pull.tension <= 0) return {.distance = pull.distance};
  pull.force_W = pull.tension * n;
  const Matrix3d along = n * n.transpose();
  pull.damping = line.damping * along;
  pull.stiffness = line.stiffness * along;
  if (pull.tension > 0)
    pull.stiffness += pull.tension / pull.distance * (Matrix3d::Identity() - along);
  return pull;
}

}  // namespace engine

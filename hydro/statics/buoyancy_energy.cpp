#include "hydro/statics/buoyancy_energy.h"

#include "hydro/loads/clip.h"
#include "hydro/loads/refine.h"

namespace hydro {
namespace {

/// ∫ d² n dS over a panel with the depths d of its vertices [m^4].
Eigen::Vector3d square_depth(const Panel& panel, const Eigen::Vector3d& d) {
  const double squares = d.squaredNorm() + d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  return squares / 6 * area_vector(panel);
}

Eigen::Vector3d heights(const Panel& panel) { return {panel[0].z(), panel[1].z(), panel[2].z()}; }

/// depth_moment() under a surface that may not be level.
double depth_moment(const Hull& hull, const Eigen::Matrix3d& R_WB, double level,
                    const SurfaceSampler& surface) {
  const Eigen::Matrix3Xd r = R_WB * hull.mesh_B.vertices;
  double integral = 0;
  for (const auto& face : hull.mesh_B.faces.colwise()) {
    const Panel panel = {r.col(face[0]), r.col(face[1]), r.col(face[2])};
    const Eigen::Vector3d elevation(surface.elevation(panel[0]), surface.elevation(panel[1]),
                                    surface.elevation(panel[2]));
    for_each_linear_piece(panel, elevation, surface,
                          [&](const Panel& piece, const Eigen::Vector3d& above) {
                            const Eigen::Vector3d depths = (above - heights(piece)).array() + level;
                            for (const PanelPart& wet : positive_part(piece, depths))
                              integral += square_depth(wet.panel, wet.value).z();
                          });
  }
  return integral / 2;
}

}  // namespace

double depth_moment(const Hull& hull, const Eigen::Matrix3d& R_WB, double level) {
  // In body axes, in which no panel has to be turned.
  const Eigen::RowVector3d up_B = R_WB.row(2);
  const Eigen::RowVectorXd depth = level - (up_B * hull.mesh_B.vertices).array();
  double integral = 0;
  for (const auto& face : hull.mesh_B.faces.colwise()) {
    const Eigen::Vector3d depths(depth[face[0]], depth[face[1]], depth[face[2]]);
    const Panel panel = {hull.mesh_B.vertices.col(face[0]), hull.mesh_B.vertices.col(face[1]),
                         hull.mesh_B.vertices.col(face[2])};
    for (const PanelPart& wet : positive_part(panel, depths))
      integral += up_B.dot(square_depth(wet.panel, wet.value));
  }
  return integral / 2;
}

double buoyancy_energy(const Hull& hull, const BodyState& state, const Sea& sea) {
  const bool level = is_flat(sea) || changes_with_time(sea);
  const double highest = level ? sea.level : surface_bounds(sea).highest;
  if (state.position.z() - hull.radius >= highest) return 0;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const double above = sea.level - state.position.z();
  const double weight = -sea.density * sea.gravity;
  if (level) return weight * depth_moment(hull, R_WB, above);
  const SurfaceSampler surface(sea, state.position, 0, kSmallestPanel * hull.radius,
                               SplitFor::surface);
  return weight * depth_moment(hull, R_WB, above, surface);
}

double energy_error_per_volume(const Sea& sea) {
  const auto* field = std::get_if<HeightField>(&sea.surface);
  return field ? sea.density * sea.gravity * kSagTolerance * field->deviation : 0;
}

}  // namespace hydro

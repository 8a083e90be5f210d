#include "hydro/statics/buoyancy_energy.h"

#include "hydro/loads/clip.h"
#include "hydro/loads/refine.h"

namespace hydro {
namespace {

/// ∫ d² n_z dS over the part of a panel that is under water, with the depths of its vertices [m^4].
double square_depth(const Panel& panel, const Eigen::Vector3d& depths) {
  double integral = 0;
  for (const PanelPart& wet : positive_part(panel, depths)) {
    const Eigen::Vector3d& d = wet.value;
    const double squares = d.squaredNorm() + d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    integral += area_vector(wet.panel).z() * squares / 6;
  }
  return integral;
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
                            integral += square_depth(piece, depths);
                          });
  }
  return integral / 2;
}

}  // namespace

double depth_moment(const Hull& hull, const Eigen::Matrix3d& R_WB, double level) {
  const Eigen::Matrix3Xd r = R_WB * hull.mesh_B.vertices;
  double integral = 0;
  for (const auto& face : hull.mesh_B.faces.colwise()) {
    const Panel panel = {r.col(face[0]), r.col(face[1]), r.col(face[2])};
    integral += square_depth(panel, level - heights(panel).array());
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

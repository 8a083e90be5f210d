#include "hydro/statics/buoyancy_energy.h"

#include "hydro/loads/clip.h"

namespace hydro {

double depth_moment(const Hull& hull, const Eigen::Matrix3d& R_WB, double level) {
  const Eigen::Matrix3Xd r = R_WB * hull.mesh_B.vertices;
  double integral = 0;  // ∫ d² n_z dS
  for (const auto& face : hull.mesh_B.faces.colwise()) {
    const Panel panel = {r.col(face[0]), r.col(face[1]), r.col(face[2])};
    const Eigen::Vector3d depths = Eigen::Vector3d::Constant(level) -
                                   Eigen::Vector3d(panel[0].z(), panel[1].z(), panel[2].z());
    for (const PanelPart& wet : positive_part(panel, depths)) {
      const Eigen::Vector3d& d = wet.value;
      const double squares = d.squaredNorm() + d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
      integral += area_vector(wet.panel).z() * squares / 6;
    }
  }
  return integral / 2;
}

double buoyancy_energy(const Hull& hull, const BodyState& state, const Sea& sea) {
  const double depth_of_centre = sea.level - state.position.z();
  if (depth_of_centre <= -hull.radius) return 0;
  return -sea.density * sea.gravity *
         depth_moment(hull, state.orientation.toRotationMatrix(), depth_of_centre);
}

}  // namespace hydro

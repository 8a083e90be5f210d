#pragma once

#include <vector>

#include "hydro/added_mass/surface_patches.h"
#include "tests/support/random_pose.h"

namespace support {

/// Returns a water plane normal to `up` at a fraction of the height between a mesh's lowest and
/// highest points along it.
inline hydro::WaterPlane plane_at(const hydro::TriMesh& mesh_B, const Eigen::Vector3d& up,
                                  double part_of_height) {
  const Eigen::RowVectorXd heights = up.transpose() * mesh_B.vertices;
  return {up, heights.minCoeff() + part_of_height * (heights.maxCoeff() - heights.minCoeff())};
}

/// Returns water planes for a mesh in random poses, from dry to deep.
inline std::vector<hydro::WaterPlane> some_planes(const hydro::TriMesh& mesh_B, int count) {
  Random random(6);
  std::vector<hydro::WaterPlane> planes;
  for (int i = 0; i < count; ++i)
    planes.push_back(plane_at(mesh_B, random.vector(1).normalized(), random.uniform(-0.1, 3)));
  return planes;
}

}  // namespace support

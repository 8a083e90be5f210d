#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// Lines and small parts in a picture: ropes, propellers, anchors. They are shaded like the dry
/// surface of a body and seen through the water like it, but show no pressure.

namespace render {

/// A line that is drawn as a round tube. In a picture it is never thinner than can be seen, however
/// far away it is.
struct Tube {
  Eigen::Matrix3Xd points_W;                ///< At least two, in order [m].
  double radius = 0;                        ///< [m]
  Eigen::Vector3d color = {0.5, 0.5, 0.5};  ///< RGB 0 … 1.
};

/// A mesh in a pose.
struct Part {
  std::shared_ptr<const hydro::TriMesh> mesh_P;  ///< It does not change while it is drawn.
  Eigen::Isometry3d X_WP = Eigen::Isometry3d::Identity();
  Eigen::Vector3d color = {0.5, 0.5, 0.5};  ///< RGB 0 … 1.
};

/// All that a picture has of them.
struct Rigging {
  std::vector<Tube> tubes;
  std::vector<Part> parts;

  bool empty() const { return tubes.empty() && parts.empty(); }
};

}  // namespace render

#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <variant>

/// @file
/// The shapes that a scene's bodies may have. Meshes are named, not loaded.

namespace app {

struct MeshScene {
  std::filesystem::path file;  ///< Resolved against the scene's folder.
  double scale = 1;            ///< > 0.
};
struct BoxScene {
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< [m]
  int divisions = 1;                               ///< Along each edge.
};
struct SphereScene {
  double radius = 1;
  int slices = 50;
  int stacks = 50;
};
struct IcosphereScene {
  double radius = 1;
  int subdivisions = 4;
};
struct EllipsoidScene {
  Eigen::Vector3d semi_axes = Eigen::Vector3d::Ones();
  int slices = 50;
  int stacks = 50;
};
struct CylinderScene {
  double radius = 1;
  double height = 2;
  int slices = 48;
  int stacks = 8;
};
using ShapeScene =
    std::variant<MeshScene, BoxScene, SphereScene, IcosphereScene, EllipsoidScene, CylinderScene>;

}  // namespace app

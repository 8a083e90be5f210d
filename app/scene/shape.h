#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <variant>

/// @file
/// The shapes that a scene's bodies may have. Meshes are named, not loaded.

namespace scene {

/// The formats of mesh files that are read: those whose readers are tested with damaged files, or
/// any that assimp reads.
enum class MeshFormats { common, any };

struct Mesh {
  std::filesystem::path file;  ///< Resolved against the scene's folder.
  double scale = 1;            ///< > 0.
};
struct Box {
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< [m]
  int divisions = 1;                               ///< Divisions along each edge.
};
struct Sphere {
  double radius = 1;
  int slices = 50;
  int stacks = 50;
};
struct Icosphere {
  double radius = 1;
  int subdivisions = 4;
};
struct Ellipsoid {
  Eigen::Vector3d semi_axes = Eigen::Vector3d::Ones();
  int slices = 50;
  int stacks = 50;
};
struct Cylinder {
  double radius = 1;
  double height = 2;
  int slices = 48;
  int stacks = 8;
};
using Shape = std::variant<Mesh, Box, Sphere, Icosphere, Ellipsoid, Cylinder>;

}  // namespace scene

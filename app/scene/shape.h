#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// @file
/// The shapes that a scene's bodies may have. Meshes are named, not loaded.

namespace scene {

/// The formats of mesh files that are read: those whose readers are tested with damaged files, or
/// any that assimp reads.
enum class MeshFormats { common, any };

/// The axis of a mesh file that points up.
enum class UpAxis { x, y, z, minus_x, minus_y, minus_z };

/// How the coordinates of a mesh file become those of the mesh frame, whose z points up. Without a
/// value the file's own word holds, or else z and metres.
struct MeshFrame {
  std::optional<UpAxis> up;    ///< Axis of the file that points up.
  std::optional<double> unit;  ///< Length of the file's unit [m].
  double scale = 1;            ///< Factor after the unit, > 0.
  bool operator==(const MeshFrame&) const = default;
};

/// The words of a scene and of the command line for axes.
const std::vector<std::pair<std::string, UpAxis>>& up_axes();
/// The words for units, with their lengths [m].
const std::vector<std::pair<std::string, double>>& length_units();

/// Names an axis by its word.
std::string name_of(UpAxis up);
/// Names a unit of a length [m] by its word, or by its length if it has none: `0.3 m`.
std::string name_of_unit(double unit);

/// How a solid is made of a mesh that is none. Without a value nothing is changed.
struct Mending {
  std::optional<double> weld;       ///< Widest crack that is closed [m].
  bool cap = false;                 ///< Flat open loops are filled.
  std::optional<int> mirror;        ///< Axis normal to the plane in which the mesh is mirrored.
  bool unite = false;               ///< Closed parts that overlap are united.
  std::optional<double> thickness;  ///< Thickness of the plates that open parts become [m].
  bool operator==(const Mending&) const = default;
};

/// The words for axes normal to a plane of symmetry.
const std::vector<std::pair<std::string, int>>& mirror_axes();

/// The mesh of a file.
struct Mesh : MeshFrame {
  std::filesystem::path file;  ///< Resolved against the scene's folder.
  Mending mending;             ///< How a solid is made of it.
  bool operator==(const Mesh&) const = default;
};
/// A box about its centre.
struct Box {
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< [m]
  int divisions = 1;                               ///< Divisions along each edge.
  bool operator==(const Box&) const = default;
};
/// A sphere of slices and stacks. By default the volume is 0.8 % below that of the smooth sphere,
/// and the added mass 0.7 to 1.1 %; 50 by 50 halve that, and take twelve times as long to solve.
struct Sphere {
  double radius = 1;  ///< [m], > 0.
  int slices = 40;    ///< Around the axis.
  int stacks = 24;    ///< Along the axis.
  bool operator==(const Sphere&) const = default;
};
/// A sphere of nearly equal triangles. By default the volume is 0.9 % below that of the smooth
/// sphere, and so is the added mass.
struct Icosphere {
  double radius = 1;     ///< [m], > 0.
  int subdivisions = 3;  ///< Each has four times the triangles.
  bool operator==(const Icosphere&) const = default;
};
/// An ellipsoid of slices and stacks.
struct Ellipsoid {
  Eigen::Vector3d semi_axes = Eigen::Vector3d::Ones();  ///< [m], > 0.
  int slices = 40;                                      ///< Around the z axis.
  int stacks = 24;                                      ///< Along the z axis.
  bool operator==(const Ellipsoid&) const = default;
};
/// A cylinder about its centre, with its axis along z.
struct Cylinder {
  double radius = 1;  ///< [m], > 0.
  double height = 2;  ///< Along the axis [m], > 0.
  int slices = 48;    ///< Around the axis.
  int stacks = 8;     ///< Along the axis.
  bool operator==(const Cylinder&) const = default;
};
/// A shape that is not made of others.
using SingleShape = std::variant<Mesh, Box, Sphere, Icosphere, Ellipsoid, Cylinder>;

/// A shape of a body of several, placed in the body's mesh frame.
struct PlacedShape {
  SingleShape shape;                                   ///< The shape.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< Position of the shape's own origin [m].
  /// Rotation from the shape to the mesh frame.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  bool operator==(const PlacedShape&) const = default;
};
/// Shapes that lie apart or touch; their union is the body.
struct Shapes {
  std::vector<PlacedShape> parts;  ///< At least one.
  bool operator==(const Shapes&) const = default;
};
/// The shape of a body.
using Shape = std::variant<Mesh, Box, Sphere, Icosphere, Ellipsoid, Cylinder, Shapes>;

/// A single shape as one that a body may have.
Shape as_shape(const SingleShape& shape);

}  // namespace scene

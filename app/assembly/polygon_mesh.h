#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "hydro/mesh/mesh.h"

namespace assembly {

/// Most vertices of a mesh file, 24 bytes each.
constexpr std::size_t kMostVertices = 200'000'000;

/// Unit of the numbers that give a place in a file.
enum class PlaceKind { line, byte };

/// Vertices and polygons as a mesh file lists them, in any order. All faults are InputErrors with a
/// place in the file.
class PolygonMesh {
 public:
  /// @param file   Must outlive it.
  /// @param first_number   The number by which faces name the first vertex.
  PolygonMesh(const std::filesystem::path& file, PlaceKind kind, int first_number)
      : file_(file), kind_(kind), first_number_(first_number) {}

  /// Makes room for triangles with corners of their own.
  void reserve_triangles(std::size_t count);

  /// @throws InputError if a coordinate is not finite or beyond the range of a float: computing
  ///     with its powers would overflow
  void add_vertex(const Eigen::Vector3d& vertex, std::uint64_t place);

  /// Adds a polygon.
  /// @param corners   Vertices as the file numbers them.
  /// @throws InputError if there is no corner
  void add_polygon(std::span<const std::int64_t> corners, std::uint64_t place);

  std::int64_t vertex_count() const { return static_cast<std::int64_t>(vertices_.size()); }

  /// Cuts the polygons into triangles (polygon_cut.h). Corners that repeat the one before are left
  /// out, and so are polygons of one or two corners, which are points and lines. One of more
  /// corners that has less than three others is a triangle without area, which names a vertex
  /// twice.
  /// @throws InputError if a polygon names a vertex that is missing
  hydro::TriMesh triangles() const;

  [[noreturn]] void fault(std::uint64_t place, const std::string& message) const;

 private:
  struct Polygon {
    std::size_t first = 0;    ///< Place of its first corner.
    std::uint64_t place = 0;  ///< A line or a byte.
  };

  std::size_t end_of(std::size_t polygon) const;  ///< Place after its last corner.
  /// Returns the corners of a polygon, counted from 0, without repetitions.
  std::vector<int> corners_of(std::size_t polygon) const;

  const std::filesystem::path& file_;
  PlaceKind kind_;
  int first_number_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<std::int64_t> corners_;
  std::vector<Polygon> polygons_;
  std::size_t added_ = 0;
};

}  // namespace assembly

#include "app/assembly/polygon_mesh.h"

#include <fmt/format.h>

#include <limits>

#include "app/assembly/mesh_text.h"
#include "hydro/mesh/polygon_cut.h"

namespace assembly {

void PolygonMesh::fault(std::uint64_t place, const std::string& message) const {
  if (kind_ == PlaceKind::line) fault_at_line(file_, static_cast<int>(place), message);
  fault_at_byte(file_, place, message);
}

void PolygonMesh::reserve_triangles(std::size_t count) {
  vertices_.reserve(3 * count);
  corners_.reserve(3 * count);
  polygons_.reserve(count);
}

void PolygonMesh::add_vertex(const Eigen::Vector3d& vertex, std::uint64_t place) {
  constexpr double kGreatest = std::numeric_limits<float>::max();
  if (!(vertex.cwiseAbs().maxCoeff() <= kGreatest) || !vertex.allFinite())
    fault(place, fmt::format("vertex {} is ({:g}, {:g}, {:g}), expected finite coordinates of a "
                             "float's range",
                             vertex_count() + first_number_, vertex.x(), vertex.y(), vertex.z()));
  if (vertices_.size() >= kMostVertices)
    fault(place,
          fmt::format("the file has more than {} million vertices", kMostVertices / 1'000'000));
  vertices_.push_back(vertex);
}

void PolygonMesh::add_polygon(std::span<const std::int64_t> corners, std::uint64_t place) {
  ++added_;
  if (corners.empty()) fault(place, fmt::format("face {} has no vertices", added_));
  polygons_.push_back({corners_.size(), place});
  corners_.insert(corners_.end(), corners.begin(), corners.end());
}

std::size_t PolygonMesh::end_of(std::size_t polygon) const {
  return polygon + 1 < polygons_.size() ? polygons_[polygon + 1].first : corners_.size();
}

std::vector<int> PolygonMesh::corners_of(std::size_t polygon) const {
  std::vector<int> corners;
  for (std::size_t i = polygons_[polygon].first; i < end_of(polygon); ++i) {
    if (corners_[i] < first_number_ || corners_[i] - first_number_ >= vertex_count())
      fault(polygons_[polygon].place,
            fmt::format("a face names vertex {}, the file has {} vertices, counted from {}",
                        corners_[i], vertex_count(), first_number_));
    const int corner = static_cast<int>(corners_[i] - first_number_);
    if (corners.empty() || corners.back() != corner) corners.push_back(corner);
  }
  if (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
  return corners;
}

hydro::TriMesh PolygonMesh::triangles() const {
  std::vector<Eigen::Vector3i> faces;
  faces.reserve(polygons_.size());
  for (std::size_t i = 0; i < polygons_.size(); ++i) {
    const std::vector<int> corners = corners_of(i);
    if (corners.size() >= 3)
      hydro::cut_polygon(vertices_, corners, faces);
    else if (end_of(i) - polygons_[i].first >= 3)
      faces.emplace_back(corners.front(), corners.back(), corners.back());
  }
  hydro::TriMesh mesh;
  if (!vertices_.empty())
    mesh.vertices = Eigen::Map<const Eigen::Matrix3Xd>(vertices_.front().data(), 3,
                                                       static_cast<Eigen::Index>(vertices_.size()));
  if (!faces.empty())
    mesh.faces = Eigen::Map<const Eigen::Matrix3Xi>(faces.front().data(), 3,
                                                    static_cast<Eigen::Index>(faces.size()));
  return mesh;
}

}  // namespace assembly

#include "hydro/added_mass/bem/surface.h"

#include <algorithm>
#include <numeric>

#include "hydro/mesh/edge_table.h"

namespace hydro::bem {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

struct Builder {
  std::vector<Vector3d> vertices;
  std::vector<Vector3i> faces;
  std::vector<int> parent;

  /// Adds a face, split at the middles of its edges (−1: none), the longest edge first. With three
  /// middles and no single longest edge it is split into four similar faces.
  void add(Vector3i face, std::array<int, 3> middles, int from) {
    const std::size_t first = longest_split(face, middles);
    if (std::count(middles.begin(), middles.end(), -1) == 0 && has_rival(face, first)) {
      for (int e = 0; e < 3; ++e)
        add({face[e], at(middles, e), at(middles, e + 2)}, {-1, -1, -1}, from);
      add({middles[0], middles[1], middles[2]}, {-1, -1, -1}, from);
      return;
    }
    if (middles[first] < 0) {
      faces.push_back(face);
      parent.push_back(from);
      return;
    }
    std::rotate(face.begin(), face.begin() + static_cast<long>(first), face.end());
    std::rotate(middles.begin(), middles.begin() + static_cast<long>(first), middles.end());
    const int m = middles[0];
    add({face[2], face[0], m}, {middles[2], -1, -1}, from);
    add({face[1], face[2], m}, {middles[1], -1, -1}, from);
  }

  static int at(const std::array<int, 3>& middles, int e) {
    return middles[static_cast<std::size_t>(e % 3)];
  }

  double length(const Vector3i& face, std::size_t e) const {
    const auto start = static_cast<std::size_t>(face[static_cast<int>(e)]);
    const auto end = static_cast<std::size_t>(face[static_cast<int>((e + 1) % 3)]);
    return (vertices[end] - vertices[start]).norm();
  }

  /// True if another edge of a face is as long as edge e.
  bool has_rival(const Vector3i& face, std::size_t e) const {
    return std::max(length(face, (e + 1) % 3), length(face, (e + 2) % 3)) * (1 + kSameLength) >=
           length(face, e);
  }

  /// The longest of the edges that have a middle; 0 if none has.
  std::size_t longest_split(const Vector3i& face, const std::array<int, 3>& middles) const {
    std::size_t longest = 0;
    double most = 0;
    for (std::size_t e = 0; e < 3; ++e) {
      if (middles[e] < 0 || length(face, e) <= most * (1 + kSameLength)) continue;
      longest = e;
      most = length(face, e);
    }
    return longest;
  }

  Split finished() const {
    Split split{{Eigen::Matrix3Xd(3, vertices.size()), Eigen::Matrix3Xi(3, faces.size())}, parent};
    for (std::size_t i = 0; i < vertices.size(); ++i)
      split.mesh.vertices.col(static_cast<Eigen::Index>(i)) = vertices[i];
    for (std::size_t f = 0; f < faces.size(); ++f)
      split.mesh.faces.col(static_cast<Eigen::Index>(f)) = faces[f];
    return split;
  }
};

Builder builder_of(const TriMesh& mesh) {
  Builder builder;
  for (Eigen::Index i = 0; i < mesh.vertex_count(); ++i)
    builder.vertices.push_back(mesh.vertices.col(i));
  return builder;
}

}  // namespace

Edges edges_of(const TriMesh& mesh) {
  Edges edges;
  edges.of_face.assign(static_cast<std::size_t>(mesh.face_count()), {-1, -1, -1});
  const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
  for (std::size_t i = 0; i + 1 < halves.size(); i += 2) {
    for (std::size_t k = i; k < i + 2; ++k) {
      const int start = halves[k].rising ? halves[k].low : halves[k].high;
      int e = 0;
      while (mesh.faces(e, halves[k].face) != start) ++e;
      edges.of_face[static_cast<std::size_t>(halves[k].face)][static_cast<std::size_t>(e)] =
          static_cast<int>(edges.faces.size());
    }
    edges.faces.push_back({halves[i].face, halves[i + 1].face});
  }
  return edges;
}

Split bisected(const Split& split, const Edges& edges, const std::vector<bool>& marked) {
  Builder builder = builder_of(split.mesh);
  std::vector<int> middle(marked.size(), -1);
  for (std::size_t f = 0; f < edges.of_face.size(); ++f) {
    const Vector3i face = split.mesh.faces.col(static_cast<Eigen::Index>(f));
    std::array<int, 3> middles;
    for (std::size_t e = 0; e < 3; ++e) {
      const auto edge = static_cast<std::size_t>(edges.of_face[f][e]);
      if (marked[edge] && middle[edge] < 0) {
        middle[edge] = static_cast<int>(builder.vertices.size());
        builder.vertices.push_back(0.5 *
                                   (split.mesh.vertices.col(face[static_cast<int>(e)]) +
                                    split.mesh.vertices.col(face[(static_cast<int>(e) + 1) % 3])));
      }
      middles[e] = middle[edge];
    }
    builder.add(face, middles, split.parent[f]);
  }
  return builder.finished();
}

Parts parts_of(const TriMesh& mesh) {
  std::vector<int> root(static_cast<std::size_t>(mesh.vertex_count()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int i) {
    while (root[static_cast<std::size_t>(i)] != i) {
      int& up = root[static_cast<std::size_t>(i)];
      up = root[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  };
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    for (int e = 0; e < 2; ++e) {
      const int a = find(mesh.faces(e, f)), b = find(mesh.faces(e + 1, f));
      root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  Parts parts{std::vector<int>(root.size(), -1), {}};
  for (std::size_t i = 0; i < root.size(); ++i) {
    const auto top = static_cast<std::size_t>(find(static_cast<int>(i)));
    if (top == i) {
      parts.of_vertex[i] = static_cast<int>(parts.volume.size());
      parts.volume.push_back(0);
    }
    parts.of_vertex[i] = parts.of_vertex[top];
  }
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    const auto part =
        static_cast<std::size_t>(parts.of_vertex[static_cast<std::size_t>(mesh.faces(0, f))]);
    parts.volume[part] += mesh.vertices.col(mesh.faces(0, f)).dot(area_vector(mesh, f)) / 3;
  }
  return parts;
}

Surface make_surface(const TriMesh& mesh) {
  return {mesh, make_elements(mesh), edges_of(mesh), parts_of(mesh)};
}

}  // namespace hydro::bem

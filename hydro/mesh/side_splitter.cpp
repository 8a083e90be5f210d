#include "hydro/mesh/side_splitter.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hydro {
namespace {

using Eigen::Vector3d;

class SideSplitter {
 public:
  SideSplitter(const TriMesh& mesh, std::vector<int> vertices, double margin, double from_ends)
      : mesh_(mesh), vertices_(std::move(vertices)), margin_(margin), from_ends_(from_ends) {
    std::ranges::sort(vertices_, {}, [&](int v) { return mesh_.vertices(0, v); });
  }

  template <class MaySplit>
  TriMesh split(MaySplit may_split) {
    for (int f = 0; f < mesh_.face_count(); ++f) {
      const Eigen::Vector3i face = mesh_.faces.col(f);
      add({face[0], face[1], face[2]}, may_split(f) ? 0 : kDeepest);
    }
    TriMesh result{mesh_.vertices, Eigen::Matrix3Xi(3, static_cast<Eigen::Index>(faces_.size()))};
    for (std::size_t f = 0; f < faces_.size(); ++f)
      result.faces.col(static_cast<Eigen::Index>(f)) =
          Eigen::Vector3i(faces_[f][0], faces_[f][1], faces_[f][2]);
    return result;
  }

 private:
  using Face = std::array<int, 3>;
  static constexpr int kDeepest = 1000;

  /// Adds a face, or its parts. Slivers could be split for ever: what is left then does not close.
  /// Each vertex lies on the sides of two faces at most.
  void add(const Face& face, int depth) {
    for (std::size_t i = 0; i < 3 && depth < kDeepest && splits_ < 4 * vertices_.size(); ++i) {
      const int from = face[i], to = face[(i + 1) % 3], third = face[(i + 2) % 3];
      const int v = vertex_on(from, to);
      if (v < 0 || v == third) continue;
      ++splits_;
      add({from, v, third}, depth + 1);
      add({v, to, third}, depth + 1);
      return;
    }
    faces_.push_back(face);
  }

  /// Returns a vertex between the ends of an edge; −1 if there is none.
  int vertex_on(int from, int to) const {
    const Vector3d a = mesh_.vertices.col(from), along = mesh_.vertices.col(to) - a;
    const double length = along.norm();
    Eigen::AlignedBox3d box(a);
    box.extend(Vector3d(mesh_.vertices.col(to)));
    box.min().array() -= margin_;
    box.max().array() += margin_;
    const auto x = [&](int v) { return mesh_.vertices(0, v); };
    for (auto it = std::ranges::lower_bound(vertices_, box.min().x(), {}, x);
         it != vertices_.end() && x(*it) <= box.max().x(); ++it) {
      const int v = *it;
      const Vector3d p = mesh_.vertices.col(v);
      if (v == from || v == to || !box.contains(p)) continue;
      const double at = along.dot(p - a) / length;
      if (at > from_ends_ && at < length - from_ends_ &&
          (p - a - at / length * along).norm() <= margin_)
        return v;
    }
    return -1;
  }

  const TriMesh& mesh_;
  std::vector<int> vertices_;  ///< Vertices that may lie on sides, ascending in x.
  double margin_, from_ends_;
  std::vector<Face> faces_;
  std::size_t splits_ = 0;
};

}  // namespace

TriMesh split_sides(const TriMesh& mesh, std::vector<int> vertices, double margin, double from_ends,
                    const std::vector<char>& faces) {
  return SideSplitter(mesh, std::move(vertices), margin, from_ends).split([&](int f) {
    return faces.empty() || faces[static_cast<std::size_t>(f)] != 0;
  });
}

}  // namespace hydro

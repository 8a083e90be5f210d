#include "app/render/paint.h"

#include <array>
#include <map>
#include <utility>

#include "hydro/mesh/face_tree.h"

namespace render {
namespace {

using Color = std::array<float, 3>;

Color color_of(const Paint& paint, int face, const Eigen::Vector3f& own) {
  const Eigen::Vector3f color =
      face >= 0 && paint.colors(0, face) >= 0 ? Eigen::Vector3f(paint.colors.col(face)) : own;
  return {color.x(), color.y(), color.z()};
}

}  // namespace

PaintedSkin painted_skin(const ShadedMesh& skin, const Paint& paint, const Eigen::Vector3f& own) {
  const hydro::FaceTree tree(paint.surface_B);
  std::map<std::pair<int, Color>, int> vertices;
  std::vector<std::pair<int, Color>> order;
  PaintedSkin painted;
  painted.skin.triangles.resize(3, skin.triangles.cols());
  for (Eigen::Index f = 0; f < skin.triangles.cols(); ++f) {
    const auto corners = skin.triangles.col(f);
    const Eigen::Vector3d middle = (skin.vertices.col(corners[0]) + skin.vertices.col(corners[1]) +
                                    skin.vertices.col(corners[2])) /
                                   3;
    const Color color = color_of(paint, tree.nearest(middle), own);
    for (int i = 0; i < 3; ++i) {
      const std::pair<int, Color> vertex(corners[i], color);
      const auto [found, is_new] = vertices.emplace(vertex, static_cast<int>(order.size()));
      if (is_new) order.push_back(vertex);
      painted.skin.triangles(i, f) = found->second;
    }
  }
  const auto count = static_cast<Eigen::Index>(order.size());
  painted.skin.vertices.resize(3, count);
  painted.skin.normals.resize(3, count);
  painted.colors.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [vertex, color] = order[static_cast<std::size_t>(i)];
    painted.skin.vertices.col(i) = skin.vertices.col(vertex);
    painted.skin.normals.col(i) = skin.normals.col(vertex);
    painted.colors.col(i) << color[0], color[1], color[2];
  }
  return painted;
}

}  // namespace render

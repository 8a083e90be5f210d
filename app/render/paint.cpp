#include "app/render/paint.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "app/render/texture_fit.h"
#include "hydro/mesh/face_tree.h"

namespace render {
namespace {

using Eigen::Index;

/// Look of a triangle.
struct FaceLook {
  Eigen::Vector3f color;
  int texture = -1;  ///< Number of the image; -1: none.
  CornerCoordinates coordinates = CornerCoordinates::Zero();
};

/// A vertex of the skin with the look of a triangle: its number, colour and texture coordinates.
using PaintedVertex = std::tuple<int, std::array<float, 3>, std::array<float, 2>>;

FaceLook look_of(const Eigen::Matrix3d& corners, const hydro::FaceTree& tree, const Paint& paint,
                 const Eigen::Vector3f& own) {
  const int face = tree.nearest((corners.col(0) + corners.col(1) + corners.col(2)) / 3);
  if (face < 0) return {.color = own};
  if (paint.textures && paint.textures->of_face[face] >= 0)
    if (const auto coordinates = fitted_coordinates(tree, paint, corners, face))
      return {.color = paint.textures->tints.col(face),
              .texture = paint.textures->of_face[face],
              .coordinates = *coordinates};
  return {.color = paint.colors(0, face) >= 0 ? Eigen::Vector3f(paint.colors.col(face)) : own};
}

std::vector<FaceLook> looks_of(const ShadedMesh& skin, const Paint& paint,
                               const Eigen::Vector3f& own) {
  const hydro::FaceTree tree(paint.surface_B);
  std::vector<FaceLook> looks;
  looks.reserve(static_cast<std::size_t>(skin.triangles.cols()));
  for (const auto& triangle : skin.triangles.colwise()) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = skin.vertices.col(triangle[i]);
    looks.push_back(look_of(corners, tree, paint, own));
  }
  return looks;
}

/// Returns the numbers of the triangles, those of one texture after the other.
std::vector<std::size_t> by_texture(const std::vector<FaceLook>& looks) {
  std::vector<std::size_t> order(looks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t f) { return looks[f].texture; });
  return order;
}

std::vector<SkinPart> parts_of(const std::vector<FaceLook>& looks,
                               const std::vector<std::size_t>& order, const TextureMap& textures) {
  std::vector<SkinPart> parts;
  int last = -2;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int texture = looks[order[i]].texture;
    if (texture != last)
      parts.push_back({.texture = texture < 0
                                      ? nullptr
                                      : textures.images[static_cast<std::size_t>(texture)].get(),
                       .first = static_cast<Index>(i)});
    ++parts.back().count;
    last = texture;
  }
  return parts;
}

void store_vertices(const std::vector<PaintedVertex>& vertices, const ShadedMesh& skin,
                    PaintedSkin& painted) {
  const auto count = static_cast<Index>(vertices.size());
  painted.skin.vertices.resize(3, count);
  painted.skin.normals.resize(3, count);
  painted.colors.resize(3, count);
  painted.coordinates.resize(2, count);
  for (Index i = 0; i < count; ++i) {
    const auto& [vertex, color, place] = vertices[static_cast<std::size_t>(i)];
    painted.skin.vertices.col(i) = skin.vertices.col(vertex);
    painted.skin.normals.col(i) = skin.normals.col(vertex);
    painted.colors.col(i) << color[0], color[1], color[2];
    painted.coordinates.col(i) << place[0], place[1];
  }
}

}  // namespace

PaintedSkin painted_skin(const ShadedMesh& skin, const Paint& paint, const Eigen::Vector3f& own) {
  const std::vector<FaceLook> looks = looks_of(skin, paint, own);
  const std::vector<std::size_t> order = by_texture(looks);
  std::map<PaintedVertex, int> numbers;
  std::vector<PaintedVertex> vertices;
  PaintedSkin painted;
  painted.skin.triangles.resize(3, skin.triangles.cols());
  for (std::size_t f = 0; f < order.size(); ++f) {
    const FaceLook& look = looks[order[f]];
    for (int i = 0; i < 3; ++i) {
      const PaintedVertex vertex = {skin.triangles(i, static_cast<Index>(order[f])),
                                    {look.color.x(), look.color.y(), look.color.z()},
                                    {look.coordinates(0, i), look.coordinates(1, i)}};
      const auto [found, is_new] = numbers.emplace(vertex, static_cast<int>(vertices.size()));
      if (is_new) vertices.push_back(vertex);
      painted.skin.triangles(i, static_cast<Index>(f)) = found->second;
    }
  }
  store_vertices(vertices, skin, painted);
  if (paint.textures)
    painted.parts = parts_of(looks, order, *paint.textures);
  else
    painted.coordinates.resize(2, 0);
  return painted;
}

Paint without_textures(const Paint& paint) {
  return {.surface_B = paint.surface_B, .colors = paint.colors};
}

}  // namespace render

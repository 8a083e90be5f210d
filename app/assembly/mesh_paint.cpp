#include "app/assembly/mesh_paint.h"

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/assembly/mesh_file_access.h"
#include "app/assembly/mesh_reader_process.h"
#include "app/assembly/mesh_text.h"
#include "app/assembly/mesh_textures.h"
#include "app/base/byte_records.h"
#include "app/render/srgb.h"
#include "app/scene/diagnostics.h"
#include "app/scene/isolated_reader.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

using Color = std::array<float, 3>;

constexpr Color kNone = {-1, -1, -1};

/// Formats whose colours are read.
constexpr const char* kPaintedFormats[] = {".obj", ".gltf", ".glb", ".ply"};

constexpr Color kWhite = {1, 1, 1};

/// Diffuse colour that assimp 5.2 gives to a material of MTL without one.
constexpr float kAssimpGray = 0.6F;

/// Corners, colours and textures of triangles.
struct Soup {
  std::vector<double> corners;  ///< Nine numbers a triangle.
  std::vector<float> colors;    ///< Three numbers a triangle.
  std::vector<TextureSource> textures;
  std::vector<int> texture_of;     ///< One number a triangle.
  std::vector<float> coordinates;  ///< Six numbers a triangle.
  std::vector<float> tints;        ///< Three numbers a triangle.
};

/// Returns the base colour of a material; none of one that assimp makes for parts without any.
/// @param gltf   A part of glTF without a material has a white one without a name.
Color base_color(const aiMaterial& material, bool gltf) {
  const aiString name = material.GetName();
  aiColor4D color;
  if (std::strcmp(name.C_Str(), AI_DEFAULT_MATERIAL_NAME) == 0) return kNone;
  if (aiGetMaterialColor(&material, AI_MATKEY_COLOR_DIFFUSE, &color) != AI_SUCCESS) return kNone;
  const bool white = color.r == 1 && color.g == 1 && color.b == 1;
  if (gltf && white && name.length == 0) return kNone;
  return {color.r, color.g, color.b};
}

/// Returns the colour of a face: that of the material, times the mean of its vertices' colours.
Color face_color(const aiMesh& part, const aiFace& face, const Color& base, bool gltf) {
  Color color = base;
  if (part.HasVertexColors(0)) {
    if (color == kNone) color = {1, 1, 1};
    aiColor4D sum;
    for (unsigned i = 0; i < 3; ++i) sum = sum + part.mColors[0][face.mIndices[i]];
    const Color mean = {sum.r / 3, sum.g / 3, sum.b / 3};
    std::ranges::transform(color, mean, color.begin(), std::multiplies<>());
  }
  if (gltf && color != kNone) std::ranges::transform(color, color.begin(), render::displayed);
  return color;
}

/// Returns the colour of a material that multiplies its texture.
Color tint_of(const Color& base, bool gltf) {
  const bool unsaid = !gltf && base == Color{kAssimpGray, kAssimpGray, kAssimpGray};
  return base == kNone || unsaid ? kWhite : base;
}

/// Adds the texture coordinates of a face. @return false if they are not finite
bool add_coordinates(const aiVector3D* coordinates, const aiFace& face, Soup& soup) {
  bool finite = true;
  for (unsigned i = 0; i < 3; ++i) {
    const aiVector3D& place = coordinates[face.mIndices[i]];
    finite = finite && std::isfinite(place.x) && std::isfinite(place.y);
    soup.coordinates.insert(soup.coordinates.end(), {place.x, place.y});
  }
  if (!finite) std::fill(soup.coordinates.end() - 6, soup.coordinates.end(), 0.0F);
  return finite;
}

void add(const aiMesh& part, const aiMaterial& material, bool gltf, TextureCollector& textures,
         Soup& soup) {
  const Color base = base_color(material, gltf);
  const MaterialTexture texture = textures.texture_of(material);
  const bool textured = texture.number >= 0 && part.HasTextureCoords(texture.channel);
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue;
    for (unsigned i = 0; i < 3; ++i) {
      const aiVector3D& v = part.mVertices[face.mIndices[i]];
      soup.corners.insert(soup.corners.end(), {v.x, v.y, v.z});
    }
    const Color color = face_color(part, face, base, gltf);
    soup.colors.insert(soup.colors.end(), color.begin(), color.end());
    const Color tint = textured ? face_color(part, face, tint_of(base, gltf), gltf) : kWhite;
    soup.tints.insert(soup.tints.end(), tint.begin(), tint.end());
    if (textured && add_coordinates(part.mTextureCoords[texture.channel], face, soup)) {
      soup.texture_of.push_back(texture.number);
    } else {
      soup.coordinates.resize(2 * soup.corners.size() / 3);
      soup.texture_of.push_back(-1);
    }
  }
}

/// Reads the triangles of a file with their colours, in this process (mesh_parser.h tells why it is
/// not to be called in the program's own).
Soup parse_paint(const fs::path& file, bool gltf) {
  auto& importer = *new Assimp::Importer;  // Not freed: the process ends.
  auto& access = *new MeshFileAccess(file);
  importer.SetIOHandler(&access);
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                         aiProcess_TransformUVCoords | aiProcess_PreTransformVertices);
  if (!scene) throw scene::InputError(file, "not a sound mesh file");
  Soup soup;
  TextureCollector textures(file, *scene, access);
  for (unsigned m = 0; m < scene->mNumMeshes; ++m)
    add(*scene->mMeshes[m], *scene->mMaterials[scene->mMeshes[m]->mMaterialIndex], gltf, textures,
        soup);
  if (std::ranges::any_of(soup.texture_of, [](int t) { return t >= 0; }))
    soup.textures = textures.sources();
  return soup;
}

void write(const app::CallOutput& output, const Soup& soup) {
  app::put_record(output, std::span(soup.corners));
  app::put_record(output, std::span(soup.colors));
  if (soup.textures.empty()) return;
  app::put_record(output, std::span(soup.texture_of));
  app::put_record(output, std::span(soup.coordinates));
  app::put_record(output, std::span(soup.tints));
  for (const TextureSource& texture : soup.textures) {
    app::put_record(output, texture.name);
    app::put_record(output, texture.file.string());
    app::put_record(output, texture.bytes);
  }
}

/// Reverses `write`.
Soup soup_in(const std::string& bytes) {
  app::ByteRecords records(bytes);
  Soup soup;
  soup.corners = records.values<double>();
  soup.colors = records.values<float>();
  if (records.at_end()) return soup;
  soup.texture_of = records.values<int>();
  soup.coordinates = records.values<float>();
  soup.tints = records.values<float>();
  while (!records.at_end()) {
    TextureSource& texture = soup.textures.emplace_back();
    texture.name = records.bytes();
    texture.file = fs::path(records.bytes());
    texture.bytes = records.bytes();
  }
  return soup;
}

Soup read_soup(const fs::path& file, bool gltf) {
  return soup_in(scene::read_isolated(
      file, "the reader of colours",
      [&](const app::CallOutput& output) { write(output, parse_paint(file, gltf)); },
      mesh_limits(file)));
}

void take_textures(Soup soup, MeshPaint& paint) {
  const Eigen::Index faces = paint.mesh.face_count();
  paint.texture_of = Eigen::Map<const Eigen::VectorXi>(soup.texture_of.data(), faces);
  paint.coordinates = Eigen::Map<const Eigen::Matrix2Xf>(soup.coordinates.data(), 2, 3 * faces);
  paint.tints = Eigen::Map<const Eigen::Matrix3Xf>(soup.tints.data(), 3, faces);
  paint.textures = std::move(soup.textures);
}

}  // namespace

std::optional<MeshPaint> read_paint(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  if (std::ranges::count(kPaintedFormats, extension) == 0) return std::nullopt;
  const bool gltf = extension == ".gltf" || extension == ".glb";
  Soup soup;
  try {
    soup = read_soup(file, gltf);
  } catch (const scene::InputError&) {
    return std::nullopt;
  }
  const bool colored = std::ranges::any_of(soup.colors, [](float c) { return c >= 0; });
  if (!colored && soup.textures.empty()) return std::nullopt;
  const auto faces = static_cast<Eigen::Index>(soup.colors.size() / 3);
  MeshPaint paint;
  paint.mesh.vertices = Eigen::Map<const Eigen::Matrix3Xd>(soup.corners.data(), 3, 3 * faces);
  paint.mesh.faces.resize(3, faces);
  for (Eigen::Index i = 0; i < 3 * faces; ++i) paint.mesh.faces(i % 3, i / 3) = static_cast<int>(i);
  paint.colors = Eigen::Map<const Eigen::Matrix3Xf>(soup.colors.data(), 3, faces);
  paint.of_light = gltf;
  if (!soup.textures.empty()) take_textures(std::move(soup), paint);
  return paint;
}

}  // namespace assembly

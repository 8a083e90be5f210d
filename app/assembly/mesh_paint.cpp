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
#include <vector>

#include "app/assembly/mesh_file_access.h"
#include "app/assembly/mesh_reader_process.h"
#include "app/assembly/mesh_text.h"
#include "app/base/byte_records.h"
#include "app/scene/diagnostics.h"
#include "app/scene/isolated_reader.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;

using Color = std::array<float, 3>;

constexpr Color kNone = {-1, -1, -1};

/// Formats whose colours are read.
constexpr const char* kPaintedFormats[] = {".obj", ".gltf", ".glb", ".ply"};

/// Corners and colours of triangles.
struct Soup {
  std::vector<double> corners;  ///< Nine numbers a triangle.
  std::vector<float> colors;    ///< Three numbers a triangle.
};

/// Returns the value as displayed of a linear share of light (IEC 61966-2-1, sRGB).
float displayed(float linear) {
  const float share = std::clamp(linear, 0.0F, 1.0F);
  return share <= 0.0031308F ? 12.92F * share : 1.055F * std::pow(share, 1 / 2.4F) - 0.055F;
}

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
  if (gltf && color != kNone) std::ranges::transform(color, color.begin(), displayed);
  return color;
}

void add(const aiMesh& part, const aiMaterial& material, bool gltf, Soup& soup) {
  const Color base = base_color(material, gltf);
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue;
    for (unsigned i = 0; i < 3; ++i) {
      const aiVector3D& v = part.mVertices[face.mIndices[i]];
      soup.corners.insert(soup.corners.end(), {v.x, v.y, v.z});
    }
    const Color color = face_color(part, face, base, gltf);
    soup.colors.insert(soup.colors.end(), color.begin(), color.end());
  }
}

/// Reads the triangles of a file with their colours, in this process (mesh_parser.h tells why it is
/// not to be called in the program's own).
Soup parse_paint(const fs::path& file, bool gltf) {
  auto& importer = *new Assimp::Importer;  // Not freed: the process ends.
  importer.SetIOHandler(new MeshFileAccess(file));
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                                           aiProcess_PreTransformVertices);
  if (!scene) throw scene::InputError(file, "not a sound mesh file");
  Soup soup;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m)
    add(*scene->mMeshes[m], *scene->mMaterials[scene->mMeshes[m]->mMaterialIndex], gltf, soup);
  return soup;
}

Soup read_soup(const fs::path& file, bool gltf) {
  const std::string bytes = scene::read_isolated(
      file, "the reader of colours",
      [&](const app::CallOutput& output) {
        const Soup soup = parse_paint(file, gltf);
        app::put_record(output, std::span(soup.corners));
        app::put_record(output, std::span(soup.colors));
      },
      mesh_limits(file));
  app::ByteRecords records(bytes);
  Soup soup;
  soup.corners = records.values<double>();
  soup.colors = records.values<float>();
  return soup;
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
  if (std::ranges::all_of(soup.colors, [](float c) { return c < 0; })) return std::nullopt;
  const auto faces = static_cast<Eigen::Index>(soup.colors.size() / 3);
  MeshPaint paint;
  paint.mesh.vertices = Eigen::Map<const Eigen::Matrix3Xd>(soup.corners.data(), 3, 3 * faces);
  paint.mesh.faces.resize(3, faces);
  for (Eigen::Index i = 0; i < 3 * faces; ++i) paint.mesh.faces(i % 3, i / 3) = static_cast<int>(i);
  paint.colors = Eigen::Map<const Eigen::Matrix3Xf>(soup.colors.data(), 3, faces);
  return paint;
}

}  // namespace assembly

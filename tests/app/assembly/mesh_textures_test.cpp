#include <gtest/gtest.h>

#include <fstream>

#include "app/assembly/mesh_paint.h"

/// Where the textures of mesh files are, and how they lie on the triangles.

namespace {

namespace fs = std::filesystem;
using Eigen::Vector2f;
using Eigen::Vector3f;

/// A folder of the test, empty at its start.
class MeshTextures : public testing::Test {
 protected:
  MeshTextures() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "sub");
  }
  ~MeshTextures() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  /// Reads a square of two triangles whose material is as MTL has it.
  assembly::MeshPaint square_of(const std::string& material) const {
    write("m.mtl", "newmtl m\n" + material);
    const auto paint = assembly::read_paint(
        write("m.obj",
              "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 3 0\nvt 3 -2\n"
              "vt 0 -2\nusemtl m\nf 1/1 2/2 3/3 4/4\n"));
    EXPECT_TRUE(paint.has_value());
    return paint.value_or(assembly::MeshPaint());
  }
  /// Returns the file of the only texture.
  fs::path file_of(const std::string& material) const {
    const assembly::MeshPaint paint = square_of(material);
    EXPECT_EQ(paint.textures.size(), 1U);
    return paint.textures.empty() ? "none" : paint.textures.front().file;
  }

  const fs::path folder_ = fs::path(testing::TempDir()) /
                           (std::string("plimsoll_textures_") +
                            testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(MeshTextures, LieOnTheCornersOfTriangles) {
  const assembly::MeshPaint paint = square_of("Kd 1 0.5 0.25\nmap_Kd t.png\n");
  ASSERT_EQ(paint.mesh.face_count(), 2);
  EXPECT_EQ(paint.texture_of, Eigen::Vector2i::Zero());
  EXPECT_FALSE(paint.of_light);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const Eigen::Vector3d v = paint.mesh.vertices.col(paint.mesh.faces(i % 3, i / 3));
    EXPECT_EQ(paint.coordinates.col(i),
              Vector2f(3 * static_cast<float>(v.x()), -2 * static_cast<float>(v.y())));
  }
  EXPECT_EQ(paint.tints.col(0), Vector3f(1, 0.5F, 0.25F));
  EXPECT_EQ(paint.colors.col(0), Vector3f(1, 0.5F, 0.25F));
}

TEST_F(MeshTextures, OfAMaterialWithoutAColorAreNotDarkened) {
  EXPECT_EQ(square_of("map_Kd t.png\n").tints.col(0), Vector3f(1, 1, 1));
  EXPECT_EQ(square_of("Kd 0 0 0\nmap_Kd t.png\n").tints.col(0), Vector3f(0, 0, 0));
}

TEST_F(MeshTextures, AreFoundBesideTheFileAndBelow) {
  write("t.png", "-");
  write("sub/s.png", "-");
  EXPECT_EQ(file_of("map_Kd t.png\n"), folder_ / "t.png");
  EXPECT_EQ(file_of("map_Kd sub/s.png \n"), folder_ / "sub/s.png");
  EXPECT_EQ(file_of("map_Kd sub\\s.png\n"), folder_ / "sub/s.png");
  EXPECT_EQ(file_of("map_Kd C:\\work\\t.png\n"), folder_ / "t.png") << "by its name";
  EXPECT_EQ(file_of("map_Kd -s 2 2 1 -clamp on t.png\n"), folder_ / "t.png") << "after options";
}

TEST_F(MeshTextures, AreNotFoundElsewhere) {
  write("../plimsoll_outside.png", "-");
  EXPECT_EQ(file_of("map_Kd ../plimsoll_outside.png\n"), "");
  fs::remove(folder_ / "../plimsoll_outside.png");
  EXPECT_EQ(file_of("map_Kd none.png\n"), "");
  EXPECT_EQ(file_of("map_Kd sub\n"), "") << "a folder";
}

TEST_F(MeshTextures, AreNotThereForMaterialsOrFacesWithoutThem) {
  EXPECT_TRUE(square_of("Kd 1 0 0\n").textures.empty());
  write("m.mtl", "newmtl m\nKd 1 0 0\nmap_Kd t.png\n");
  const auto paint = assembly::read_paint(
      write("n.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl m\nf 1 2 3\n"));
  ASSERT_TRUE(paint.has_value());
  EXPECT_TRUE(paint->textures.empty());
  EXPECT_EQ(paint->coordinates.size(), 0);
}

/// A triangle with texture coordinates (0.25, 0.25), (0.75, 0.25) and (0.25, 0.75) from the upper
/// left corner, as glTF has them, and a material.
std::string gltf_with(const std::string& material, const std::string& image) {
  const std::string positions = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const std::string places = "AACAPgAAgD4AAEA/AACAPgAAgD4AAEA/";
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "extensionsUsed": ["KHR_texture_transform"],
    "nodes": [{"mesh": 0}], "buffers": [{"byteLength": 60,
    "uri": "data:application/octet-stream;base64,)" +
         positions + places + R"("}],
    "bufferViews": [{"buffer": 0, "byteLength": 36},
                    {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "images": [{"uri": ")" +
         image + R"("}], "textures": [{"source": 0}],
    "materials": [{"pbrMetallicRoughness": {)" +
         material + R"(}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}]})";
}

TEST_F(MeshTextures, OfGltfMultiplyLightAndComeFromItsAddress) {
  write("my t.png", "-");
  const auto paint = assembly::read_paint(write(
      "t.gltf",
      gltf_with(R"("baseColorFactor": [1, 0.2140411, 0, 1], "baseColorTexture": {"index": 0})",
                "my%20t.png")));
  ASSERT_TRUE(paint.has_value());
  ASSERT_EQ(paint->textures.size(), 1U);
  EXPECT_EQ(paint->textures[0].file, folder_ / "my t.png");
  EXPECT_TRUE(paint->of_light);
  EXPECT_LT((paint->tints.col(0) - Vector3f(1, 0.5F, 0)).norm(), 1e-5F);
  Eigen::Matrix<float, 2, 3> from_below;
  from_below << 0.25F, 0.75F, 0.25F, 0.75F, 0.75F, 0.25F;
  EXPECT_EQ(paint->coordinates, from_below);
}

TEST_F(MeshTextures, OfGltfMayBeWithoutAColorMovedAndInTheFile) {
  const auto paint = assembly::read_paint(
      write("t.gltf", gltf_with(R"("baseColorTexture": {"index": 0, "extensions":
                                  {"KHR_texture_transform": {"scale": [2, 1], "offset": [0.5, 0]}}})",
                                "data:image/png;base64,QUJDRA==")));
  ASSERT_TRUE(paint.has_value());
  ASSERT_EQ(paint->textures.size(), 1U);
  EXPECT_EQ(paint->textures[0].bytes, "ABCD");
  EXPECT_TRUE(paint->textures[0].file.empty());
  EXPECT_LT(paint->colors(0, 0), 0) << "the body's own colour, where the image is none";
  EXPECT_LT((paint->tints.col(0) - Vector3f::Ones()).norm(), 1e-6F);
  EXPECT_LT((paint->coordinates.row(0) - Eigen::RowVector3f(1, 2, 1)).norm(), 1e-6F);
}

}  // namespace

#include "app/assembly/mesh_paint.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3f;

/// A folder of the test with a file.
fs::path file_with(const std::string& name, const std::string& text) {
  const fs::path folder = fs::path(testing::TempDir()) /
                          (std::string("plimsoll_paint_") +
                           testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::create_directories(folder);
  std::ofstream(folder / name) << text;
  return folder / name;
}

/// The colour of the triangle with a corner at a height; the file has one triangle for each height.
Vector3f color_at(const assembly::MeshPaint& paint, double z) {
  for (Eigen::Index f = 0; f < paint.mesh.face_count(); ++f)
    if (paint.mesh.vertices(2, paint.mesh.faces(0, f)) == z) return paint.colors.col(f);
  ADD_FAILURE() << "no triangle at " << z;
  return Vector3f::Zero();
}

constexpr float kRounding = 1e-6F;

const std::string kThreeTriangles =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 2\nv 1 0 2\nv 0 1 2\n";

TEST(MeshPaint, HasTheColorsOfMaterialsBesideAnObjFile) {
  file_with("m.mtl", "newmtl red\nKd 0.8 0.1 0.2\nnewmtl blue\nKd 0 0.25 1\n");
  const fs::path file =
      file_with("t.obj", "mtllib m.mtl\n" + kThreeTriangles +
                             "usemtl red\nf 1 2 3\nusemtl blue\nf 4 5 6\nf 7 8 9\n");
  const auto paint = assembly::read_paint(file);
  ASSERT_TRUE(paint.has_value());
  EXPECT_LT((color_at(*paint, 0) - Vector3f(0.8F, 0.1F, 0.2F)).norm(), kRounding);
  for (const double z : {1, 2})
    EXPECT_LT((color_at(*paint, z) - Vector3f(0, 0.25F, 1)).norm(), kRounding);
}

TEST(MeshPaint, IsNoneOfAFileWithoutColors) {
  const fs::path file = file_with("t.obj", kThreeTriangles + "f 1 2 3\nf 4 5 6\n");
  EXPECT_FALSE(assembly::read_paint(file).has_value());
  EXPECT_FALSE(
      assembly::read_paint(file_with("u.obj", "mtllib none.mtl\n" + kThreeTriangles + "f 1 2 3\n"))
          .has_value());
  EXPECT_FALSE(assembly::read_paint(file_with("t.stl", "solid t\nendsolid t\n")).has_value());
  EXPECT_FALSE(assembly::read_paint(file_with("v.obj", "nonsense")).has_value());
}

TEST(MeshPaint, IsTheMeanOfTheColorsOfVertices) {
  const fs::path file =
      file_with("t.ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 255 51\n3 0 1 2\n");
  const auto paint = assembly::read_paint(file);
  ASSERT_TRUE(paint.has_value());
  EXPECT_LT((color_at(*paint, 0) - Vector3f(1, 2, 0.2F) / 3).norm(), kRounding);
}

/// A triangle of glTF, whose colour is linear in light.
TEST(MeshPaint, OfGltfIsAsDisplayed) {
  const std::string floats = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";  // 3 corners
  const fs::path file =
      file_with("t.gltf",
                R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
          "nodes": [{"mesh": 0}], "buffers": [{"byteLength": 36,
          "uri": "data:application/octet-stream;base64,)" +
                    floats + R"("}],
          "bufferViews": [{"buffer": 0, "byteLength": 36}],
          "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                         "min": [0, 0, 0], "max": [1, 1, 0]}],
          "materials": [{"name": "m",
                         "pbrMetallicRoughness": {"baseColorFactor": [1, 0.2140411, 0, 1]}}],
          "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}]})");
  const auto paint = assembly::read_paint(file);
  ASSERT_TRUE(paint.has_value());
  EXPECT_LT((color_at(*paint, 0) - Vector3f(1, 0.5F, 0)).norm(), 1e-5F);
}

}  // namespace

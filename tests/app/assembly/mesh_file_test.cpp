#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "app/assembly/mesh_io.h"
#include "app/assembly/mesh_parser.h"
#include "app/assembly/mesh_reader_process.h"
#include "app/scene/diagnostics.h"
#include "app/scene/isolated_reader.h"

/// @file
/// What a mesh file may make the reader do.

namespace {

namespace fs = std::filesystem;
using assembly::MeshFile;
using scene::MeshFormats;
using testing::HasSubstr;

constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

class HostileMesh : public testing::Test {
 protected:
  HostileMesh() : folder_(fs::path(testing::TempDir()) / ("hostile_mesh_" + name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "meshes");
  }
  ~HostileMesh() override { fs::remove_all(folder_); }

  fs::path write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_ / file, std::ios::binary) << text;
    return folder_ / file;
  }
  const fs::path& folder() const { return folder_; }

  static std::string fault_in(const std::function<void()>& read) {
    try {
      read();
    } catch (const scene::InputError& error) {
      return error.what();
    }
    return "";
  }
  static std::string fault_of(const fs::path& file, MeshFormats formats = MeshFormats::common) {
    return fault_in([&] { assembly::read_mesh(file, formats); });
  }

  /// The fault that the parser finds in the time that a slow machine and a sanitizer take.
  static std::string fault_found_in_time(const fs::path& file) {
    constexpr int kSeconds = 100;
    constexpr double kBytesPerSecond = 1e6;
    const auto parse = [&](const app::CallOutput&) {
      assembly::parse_mesh(file, MeshFormats::any);
    };
    const auto limits = scene::limits_by_size(file, kSeconds, kBytesPerSecond);
    return fault_in([&] { scene::read_isolated(file, "the reader", parse, limits); });
  }

  /// A glTF file of one triangle whose 36 bytes of vertices and 6 of indices lie in `uri`.
  static std::string triangle_in(const std::string& uri) {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"mesh": 0}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
      "buffers": [{"uri": ")" +
           uri + R"(", "byteLength": 42}],
      "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                     "min": [0, 0, 0], "max": [1, 1, 0]},
                    {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}]})";
  }
  static std::string triangle_bytes() {
    const float vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint16_t indices[] = {0, 1, 2};
    return std::string(reinterpret_cast<const char*>(vertices), sizeof vertices) +
           std::string(reinterpret_cast<const char*>(indices), sizeof indices);
  }

 private:
  static std::string name() {
    return testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  fs::path folder_;
};

TEST_F(HostileMesh, PipesAreNoFilesWhereverTheyAreNamed) {
  const fs::path pipe = folder() / "pipe.obj";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(fault_of(pipe), HasSubstr("is not a file"));
  ASSERT_EQ(::mkfifo((folder() / "pipe.mtl").c_str(), 0600), 0);
  EXPECT_EQ(fault_of(write("a.obj", std::string("mtllib pipe.mtl\n") + kTetrahedron)), "");
  ASSERT_EQ(::mkfifo((folder() / "pipe.bin").c_str(), 0600), 0);
  EXPECT_THAT(fault_of(write("a.gltf", triangle_in("pipe.bin"))),
              HasSubstr("not a sound mesh file"));
}

TEST_F(HostileMesh, BuffersLieInTheFolderOfTheMesh) {
  write("outside.bin", triangle_bytes());
  write("meshes/inside.bin", triangle_bytes());
  const auto gltf = [&](const std::string& uri) {
    return fault_of(write("meshes/a.gltf", triangle_in(uri)));
  };
  EXPECT_EQ(gltf("inside.bin"), "");
  EXPECT_THAT(gltf("../outside.bin"), HasSubstr("not a sound mesh file"));
  EXPECT_THAT(gltf((folder() / "outside.bin").string()), HasSubstr("not a sound mesh file"));
  fs::create_symlink(folder() / "outside.bin", folder() / "meshes/link.bin");
  EXPECT_THAT(gltf("link.bin"), HasSubstr("not a sound mesh file"));
}

TEST_F(HostileMesh, AMeshMayItselfBeALink) {
  const fs::path file = write("a.obj", kTetrahedron);
  fs::create_symlink(file, folder() / "meshes/link.obj");
  EXPECT_EQ(fault_of(folder() / "meshes/link.obj"), "");
}

TEST_F(HostileMesh, OtherFormatsAreReadOnRequest) {
  const fs::path file = write("a.ac",
                              "AC3Db\nMATERIAL \"\" rgb 1 1 1  amb 0.2 0.2 0.2  emis 0 0 0  spec "
                              "0.5 0.5 0.5  shi 10  trans 0\nOBJECT world\nkids 1\nOBJECT poly\n"
                              "numvert 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\nnumsurf 4\n"
                              "SURF 0x0\nmat 0\nrefs 3\n0 0 0\n2 0 0\n1 0 0\n"
                              "SURF 0x0\nmat 0\nrefs 3\n0 0 0\n1 0 0\n3 0 0\n"
                              "SURF 0x0\nmat 0\nrefs 3\n0 0 0\n3 0 0\n2 0 0\n"
                              "SURF 0x0\nmat 0\nrefs 3\n1 0 0\n2 0 0\n3 0 0\nkids 0\n");
  EXPECT_THAT(fault_of(file), HasSubstr("only with the option --any-format"));
  EXPECT_EQ(fault_of(file, MeshFormats::any), "");
}

TEST_F(HostileMesh, ACommonFormatIsNotReadAsAnother) {
  // Without its own reader assimp would try those of all other formats.
  const fs::path file = write("a.obj", "AC3Db\nOBJECT world\nkids 0\n");
  EXPECT_NE(fault_of(file), "");
  EXPECT_THAT(fault_of(write("a.glb", "AC3Db\nOBJECT world\nkids 0\n")),
              HasSubstr("not a sound mesh file"));
}

TEST_F(HostileMesh, NodesNestedWithoutEndAreAFault) {
  std::ostringstream nodes;
  constexpr int kNodes = 100'000;
  for (int i = 1; i < kNodes; ++i) nodes << "{\"children\": [" << i << "]}, ";
  std::string text = triangle_in("a.bin");
  write("a.bin", triangle_bytes());
  const std::string one = "\"nodes\": [{\"mesh\": 0}]";
  text.replace(text.find(one), one.size(), "\"nodes\": [" + nodes.str() + "{\"mesh\": 0}]");
  EXPECT_NE(fault_of(write("deep.gltf", text)), "");
  const fs::path file = folder() / "deep.gltf";
  EXPECT_THAT(fault_of(file), HasSubstr(file.string()));
}

TEST_F(HostileMesh, SpheresOfAFewBytesEachAreAFaultWhereTheyAreManyMillionVertices) {
  std::string text = "f 1 1 1 0.5 0.5 0 0 0\n";
  for (int i = 0; i < 300; ++i) text += "s " + std::to_string(i) + " 0 0 1\n";
  EXPECT_THAT(fault_found_in_time(write("spheres.nff", text)),
              HasSubstr("more than 3000000 vertices, the most that are read from"));
  EXPECT_EQ(fault_of(write("sphere.nff", text.substr(0, text.find("s 1 "))), MeshFormats::any), "");
}

TEST_F(HostileMesh, HeadsThatAreCutOffAreFaults) {
  EXPECT_THAT(fault_of(write("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n")),
              HasSubstr("its head has no end"));
  EXPECT_THAT(fault_of(write("b.ply", "ply\n")), HasSubstr("its head has no end"));
}

TEST_F(HostileMesh, WhatAFileStatesOfItsFrameIsKept) {
  write("a.bin", triangle_bytes());
  const MeshFile gltf =
      assembly::read_welded(write("a.gltf", triangle_in("a.bin")), MeshFormats::common);
  EXPECT_EQ(gltf.frame.up, scene::UpAxis::y);
  EXPECT_EQ(gltf.frame.unit, 1.0);
  const MeshFile obj = assembly::read_welded(write("a.obj", kTetrahedron), MeshFormats::common);
  EXPECT_EQ(obj.frame.up, std::nullopt);
  EXPECT_EQ(obj.frame.unit, std::nullopt);
}

}  // namespace

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "app/assembly/mesh_io.h"
#include "app/assembly/obj_reader.h"
#include "app/assembly/off_reader.h"
#include "app/assembly/ply_reader.h"
#include "app/assembly/stl_reader.h"
#include "app/scene/diagnostics.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/tolerance.h"

/// @file
/// The formats whose readers are this program's: what they keep, what they leave out, and where
/// they say a fault is.

namespace {

namespace fs = std::filesystem;
using assembly::MeshFile;
using hydro::TriMesh;
using testing::HasSubstr;

using Reader = MeshFile (*)(const fs::path&, std::string_view);

TriMesh read(Reader reader, const std::string& text) { return reader("hull", text).mesh; }

std::string fault_of(Reader reader, const std::string& text) {
  try {
    reader("hull", text);
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "";
}

/// A cube of 1 m at coordinates of a map, with more digits than a float has.
TriMesh far_cube() {
  return translated(hydro::make_box({1, 1, 1}), {500000.123456789, 5000000.987654321, 0.25});
}

/// The text of a mesh, with all digits of its coordinates.
std::ostringstream full_text() {
  std::ostringstream out;
  out.precision(17);
  return out;
}

std::string obj_text(const TriMesh& mesh) {
  std::ostringstream out = full_text();
  for (const auto& p : mesh.vertices.colwise()) out << "v " << p.transpose() << '\n';
  for (const auto& f : mesh.faces.colwise()) out << "f " << f.transpose().array() + 1 << '\n';
  return out.str();
}

std::string off_text(const TriMesh& mesh) {
  std::ostringstream out = full_text();
  out << "OFF\n" << mesh.vertex_count() << ' ' << mesh.face_count() << " 0\n";
  for (const auto& p : mesh.vertices.colwise()) out << p.transpose() << '\n';
  for (const auto& f : mesh.faces.colwise()) out << "3 " << f.transpose() << '\n';
  return out.str();
}

std::string stl_text(const TriMesh& mesh) {
  std::ostringstream out = full_text();
  out << "solid a facet\n";
  for (const auto& f : mesh.faces.colwise()) {
    out << "facet normal 0 0 nan\nouter loop\n";
    for (const int v : f) out << "vertex " << mesh.vertices.col(v).transpose() << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid\n";
  return out.str();
}

std::string ply_head(const TriMesh& mesh, const std::string& format) {
  std::ostringstream out;
  out << "ply\nformat " << format << " 1.0\ncomment made by a test\nelement vertex "
      << mesh.vertex_count()
      << "\nproperty double x\nproperty uchar red\nproperty double y\nproperty double z\n"
      << "element face " << mesh.face_count()
      << "\nproperty list uchar float more\nproperty list uchar int vertex_indices\nend_header\n";
  return out.str();
}

std::string ply_text(const TriMesh& mesh) {
  std::ostringstream out = full_text();
  out << ply_head(mesh, "ascii");
  for (const auto& p : mesh.vertices.colwise())
    out << p.x() << " 255 " << p.y() << ' ' << p.z() << '\n';
  for (const auto& f : mesh.faces.colwise()) out << "2 0.5 nan 3 " << f.transpose() << '\n';
  return out.str();
}

template <class T>
void put(std::string& bytes, T value, std::endian order) {
  std::string stored(sizeof value, '\0');
  std::memcpy(stored.data(), &value, sizeof value);
  if (order != std::endian::native) std::ranges::reverse(stored);
  bytes += stored;
}

std::string binary_ply(const TriMesh& mesh, std::endian order) {
  std::string bytes =
      ply_head(mesh, order == std::endian::big ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : mesh.vertices.colwise()) {
    put(bytes, p.x(), order);
    put(bytes, std::uint8_t{255}, order);
    put(bytes, p.y(), order);
    put(bytes, p.z(), order);
  }
  for (const auto& f : mesh.faces.colwise()) {
    put(bytes, std::uint8_t{1}, order);
    put(bytes, 0.5f, order);
    put(bytes, std::uint8_t{3}, order);
    for (const int v : f) put(bytes, std::int32_t{v}, order);
  }
  return bytes;
}

std::string binary_stl(const TriMesh& mesh, std::string head) {
  head.resize(80, ' ');
  put(head, static_cast<std::uint32_t>(mesh.face_count()), std::endian::little);
  for (const auto& f : mesh.faces.colwise()) {
    for (int i = 0; i < 3; ++i) put(head, 0.0f, std::endian::little);
    for (const int v : f)
      for (const double x : mesh.vertices.col(v))
        put(head, static_cast<float>(x), std::endian::little);
    put(head, std::uint16_t{7}, std::endian::little);
  }
  return head;
}

TEST(MeshReaders, AMeshFarFromTheOriginKeepsAllDigitsInEveryFormatThatHoldsThem) {
  const TriMesh cube = far_cube();
  const std::pair<const char*, std::string> files[] = {
      {"far.obj", obj_text(cube)},
      {"far.off", off_text(cube)},
      {"far.stl", stl_text(cube)},
      {"far_text.ply", ply_text(cube)},
      {"far_little.ply", binary_ply(cube, std::endian::little)},
      {"far_big.ply", binary_ply(cube, std::endian::big)}};
  for (const auto& [name, bytes] : files) {
    const fs::path file = fs::path(testing::TempDir()) / name;
    std::ofstream(file, std::ios::binary) << bytes;
    const TriMesh mesh = assembly::read_mesh(file);
    fs::remove(file);
    ASSERT_EQ(mesh.vertex_count(), 8) << name;
    EXPECT_EQ(bounding_box(mesh).min(), bounding_box(cube).min()) << name;
    EXPECT_EQ(bounding_box(mesh).max(), bounding_box(cube).max()) << name;
    EXPECT_TRUE(check_mesh(mesh).sound()) << name;
    // The sides of the cube are differences of doubles of 5e6, whose last digit is 1e-9.
    EXPECT_NEAR(solid_properties(mesh).volume, 1, support::tolerance(3e-9)) << name;
  }
}

/// The corners of all triangles as assimp reads them, in the order of the file.
Eigen::Matrix3Xd corners_by_assimp(const fs::path& file) {
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (scene == nullptr) return {};
  std::vector<Eigen::Vector3d> corners;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m)
    for (unsigned f = 0; f < scene->mMeshes[m]->mNumFaces; ++f)
      for (unsigned i = 0; i < 3; ++i) {
        const aiMesh& part = *scene->mMeshes[m];
        const aiVector3D& v = part.mVertices[part.mFaces[f].mIndices[i]];
        corners.emplace_back(v.x, v.y, v.z);
      }
  return Eigen::Map<Eigen::Matrix3Xd>(corners.front().data(), 3,
                                      static_cast<Eigen::Index>(corners.size()));
}

TEST(MeshReaders, TheMeshesOfTheScenesAreThoseThatAssimpReads) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(PLIMSOLL_SOURCE_DIR "/scenes/meshes")) {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const Reader reader =
        entry.path().extension() == ".stl" ? assembly::read_stl : assembly::read_obj;
    const TriMesh mesh = reader(entry.path(), bytes).mesh;
    const Eigen::Matrix3Xd expected = corners_by_assimp(entry.path());
    ASSERT_EQ(3 * mesh.face_count(), expected.cols()) << entry.path();
    // assimp rounds to floats.
    const double rounding = support::tolerance(1e-6 * bounding_box(mesh).sizes().maxCoeff());
    EXPECT_LE((mesh.vertices(Eigen::all, mesh.faces.reshaped()) - expected).cwiseAbs().maxCoeff(),
              rounding)
        << entry.path();
    ++count;
  }
  EXPECT_GE(count, 10);
}

TEST(MeshReaders, AnObjFileMayCountBackContinueLinesAndHaveColoursAndWeights) {
  const TriMesh mesh = read(assembly::read_obj,
                            "\xEF\xBB\xBF# a tetrahedron\r\n"
                            "mtllib none.mtl\r\no hull\r\ng side\r\n"
                            "v 0 0 0 0.5 0.5 0.5\r\n"
                            "v +2.0 0 0 2 # of weight 2\r\n"
                            "vn 1 0 0\r\nvt 0 0\r\n"
                            "v 0 \\\r\n1 0 1.0\r\n"
                            "\tv 0 0 1e0\r\n"
                            "usemtl steel\r\ns off\r\n"
                            "f -4/1/1 -2//1 -3/1\r\n"
                            "f 1 \\\r\n 2 4\r\nf 1 4 3 # the last but one\r\nf 2 3 4\r\n"
                            "l 1 2\r\np 1\r\n");
  EXPECT_EQ(mesh.vertices,
            (Eigen::Matrix3Xd(3, 4) << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1).finished());
  EXPECT_EQ(mesh.faces, (Eigen::Matrix3Xi(3, 4) << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3).finished());
}

TEST(MeshReaders, FacesMayStandBeforeTheirVerticesAndLinesMayEndInAnyWay) {
  const TriMesh mesh = read(assembly::read_obj, "f 1 2 3\rv 0 0 0\rv 1 0 0\r\n\nv 0 1 0");
  EXPECT_EQ(mesh.face_count(), 1);
  EXPECT_EQ(mesh.vertex_count(), 3);
}

TEST(MeshReaders, AConcaveDeckIsASolidWithItsSides) {
  // A prism over an L, whose deck and bottom have six corners each.
  const TriMesh prism = read(assembly::read_obj,
                             "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
                             "v 0 0 1\nv 3 0 1\nv 3 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
                             "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\n"
                             "f 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n");
  EXPECT_EQ(prism.face_count(), 4 + 4 + 12);
  EXPECT_TRUE(check_mesh(prism).sound());
  EXPECT_NEAR(check_mesh(prism).volume, 4, support::tolerance(1e-14));
}

TEST(MeshReaders, AnStlFileOfTextMayHaveSeveralSolidsAndWordsOnAnyLine) {
  const TriMesh mesh = read(assembly::read_stl,
                            "SOLID first part\n FACET NORMAL 0 0 1 OUTER LOOP\n"
                            "VERTEX 0 0 0 VERTEX 1 0 0\n\nVERTEX 0 1 0 ENDLOOP ENDFACET\nENDSOLID\n"
                            "solid\nfacet normal -nan(ind) 1.#QNAN 0\nouter loop\nvertex 0 0 1\n"
                            "vertex 1 0 1\nvertex 0 1 1\nendloop\nendfacet\nendsolid second\n");
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(mesh.vertices.col(5), Eigen::Vector3d(0, 1, 1));
}

TEST(MeshReaders, ABinaryStlFileMayBeginAsOneOfTextAndIsRoundedToFloats) {
  const TriMesh cube = hydro::make_box({1, 2, 3});
  const MeshFile file = assembly::read_stl("hull", binary_stl(cube, "solid made by a program"));
  EXPECT_EQ(file.rounding, assembly::Rounding::of_floats);
  EXPECT_EQ(file.mesh.face_count(), 12);
  EXPECT_EQ(solid_properties(file.mesh).volume, 6);
  EXPECT_EQ(assembly::read_stl("hull", stl_text(cube)).rounding, assembly::Rounding::as_written);
}

TEST(MeshReaders, StripsOfAPlyFileAreCutIntoTrianglesOfOneSense) {
  const TriMesh mesh = read(assembly::read_ply,
                            "ply\nformat ascii 1.0\nelement tristrips 1\n"
                            "property list int int vertex_indices\nelement camera 1\n"
                            "property float x\nelement vertex 5\nproperty int x\n"
                            "property int y\nproperty int z\nend_header\n"
                            "9 0 1 2 3 -1 1 4 3 -1\n1.5\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 0 0\n");
  EXPECT_EQ(mesh.faces, (Eigen::Matrix3Xi(3, 3) << 0, 1, 1, 1, 3, 4, 2, 2, 3).finished());
}

TEST(MeshReaders, AnOffFileMayHavePrefixesCommentsAndColours) {
  const TriMesh mesh = read(assembly::read_off,
                            "CNOFF 3 1 # counts\n# a triangle\n0 0 0 0 0 1 255 0 0\n\n"
                            "1 0 0 0 0 1 255 0 0\n0 1 0 0 0 1 255 0 0\n3 0 1 2 0.5 0.5 0.5\n");
  EXPECT_EQ(mesh.face_count(), 1);
  EXPECT_EQ(
      read(assembly::read_off, "4OFF\n3 1 3\n0 0 0 1\n2 0 0 2\n0 1 0 1\n3 0 1 2\n").vertices.col(1),
      Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(read(assembly::read_off, "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").face_count(), 1);
}

struct Case {
  Reader reader;
  std::string bytes;
  const char* fault;
};

TEST(MeshReaders, FaultsNameTheLineOrTheByte) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
      "property float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  std::string wrong_float = binary_stl(hydro::make_box({1, 1, 1}), "");
  wrong_float.replace(84 + 50 + 12, 4, "\xff\xff\xff\xff");
  std::string cut = binary_ply(hydro::make_box({1, 1, 1}), std::endian::little);
  cut.pop_back();
  const Case cases[] = {
      {assembly::read_obj, "v 0 0 0\nv 1 0\n", "hull:2: the line ends where a number is expected"},
      {assembly::read_obj, "v 0 0 0\n\nv 1 0 O\n", "hull:3: found 'O', expected a number"},
      {assembly::read_obj, "v 0 0 1e400\n", "hull:1: vertex 1 is (0, 0, inf), expected finite"},
      {assembly::read_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n",
       "hull:4: a face names vertex 99, the file has 3 vertices, counted from 1"},
      {assembly::read_obj, "v 0 0 0\nf 1 -2 1\n",
       "hull:2: a face names vertex -2, the file has 1 vertices before it"},
      {assembly::read_obj, "v 0 0 0\nf 0 1 1\n", "hull:2: a face names vertex 0"},
      {assembly::read_obj, "v 0 0 0\nf 1 1.5 1\n", "hull:2: found '1.5', expected the corner"},
      {assembly::read_obj, "v 0 0 0 0\n", "hull:1: the weight of a vertex is 0"},
      {assembly::read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n",
       "hull:5: the file is cut short: it ends before vertex 3 of 3"},
      {assembly::read_off, "OFF\n2 1 0\n0 0 0\n1 0 0 0 0 0 0 0\n",
       "hull:5: the file is cut short: it ends before face 1 of 1"},
      {assembly::read_off, "OFF\n1000000000 1000000000 0\n0 0 0\n",
       "its head announces 1000000000 vertices, but only 6 bytes follow"},
      {assembly::read_off, "OFF\n1 1 0\n0 0 0\n3 0 0\n", "hull:4: the line ends where a whole"},
      {assembly::read_off, "OFF BINARY\n", "hull:1: a binary file of OFF is not read"},
      {assembly::read_off, "nOFF\n", "hull:1: found 'nOFF', expected OFF"},
      {assembly::read_stl,
       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
       "endloop\n",
       "hull:6: found 'endloop', expected vertex"},
      {assembly::read_stl, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
       "the file is cut short: it ends where vertex is expected"},
      {assembly::read_stl, "solid\n", "it ends where facet or endsolid is expected"},
      {assembly::read_stl, wrong_float, "hull: at byte 146: vertex 4 is ("},
      {assembly::read_stl, binary_stl(hydro::make_box({1, 1, 1}), "") + "x",
       "with 12 triangles, which it announces, it has 685 bytes, expected 684"},
      {assembly::read_ply, "plyx\n", "hull:1: the file does not begin with a line 'ply'"},
      {assembly::read_ply, "ply\nformat asci 1.0\n", "hull:2: found 'asci', expected ascii"},
      {assembly::read_ply, "ply\nproperty float x\n", "hull:2: a property comes before"},
      {assembly::read_ply, "ply\nelement vertex 3\nproperty real x\n",
       "hull:3: found 'real', expected a type"},
      {assembly::read_ply, "ply\nend_header\n", "hull:2: the head has no line 'format'"},
      {assembly::read_ply, head, "the file is cut short: its head has no end"},
      {assembly::read_ply, head + faces + "0 0 0\n3 0 0 7\n",
       "hull:11: a face names vertex 7, the file has 1 vertices, counted from 0"},
      {assembly::read_ply, head + faces + "0 0\n3 0 0 0\n",
       "hull:10: the line ends where a number"},
      {assembly::read_ply, head + faces + "0 0 0\n1000000000 0 0 0\n", "hull:11: the line ends"},
      {assembly::read_ply, head + faces + "0 0 0\n3 0 0 0.5\n", "hull:11: found 0.5, expected a"},
      {assembly::read_ply, head + faces + "0 nan 0\n3 0 0 0\n", "hull:10: vertex 0 is (0, nan, 0)"},
      {assembly::read_ply,
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n"
       "0\n",
       "the vertices have no properties x, y and z"},
      {assembly::read_ply, cut, "the file is cut short: it ends within an element"}};
  for (const Case& c : cases) EXPECT_THAT(fault_of(c.reader, c.bytes), HasSubstr(c.fault));
}

TEST(MeshReaders, AFaultComesBackFromTheReadersProcessWithItsLine) {
  const fs::path file = fs::path(testing::TempDir()) / "with_a_fault.obj";
  std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n";
  try {
    assembly::read_mesh(file);
    ADD_FAILURE() << "the file was read";
  } catch (const scene::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("with_a_fault.obj:4: a face names vertex 99"));
  }
  fs::remove(file);
}

}  // namespace

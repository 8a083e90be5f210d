#include "app/assembly/mesh_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "app/scene/diagnostics.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

namespace {

namespace fs = std::filesystem;
using hydro::TriMesh;
using support::Random;
using testing::HasSubstr;

/// A folder for the files of one test, removed with it.
class MeshIo : public testing::Test {
 protected:
  MeshIo() : folder_(fs::path(testing::TempDir()) / ("mesh_io_" + name())) {
    fs::create_directories(folder_);
  }
  ~MeshIo() override { fs::remove_all(folder_); }

  fs::path write(const std::string& file, const std::function<void(std::ostream&)>& content) const {
    std::ofstream out(folder_ / file, std::ios::binary);
    out.precision(9);
    content(out);
    return folder_ / file;
  }
  fs::path write(const std::string& file, const std::string& text) const {
    return write(file, [&](std::ostream& out) { out << text; });
  }
  const fs::path& folder() const { return folder_; }

 private:
  static std::string name() {
    return testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  fs::path folder_;
};

void write_obj(std::ostream& out, const TriMesh& mesh) {
  for (const auto& p : mesh.vertices.colwise()) out << "v " << p.transpose() << '\n';
  for (const auto& f : mesh.faces.colwise()) out << "f " << f.transpose().array() + 1 << '\n';
}

void write_off(std::ostream& out, const TriMesh& mesh) {
  out << "OFF\n" << mesh.vertex_count() << ' ' << mesh.face_count() << " 0\n";
  for (const auto& p : mesh.vertices.colwise()) out << p.transpose() << '\n';
  for (const auto& f : mesh.faces.colwise()) out << "3 " << f.transpose() << '\n';
}

void write_ply(std::ostream& out, const TriMesh& mesh) {
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertex_count()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
      << mesh.face_count() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& p : mesh.vertices.colwise()) out << p.transpose() << '\n';
  for (const auto& f : mesh.faces.colwise()) out << "3 " << f.transpose() << '\n';
}

void write_ascii_stl(std::ostream& out, const TriMesh& mesh) {
  out << "solid s\n";
  for (const auto& f : mesh.faces.colwise()) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const int v : f) out << "vertex " << mesh.vertices.col(v).transpose() << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid s\n";
}

void write_binary_stl(std::ostream& out, const TriMesh& mesh) {
  out << std::string(80, ' ');
  const auto put = [&](const auto& value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(static_cast<std::uint32_t>(mesh.face_count()));
  for (const auto& f : mesh.faces.colwise()) {
    for (int i = 0; i < 3; ++i) put(0.0f);
    for (const int v : f)
      for (const double x : mesh.vertices.col(v)) put(static_cast<float>(x));
    put(std::uint16_t{0});
  }
}

/// Message of the InputError that reading the file throws; fails the test if there is none.
std::string mesh_fault(const fs::path& file) {
  try {
    assembly::read_mesh(file);
  } catch (const scene::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string()));
    return error.what();
  }
  ADD_FAILURE() << file << " was read";
  return {};
}

fs::path bad(const std::string& file) {
  return fs::path(PLIMSOLL_SOURCE_DIR) / "tests/data/bad_meshes" / file;
}

TEST_F(MeshIo, EveryFormatGivesTheSameClosedSolid) {
  using Writer = void (*)(std::ostream&, const TriMesh&);
  const std::pair<const char*, Writer> formats[] = {{"a.obj", write_obj},
                                                    {"a.off", write_off},
                                                    {"a.ply", write_ply},
                                                    {"ascii.stl", write_ascii_stl},
                                                    {"binary.STL", write_binary_stl}};
  Random random(1);
  const TriMesh mesh = translated(support::random_star(random, 3), {2, -1, 0.5});
  const double volume = solid_properties(mesh).volume;
  for (const auto& [name, writer] : formats) {
    const TriMesh read =
        assembly::read_mesh(write(name, [&](std::ostream& out) { writer(out, mesh); }));
    EXPECT_EQ(read.face_count(), mesh.face_count()) << name;
    EXPECT_EQ(read.vertex_count(), mesh.vertex_count()) << name;
    EXPECT_TRUE(check_mesh(read).sound()) << name;
    // Each coordinate is rounded to 6e-8 of at most 3.4 m, on a surface of about 15 m^2.
    EXPECT_NEAR(solid_properties(read).volume, volume, support::tolerance(3e-6)) << name;
  }
}

TEST_F(MeshIo, CoordinatesOfATextComeAsTheNearestDoubles) {
  const fs::path file = write("a.obj", "v 0.1 100.3 -7\nv 1.1 100.3 -7\nv 0.1 1e2 -7\nf 1 2 3\n");
  EXPECT_EQ(assembly::read_mesh(file).vertices.col(0), Eigen::Vector3d(0.1, 100.3, -7));
}

TEST_F(MeshIo, PolygonsAreCutIntoTrianglesAndNormalsDoNotSplitVertices) {
  const TriMesh cube = assembly::read_mesh(
      write("quads.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
            "vn 0 0 1\nvn 1 0 0\nvn 0 1 0\n"
            "f 1//1 3//1 4//1 2//1\nf 5//1 6//1 8//1 7//1\nf 1//3 2//3 6//3 5//3\n"
            "f 3//3 7//3 8//3 4//3\nf 1//2 5//2 7//2 3//2\nf 2//2 4//2 8//2 6//2\n"));
  EXPECT_EQ(cube.vertex_count(), 8);
  EXPECT_EQ(cube.face_count(), 12);
  EXPECT_TRUE(check_mesh(cube).sound());
  EXPECT_EQ(check_mesh(cube).volume, 1);
}

TEST_F(MeshIo, GroupsArePartsOfOneMeshAndLinesAndLooseVerticesAreLeftOut) {
  const fs::path file = write("parts.obj", [](std::ostream& out) {
    out << "o first\n";
    write_obj(out, support::corner_tetrahedron({1, 1, 1}));
    out << "o second\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nv 9 9 9\n"
        << "f 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\nl 1 9\n";
  });
  const TriMesh mesh = assembly::read_mesh(file);
  EXPECT_EQ(mesh.vertex_count(), 8);
  EXPECT_EQ(mesh.face_count(), 8);
  EXPECT_TRUE(check_mesh(mesh).sound());
}

TEST_F(MeshIo, ASeamComputedTwiceIsWelded) {
  // cos and sin of 0 and of 2π differ by the round-off of π.
  const fs::path file = write("seam.obj", [](std::ostream& out) {
    const TriMesh ring = support::make_torus(1, 0.5, 8, 3);
    TriMesh open = ring;
    open.vertices.conservativeResize(3, 27);
    for (int j = 0; j < 3; ++j)
      open.vertices.col(24 + j) = ring.vertices.col(j) + Eigen::Vector3d(0, -2.4e-16, 0);
    for (Eigen::Index f = 42; f < 48; ++f)  // the last of the eight sectors
      for (int& v : open.faces.col(f))
        if (v < 3) v += 24;
    write_obj(out, open);
  });
  const assembly::MeshFile read = assembly::read_welded(file, scene::MeshFormats::common);
  EXPECT_EQ(read.mesh.vertex_count(), 24);
  EXPECT_TRUE(check_mesh(read.mesh).sound());
  EXPECT_EQ(read.dropped, 0);
  EXPECT_EQ(assembly::note_of_dropped(read), "");
}

/// Keeps the notes that it receives.
class Notes : public app::Reporter {
 public:
  void note(const std::string& message) override { all.push_back(message); }
  std::vector<std::string> all;
};

TEST_F(MeshIo, FacesThatLoseACornerAreToldOf) {
  const fs::path file = write("fin.obj", [](std::ostream& out) {
    write_obj(out, hydro::make_box(Eigen::Vector3d::Ones()));
    out << "f 1 2 2\n";
  });
  Notes notes;
  EXPECT_EQ(assembly::read_solid(file, notes).face_count(), 12);
  EXPECT_EQ(notes.all,
            std::vector<std::string>{file.string() + ": note: 1 face without area was dropped"});
}

/// A tetrahedron of edge 1 that two nodes place: one moved and turned, the other mirrored.
constexpr const char* kCollada = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.5" name="half"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="outer"><translate>10 0 0</translate>
<node id="turned"><rotate>0 0 1 90</rotate><scale>2 1 1</scale>
<instance_geometry url="#g"/></node></node>
<node id="mirrored"><scale>-1 1 1</scale><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";

TEST_F(MeshIo, NodesPlaceThePartsAndAMirroredPartStaysOutward) {
  const TriMesh mesh = assembly::read_mesh(write("nodes.dae", kCollada), scene::MeshFormats::any);
  EXPECT_EQ(mesh.face_count(), 8);
  EXPECT_TRUE(check_mesh(mesh).sound());
  // In metres: the mirrored one reaches to x = −0.5; of the other, x of length 2 points along y.
  const double rounding = support::tolerance(1e-6);  // floats of up to 5 m
  EXPECT_LE((bounding_box(mesh).min() - Eigen::Vector3d(-0.5, 0, 0)).norm(), rounding);
  EXPECT_LE((bounding_box(mesh).max() - Eigen::Vector3d(5, 1, 0.5)).norm(), rounding);
  EXPECT_NEAR(check_mesh(mesh).volume, (2 + 1) / 6.0 / 8, rounding);
}

TEST_F(MeshIo, AnAxisThatPointsUpBecomesZAndNothingIsMirrored) {
  const TriMesh mesh = translated(hydro::make_box({1, 2, 3}), {10, 20, 30});
  const fs::path file = write("a.obj", [&](std::ostream& out) { write_obj(out, mesh); });
  const std::pair<scene::UpAxis, Eigen::Vector3d> cases[] = {
      {scene::UpAxis::z, {10, 20, 30}},  {scene::UpAxis::minus_z, {10, -20, -30}},
      {scene::UpAxis::y, {10, -30, 20}}, {scene::UpAxis::minus_y, {10, 30, -20}},
      {scene::UpAxis::x, {-30, 20, 10}}, {scene::UpAxis::minus_x, {30, 20, -10}}};
  for (const auto& [up, centre] : cases) {
    const TriMesh read = assembly::read_mesh(file, scene::MeshFormats::common, {.up = up});
    EXPECT_EQ(bounding_box(read).center(), centre) << scene::name_of(up);
    // A mirrored box would be inward.
    EXPECT_NEAR(check_mesh(read).volume, 6, support::tolerance(1e-12)) << scene::name_of(up);
  }
}

TEST_F(MeshIo, UnitAndScaleMultiplyTheCoordinates) {
  const fs::path file = write("a.obj", [](std::ostream& out) {
    write_obj(out, hydro::make_box({1, 2, 3}));
  });
  for (const auto& [word, length] : scene::length_units()) {
    const TriMesh read =
        assembly::read_mesh(file, scene::MeshFormats::common, {.unit = length, .scale = 10});
    EXPECT_EQ(bounding_box(read).sizes().x(), 10 * length) << word;
  }
}

/// A tetrahedron of the edges 1, 2 and 3 along x, y and z.
constexpr const char* kFbx = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
  FBXVersion: 7400
}
GlobalSettings:  {
  Properties70:  {
    P: "UpAxis", "int", "Integer", "", 2
    P: "UpAxisSign", "int", "Integer", "", 1
    P: "FrontAxis", "int", "Integer", "", 1
    P: "FrontAxisSign", "int", "Integer", "", -1
    P: "CoordAxis", "int", "Integer", "", 0
    P: "CoordAxisSign", "int", "Integer", "", 1
    P: "UnitScaleFactor", "double", "Number", "", 2.54
  }
}
Objects:  {
  Geometry: 1, "Geometry::g", "Mesh" {
    Vertices: *12 { a: 0,0,0,1,0,0,0,2,0,0,0,3 }
    PolygonVertexIndex: *12 { a: 0,2,-2,0,1,-4,0,3,-3,1,2,-4 }
    GeometryVersion: 124
  }
  Model: 2, "Model::m", "Mesh" {
    Version: 232
  }
}
Connections:  {
  C: "OO",2,0
  C: "OO",1,2
}
)";

TEST_F(MeshIo, AFileThatNamesItsAxisAndUnitIsTurnedAndScaledUnlessTheAuthorSaysElse) {
  const auto top = [](const fs::path& file, const scene::MeshFrame& frame = {}) {
    const TriMesh mesh = assembly::read_mesh(file, scene::MeshFormats::any, frame);
    EXPECT_TRUE(check_mesh(mesh).sound()) << file;
    return Eigen::Vector3d(bounding_box(mesh).max());
  };
  const double rounding = support::tolerance(1e-6);  // that of floats of up to 3
  std::string y_up = kCollada;
  y_up.replace(y_up.find("Z_UP"), 4, "Y_UP");
  const fs::path dae = write("y.dae", y_up);
  EXPECT_LE((top(dae) - Eigen::Vector3d(5, 0, 1)).norm(), rounding);
  EXPECT_LE((top(dae, {.up = scene::UpAxis::z, .unit = 1}) - Eigen::Vector3d(10, 2, 1)).norm(),
            rounding);
  const fs::path fbx = write("z.fbx", kFbx);
  EXPECT_LE((top(fbx) - 0.0254 * Eigen::Vector3d(1, 2, 3)).norm(), rounding);
  EXPECT_LE((top(fbx, {.unit = 1}) - Eigen::Vector3d(1, 2, 3)).norm(), rounding);
  std::string below = kFbx;
  below.replace(below.find("\"\", 2") + 4, 1, "1");
  EXPECT_LE((top(write("y.fbx", below)) - 0.0254 * Eigen::Vector3d(1, 0, 2)).norm(), rounding);
}

TEST_F(MeshIo, FilesThatHoldNoMeshAreRefusedWithTheReason) {
  EXPECT_THAT(mesh_fault(folder() / "none.obj"), HasSubstr("there is no such file"));
  EXPECT_THAT(mesh_fault(folder()), HasSubstr("is not a file"));
  const std::pair<const char*, const char*> cases[] = {
      {"empty.obj", "the file is empty"},
      {"no_triangles.obj", "the file holds no triangles"},
      {"unknown.mesh_format", "no mesh format has the extension '.mesh_format'; known are .obj"},
      {"not_a_mesh.stl", "does not begin with 'solid' as text, and is too short for a binary one"},
      {"truncated.stl", "as a binary one with 12 triangles, which it announces, it has"},
      {"truncated.glb", "not a sound mesh file"},
      {"truncated.ply", "the file is cut short: its head announces 3 elements 'vertex'"},
      {"truncated_binary.ply", "at byte 409: the file is cut short: it ends before face 12 of 12"},
      {"huge_count.ply", "the file is cut short: its head announces 100000000000 elements"},
      {"huge_count.off", "the file is cut short: its head announces 100000000000 vertices"},
      {"face_without_vertices.ply", "face 1 has no vertices"},
      {"wrong_index.obj", ":5: a face names vertex 4, the file has 3 vertices, counted from 1"},
      {"wrong_index.ply", ":13: a face names vertex 7, the file has 3 vertices, counted from 0"},
      {"not_finite.obj", "is (nan, 0, 0), expected finite coordinates"},
      {"infinite.obj", "is (1e+39, 0, 0), expected finite coordinates"}};
  for (const auto& [file, reason] : cases)
    EXPECT_THAT(mesh_fault(bad(file)), HasSubstr(reason)) << file;
}

TEST_F(MeshIo, MeshesThatBoundNoSolidAreReadAndTheCheckNamesTheirFault) {
  const std::pair<const char*, const char*> cases[] = {
      {"open.obj", "3 edges are open"},
      {"inward.obj", "the normals point into the solid"},
      {"misoriented.obj", "3 edges have their two faces turned against each other"},
      {"duplicate.obj", "1 face has the same vertices as an earlier one"},
      {"crowded.obj", "1 edge has more than two faces"},
      {"degenerate.obj", "1 face has no area, at (0.5, 0, 0)"},
      {"overlapping.obj", "pairs of faces cut through each other"},
      {"counted_twice.obj", "1 closed part is turned the wrong way"},
      {"flat.obj", "the mesh encloses no volume"}};
  for (const auto& [file, sentence] : cases)
    EXPECT_THAT(describe(check_mesh(assembly::read_mesh(bad(file)))),
                testing::Contains(HasSubstr(sentence)))
        << file;
}

TEST_F(MeshIo, RandomBytesAreRefusedWhateverTheyCallThemselves) {
  Random random(2);
  for (const char* name : {"a.obj", "a.stl", "a.ply", "a.off", "a.glb", "a.gltf"}) {
    const fs::path file = write(name, [&](std::ostream& out) {
      for (int i = 0; i < 2000; ++i) out.put(static_cast<char>(random.uniform(-128, 128)));
    });
    EXPECT_FALSE(mesh_fault(file).empty());
  }
}

}  // namespace

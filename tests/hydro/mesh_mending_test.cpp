#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mending/diagnosis.h"
#include "hydro/mesh/mending/mend.h"
#include "hydro/mesh/mending/solid_union.h"
#include "hydro/mesh/mending/thicken.h"
#include "hydro/mesh/mending/turn_faces.h"
#include "hydro/mesh/region_cut.h"
#include "tests/support/tolerance.h"
#include "tests/support/wild_meshes.h"

namespace {

using Eigen::Vector3d;
using hydro::LoopShape;
using hydro::MendedMesh;
using hydro::TriMesh;
using support::box_at;
using support::Random;
using support::WildMesh;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Largest relative error of a volume: that of cracks and shifts of a millionth of the size.
constexpr double kVolume = 1e-4;

double volume(const TriMesh& mesh) { return hydro::solid_properties(mesh).volume; }

/// Box of 4 x 2 x 1 m from z = 0 up without its top.
TriMesh open_box() {
  return support::without(box_at({4, 2, 1}, {0, 0, 0.5}, 4),
                          [](const Vector3d& p) { return p.z() > 1 - 1e-9; });
}

TEST(MeshMending, EveryWildMeshBecomesASolidOfTheRightVolume) {
  for (const WildMesh& wild : support::wild_meshes()) {
    const MendedMesh mended = hydro::mended(wild.mesh, wild.options);
    EXPECT_THAT(describe(mended.report), IsEmpty()) << wild.name;
    EXPECT_THAT(mended.failures, IsEmpty()) << wild.name;
    EXPECT_NEAR(mended.report.volume / wild.volume, 1, support::tolerance(kVolume)) << wild.name;
  }
}

TEST(MeshMending, DoesNotDependOnThePose) {
  Random random(3);
  for (const WildMesh& wild : support::wild_meshes()) {
    if (wild.options.mirror) continue;  // Its plane is that of the mesh frame.
    const MendedMesh mended =
        hydro::mended(transformed(wild.mesh, support::random_pose(random, 2)), wild.options);
    EXPECT_THAT(describe(mended.report), IsEmpty()) << wild.name;
    EXPECT_NEAR(mended.report.volume / wild.volume, 1, support::tolerance(kVolume)) << wild.name;
  }
}

TEST(MeshMending, RepeatsItselfToTheLastBit) {
  for (const WildMesh& wild : support::wild_meshes())
    EXPECT_TRUE(same_mesh(hydro::mended(wild.mesh, wild.options).mesh,
                          hydro::mended(wild.mesh, wild.options).mesh))
        << wild.name;
}

TEST(MeshMending, LeavesASolidAsItIs) {
  Random random(4);
  for (const TriMesh& solid : {hydro::make_sphere(1, 30, 20), support::random_star(random, 3),
                               support::make_torus(2, 0.7, 30, 20)}) {
    const MendedMesh mended = hydro::mended(solid, {});
    EXPECT_TRUE(same_mesh(mended.mesh, solid));
    EXPECT_THAT(mended.changes, IsEmpty());
  }
}

TEST(MeshMending, SaysWhatItCouldNotDo) {
  const TriMesh box = box_at({4, 2, 1}, {0, 0, 0.5});
  EXPECT_THAT(hydro::mended(box, {.mirror = 1}).failures,
              ElementsAre(HasSubstr("lies on both sides of the plane y = 0")));
  EXPECT_THAT(hydro::mended(box, {.cap = true}).failures, ElementsAre(HasSubstr("no flat open")));
  EXPECT_THAT(hydro::mended(box, {.thickness = 0.1}).failures,
              ElementsAre(HasSubstr("no open part")));
  EXPECT_THAT(hydro::mended(box, {.unite = true}).failures, ElementsAre(HasSubstr("overlap")));
  EXPECT_THAT(hydro::mended(open_box(), {.unite = true}).failures,
              ElementsAre(HasSubstr("parts are open")));
}

TEST(MeshMending, CapsNoLoopThatIsNotFlat) {
  TriMesh mesh = open_box();
  for (auto v : mesh.vertices.colwise())
    if (v.z() == 1) v.z() += 0.02 * v.x() * v.x();  // a sheer of 80 mm in 4 m
  const hydro::MeshDiagnosis found = hydro::diagnosed(mesh);
  ASSERT_EQ(found.loops.size(), 1);
  EXPECT_EQ(found.loops[0].shape, LoopShape::bent);
  EXPECT_FALSE(hydro::mended(mesh, {.cap = true}).report.closed());
  EXPECT_FALSE(hydro::remedy_for(mesh));
}

TEST(MeshMending, AFlatPlateIsNotDoubledByACap) {
  const TriMesh plate = support::without(box_at({4, 2, 1}, {0, 0, 0.5}, 4),
                                         [](const Vector3d& p) { return p.z() < 1 - 1e-9; });
  EXPECT_THAT(hydro::mended(plate, {.cap = true}).failures, ElementsAre(HasSubstr("no flat open")));
  const MendedMesh thick = hydro::mended(plate, {.thickness = 0.01});
  EXPECT_TRUE(thick.report.sound());
  EXPECT_NEAR(thick.report.volume, 4 * 2 * 0.01, support::tolerance(1e-12));
}

TEST(MeshDiagnosis, TellsPartsLoopsAndSharedVolume) {
  const TriMesh two = support::united(open_box(), box_at({1, 1, 1}, {0, 4, 0.5}));
  const hydro::MeshDiagnosis apart = hydro::diagnosed(two);
  ASSERT_EQ(apart.parts.size(), 2);
  EXPECT_FALSE(apart.parts[0].closed);
  EXPECT_TRUE(apart.parts[1].closed);
  EXPECT_NEAR(apart.parts[1].volume, 1, support::tolerance(1e-12));
  EXPECT_NEAR(apart.parts[0].area, 8 + 8 + 4, support::tolerance(1e-12));
  ASSERT_EQ(apart.loops.size(), 1);
  EXPECT_EQ(apart.loops[0].shape, LoopShape::flat);
  EXPECT_NEAR(apart.loops[0].length, 12, support::tolerance(1e-12));
  EXPECT_NEAR(apart.loops[0].normal.z(), 1, support::tolerance(1e-12));
  const TriMesh crossing =
      support::united(box_at({4, 2, 1}, {0, 0, 0.5}), box_at({1, 1, 2}, {0.3, 0.2, 1.1}));
  const hydro::MeshDiagnosis overlapping = hydro::diagnosed(crossing);
  ASSERT_EQ(overlapping.overlaps.size(), 1);
  ASSERT_TRUE(overlapping.overlaps[0].volume);
  EXPECT_NEAR(*overlapping.overlaps[0].volume, 0.9, support::tolerance(1e-12));
}

TEST(MeshDiagnosis, TellsACrackFromAHole) {
  const hydro::MeshDiagnosis found = hydro::diagnosed(support::box_with_t_junctions());
  EXPECT_EQ(found.t_junctions, 2);
  for (const hydro::OpenLoop& loop : found.loops) EXPECT_EQ(loop.shape, LoopShape::line);
}

TEST(MeshDiagnosis, TheRemedyGivesASolidOfTheVolumeThatItTells) {
  for (const WildMesh& wild : support::wild_meshes()) {
    const std::optional<hydro::Remedy> remedy = hydro::remedy_for(wild.mesh);
    ASSERT_TRUE(remedy) << wild.name;
    const MendedMesh mended = hydro::mended(wild.mesh, remedy->options);
    EXPECT_TRUE(mended.report.sound()) << wild.name;
    EXPECT_EQ(mended.report.volume, remedy->volume) << wild.name;
  }
}

TEST(MeshDiagnosis, AHoleBesideAPlaneOfSymmetryIsNoHalf) {
  // A unit cube with a corner at the origin, without one triangle with an edge in y = 0.
  const TriMesh cube = box_at({1, 1, 1}, {0.5, 0.5, 0.5});
  for (Eigen::Index f = 0; f < cube.face_count(); ++f) {
    TriMesh holed = cube;
    holed.faces.col(f) = Eigen::Vector3i(cube.faces.rightCols(1));
    holed.faces.conservativeResize(3, cube.face_count() - 1);
    const std::optional<hydro::Remedy> remedy = hydro::remedy_for(holed);
    ASSERT_TRUE(remedy);
    EXPECT_FALSE(remedy->options.mirror);
    EXPECT_NEAR(remedy->volume, 1, support::tolerance(1e-12));
  }
}

TEST(SolidUnion, HasTheVolumeOfBoxesLessTheirCommonPart) {
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    const Vector3d a = Vector3d::Constant(2) + random.vector(1),
                   b = Vector3d::Constant(2) + random.vector(1), shift = random.vector(1.2);
    const Vector3d common = (a / 2).cwiseMin(shift + b / 2) - (-a / 2).cwiseMax(shift - b / 2);
    ASSERT_GT(common.minCoeff(), 0);
    const Eigen::Isometry3d pose = support::random_pose(random, 3);
    const std::optional<TriMesh> whole = hydro::united(
        {transformed(hydro::make_box(a, 3), pose), transformed(box_at(b, shift, 2), pose)});
    ASSERT_TRUE(whole);
    EXPECT_NEAR(volume(*whole), a.prod() + b.prod() - common.prod(), support::tolerance(1e-11));
  }
}

TEST(SolidUnion, DoesNotDependOnTheOrderAndHoldsWhatItUnites) {
  Random random(7);
  for (int i = 0; i < 6; ++i) {
    const TriMesh star =
        transformed(support::random_star(random, 2), support::random_pose(random, 0.3));
    const TriMesh torus =
        transformed(support::make_torus(1, 0.4, 24, 12), support::random_pose(random, 0.3));
    const std::optional<TriMesh> one = hydro::united({star, torus});
    const std::optional<TriMesh> other = hydro::united({torus, star});
    ASSERT_TRUE(one && other);
    EXPECT_NEAR(volume(*one), volume(*other), support::tolerance(1e-11));
    EXPECT_GT(volume(*one), std::max(volume(star), volume(torus)));
    EXPECT_LT(volume(*one), volume(star) + volume(torus));
    // Nothing is added by a mesh that is in it already.
    const std::optional<TriMesh> again =
        hydro::united({*one, hydro::scaled(hydro::make_icosphere(1, 1), 0.2)});
    ASSERT_TRUE(again);
    EXPECT_NEAR(volume(*again), volume(*one), support::tolerance(1e-12));
  }
}

TEST(SolidUnion, KeepsTheCavitiesOfASolid) {
  const TriMesh hollow =
      support::united(box_at({4, 2, 1}, {0, 0, 0}), hydro::flipped(box_at({1, 1, 0.5}, {1, 0, 0})));
  const std::optional<TriMesh> whole = hydro::united({hollow, box_at({1, 1, 2}, {-1.1, 0.1, 0.2})});
  ASSERT_TRUE(whole);
  EXPECT_NEAR(volume(*whole), 8 - 0.5 + 2 - 1, support::tolerance(1e-12));
}

TEST(Thickness, ApproachesAreaTimesThickness) {
  // A hemisphere without its lid: the inner side is smaller by the thickness over the radius.
  const TriMesh bowl =
      support::without(hydro::make_sphere(1, 40, 24), [](const Vector3d& p) { return p.z() > 0; });
  double area = 0;
  for (Eigen::Index f = 0; f < bowl.face_count(); ++f) area += area_vector(bowl, f).norm();
  for (const double t : {0.04, 0.02, 0.01}) {
    const TriMesh plate = hydro::thickened(bowl, t);
    EXPECT_TRUE(check_mesh(plate).sound());
    EXPECT_NEAR(volume(plate) / (area * t), 1 - t + t * t / 3, support::tolerance(3e-3));
  }
}

TEST(TurnFaces, AStripWithOneSideKeepsAnEdgeOnWhichFacesDisagree) {
  constexpr int kSteps = 12;
  TriMesh strip{Eigen::Matrix3Xd(3, 2 * kSteps), Eigen::Matrix3Xi(3, 2 * kSteps)};
  for (int i = 0; i < kSteps; ++i) {
    const double u = 2 * M_PI * i / kSteps;
    for (const int side : {0, 1}) {
      const double off = side == 0 ? -0.3 : 0.3;
      strip.vertices.col(2 * i + side) << (1 + off * std::cos(u / 2)) * std::cos(u),
          (1 + off * std::cos(u / 2)) * std::sin(u), off * std::sin(u / 2);
    }
    const bool last = i == kSteps - 1;
    const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
    strip.faces.col(2 * i) << a, c, b;
    strip.faces.col(2 * i + 1) << b, c, d;
  }
  EXPECT_EQ(check_mesh(hydro::turned_consistently(strip)).misoriented_edges.count, 1);
}

TEST(RegionCut, CoversTheOutlineLessTheHoles) {
  Random random(8);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Isometry3d pose = support::random_pose(random, 2);
    std::vector<Vector3d> vertices;
    const auto ring = [&](const Vector3d& middle, double radius, int corners, bool clockwise) {
      std::vector<int> line;
      for (int k = 0; k < corners; ++k) {
        const double u = (clockwise ? -2 : 2) * M_PI * k / corners;
        const double r = radius * random.uniform(0.7, 1.0);
        line.push_back(static_cast<int>(vertices.size()));
        vertices.emplace_back(pose * (middle + r * Vector3d(std::cos(u), std::sin(u), 0)));
      }
      return line;
    };
    const std::vector<int> outline = ring({0, 0, 0}, 5, 40, false);
    std::vector<std::vector<int>> holes;
    for (const Vector3d& middle :
         {Vector3d(1.5, 0.2, 0), Vector3d(-1.4, -1, 0), Vector3d(-1, 1.5, 0)})
      holes.push_back(ring(middle, 0.9, 15, true));
    const Vector3d normal = pose.linear().col(2);
    const auto area = [&](const std::vector<int>& line) {
      Vector3d sum = Vector3d::Zero();
      for (std::size_t k = 0; k < line.size(); ++k)
        sum += vertices[line[k]].cross(vertices[line[(k + 1) % line.size()]]) / 2;
      return sum.dot(normal);
    };
    double expected = area(outline), covered = 0;
    for (const auto& hole : holes) expected += area(hole);
    std::vector<Eigen::Vector3i> faces;
    hydro::cut_region(vertices, outline, holes, normal, faces);
    for (const Eigen::Vector3i& f : faces) {
      const double part = area({f[0], f[1], f[2]});
      EXPECT_GT(part, 0);
      covered += part;
    }
    EXPECT_EQ(faces.size(), 40 + 3 * 15 + 2 * 3 - 2);
    EXPECT_NEAR(covered, expected, support::tolerance(1e-12));
  }
}

}  // namespace

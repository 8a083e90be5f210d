#include "app/render/shaded_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/airy_waves.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/render/pictures.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Index;
using Eigen::Vector3d;
using hydro::TriMesh;

TEST(ShadedMesh, KeepsTheEdgesOfABoxSharp) {
  const render::ShadedMesh skin = render::make_shaded_mesh(hydro::make_box({1, 2, 3}, 2));
  for (const auto n : skin.normals.colwise())
    EXPECT_NEAR(n.cwiseAbs().maxCoeff(), 1, support::tolerance(1e-15));
  // Six sides of nine vertices each.
  EXPECT_EQ(skin.vertices.cols(), 54);
}

TEST(ShadedMesh, MakesABallSmooth) {
  const TriMesh ball = hydro::make_icosphere(2, 3);
  const render::ShadedMesh skin = render::make_shaded_mesh(ball);
  EXPECT_EQ(skin.vertices.cols(), ball.vertex_count());
  for (Index i = 0; i < skin.vertices.cols(); ++i) {
    // Faces of 642 vertices see each other under 8 degrees; their mean is off by far less.
    const double cosine = skin.normals.col(i).dot(skin.vertices.col(i).normalized());
    EXPECT_GT(cosine, std::cos(support::tolerance(0.02)));
  }
}

TEST(ShadedMesh, KeepsTheRimOfACylinderSharpAndItsSideSmooth) {
  const render::ShadedMesh skin = render::make_shaded_mesh(hydro::make_cylinder(1, 2, 24, 2));
  for (Index i = 0; i < skin.vertices.cols(); ++i) {
    const Vector3d n = skin.normals.col(i);
    const Vector3d out = Vector3d(skin.vertices(0, i), skin.vertices(1, i), 0).normalized();
    const bool on_cap = std::abs(n.z()) > 1 - 1e-12;
    // A rim vertex between two panels of the side leans to the one with more triangles there by at
    // most a sixth of the 15 degrees between them.
    EXPECT_TRUE(on_cap || n.dot(out) > std::cos(0.05)) << i;
  }
}

TEST(ShadedMesh, OfAFaceWithoutAreaHasUnitNormals) {
  TriMesh mesh;
  mesh.vertices.resize(3, 3);
  mesh.vertices << 0, 1, 2, 0, 0, 0, 0, 0, 0;
  mesh.faces.resize(3, 1);
  mesh.faces << 0, 1, 2;
  const render::ShadedMesh skin = render::make_shaded_mesh(mesh);
  for (const auto n : skin.normals.colwise()) EXPECT_DOUBLE_EQ(n.norm(), 1);
}

TEST(Subdivided, IsTheSameClosedSurfaceWithShortEdges) {
  const TriMesh torus = pictures::make_torus(1, 0.35, 11, 6);
  const hydro::SolidProperties before = hydro::solid_properties(torus);
  for (const double longest : {0.4, 0.13, 0.05}) {
    const TriMesh fine = render::subdivided(torus, longest, 1e6);
    EXPECT_LE(longest_edge(fine), longest);
    // The volume by the divergence theorem: a gap or a face turned over would change it, and its
    // place would depend on the origin.
    const hydro::SolidProperties after =
        hydro::solid_properties(hydro::translated(fine, {7, 8, 9}));
    EXPECT_NEAR(after.volume, before.volume, support::tolerance(1e-12 * before.volume * 1e3));
    EXPECT_LT((after.centroid - before.centroid - Vector3d(7, 8, 9)).norm(),
              support::tolerance(1e-10));
    EXPECT_EQ(fine.vertex_count() - fine.face_count() / 2, 0) << "Euler: V - F/2 = 0 for a ring";
  }
}

TEST(Subdivided, StaysWithinTheFacesGranted) {
  const TriMesh box = hydro::make_box({10, 10, 10});
  const TriMesh fine = render::subdivided(box, 1e-3, 20'000);
  EXPECT_LE(fine.face_count(), 20'000);
  EXPECT_GT(fine.face_count(), 2'000);
}

TEST(StraightEdge, IsShortInShortWavesAndInfiniteOnStillWater) {
  hydro::Sea sea;
  EXPECT_TRUE(std::isinf(render::longest_straight_edge(sea, 1e-3)));
  const auto in_waves = [&](double wavelength) {
    sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.2, wavelength, 0, 0, 9.81)}};
    return render::longest_straight_edge(sea, 1e-3);
  };
  const double edge = in_waves(8);
  EXPECT_NEAR(in_waves(4), edge / 2, support::tolerance(1e-9));
  // For one wave: sqrt(2) a (1 - cos(k L / 2)) is the sag.
  EXPECT_NEAR(std::sqrt(2) * 0.2 * (1 - std::cos(M_PI / 8 * edge)), 1e-3,
              support::tolerance(1e-12));
  EXPECT_TRUE(std::isinf([&] {
    sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(1e-4, 3, 0, 0, 9.81)}};
    return render::longest_straight_edge(sea, 1e-3);
  }()));
}

TEST(Creases, AreTheEdgesAtWhichASurfaceIsSharpOrEnds) {
  EXPECT_EQ(render::creases_of(hydro::make_box({1, 2, 3}, 3)).cols(), 12 * 3);  // no diagonals
  EXPECT_EQ(render::creases_of(hydro::make_sphere(1, 24, 12)).cols(), 0);
  hydro::TriMesh sheet;
  sheet.vertices = Eigen::Matrix3Xd(3, 4);
  sheet.vertices << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  sheet.faces = Eigen::Matrix3Xi(3, 2);
  sheet.faces << 0, 0, 1, 2, 2, 3;
  EXPECT_EQ(render::creases_of(sheet).cols(), 4);
}

}  // namespace

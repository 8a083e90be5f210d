#include "hydro/added_mass/water_entry.h"

#include <gtest/gtest.h>

#include "hydro/added_mass/surface_added_mass.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/tolerance.h"
#include "tests/support/water_planes.h"

namespace hydro {
namespace {

using Eigen::Vector3d;
using support::plane_at;
using support::tolerance;

/// A prism along x whose section is a wedge of half-breadth 1 under a wall of the same height.
TriMesh wedge(double deadrise, double length) {
  const double keel = -std::tan(deadrise);
  const std::array<Eigen::Vector2d, 5> section{
      Eigen::Vector2d(0, keel), {1, 0}, {1, 1}, {-1, 1}, {-1, 0}};
  TriMesh mesh;
  mesh.vertices.resize(3, 10);
  for (int i = 0; i < 5; ++i)
    for (const int end : {0, 1})
      mesh.vertices.col(i + 5 * end) << (end - 0.5) * length, section[i].x(), section[i].y();
  std::vector<Eigen::Vector3i> faces;
  for (int i = 0; i < 5; ++i) {
    const int j = (i + 1) % 5;
    faces.push_back({i, i + 5, j});
    faces.push_back({j, i + 5, j + 5});
  }
  for (int i = 1; i < 4; ++i) {
    faces.push_back({0, i, i + 1});
    faces.push_back({5, 5 + i + 1, 5 + i});
  }
  mesh.faces.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t i = 0; i < faces.size(); ++i)
    mesh.faces.col(static_cast<Eigen::Index>(i)) = faces[i];
  if (wetted_volume(mesh, {}) < 0) mesh.faces.row(1).swap(mesh.faces.row(2));
  return mesh;
}

TEST(WaterEntry, MeasuresWhatThePlaneCuts) {
  const TriMesh mesh = wedge(0.5, 6);
  const Waterplane cut = waterplane(mesh, plane_at(mesh, Vector3d::UnitZ(), 0.2));
  const double depth = 0.2 * (1 + std::tan(0.5)), half = depth / std::tan(0.5);
  EXPECT_NEAR(cut.draught, depth, tolerance(1e-12));
  EXPECT_NEAR(cut.area, 2 * half * 6, tolerance(1e-12));
  EXPECT_NEAR(cut.perimeter, 2 * (2 * half + 6), tolerance(1e-12));
  EXPECT_NEAR(cut.volume, half * depth * 6, tolerance(1e-12));
}

// Wagner's values in the limit of small deadrise.
TEST(WaterEntry, RisesAsWagnerFound) {
  const TriMesh plate = wedge(1e-4, 4000), ball = make_icosphere(1, 6);
  EXPECT_NEAR(rise_at_entry(waterplane(plate, {Vector3d::UnitZ(), -5e-5})), M_PI / 2 - 1,
              tolerance(1e-3));
  // A cap of 0.2 % of the radius is one of few faces.
  EXPECT_NEAR(rise_at_entry(waterplane(ball, {Vector3d::UnitZ(), -0.998})), 0.5, tolerance(0.05));
}

TEST(WaterEntry, RaisesNoWaterAtWallsAndSteepSides) {
  const TriMesh box = make_box({4, 2, 1}, 1);
  EXPECT_EQ(rise_at_entry(waterplane(box, {Vector3d::UnitZ(), 0})), 0);
  EXPECT_EQ(rise_at_entry(waterplane(wedge(1.35, 4), {Vector3d::UnitZ(), -0.5})), 0);
  EXPECT_EQ(rise_at_entry(waterplane(box, {})), 0);
  EXPECT_EQ(rise_at_entry(waterplane(box, {Vector3d::UnitZ(), -2})), 0);
}

/// Rate of A_33 with draught under a level body whose lowest point is at the depth h, for ρ = 1:
/// force at constant speed over V².
double rate(const SurfaceAddedMass& model, double lowest, double h) {
  const auto heave = [&](double depth) {
    return model.under({Vector3d::UnitZ(), lowest + depth})(2, 2);
  };
  const double d = 0.1 * h;
  return (heave(h + d) - heave(h - d)) / (2 * d);
}

// Similarity solutions of Zhao and Faltinsen (1993): 14.14 and 214 ρ V³ t a length. Ends leave a
// prism of 40 half-breadths less by some 2 %.
TEST(WaterEntry, OfAWedgeHasTheForceOfTheSimilaritySolution) {
  for (const auto& [degrees, wanted] : {std::pair(30.0, 14.14), std::pair(10.0, 214.0)}) {
    const double deadrise = degrees * M_PI / 180, length = 20;
    const SurfaceAddedMass model(wedge(deadrise, length));
    for (const double half : {0.02, 0.1, 0.25}) {
      const double h = half * std::tan(deadrise);
      EXPECT_NEAR(rate(model, -std::tan(deadrise), h) / (length * h), wanted,
                  tolerance(0.15 * wanted))
          << degrees << "°, half-breadth " << half;
    }
  }
}

// Slamming coefficients F/(½ρπR²V²) by Miloh (1991).
TEST(WaterEntry, OfASphereHasTheForceOfTheory) {
  const SurfaceAddedMass model(make_icosphere(1, 5));
  for (const auto& [h, wanted] :
       {std::pair(0.02, 0.68), std::pair(0.1, 1.19), std::pair(0.2, 1.24)})
    EXPECT_NEAR(rate(model, -1, h) / (M_PI / 2), wanted, tolerance(0.15 * wanted)) << h;
}

}  // namespace
}  // namespace hydro

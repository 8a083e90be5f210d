#include "hydro/added_mass/water_entry.h"

#include <gtest/gtest.h>

#include "hydro/added_mass/surface_added_mass.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"
#include "tests/support/water_planes.h"

namespace hydro {
namespace {

using Eigen::Vector3d;
using support::plane_at;
using support::tolerance;
using support::wedge;

TEST(WaterEntry, MeasuresWhatThePlaneCuts) {
  const TriMesh mesh = wedge(0.5, 6);
  const SurfaceCut cut = surface_cut(mesh, plane_at(mesh, Vector3d::UnitZ(), 0.2));
  const double depth = 0.2 * (1 + std::tan(0.5)), half = depth / std::tan(0.5);
  EXPECT_NEAR(cut.draught, depth, tolerance(1e-12));
  EXPECT_NEAR(cut.area, 2 * half * 6, tolerance(1e-12));
  EXPECT_NEAR(cut.perimeter, 2 * (2 * half + 6), tolerance(1e-12));
  EXPECT_NEAR(cut.volume, half * depth * 6, tolerance(1e-12));
}

// Wagner's values in the limit of small deadrise.
TEST(WaterEntry, RisesAsWagnerFound) {
  const TriMesh plate = wedge(1e-4, 4000), ball = make_icosphere(1, 6);
  EXPECT_NEAR(rise_at_entry(surface_cut(plate, {Vector3d::UnitZ(), -5e-5})), M_PI / 2 - 1,
              tolerance(1e-3));
  // A cap of 0.2 % of the radius is one of few faces.
  EXPECT_NEAR(rise_at_entry(surface_cut(ball, {Vector3d::UnitZ(), -0.998})), 0.5, tolerance(0.05));
}

TEST(WaterEntry, RaisesNoWaterAtWallsAndSteepSides) {
  const TriMesh box = make_box({4, 2, 1}, 1);
  EXPECT_EQ(rise_at_entry(surface_cut(box, {Vector3d::UnitZ(), 0})), 0);
  EXPECT_EQ(rise_at_entry(surface_cut(wedge(1.35, 4), {Vector3d::UnitZ(), -0.5})), 0);
  EXPECT_EQ(rise_at_entry(surface_cut(box, {})), 0);
  EXPECT_EQ(rise_at_entry(surface_cut(box, {Vector3d::UnitZ(), -2})), 0);
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

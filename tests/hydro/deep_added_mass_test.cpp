#include "hydro/added_mass/deep_added_mass.h"

#include <gtest/gtest.h>

#include "hydro/added_mass/surface_cut.h"
#include "hydro/added_mass/surface_solve.h"
#include "hydro/airy_waves.h"
#include "hydro/decompositions.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/repeats.h"
#include "tests/support/tolerance.h"
#include "tests/support/water_planes.h"

namespace hydro {
namespace {

using Eigen::Vector3d;
using support::plane_at;
using support::tolerance;

/// A body with its two models, of coarse potentials: what is tested holds for any.
struct Modelled {
  explicit Modelled(TriMesh of)
      : mesh(translated(of, -solid_properties(of).centroid)),
        solution(solve_added_mass(mesh, {.tolerance = 1e3})),
        share(mesh, solution),
        deep(mesh, solution) {}

  TriMesh mesh;
  AddedMassSolution solution;
  WettedAddedMass share;
  DeepAddedMass deep;
};

/// The state in which level water at z = 0 is the plane.
BodyState under(const WaterPlane& plane) {
  return {.position = {0, 0, -plane.height},
          .orientation = Eigen::Quaterniond::FromTwoVectors(plane.up, Vector3d::UnitZ())};
}

double immersed(const TriMesh& mesh, const WaterPlane& plane) {
  return wetted_volume(mesh, plane) / wetted_volume(mesh, {});
}

double along(const Matrix6d& A, const Vector3d& up) { return up.dot(A.topLeftCorner<3, 3>() * up); }

TEST(SurfaceCut, IsThatOfThePlainSum) {
  support::Random random(3);
  for (const TriMesh& mesh :
       {make_icosphere(1, 4), make_box({3, 2, 1}, 1), support::make_torus(2, 0.4, 40, 20),
        support::random_star(random, 3)}) {
    const kernel::Panels panels = kernel::make_panels(mesh);
    const kernel::Tree tree = kernel::make_tree(panels);
    for (int i = 0; i < support::repeats(20); ++i) {
      const WaterPlane plane = plane_at(mesh, random.vector(1).normalized(), random.uniform(0, 1));
      const SurfaceCut plain = surface_cut(mesh, plane);
      const SurfaceCut cut = kernel::surface_cut(panels, tree, plane);
      const double size = bounding_box(mesh).sizes().norm();
      EXPECT_NEAR(cut.volume, plain.volume, tolerance(1e-12) * std::pow(size, 3));
      EXPECT_NEAR(cut.area, plain.area, tolerance(1e-12) * size * size);
      EXPECT_NEAR(cut.perimeter, plain.perimeter, tolerance(1e-12) * 100 * size);
    }
  }
}

// Power laws all the way: a cone and a wedge by their tips, a box by its face.
TEST(SurfaceCut, HasTheDraughtOfItsMoments) {
  const auto cut = [](const TriMesh& mesh, const WaterPlane& plane) {
    const kernel::Panels panels = kernel::make_panels(mesh);
    return kernel::surface_cut(panels, kernel::make_tree(panels), plane);
  };
  const TriMesh box = make_box({2, 2, 2});
  EXPECT_NEAR(cut(box, {Vector3d::UnitZ(), -0.4}).draught, 0.6, tolerance(1e-12));
  const Vector3d edge = Vector3d(0, 1, 1).normalized(), corner = Vector3d(1, 1, 1).normalized();
  EXPECT_NEAR(cut(box, {edge, -1}).draught, std::sqrt(2) - 1, tolerance(1e-12));
  EXPECT_NEAR(cut(box, {corner, -1}).draught, std::sqrt(3) - 1, tolerance(1e-12));
}

// An edge in the surface belongs to the waterplane's outline, from whichever side it is reached.
TEST(SurfaceCut, CountsEdgesThatLieInTheSurface) {
  const TriMesh box = make_box({4, 2, 2}, 2);
  const kernel::Panels panels = kernel::make_panels(box);
  const kernel::Tree tree = kernel::make_tree(panels);
  for (const double height : {-1e-9, 0.0, 1e-9})
    EXPECT_NEAR(kernel::surface_cut(panels, tree, {Vector3d::UnitZ(), height}).perimeter, 12,
                tolerance(1e-12));
}

TEST(DeepAddedMass, IsTheShareFromHalfTheVolumeOnAndNeverMore) {
  support::Random random(5);
  const Modelled body(support::random_star(random, 2));
  for (int i = 0; i < support::repeats(40); ++i) {
    const WaterPlane plane =
        plane_at(body.mesh, random.vector(1).normalized(), random.uniform(0, 1.2));
    const BodyState state = under(plane);
    const Matrix6d A = body.deep.at(state, {}, 0), whole = body.share.at(state, {}, 0);
    EXPECT_EQ(A, A.transpose());
    EXPECT_GE(eigenvalues(Matrix6d(whole - A))[0], -tolerance(1e-12) * whole.norm());
    const double part = immersed(body.mesh, plane);
    if (part > 0.5) {
      EXPECT_EQ(A, whole);
    } else if (part > 0.01 && part < 0.45) {
      EXPECT_LT(along(A, plane.up), along(whole, plane.up));
    }
  }
}

// Poses a millionth of the height apart, also where vertices cross the surface.
TEST(DeepAddedMass, HasNoJumps) {
  support::Random random(6);
  const Modelled body(support::random_star(random, 1));
  const double size = body.deep.whole().topLeftCorner<3, 3>().norm();
  for (int i = 0; i < support::repeats(4); ++i) {
    const Vector3d up = random.vector(1).normalized();
    const double step = 1e-6;
    for (Eigen::Index vertex = 0; vertex < body.mesh.vertices.cols(); ++vertex) {
      const double height = up.dot(body.mesh.vertices.col(vertex));
      const auto at = [&](double h) { return body.deep.at(under({up, h}), {.density = 1}, 0); };
      // The steepest growth is that of the first tip, and of outlines that grow about saddles.
      const Matrix6d change = at(height + step) - at(height - step);
      EXPECT_LT((change.topLeftCorner<3, 3>().norm()), 2e-4 * size);
    }
  }
}

/// Rate of A_33 with draught: force at constant speed over ρV².
double rate(const Modelled& body, double h) {
  const double lowest = body.mesh.vertices.row(2).minCoeff();
  const auto heave = [&](double depth) {
    return body.deep.at(under({Vector3d::UnitZ(), lowest + depth}), {.density = 1}, 0)(2, 2);
  };
  const double d = 0.1 * h;
  return (heave(h + d) - heave(h - d)) / (2 * d);
}

// Similarity solutions of Zhao and Faltinsen (1993): 14.14 and 214 ρ V³ t a length.
TEST(DeepAddedMass, OfAWedgeHasTheForceOfTheSimilaritySolution) {
  for (const auto& [degrees, wanted] : {std::pair(30.0, 14.14), std::pair(10.0, 214.0)}) {
    const double deadrise = degrees * M_PI / 180, length = 20;
    const Modelled body(support::wedge(deadrise, length));
    for (const double half : {0.02, 0.1, 0.25}) {
      const double h = half * std::tan(deadrise);
      EXPECT_NEAR(rate(body, h) / (length * h), wanted, tolerance(0.15 * wanted))
          << degrees << "°, half-breadth " << half;
    }
  }
}

// Slamming coefficients F/(½ρπR²V²) by Miloh (1991).
TEST(DeepAddedMass, OfASphereHasTheForceOfTheory) {
  const Modelled body(make_icosphere(1, 4));
  for (const auto& [h, wanted] :
       {std::pair(0.02, 0.68), std::pair(0.1, 1.19), std::pair(0.2, 1.24)})
    EXPECT_NEAR(rate(body, h) / (M_PI / 2), wanted, tolerance(0.15 * wanted)) << h;
}

// Heave of a barge, a crate and a buoy against the solution under a surface that gives way, of
// which the share alone is 16, 15 and 58 % off.
TEST(DeepAddedMass, OfAFloatIsNearThatOfASurfaceThatGivesWay) {
  const Vector3d up = Vector3d::UnitZ();
  for (const auto& [mesh, off] :
       {std::pair(make_box({4, 2, 1}, 4), 0.06), std::pair(make_box({1, 1, 1}, 4), 0.1),
        std::pair(make_icosphere(1, 3), 0.37)}) {
    const Modelled body(mesh);
    for (const double v : {0.1, 0.2, 0.3, 0.4}) {
      double low = -1, high = 0;
      for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (immersed(body.mesh, {up, middle}) < v ? low : high) = middle;
      }
      const double solved = solve_under(body.mesh, {up, high}).matrix(2, 2);
      const double heave = body.deep.at(under({up, high}), {.density = 1}, 0)(2, 2);
      EXPECT_NEAR(heave, solved, tolerance(off) * solved) << v;
      const double share = body.share.at(under({up, high}), {.density = 1}, 0)(2, 2);
      EXPECT_LE(std::abs(heave - solved), std::abs(share - solved)) << v;
    }
  }
}

// A flat face is felt at once, as a plate; half of a square plate has 0.2274 ρ L³.
TEST(DeepAddedMass, OfAFlatBottomIsThatOfAPlate) {
  const Modelled body(make_box({1, 1, 1}, 4));
  const double heave = body.deep.at(under({Vector3d::UnitZ(), -0.4999}), {.density = 1}, 0)(2, 2);
  EXPECT_NEAR(heave, 0.2274, tolerance(0.08 * 0.2274));
}

/// As in wetted_added_mass_test.cpp: the sea turned with the body about the y axis.
TEST(DeepAddedMass, InASeaThatSlopesAsAPlaneIsThatOfTheTurnedBody) {
  support::Random random(7);
  const Modelled body(support::random_star(random, 1));
  const double angle = 0.3;
  Eigen::MatrixXd heights(2, 2);
  heights << -10, 10, -10, 10;
  Sea sloping;
  sloping.surface = make_height_field(std::tan(angle) * heights, 20, {-10, -10});
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(-angle, Vector3d::UnitY()));
  for (int k = 0; k < support::repeats(8); ++k) {
    const BodyState flat = {.position = {0.1, -0.2, random.uniform(0, 0.8)},
                            .orientation = random.rotation()};
    const BodyState turned = {.position = turn * flat.position,
                              .orientation = turn * flat.orientation};
    const Matrix6d A = body.deep.at(flat, {}, 0);
    EXPECT_LT((A - body.deep.at(turned, sloping, 0)).norm(), tolerance(1e-11) * A.norm());
  }
}

TEST(DeepAddedMass, InAUniformFlowIsLoadedByItsAcceleration) {
  support::Random random(8);
  Sea sea;
  sea.surface = WaveSurface{{linear_wave(sea, 2, 1e-5, 0.4, 0.3)}};
  const Modelled body(support::random_star(random, 1));
  for (const double z : {-1.8, 0.0, 0.4, 0.8}) {
    const BodyState state{.position = {0, 0, surface_height(sea, 0, 0, 0) + z},
                          .orientation = random.rotation()};
    const Vector3d u = water_at(sea, state.position, 0).acceleration;
    const Vector6d A_u =
        body.deep.at(state, sea, 0).leftCols<3>() * (state.orientation.conjugate() * u);
    const Wrench load = body.deep.wave_load(state, sea, 0);
    EXPECT_LT((load.force - state.orientation * A_u.head<3>()).norm(), 1e-4 * A_u.norm()) << z;
    EXPECT_LT((load.moment - state.orientation * A_u.tail<3>()).norm(), 1e-4 * A_u.norm()) << z;
  }
}

}  // namespace
}  // namespace hydro

#include <gtest/gtest.h>

#include <numbers>

#include "hydro/bem/compressed.h"
#include "hydro/bem/dense.h"
#include "hydro/bem/galerkin.h"
#include "hydro/bem/pair.h"
#include "hydro/bem/quadrature.h"
#include "hydro/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::TriMesh;
using support::tolerance;
namespace bem = hydro::bem;

/// ∫ f dS by splitting each edge of the element in `parts`.
template <class Function>
double integral(const bem::Element& element, int parts, Function f) {
  double sum = 0;
  const Vector3d u = (element.corners[1] - element.corners[0]) / parts;
  const Vector3d v = (element.corners[2] - element.corners[0]) / parts;
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; i + j < parts; ++j) {
      const Vector3d a = element.corners[0] + i * u + j * v;
      for (const bem::Node& node : bem::rule_of_degree_5()) {
        const double weight = node.weight * element.area / (parts * parts);
        sum += weight * f(bem::point({a, a + u, a + v}, node));
        if (i + j + 1 < parts) sum += weight * f(bem::point({a + u + v, a + v, a + u}, node));
      }
    }
  }
  return sum;
}

bem::Element random_element(support::Random& random, const Vector3d& at) {
  return bem::make_element(at + random.vector(1), at + random.vector(1), at + random.vector(1));
}

TEST(ElementPotentials, AreTheIntegralsTheyStandFor) {
  support::Random random(3);
  for (int k = 0; k < 10; ++k) {
    const bem::Element element = random_element(random, Vector3d::Zero());
    const Vector3d x = random.vector(1) + 1.5 * element.normal;
    const bem::Potentials seen = bem::potentials(element, x);
    const auto check = [&](double value, auto f) {
      // The rule's error is of order 6 in a 30th of the element.
      EXPECT_NEAR(value, integral(element, 30, f), tolerance(1e-9));
    };
    check(seen.single, [&](const Vector3d& y) { return 1 / (y - x).norm(); });
    check(seen.solid_angle, [&](const Vector3d& y) {
      return element.normal.dot(y - x) / std::pow((y - x).norm(), 3);
    });
    for (int i = 0; i < 3; ++i) {
      check(seen.first[i], [&](const Vector3d& y) { return (y - x)[i] / (y - x).norm(); });
      const Vector3d flat = Vector3d::Unit(i) - element.normal[i] * element.normal;
      check(seen.attraction[i],
            [&](const Vector3d& y) { return flat.dot(y - x) / std::pow((y - x).norm(), 3); });
    }
  }
}

TEST(SolidAngles, OfAClosedSurfaceAddUp) {
  support::Random random(4);
  const TriMesh mesh = support::random_star(random);
  const std::vector<bem::Element> elements = bem::make_elements(mesh);
  const auto sum = [&](const Vector3d& x) {
    double whole = 0;
    for (const bem::Element& element : elements) whole += bem::solid_angle(element, x);
    return whole / (4 * std::numbers::pi);
  };
  EXPECT_NEAR(sum(random.vector(0.3)), 1, tolerance(1e-12));
  EXPECT_NEAR(sum({2, 0.1, -0.3}), 0, tolerance(1e-12));
  for (const bem::Element& element : elements)
    EXPECT_NEAR(sum(element.centroid), 0.5, tolerance(1e-12));
}

TEST(PairIntegrals, OfAnElementWithItselfAreTheClosedForm) {
  support::Random random(5);
  const bem::Element a = random_element(random, Vector3d::Zero());
  double graded = 0;
  for (std::size_t e = 0; e < 3; ++e) {
    const std::array<Vector3d, 3> piece = {a.corners[e], a.corners[(e + 1) % 3], a.centroid};
    for (const bem::Node& node : bem::rule_at_edge()) {
      const double area =
          0.5 * (piece[1] - piece[0]).cross(piece[2] - piece[0]).norm() * node.weight;
      graded += area * bem::potentials(a, bem::point(piece, node)).single;
    }
  }
  // What 36 points leave of the logarithm along the edges.
  EXPECT_NEAR(bem::pair_integrals(a, a, {0, 1, 2}).single, graded, tolerance(2e-5) * graded);
}

TEST(PairIntegrals, DoNotDependOnTheOrder) {
  const Vector3d p(0, 0, 0), q(1, 0, 0), r(0.3, 0.8, 0), s(0.5, -0.2, 0.9), t(-0.5, -0.9, 0.1);
  const bem::Element a = bem::make_element(p, q, r), edge = bem::make_element(q, p, s),
                     corner = bem::make_element(p, t, {-1, 0.1, 0}),
                     near = hydro::bem::make_element(p + 0.1 * s, r + 0.1 * s, q + 0.1 * s);
  const auto check = [&](const bem::Element& b, std::array<int, 3> ab, std::array<int, 3> ba) {
    const bem::PairIntegrals one = bem::pair_integrals(a, b, ab);
    const bem::PairIntegrals other = bem::pair_integrals(b, a, ba);
    EXPECT_NEAR(one.single, other.single, tolerance(1e-4) * one.single);
    EXPECT_LT((one.first - other.second).norm(), tolerance(1e-4) * one.single);
  };
  check(edge, {1, 0, -1}, {1, 0, -1});
  check(corner, {0, -1, -1}, {0, -1, -1});
  check(near, {-1, -1, -1}, {-1, -1, -1});
}

TEST(PairIntegrals, OfDistantElementsKeepTheirBound) {
  support::Random random(6);
  for (int k = 0; k < 200; ++k) {
    const bem::Element a = random_element(random, Vector3d::Zero());
    const bem::Element b = random_element(random, Vector3d::Zero());
    for (const double reach : {bem::kNear, bem::kFar}) {
      const Vector3d away = random.rotation() * Vector3d::UnitX();
      const Vector3d shift = a.centroid - b.centroid + 1.001 * reach * (a.radius + b.radius) * away;
      const bem::Element moved =
          bem::make_element(b.corners[0] + shift, b.corners[1] + shift, b.corners[2] + shift);
      const double exact =
          integral(a, 4, [&](const Vector3d& x) { return bem::potentials(moved, x).single; });
      EXPECT_NEAR(bem::pair_integrals(a, moved, {-1, -1, -1}).single, exact,
                  tolerance(bem::kFarError) * exact);
    }
  }
}

TEST(Split, KeepsSurfaceAndConformity) {
  support::Random random(7);
  const TriMesh mesh = support::random_star(random, 1);
  std::vector<int> parent(static_cast<std::size_t>(mesh.face_count()));
  for (std::size_t f = 0; f < parent.size(); ++f) parent[f] = static_cast<int>(f);
  bem::Split split{mesh, parent};
  for (int round = 0; round < 3; ++round) {
    const bem::Edges edges = bem::edges_of(split.mesh);
    std::vector<bool> marked(edges.faces.size());
    for (std::size_t e = 0; e < marked.size(); ++e) marked[e] = random.uniform(0, 1) < 0.4;
    split = bem::bisected(split, edges, marked);
  }
  // Each edge has its two faces, or edges_of would miss sides.
  const bem::Edges edges = bem::edges_of(split.mesh);
  EXPECT_EQ(2 * edges.faces.size(), 3 * split.parent.size());
  std::vector<Vector3d> areas(parent.size(), Vector3d::Zero());
  for (std::size_t f = 0; f < split.parent.size(); ++f)
    areas[static_cast<std::size_t>(split.parent[f])] +=
        hydro::area_vector(split.mesh, static_cast<Eigen::Index>(f));
  for (std::size_t f = 0; f < areas.size(); ++f)
    EXPECT_LT((areas[f] - hydro::area_vector(mesh, static_cast<Eigen::Index>(f))).norm(),
              tolerance(1e-14));
}

TEST(CompressedInteractions, AreThoseStored) {
  const TriMesh mesh = hydro::make_box({3, 2, 1}, 12);
  const std::vector<bem::Element> elements = bem::make_elements(mesh);
  const bem::DenseInteractions dense = bem::dense_interactions(mesh, elements);
  const bem::CompressedInteractions compressed(mesh, elements);
  support::Random random(8);
  bem::Columns densities(mesh.face_count(), 5);
  for (Eigen::Index i = 0; i < densities.size(); ++i) densities.data()[i] = random.uniform(0, 1);
  const bem::Columns exact = dense.single * densities;
  EXPECT_LT((compressed.apply(densities) - exact).norm(), tolerance(2e-4) * exact.norm());
  double worst = 0, size = 0;
  for (std::size_t f = 0; f < elements.size(); ++f) {
    worst = std::max(worst, (compressed.swirl()[f] - dense.swirl[f]).norm());
    size = std::max(size, dense.swirl[f].norm());
  }
  EXPECT_LT(worst, tolerance(1e-3) * size);
}

TEST(CompressedInteractions, GiveTheAddedMassOfThoseStored) {
  for (const TriMesh& mesh :
       {hydro::make_box({3, 2, 1}, 10), support::make_torus(1, 0.3, 40, 16)}) {
    const std::vector<bem::Element> elements = bem::make_elements(mesh);
    const bem::Parts parts = bem::parts_of(mesh);
    const bem::Potential loads = bem::loads_on(mesh, elements);
    const hydro::Matrix6d stored = bem::solve_dense(mesh, elements, parts).transpose() * loads;
    const bem::LargeSolution large = bem::solve_compressed(mesh, elements, parts);
    const hydro::Matrix6d compressed = large.psi.transpose() * loads;
    EXPECT_LT((compressed - stored).cwiseAbs().maxCoeff(),
              tolerance(5e-4) * stored.cwiseAbs().maxCoeff());
    EXPECT_GT(large.steps, 1);
  }
}

TEST(Galerkin, ConvergesOnASphereFasterThanItsPanelsShrink) {
  std::vector<double> errors;
  for (const int subdivisions : {1, 2, 3}) {
    const TriMesh mesh = hydro::make_icosphere(1, subdivisions);
    const std::vector<bem::Element> elements = bem::make_elements(mesh);
    const bem::Potential psi = bem::solve_dense(mesh, elements, bem::parts_of(mesh));
    double volume = 0;
    for (const bem::Element& element : elements)
      volume += element.area * element.centroid.dot(element.normal) / 3;
    errors.push_back(std::abs(psi.col(0).dot(bem::loads_on(mesh, elements).col(0)) / volume - 0.5));
  }
  // Order 3 in the panels' size, and a polyhedron is nearer to its ball than that.
  EXPECT_GT(errors[0] / errors[1], 5);
  EXPECT_GT(errors[1] / errors[2], 5);
  EXPECT_LT(errors[2], tolerance(1e-5));
}

}  // namespace

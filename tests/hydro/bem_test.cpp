#include <gtest/gtest.h>

#include <numbers>

#include "hydro/bem/compressed.h"
#include "hydro/bem/dense.h"
#include "hydro/bem/galerkin.h"
#include "hydro/bem/near_pairs.h"
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
    const bem::PotentialMoments seen = bem::potential_moments(element, x);
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
      const auto along = [&](int axis, const Vector3d& y) {
        return (Vector3d::Unit(axis) - element.normal[axis] * element.normal).dot(y - x);
      };
      check(seen.attraction[i],
            [&](const Vector3d& y) { return along(i, y) / std::pow((y - x).norm(), 3); });
      for (int j = 0; j < 3; ++j) {
        check(seen.second(i, j),
              [&](const Vector3d& y) { return along(i, y) * along(j, y) / (y - x).norm(); });
        check(seen.stress(i, j), [&](const Vector3d& y) {
          return along(i, y) * along(j, y) / std::pow((y - x).norm(), 3);
        });
      }
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
  EXPECT_NEAR(bem::pair_integrals(a, a, {0, 1, 2}).single(), graded, tolerance(2e-5) * graded);
}

TEST(PairIntegrals, DoNotDependOnTheOrder) {
  const Vector3d p(0, 0, 0), q(1, 0, 0), r(0.3, 0.8, 0), s(0.5, -0.2, 0.9), t(-0.5, -0.9, 0.1);
  const bem::Element a = bem::make_element(p, q, r), edge = bem::make_element(q, p, s),
                     corner = bem::make_element(p, t, {-1, 0.1, 0}),
                     near = hydro::bem::make_element(p + 0.1 * s, r + 0.1 * s, q + 0.1 * s);
  const auto check = [&](const bem::Element& b, std::array<int, 3> ab, std::array<int, 3> ba) {
    const bem::PairIntegrals one = bem::pair_integrals(a, b, ab);
    const bem::PairIntegrals other = bem::pair_integrals(b, a, ba);
    const bem::PairIntegrals back = bem::turned(other);
    EXPECT_LT((one.hats - back.hats).norm(), tolerance(1e-4) * one.single());
    EXPECT_LT((one.rise - back.rise).norm(), tolerance(1e-4) * one.single());
    EXPECT_LT((one.other_rise - back.other_rise).norm(), tolerance(1e-4) * one.single());
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
      bem::LanePairs pairs;
      bem::pairs_by_points(a, bem::batches_of({moved})[0], pairs);
      // Without a common corner, and near by its own rule, this one is as exact as is needed.
      const bem::PairIntegrals exact = bem::pair_integrals(a, moved, {-1, -1, -1});
      EXPECT_LT((bem::hats_of_lane(pairs, 0) - exact.hats).cwiseAbs().maxCoeff(),
                tolerance(bem::kFarError) * exact.single());
    }
  }
}

TEST(LaneKernels, GiveTheIntegralsOfASinglePair) {
  support::Random random(9);
  const bem::Element a = random_element(random, Vector3d::Zero());
  std::vector<bem::Element> others;
  for (int k = 0; k < 5; ++k) others.push_back(random_element(random, {9, 0, 1.0 * k}));
  const bem::Batch batch = bem::batches_of(others)[0];
  bem::LanePairs pairs;
  bem::LaneSwirls swirls = {};
  bem::pairs_by_points(a, batch, pairs);
  bem::add_swirls(batch, pairs, swirls);
  Eigen::Matrix3d swirl = Eigen::Matrix3d::Zero();  // of hat 0
  for (std::size_t k = 0; k < others.size(); ++k) {
    const bem::PairIntegrals exact = bem::pair_integrals(a, others[k], {-1, -1, -1});
    for (int j = 0; j < 3; ++j)
      swirl += exact.hats(0, j) * others[k].corners[j] * others[k].normal.transpose();
    swirl.diagonal().array() -= exact.rise[0];
  }
  // Five elements of different shapes at 4 … 9 radii.
  EXPECT_LT((bem::summed(swirls)[0] - swirl).norm(), tolerance(1e-3) * swirl.norm());
}

/// ∫∫ curl φ·curl φ'/r of two functions by a fine rule, against what the kernels couple.
TEST(LaneKernels, CoupleTheCurlsOfTheFunctions) {
  support::Random random(10);
  const bem::Element a = random_element(random, Vector3d::Zero());
  const bem::Element b = random_element(random, {6, 1, 2});
  const bem::Batch batch = bem::batches_of({b})[0];
  bem::LanePairs pairs;
  bem::LaneCouplings couplings;
  bem::pairs_by_points(a, batch, pairs);
  bem::couple(a, batch, pairs, couplings);
  const auto curl = [](const bem::Element& e, std::size_t k, const Vector3d& x) -> Vector3d {
    if (k < 3) return e.curls[k];
    const std::size_t i = k - 3, j = (i + 1) % 3;
    const Vector3d hats = bem::hats_at(e, x);
    return 4 * (hats[static_cast<int>(i)] * e.curls[j] + hats[static_cast<int>(j)] * e.curls[i]);
  };
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t l = 0; l < 6; ++l) {
      const auto inner = [&](const Vector3d& x) {
        return integral(b, 2, [&](const Vector3d& y) {
          return curl(a, k, x).dot(curl(b, l, y)) / (x - y).norm();
        });
      };
      // Far pairs are integrated to kFarError of ∫∫ 1/r times the curls, at most 4 on an edge.
      const double size = 16 * pairs.hats[0][0][0] * a.curls[0].norm() * b.curls[0].norm();
      EXPECT_NEAR(couplings.functions[k][l][0], integral(a, 2, inner), tolerance(5e-3) * size);
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

TEST(DenseEquations, AreSymmetricAndKnowNoConstants) {
  support::Random random(12);
  const bem::Surface surface = bem::make_surface(support::random_star(random, 1));
  const Eigen::MatrixXd matrix = bem::dense_equations(surface).matrix;
  EXPECT_EQ(matrix, matrix.transpose());
  Eigen::VectorXd constant = Eigen::VectorXd::Zero(matrix.rows());
  constant.head(surface.vertex_count()).setOnes();
  EXPECT_LT((matrix * constant).cwiseAbs().maxCoeff(),
            tolerance(1e-13) * matrix.cwiseAbs().maxCoeff());
  bem::Potential vectors(matrix.rows(), 6);
  for (Eigen::Index i = 0; i < vectors.size(); ++i) vectors.data()[i] = random.uniform(-1, 1);
  EXPECT_LT((bem::product(matrix, vectors) - matrix * vectors).norm(),
            tolerance(1e-13) * vectors.norm() * matrix.norm());
}

TEST(CompressedInteractions, GiveTheForcesBetweenAllPairs) {
  const bem::Surface surface = bem::make_surface(hydro::make_box({3, 2, 1}, 8));
  const bem::CompressedInteractions compressed(surface);
  support::Random random(8);
  bem::Columns densities(surface.mesh.face_count(), 5);
  for (Eigen::Index i = 0; i < densities.size(); ++i) densities.data()[i] = random.uniform(0, 1);
  bem::Columns exact = bem::Columns::Zero(3 * densities.rows(), 5);
  const std::vector<bem::Batch> batches = bem::batches_of(surface.elements);
  const bem::NearPairs near(surface);
  bem::LanePairs pairs;
  for (std::size_t a = 0; a < surface.face_count(); ++a) {
    for (std::size_t b = 0; b < surface.face_count(); ++b) {
      bem::pairs_by_points(surface.elements[a], batches[b / bem::kLanes], pairs);
      for (const bem::NearElement& other : near.of(a))
        if (other.element == b) bem::set_lane(other.integrals, b % bem::kLanes, pairs);
      exact.middleRows<3>(static_cast<Eigen::Index>(3 * a)) +=
          bem::hats_of_lane(pairs, b % bem::kLanes).rowwise().sum() *
          densities.row(static_cast<Eigen::Index>(b));
    }
  }
  const bem::Columns hats = compressed.apply_to_hats(densities);
  EXPECT_LT((hats - exact).norm(), tolerance(2e-4) * exact.norm());
  const bem::Columns sums = compressed.apply(densities);
  for (Eigen::Index f = 0; f < sums.rows(); ++f)
    EXPECT_LT((hats.middleRows<3>(3 * f).colwise().sum() - sums.row(f)).norm(),
              tolerance(1e-12) * sums.row(f).norm());
}

TEST(CompressedInteractions, GiveTheAddedMassOfThoseStored) {
  for (const TriMesh& mesh :
       {hydro::make_box({3, 2, 1}, 14), support::make_torus(1, 0.3, 48, 20)}) {
    const bem::Surface surface = bem::make_surface(mesh);
    const bem::Potential loads = bem::loads_on(surface);
    const bem::Solution stored = bem::solve_dense(surface), large = bem::solve_compressed(surface);
    const hydro::Matrix6d truth = stored.psi.transpose() * loads;
    const hydro::Matrix6d linear =
        truth - (1 + 1 / bem::kBeyond) * stored.doubt;  // without what quadratic functions gain
    const hydro::Matrix6d compressed = large.psi.transpose() * loads;
    EXPECT_LT((compressed - linear).cwiseAbs().maxCoeff(),
              tolerance(2e-3) * linear.cwiseAbs().maxCoeff());
    // What it says it lacks is at least what it lacks of the better solution, motion by motion.
    for (int m = 0; m < 6; ++m)
      EXPECT_LT(truth(m, m) - compressed(m, m),
                large.doubt(m, m) + 2e-4 * truth.diagonal().maxCoeff());
    EXPECT_GT(large.steps, 1);
  }
}

TEST(Galerkin, ConvergesOnASphereFasterThanItsPanelsShrink) {
  std::vector<double> errors;
  for (const int subdivisions : {1, 2, 3}) {
    const bem::Surface surface = bem::make_surface(hydro::make_icosphere(1, subdivisions));
    const bem::Potential psi = bem::solve_dense(surface).psi;
    double volume = 0;
    for (const bem::Element& element : surface.elements)
      volume += element.area * element.centroid.dot(element.normal) / 3;
    errors.push_back(std::abs(psi.col(0).dot(bem::loads_on(surface).col(0)) / volume - 0.5));
  }
  // A polyhedron's added mass is off its ball's by order 3 in the edges.
  EXPECT_GT(errors[0] / errors[1], 5);
  EXPECT_GT(errors[1] / errors[2], 5);
  EXPECT_LT(errors[2], tolerance(1e-4));
}

TEST(Galerkin, GainsWhatItSaysItLacks) {
  // On coarse panels the doubt covers what panels halved twice and more change.
  const bem::Surface coarse = bem::make_surface(hydro::make_box({2, 2, 2}, 4));
  const bem::Solution solution = bem::solve_dense(coarse);
  const hydro::Matrix6d matrix = solution.psi.transpose() * bem::loads_on(coarse);
  EXPECT_NEAR(matrix(0, 0), 5.1073, solution.doubt(0, 0));
  EXPECT_NEAR(matrix(4, 4), 1.2564, solution.doubt(4, 4));
}

}  // namespace

#include <gtest/gtest.h>

#include <numbers>

#include "hydro/added_mass/bem/compressed.h"
#include "hydro/added_mass/bem/dense.h"
#include "hydro/added_mass/bem/dense_symmetric.h"
#include "hydro/added_mass/bem/galerkin.h"
#include "hydro/added_mass/bem/near_pairs.h"
#include "hydro/added_mass/bem/pair.h"
#include "hydro/added_mass/bem/quadrature.h"
#include "hydro/mesh/primitives.h"
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

TEST(PairIntegrals, FromEitherSideAreTheSame) {
  const Vector3d p(0, 0, 0), q(1, 0, 0), r(0.3, 0.8, 0), s(0.5, -0.2, 0.9), t(-0.5, -0.9, 0.1);
  const bem::Element a = bem::make_element(p, q, r), edge = bem::make_element(q, p, s),
                     corner = bem::make_element(p, t, {-1, 0.1, 0}),
                     near = hydro::bem::make_element(p + 0.1 * s, r + 0.1 * s, q + 0.1 * s);
  const auto check = [&](const bem::Element& b, std::array<int, 3> ab, std::array<int, 3> ba) {
    const bem::PairIntegrals one = bem::integrals_from(a, b, ab);
    const bem::PairIntegrals back = bem::turned(bem::integrals_from(b, a, ba));
    EXPECT_LT((one.hats - back.hats).norm(), tolerance(1e-4) * one.single());
    EXPECT_LT((one.rise - back.rise).norm(), tolerance(1e-4) * one.single());
    EXPECT_LT((one.other_rise - back.other_rise).norm(), tolerance(1e-4) * one.single());
  };
  check(edge, {1, 0, -1}, {1, 0, -1});
  check(corner, {0, -1, -1}, {0, -1, -1});
  check(near, {-1, -1, -1}, {-1, -1, -1});
}

/// The corners of an element in another order, or its mirror image in the plane x = 0.
bem::Element relabelled(const bem::Element& e, std::array<std::size_t, 3> order, bool mirrored) {
  const Vector3d scale(mirrored ? -1 : 1, 1, 1);
  return bem::make_element(scale.cwiseProduct(e.corners[order[0]]),
                           scale.cwiseProduct(e.corners[order[1]]),
                           scale.cwiseProduct(e.corners[order[2]]));
}

TEST(PairIntegrals, DoNotHangOnTheOrderOfElementsAndCorners) {
  const Vector3d p(0, 0, 0), q(1, 0, 0), r(0.5, std::sqrt(0.75), 0), up(0.1, 0.2, 0.15);
  // Two sides are as long as each other, and all three; the areas are the same, and are not.
  const bem::Element even = bem::make_element(p, q, r);
  for (const bem::Element& other :
       {bem::make_element(p + up, q + up, r + up), bem::make_element(p + up, q + up, 2 * r + up)}) {
    const bem::PairIntegrals pair = bem::pair_integrals(even, other, {-1, -1, -1});
    const std::array<std::size_t, 3> turn = {1, 2, 0}, flip = {0, 2, 1};
    for (const bool mirrored : {false, true}) {
      const auto& order = mirrored ? flip : turn;
      const bem::Element a = relabelled(even, order, mirrored);
      const bem::Element b = relabelled(other, order, mirrored);
      const bem::PairIntegrals again = bem::turned(bem::pair_integrals(b, a, {-1, -1, -1}));
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          EXPECT_NEAR(again.hats(i, j), pair.hats(order[i], order[j]),
                      tolerance(1e-14) * pair.single());
    }
  }
}

/// ∫∫ λ_i λ_j/r by a rule of degree 5 on nine pieces of each, for distant elements.
Eigen::Matrix3d fine_integrals(const bem::Element& a, const bem::Element& b) {
  Eigen::Matrix3d hats = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      hats(i, j) = integral(a, 3, [&](const Vector3d& x) {
        return bem::hats_at(a, x)[i] * integral(b, 3, [&](const Vector3d& y) {
                 return bem::hats_at(b, y)[j] / (x - y).norm();
               });
      });
  return hats;
}

/// The element turned about its centroid so that its farthest corner lies in a direction.
bem::Element pointed(const bem::Element& element, const Vector3d& direction) {
  Vector3d farthest = Vector3d::Zero();
  for (const Vector3d& corner : element.corners)
    if ((corner - element.centroid).norm() > farthest.norm()) farthest = corner - element.centroid;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(farthest, direction);
  return bem::make_element(turn * element.corners[0], turn * element.corners[1],
                           turn * element.corners[2]);
}

/// The largest errors over ∫∫ 1/r, of ∫∫ λ_i λ_j/r and of ∫∫ 1/r, of the rule for distant pairs at
/// `reach`. Half of the pairs are drawn out along the line between them: the worst for a rule.
std::pair<double, double> errors_of_distant_pairs(double reach) {
  support::Random random(6);
  std::pair<double, double> worst = {0, 0};
  for (int k = 0; k < 1000; ++k) {
    const Vector3d away = random.rotation() * Vector3d::UnitX();
    bem::Element a = random_element(random, Vector3d::Zero());
    bem::Element b = random_element(random, Vector3d::Zero());
    if (k % 2 == 0) {
      a = pointed(a, k % 4 == 0 ? away : -away);
      b = pointed(b, k % 8 < 4 ? away : -away);
    }
    const Vector3d shift = a.centroid - b.centroid + 1.0001 * reach * (a.radius + b.radius) * away;
    b = bem::make_element(b.corners[0] + shift, b.corners[1] + shift, b.corners[2] + shift);
    bem::LanePairs pairs;
    bem::pairs_by_points(a, bem::batches_of({b})[0], pairs);
    const Eigen::Matrix3d exact = fine_integrals(a, b);
    const Eigen::Matrix3d error = (bem::hats_of_lane(pairs, 0) - exact) / exact.sum();
    worst.first = std::max(worst.first, error.cwiseAbs().maxCoeff());
    worst.second = std::max(worst.second, std::abs(error.sum()));
  }
  return worst;
}

TEST(PairIntegrals, OfDistantElementsKeepTheirBound) {
  for (const double reach : {bem::kNear, bem::kFar}) {
    const auto [of_hats, of_sum] = errors_of_distant_pairs(reach);
    EXPECT_LT(of_hats, tolerance(bem::kFarError));
    EXPECT_LT(of_sum, tolerance(bem::kFarError));
    // The bound is not an idle one: at either limit some pair comes within a factor of 4.
    EXPECT_GT(of_sum, bem::kFarError / 4);
  }
}

TEST(LaneKernels, GiveTheIntegralsOfASinglePair) {
  support::Random random(9);
  const bem::Element a = random_element(random, Vector3d::Zero());
  std::vector<bem::Element> others;
  for (int k = 0; k < 5; ++k) others.push_back(random_element(random, {9, 0, 1.0 * k}));
  const bem::Batch batch = bem::batches_of(others)[0];
  bem::LanePairs pairs;
  bem::LaneRotationMoments moments = {};
  bem::pairs_by_points(a, batch, pairs);
  bem::add_rotation_moments(batch, pairs, moments);
  Eigen::Matrix3d rotation_moments = Eigen::Matrix3d::Zero();  // of hat 0
  for (std::size_t k = 0; k < others.size(); ++k) {
    const bem::PairIntegrals exact = bem::pair_integrals(a, others[k], {-1, -1, -1});
    for (int j = 0; j < 3; ++j)
      rotation_moments += exact.hats(0, j) * others[k].corners[j] * others[k].normal.transpose();
    rotation_moments.diagonal().array() -= exact.rise[0];
  }
  // Five elements of different shapes at 4 … 9 radii.
  EXPECT_LT((bem::summed(moments)[0] - rotation_moments).norm(),
            tolerance(1e-3) * rotation_moments.norm());
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

TEST(DenseEquations, KnowNoConstants) {
  support::Random random(12);
  const bem::Surface surface = bem::make_surface(support::random_star(random, 1));
  const Eigen::MatrixXd matrix = bem::dense_equations(surface).matrix;
  Eigen::VectorXd constant = Eigen::VectorXd::Zero(matrix.rows());
  constant.head(surface.vertex_count()).setOnes();
  EXPECT_LT((matrix.selfadjointView<Eigen::Lower>() * constant).cwiseAbs().maxCoeff(),
            tolerance(1e-13) * matrix.cwiseAbs().maxCoeff());
}

/// A symmetric positive matrix with eigenvalues from 1 on, of which the upper triangle is spoilt.
Eigen::MatrixXd lower_triangle(support::Random& random, Eigen::Index size) {
  Eigen::MatrixXd any(size, size);
  for (double& entry : any.reshaped()) entry = random.uniform(-1, 1);
  Eigen::MatrixXd matrix = any * any.transpose() + Eigen::MatrixXd::Identity(size, size);
  matrix.triangularView<Eigen::StrictlyUpper>().setConstant(1e300);
  return matrix;
}

bem::SixColumns random_columns(support::Random& random, Eigen::Index size) {
  bem::SixColumns columns(size, 6);
  for (double& entry : columns.reshaped()) entry = random.uniform(-1, 1);
  return columns;
}

TEST(Eliminated, ActsAsTheEquationsOfTheLastUnknowns) {
  support::Random random(13);
  // Sizes below, at and above whole blocks of columns and of the factor.
  for (const auto& [count, rest] : {std::pair{4, 6}, {8, 16}, {96, 40}, {205, 331}}) {
    const Eigen::MatrixXd lower = lower_triangle(random, count + rest);
    const Eigen::MatrixXd whole = lower.selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd A = whole.topLeftCorner(count, count);
    const Eigen::MatrixXd C = whole.bottomLeftCorner(rest, count);
    const Eigen::MatrixXd B = whole.bottomRightCorner(rest, rest);
    const bem::Eliminated eliminated(lower, count);
    const bem::SixColumns x = random_columns(random, count), y = random_columns(random, rest);
    // Round-off of sums of some hundred numbers, and A⁻¹'s of a condition below 1e3.
    const double bound = tolerance(1e-13) * whole.norm();
    const double inverse_bound = tolerance(1e-11) * whole.norm();
    EXPECT_LT((A * eliminated.solve(x) - x).norm(), inverse_bound);
    EXPECT_LT((eliminated.forward(x) - C * x).norm(), bound * x.norm());
    EXPECT_LT((eliminated.backward(y) - C.transpose() * y).norm(), bound * y.norm());
    const bem::SixColumns rest_of_y = B * y - C * A.llt().solve(C.transpose() * y);
    EXPECT_LT((eliminated.apply(y) - rest_of_y).norm(), inverse_bound * y.norm());
    EXPECT_EQ(eliminated.remaining(1, 3), B(1, 3));
    EXPECT_EQ(eliminated.remaining(3, 1), B(1, 3));
  }
}

TEST(Eliminated, RefusesAMatrixThatIsNotPositive) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(300, 300);
  matrix(250, 250) = -1;
  EXPECT_THROW(bem::Eliminated(matrix, 290), std::invalid_argument);
  EXPECT_NO_THROW(bem::Eliminated(matrix, 200));
}

TEST(CompressedInteractions, GiveTheAddedMassOfThoseStoredOnLargeMeshes) {
  for (const TriMesh& mesh :
       {hydro::make_box({3, 2, 1}, 14), support::make_torus(1, 0.3, 48, 20)}) {
    const bem::Surface surface = bem::make_surface(mesh);
    const bem::Potential loads = bem::loads_on(surface);
    const bem::Solution stored = bem::solve_dense(surface), large = bem::solve_compressed(surface);
    const hydro::Matrix6d truth = stored.psi.transpose() * loads;
    const hydro::Matrix6d linear =
        truth -
        (1 + 1 / bem::kBeyond) * stored.error_estimate;  // without what quadratic functions gain
    const hydro::Matrix6d compressed = large.psi.transpose() * loads;
    EXPECT_LT((compressed - linear).cwiseAbs().maxCoeff(),
              tolerance(2e-3) * linear.cwiseAbs().maxCoeff());
    // What it says it lacks is at least what it lacks of the better solution, motion by motion.
    for (int m = 0; m < 6; ++m)
      EXPECT_LT(truth(m, m) - compressed(m, m),
                large.error_estimate(m, m) + 2e-4 * truth.diagonal().maxCoeff());
    EXPECT_GT(large.steps, 1);
  }
}

}  // namespace

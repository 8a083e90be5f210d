#include "hydro/added_mass/bem/compressed.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/added_mass/bem/conjugate_gradients.h"
#include "hydro/added_mass/bem/galerkin.h"
#include "hydro/added_mass/bem/near_pairs.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/tolerance.h"

/// The compressed solver on meshes of a few hundred panels, which sanitizers get through. Their
/// clusters are few, but there are near and distant pairs of them, on more than one level.

namespace {

using Eigen::Index;
using Eigen::Vector3d;
using hydro::TriMesh;
using support::tolerance;
namespace bem = hydro::bem;

/// 192 panels; opposite sides of the ring are distant.
TriMesh ring() { return support::make_torus(1, 0.1, 24, 4); }

/// 192 panels of different sizes; the ends are distant.
TriMesh beam() { return hydro::make_box({8, 1, 0.8}, 4); }

bem::Columns random_columns(support::Random& random, Index rows, Index columns) {
  bem::Columns all(rows, columns);
  for (Index i = 0; i < all.size(); ++i) all.data()[i] = random.uniform(0, 1);
  return all;
}

TEST(ClusterTree, HasEveryPairOfElementsOnceEitherNearOrFar) {
  for (const TriMesh& mesh : {ring(), beam()}) {
    const std::vector<bem::Element> elements = bem::make_elements(mesh);
    const bem::ClusterTree tree = bem::make_cluster_tree(elements);
    const auto count = static_cast<Index>(elements.size());
    Eigen::MatrixXi met = Eigen::MatrixXi::Zero(count, count);
    int far = 0;
    for (const bem::Cluster& cluster : tree.clusters) {
      std::vector<int> others = cluster.far;
      far += static_cast<int>(others.size());
      others.insert(others.end(), cluster.near.begin(), cluster.near.end());
      for (const int index : others) {
        const bem::Cluster& other = tree.clusters[static_cast<std::size_t>(index)];
        for (int i = cluster.first; i < cluster.last; ++i)
          for (int j = other.first; j < other.last; ++j)
            ++met(tree.order[static_cast<std::size_t>(i)], tree.order[static_cast<std::size_t>(j)]);
      }
    }
    EXPECT_EQ(met.minCoeff(), 1);
    EXPECT_EQ(met.maxCoeff(), 1);
    EXPECT_GT(far, 4);
    EXPECT_GT(tree.levels.size(), 3u);
  }
}

TEST(Grid, ReproducesPolynomialsOfItsDegree) {
  support::Random random(5);
  const bem::Grid grid(Eigen::AlignedBox3d(Vector3d(1, -2, 0), Vector3d(3, 0, 2)));
  const auto cubic = [](const Vector3d& r) { return r.x() * r.x() * r.y() - 2 * r.z() + 3; };
  for (int k = 0; k < 10; ++k) {
    const Vector3d at = Vector3d(2, -1, 1) + random.vector(1).cwiseMax(-1).cwiseMin(1);
    const Eigen::VectorXd weights = grid.weights_at(at);
    double value = 0;
    for (Index i = 0; i < grid.count(); ++i)
      value += weights[i] * cubic(grid.nodes().row(i).transpose());
    EXPECT_NEAR(value, cubic(at), tolerance(1e-12));
  }
}

/// A flat box has one layer of points: their number is no multiple of a vector's lanes.
TEST(Grid, AddsTheInteractionsOfItsPoints) {
  support::Random random(6);
  const bem::Grid at(Eigen::AlignedBox3d(Vector3d(0, 0, 0), Vector3d(1, 1, 0)));
  const bem::Grid from(Eigen::AlignedBox3d(Vector3d(4, 0, 0), Vector3d(5, 0.3, 1)));
  const bem::FloatColumns moments =
      random_columns(random, from.offsets().rows(), bem::kBlock).cast<float>();
  bem::Columns field = bem::Columns::Zero(at.count(), bem::kBlock);
  bem::add_interaction(at, from, moments, field.data());
  for (Index i = 0; i < at.count(); ++i) {
    Eigen::RowVectorXd exact = Eigen::RowVectorXd::Zero(bem::kBlock);
    for (Index j = 0; j < from.count(); ++j)
      exact += moments.row(j).cast<double>() / (at.nodes().row(i) - from.nodes().row(j)).norm();
    EXPECT_LT((field.row(i) - exact).norm(), tolerance(1e-5) * exact.norm());
  }
}

TEST(NearPairs, AreTheSameFromEitherSide) {
  const bem::Surface surface = bem::make_surface(beam());
  const bem::NearPairs near(surface);
  for (std::size_t a = 0; a < surface.face_count(); ++a) {
    const auto row = near.of(a);
    EXPECT_TRUE(std::is_sorted(row.begin(), row.end(), [](const auto& one, const auto& other) {
      return one.element < other.element;
    }));
    for (const bem::NearElement& other : row) {
      const auto back = near.of(other.element);
      const auto mine = std::find_if(back.begin(), back.end(),
                                     [a](const auto& element) { return element.element == a; });
      ASSERT_NE(mine, back.end());
      EXPECT_EQ(mine->integrals.hats, other.integrals.hats.transpose());
    }
  }
}

TEST(CompressedInteractions, GiveTheForcesBetweenAllPairs) {
  support::Random random(8);
  for (const TriMesh& mesh : {ring(), beam()}) {
    const bem::Surface surface = bem::make_surface(mesh);
    const bem::CompressedInteractions compressed(surface);
    const bem::Columns densities = random_columns(random, surface.mesh.face_count(), 5);
    bem::Columns exact = bem::Columns::Zero(3 * densities.rows(), 5);
    const std::vector<bem::Batch> batches = bem::batches_of(surface.elements);
    const bem::NearPairs near(surface);
    bem::LanePairs pairs;
    for (std::size_t a = 0; a < surface.face_count(); ++a) {
      for (std::size_t b = 0; b < surface.face_count(); ++b) {
        bem::pairs_by_points(surface.elements[a], batches[b / bem::kLanes], pairs);
        for (const bem::NearElement& other : near.of(a))
          if (other.element == b) bem::set_lane(other.integrals, b % bem::kLanes, pairs);
        exact.middleRows<3>(static_cast<Index>(3 * a)) +=
            bem::hats_of_lane(pairs, b % bem::kLanes).rowwise().sum() *
            densities.row(static_cast<Index>(b));
      }
    }
    const bem::Columns hats = compressed.apply_to_hats(densities);
    EXPECT_LT((hats - exact).norm(), tolerance(2e-4) * exact.norm());
    const bem::Columns sums = compressed.apply(densities);
    for (Index f = 0; f < sums.rows(); ++f)
      EXPECT_LT((hats.middleRows<3>(3 * f).colwise().sum() - sums.row(f)).norm(),
                tolerance(1e-12) * sums.row(f).norm());
  }
}

TEST(CompressedInteractions, GiveTheAddedMassOfThoseStored) {
  for (const TriMesh& mesh : {ring(), beam()}) {
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
    EXPECT_GT(large.steps, 1);
  }
}

bem::Potential random_potential(support::Random& random, Index rows) {
  return random_columns(random, rows, 6).array() - 0.5;
}

TEST(ConjugateGradients, SolveForEveryMotionThatHasAForce) {
  support::Random random(9);
  const Index count = 30;
  const Eigen::MatrixXd root = random_columns(random, count, count);
  const Eigen::MatrixXd matrix = root * root.transpose() + Eigen::MatrixXd::Identity(count, count);
  bem::Potential sides = random_potential(random, count);
  sides.col(3).setZero();
  const auto apply = [&](const bem::Potential& x) { return bem::Potential(matrix * x); };
  const auto jacobi = [&](const bem::Potential& r) {
    return bem::Potential(matrix.diagonal().cwiseInverse().asDiagonal() * r);
  };
  const bem::Iterated iterated = bem::conjugate_gradients(sides, 1e-10, apply, jacobi);
  EXPECT_LT((matrix * iterated.solution - sides).norm(), tolerance(1e-7) * sides.norm());
  EXPECT_EQ(iterated.solution.col(3).norm(), 0);
  EXPECT_GT(iterated.steps, 5);
}

TEST(ConjugateGradients, RefuseWhatDoesNotConverge) {
  support::Random random(10);
  const bem::Potential sides = random_potential(random, 8);
  const auto same = [](const bem::Potential& r) { return r; };
  const auto infinite = [](const bem::Potential& x) { return bem::Potential(x * HUGE_VAL); };
  EXPECT_THROW(bem::conjugate_gradients(sides, 1e-6, infinite, same), std::invalid_argument);
}

}  // namespace

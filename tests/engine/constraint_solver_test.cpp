#include "engine/constraints/constraint_solver.h"

#include "engine/base/constants.h"
#include "engine/constraints/prepared_block.h"
#include "tests/engine/prelude.h"

/// (E8) and (E36) for blocks of all kinds between bodies with coupled inertias.

namespace {

using engine::ConstrainedBody;
using engine::ConstraintBlock;
using engine::ConstraintSolution;
using engine::PreparedBlock;
using Kind = ConstraintBlock::Kind;

/// Symmetric and positive definite, all motions coupled, its eigenvalues from `least` to `most`.
Matrix6d random_inertia(support::Random& random, double least, double most) {
  Matrix6d root;
  for (int i = 0; i < 36; ++i) root(i / 6, i % 6) = random.uniform(-1, 1);
  const Eigen::SelfAdjointEigenSolver<Matrix6d> axes(root * root.transpose());
  Vector6d values;
  for (int i = 0; i < 6; ++i) values[i] = least * std::pow(most / least, i / 5.0);
  return axes.eigenvectors() * values.asDiagonal() * axes.eigenvectors().transpose();
}

struct Island {
  std::vector<ConstrainedBody> bodies;
  std::vector<ConstraintBlock> blocks;

  ConstraintSolution solved(const std::vector<Vector3d>& start = {}) const {
    return engine::solve_constraints(bodies, blocks, start, size());
  }
  double size() const {
    double energy = 0;
    for (const ConstrainedBody& b : bodies) energy += b.velocity.dot(b.inertia * b.velocity);
    return std::sqrt(energy);
  }
};

Island random_bodies(support::Random& random, int count, double most = 10) {
  Island island;
  for (int i = 0; i < count; ++i) {
    const Matrix6d S = random_inertia(random, 1, most);
    Vector6d u;
    for (int k = 0; k < 6; ++k) u[k] = random.uniform(-1, 1);
    island.bodies.push_back({.body = 3 * i, .inertia = S, .mobility = S.inverse(), .velocity = u});
  }
  return island;
}

/// A block between two of the bodies, or one and the world.
ConstraintBlock random_block(support::Random& random, const Island& island, Kind kind, int rows) {
  const auto count = static_cast<double>(island.bodies.size());
  const auto first = static_cast<std::size_t>(random.uniform(0, count));
  const auto second = static_cast<std::size_t>(random.uniform(0, count));
  ConstraintBlock block{.kind = kind, .rows = rows, .bodies = {island.bodies[first].body, kWorld}};
  if (second != first) block.bodies[1] = island.bodies[second].body;
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < 6; ++k)
      for (int side = 0; side < 2; ++side) block.J[side](i, k) = random.uniform(-1, 1);
    block.target[i] = random.uniform(-0.5, 0.5);
    block.compliance[i] = random.uniform(0.001, 0.1);
  }
  return block;
}

void add_random_contact(support::Random& random, Island& island) {
  island.blocks.push_back(random_block(random, island, Kind::contact, 3));
  island.blocks.back().limit = random.uniform(0, 0.5);
}

/// Two to six bodies, by the seed.
Island random_bodies_of(unsigned seed, support::Random& random) {
  return random_bodies(random, 2 + static_cast<int>(seed) % 5, 100);
}

/// What (E8) lacks for a block, in the velocities of a solution.
Vector3d lacking(const Island& island, const ConstraintSolution& found, std::size_t k) {
  return PreparedBlock(island.blocks[k], island.bodies).missed(found.impulses[k], found.velocities);
}

void expect_contact(const Vector3d& p, const Vector3d& rest, double friction, double small) {
  EXPECT_GE(p[0], 0);
  EXPECT_GE(rest[0], -small);
  EXPECT_LT(p[0] * std::abs(rest[0]), small);
  const double most = friction * p[0];
  EXPECT_LE(p.tail<2>().norm(), most + small);
  if (p.tail<2>().norm() < most - small)
    EXPECT_LT(rest.tail<2>().norm() * p[0], small);
  else  // it slides against the friction
    EXPECT_LT(
        std::abs(p.tail<2>().dot(rest.tail<2>()) + p.tail<2>().norm() * rest.tail<2>().norm()),
        small);
}

/// That every block has what its kind asks for.
void expect_solved(const Island& island, const ConstraintSolution& found, double error = 1e-6) {
  EXPECT_TRUE(found.converged);
  const double small = tolerance(error);
  for (std::size_t k = 0; k < island.blocks.size(); ++k) {
    const ConstraintBlock& block = island.blocks[k];
    const Vector3d& p = found.impulses[k];
    const Vector3d rest = lacking(island, found, k);
    switch (block.kind) {
      case Kind::bilateral:
        EXPECT_LT(rest.norm(), small);
        break;
      case Kind::one_sided:
        EXPECT_GE(p[0], 0);
        EXPECT_GE(rest[0], -small);
        EXPECT_LT(p[0] * std::abs(rest[0]), small);
        break;
      case Kind::bounded:
        EXPECT_LE(std::abs(p[0]), block.limit + small);
        if (std::abs(p[0]) < block.limit - small)
          EXPECT_LT(std::abs(rest[0]), small);
        else
          EXPECT_LT(p[0] * rest[0], small);
        break;
      case Kind::contact:
        expect_contact(p, rest, block.limit, small);
    }
  }
}

TEST(ConstraintSolver, FindsVelocitiesThatFollowFromTheImpulses) {
  support::Random random(1);
  Island island = random_bodies(random, 3);
  for (int i = 0; i < 4; ++i)
    island.blocks.push_back(random_block(random, island, Kind::bilateral, 1 + i % 3));
  const ConstraintSolution found = island.solved();
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    Vector6d u = island.bodies[i].velocity;
    for (std::size_t k = 0; k < island.blocks.size(); ++k)
      for (std::size_t side = 0; side < 2; ++side)
        if (island.blocks[k].bodies[side] == island.bodies[i].body)
          u += island.bodies[i].mobility * island.blocks[k].J[side].transpose() * found.impulses[k];
    EXPECT_LT((u - found.velocities[i]).norm(), tolerance(1e-12));
  }
}

TEST(ConstraintSolver, MeetsBilateralRowsByOneNewtonStep) {
  for (const double ratio : {1.0, 1e3, 1e6}) {
    SCOPED_TRACE(ratio);
    support::Random random(2);
    Island island = random_bodies(random, 5, ratio);
    for (int i = 0; i < 6; ++i)
      island.blocks.push_back(random_block(random, island, Kind::bilateral, 3));
    const ConstraintSolution found = island.solved();
    expect_solved(island, found);
    EXPECT_EQ(found.sweeps, 2);
  }
}

TEST(ConstraintSolver, MeetsWhatBlocksOfAllKindsAskFor) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    support::Random random(seed);
    Island island = random_bodies_of(seed, random);
    for (int i = 0; i < 6; ++i) {
      add_random_contact(random, island);
      island.blocks.push_back(random_block(random, island, Kind::one_sided, 1));
      island.blocks.push_back(random_block(random, island, Kind::bounded, 1));
      island.blocks.back().limit = random.uniform(0, 0.2);
    }
    if (seed % 2) island.blocks.push_back(random_block(random, island, Kind::bilateral, 2));
    expect_solved(island, island.solved(), 1e-5);
  }
}

TEST(ConstraintSolver, FindsTheSameVelocitiesFromAnyStart) {
  support::Random random(3);
  Island island = random_bodies(random, 4);
  std::vector<Vector3d> start;
  for (int i = 0; i < 6; ++i) {
    island.blocks.push_back(random_block(random, island, Kind::contact, 3));
    island.blocks.back().limit = 0.3;
    start.emplace_back(random.uniform(0, 2), 0, 0);
  }
  const ConstraintSolution cold = island.solved(), warm = island.solved(start);
  for (std::size_t i = 0; i < island.bodies.size(); ++i)
    EXPECT_LT((cold.velocities[i] - warm.velocities[i]).norm(), tolerance(1e-6));
  EXPECT_EQ(island.solved(cold.impulses).sweeps, 1);
}

/// A tower of points that can move up and down only, each on the next, the uppermost the heaviest.
TEST(ConstraintSolver, HoldsAHeavyBodyOnLightOnes) {
  Island island;
  for (int i = 0; i < 5; ++i) {
    const double mass = i == 4 ? 1e5 : 1;
    island.bodies.push_back({.body = i,
                             .inertia = mass * Matrix6d::Identity(),
                             .mobility = Matrix6d::Identity() / mass,
                             .velocity = Vector6d::Unit(2) * -0.1});
    ConstraintBlock block{.kind = Kind::contact, .bodies = {i, i == 0 ? kWorld : i - 1}};
    for (int row = 0; row < 3; ++row) {
      block.J[0](row, (row + 2) % 3) = 1;
      block.J[1](row, (row + 2) % 3) = -1;
    }
    block.compliance = Vector3d::Constant(1e-13);
    block.limit = 0.5;
    island.blocks.push_back(block);
  }
  const ConstraintSolution found = island.solved();
  EXPECT_TRUE(found.converged);
  for (const Vector6d& u : found.velocities) EXPECT_LT(u.norm(), tolerance(1e-4));
  EXPECT_NEAR(found.impulses[0][0], 1e4 + 0.4, tolerance(0.1));
}

TEST(ConstraintSolver, LetsContradictoryRowsCompromise) {
  Island island;
  island.bodies.push_back({.body = 0,
                           .inertia = Matrix6d::Identity(),
                           .mobility = Matrix6d::Identity(),
                           .velocity = Vector6d::Zero()});
  for (const double target : {1.0, -1.0}) {
    ConstraintBlock block{.rows = 1, .bodies = {0, kWorld}};
    block.J[0](0, 0) = 1;
    block.target[0] = target;
    island.blocks.push_back(block);
  }
  const ConstraintSolution found = island.solved();
  EXPECT_TRUE(found.velocities[0].allFinite());
  EXPECT_LT(found.velocities[0].norm(), 1e-4);
}

TEST(Disk, HasTheLeastPointInItOrOnItsRim) {
  support::Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d w(random.uniform(0.01, 10), random.uniform(0.01, 10));
    const Eigen::Vector2d g(random.uniform(-5, 5), random.uniform(-5, 5));
    const double radius = random.uniform(0, 3);
    const Eigen::Vector2d x = engine::least_in_disk(w, g, radius);
    EXPECT_LE(x.norm(), radius * (1 + 1e-12));
    const Eigen::Vector2d slope = w.cwiseProduct(x) - g;
    if (x.norm() < radius * (1 - 1e-9)) {
      EXPECT_LT(slope.norm(), tolerance(1e-9));
      continue;
    }
    // On the rim the slope points inwards.
    EXPECT_LT((slope.normalized() + x.normalized()).norm(), tolerance(1e-3));
  }
  EXPECT_EQ(engine::least_in_disk({1, 2}, {3, 4}, 0), Eigen::Vector2d::Zero());
}

}  // namespace

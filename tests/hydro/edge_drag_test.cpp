#include "hydro/loads/edge_drag.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "hydro/decompositions.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::BodyState;
using hydro::EdgeDrag;
using hydro::HullWater;
using hydro::make_box;
using hydro::Matrix6d;
using hydro::Vector6d;
using hydro::Wrench;
using support::tolerance;

const HullWater kCalm{.velocity = Vector3d::Zero(), .surface = 0, .density = 1000};
const HullWater kDeep{.velocity = Vector3d::Zero(), .surface = 1e3, .density = 1000};

BodyState moving(const Vector3d& v, const Vector3d& w = Vector3d::Zero()) {
  return {.linear_velocity = v, .angular_velocity = w};
}

double power(const Wrench& load, const BodyState& state) {
  return load.force.dot(state.linear_velocity) + load.moment.dot(state.angular_velocity);
}

/// Strength A of the flow at an edge of a long bar in unit motion, from its power.
double strength(double breadth, double height, const BodyState& unit_motion) {
  constexpr double kLength = 1000;
  const EdgeDrag edges(make_box({kLength, breadth, height}));
  const double taken = -power(edges.load(unit_motion, kDeep), unit_motion);
  return std::cbrt(taken / (4 * kLength * kDeep.density * hydro::kEdgeDrag));
}

// The exact strengths are those of the flow about a rectangle by the mapping
// dz/dζ = κ √(1 − 2 cos 2α ζ⁻² + ζ⁻⁴) of a circle's outside, with Fourier's series of the stream
// function of a turn. They are for a breadth of 1.
TEST(EdgeDrag, HasTheFlowAtTheEdgesOfRectangles) {
  struct Exact {
    double height, along_breadth, along_height, turn;
  };
  for (const Exact& exact :
       {Exact{1, 0.9792, 0.9792, 0.5116}, Exact{1.0 / 2, 0.7499, 1.0300, 0.3657},
        Exact{1.0 / 3, 0.6454, 1.0685, 0.3327}, Exact{1.0 / 4, 0.5815, 1.1002, 0.3217},
        Exact{1.0 / 6, 0.5034, 1.1512, 0.3172}}) {
    const double h = exact.height;
    EXPECT_NEAR(strength(1, h, moving({0, 1, 0})) / exact.along_breadth, 1.05, tolerance(0.05));
    EXPECT_NEAR(strength(1, h, moving({0, 0, 1})) / exact.along_height, 0.95, tolerance(0.09));
    EXPECT_NEAR(strength(1, h, moving({0, 0, 0}, {1, 0, 0})) / exact.turn, 0.92, tolerance(0.08));
  }
}

// The flow about a disc that moves along its axis has 2/π of the potential of a strip as wide.
TEST(EdgeDrag, IsLessAboutADiscThanAboutAStrip) {
  constexpr double kThin = 1e-3;
  const EdgeDrag disc(hydro::make_cylinder(0.5, kThin, 128, 1));
  const double taken = -disc.load(moving({0, 0, 1}), kDeep).force.z();
  const double around = 128 * std::sin(M_PI / 128);
  const double at_disc = std::cbrt(taken / (2 * around * kDeep.density * hydro::kEdgeDrag));
  EXPECT_NEAR(at_disc / strength(1, kThin, moving({0, 0, 1})), 2 / M_PI, tolerance(0.05));
}

// A barge with its centre of gravity in the waterline [I93]: B_44 = (2/π) ρ L d⁴ (H² + 1)² φ ω,
// H = B/2d, is the linear equivalent of the moment ¾ ρ L d⁴ (H² + 1)² φ'².
TEST(EdgeDrag, OfARollingBargeIsIkedas) {
  for (const double ratio : {2.0, 3.0, 4.0, 6.0, 8.0}) {
    const double length = 1000, draught = 0.5, H = ratio / 2;
    const EdgeDrag edges(make_box({length, ratio * draught, 2 * draught}));
    const double moment = -edges.load(moving({0, 0, 0}, {1, 0, 0}), kCalm).moment.x();
    const double ikeda = 0.75 * 1000 * length * std::pow(draught, 4) * std::pow(H * H + 1, 2);
    EXPECT_NEAR(moment / ikeda, 0.82, tolerance(0.2)) << ratio;
  }
}

TEST(EdgeDrag, TakesPowerInAnyMotionAndIsQuadratic) {
  support::Random random(1);
  const EdgeDrag edges(make_box({3, 2, 1}));
  for (int i = 0; i < 100; ++i) {
    BodyState state = random.state(0.5, 2);
    const Wrench load = edges.load(state, kCalm);
    EXPECT_LT(power(load, state), 0);
    state.linear_velocity *= -2;
    state.angular_velocity *= -2;
    const Wrench faster = edges.load(state, kCalm);
    EXPECT_NEAR((faster.force + 4 * load.force).norm(), 0, tolerance(1e-12 * load.force.norm()));
    EXPECT_NEAR((faster.moment + 4 * load.moment).norm(), 0, tolerance(1e-12 * load.moment.norm()));
  }
}

TEST(EdgeDrag, HasTheDerivativeByItsJacobian) {
  support::Random random(2);
  const EdgeDrag edges(make_box({3, 2, 1}));
  for (int i = 0; i < 20; ++i) {
    const BodyState state = random.state(0.5, 2);
    const Matrix6d J = edges.jacobian(state, kCalm);
    EXPECT_TRUE(hydro::is_symmetric(J));
    EXPECT_LT(hydro::eigen_decomposition(J).values.maxCoeff(), 1e-9 * J.norm());
    for (int k = 0; k < 6; ++k) {
      const double step = 1e-5;
      const auto load = [&](double change) {
        BodyState changed = state;
        (k < 3 ? changed.linear_velocity[k] : changed.angular_velocity[k - 3]) += change;
        const Wrench wrench = edges.load(changed, kCalm);
        Vector6d six;
        six << wrench.force, wrench.moment;
        return six;
      };
      const Vector6d slope = (load(step) - load(-step)) / (2 * step);
      EXPECT_NEAR((slope - J.col(k)).norm(), 0, tolerance(1e-4 * J.norm()));
    }
  }
}

TEST(EdgeDrag, MeetsTheWaterThatMoves) {
  const EdgeDrag edges(make_box({3, 2, 1}));
  HullWater stream = kDeep;
  stream.velocity = {0.3, -0.2, 0.5};
  const Wrench still = edges.load(moving(-stream.velocity), kDeep);
  EXPECT_EQ(edges.load(moving(Vector3d::Zero()), stream).force, still.force);
  EXPECT_GT(still.force.dot(stream.velocity), 0);
}

TEST(EdgeDrag, OfAHalfImmersedBoxIsHalf) {
  const EdgeDrag edges(make_box({3, 2, 1}, 2));
  const BodyState heaving = moving({0, 0, 1});
  EXPECT_NEAR(2 * edges.load(heaving, kCalm).force.z(), edges.load(heaving, kDeep).force.z(),
              tolerance(1e-9));
  BodyState dry = heaving;
  dry.position.z() = 0.51;
  EXPECT_EQ(edges.load(dry, kCalm).force, Vector3d::Zero());
}

TEST(EdgeDrag, DoesNotDependOnTheTrianglesOfABox) {
  const BodyState swaying = moving({0.1, 1, 0.4});
  const Vector3d coarse = EdgeDrag(make_box({3, 2, 1})).load(swaying, kDeep).force;
  const Vector3d fine = EdgeDrag(make_box({3, 2, 1}, 8)).load(swaying, kDeep).force;
  EXPECT_NEAR((fine - coarse).norm(), 0, tolerance(1e-9 * coarse.norm()));
}

TEST(EdgeDrag, OfRoundBodiesIsNone) {
  EXPECT_TRUE(EdgeDrag(hydro::make_icosphere(1, 2)).none());
  EXPECT_TRUE(EdgeDrag(hydro::make_ellipsoid({3, 1, 1}, 24, 24)).none());
}

// The side of a drum turns by 45° from face to face.
TEST(EdgeDrag, OfADrumIsThatOfItsEnds) {
  const EdgeDrag edges(hydro::make_cylinder(1, 2, 8, 2));
  EXPECT_FALSE(edges.none());
  EXPECT_NEAR(edges.load(moving({0, 0, 0}, {0, 0, 1}), kDeep).moment.norm(), 0, 1e-20);
  EXPECT_GT(-edges.load(moving({0, 0, 1}), kDeep).force.z(), 1000);
}

TEST(EdgeDrag, TurnsWithTheBody) {
  support::Random random(4);
  const EdgeDrag edges(make_box({3, 2, 1}));
  BodyState state = random.state(0, 1);
  const Wrench load = edges.load(state, kDeep);
  const Eigen::Quaterniond turn = random.rotation();
  state.orientation = turn * state.orientation;
  state.linear_velocity = turn * state.linear_velocity;
  state.angular_velocity = turn * state.angular_velocity;
  const Wrench turned = edges.load(state, kDeep);
  EXPECT_NEAR((turned.force - turn * load.force).norm(), 0, tolerance(1e-12 * load.force.norm()));
  EXPECT_NEAR((turned.moment - turn * load.moment).norm(), 0,
              tolerance(1e-12 * load.moment.norm()));
}

}  // namespace

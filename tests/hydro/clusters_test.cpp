#include <gtest/gtest.h>

#include <algorithm>

#include "hydro/loads/loads.h"
#include "hydro/loads/viscous_drag.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"
#include "tests/support/reference_loads.h"
#include "tests/support/repeats.h"
#include "tests/support/tolerance.h"

/// Viscous drag of whole branches by few points, against the sum over the faces.

namespace {

using hydro::BodyState;
using hydro::Coefficients;
using hydro::Hull;
using hydro::Sea;
using hydro::ViscousDrag;
using hydro::Wrench;

/// Round, flat with edges, long, and rough: all of enough faces to have clusters.
std::vector<Hull> large_hulls(support::Random& random) {
  std::vector<Hull> all;
  all.push_back(hydro::make_hull(hydro::make_icosphere(1, 5)));
  all.push_back(hydro::make_hull(hydro::make_box({2, 3, 0.1}, 32)));
  all.push_back(hydro::make_hull(hydro::make_cylinder(0.4, 6, 96, 64)));
  all.push_back(hydro::make_hull(support::random_star(random, 5)));
  for (const Hull& hull : all) EXPECT_FALSE(hull.tree.clusters.empty());
  return all;
}

std::vector<ViscousDrag> laws() {
  return {{ViscousDrag::Law::constant, 0.02},
          {ViscousDrag::Law::thesis},
          {.law = ViscousDrag::Law::ittc57, .length = 2, .reynolds_per_speed = 2e6},
          // Re = 1e4 at 1 m/s: the line is held on a part of the body.
          {.law = ViscousDrag::Law::ittc57, .length = 0.01, .reynolds_per_speed = 1e4}};
}

/// Motion number i of a body: it slides, turns or does both, below 1 m/s, across 1 and 2, and
/// above.
BodyState motion(int i, const Hull& hull, support::Random& random) {
  BodyState state{.orientation = random.rotation()};
  state.position = i % 2 == 0 ? Eigen::Vector3d(0, 0, -20) : random.vector(0.5 * hull.radius);
  constexpr double kSpeeds[] = {0.4, 1.5, 5};
  const double speed = kSpeeds[i % 3];
  if (i % 4 != 1) state.linear_velocity = speed * random.vector(1).normalized();
  if (i % 4 != 2) state.angular_velocity = random.vector(speed / hull.radius);
  return state;
}

/// The scale of the tolerance: all of the skin under the largest traction of its fastest place [N].
double scale_of(const Hull& hull, const BodyState& state, const Sea& sea, const ViscousDrag& law) {
  const double fastest = state.linear_velocity.norm() + hull.radius * state.angular_velocity.norm();
  double most = 0;
  for (int i = 1; i <= 1000; ++i) {
    const double speed = fastest * i / 1000;
    most = std::max(most, hydro::viscous_coefficient(law, speed) * speed * speed);
  }
  return 0.5 * sea.density * most *
         hull.tree.nodes[0].moment[hydro::kernel::kOne][hydro::kernel::kAreaLane];
}

Wrench drag(const Hull& hull, const BodyState& state, const Sea& sea, const ViscousDrag& law,
            const hydro::Summation& how) {
  return hydro::compute_loads(hull, state, sea, 0.3, {.viscous_drag = law}, how).viscous_drag;
}

/// The sum over the faces is itself only to 1e-5 of its largest component: with the ITTC line.
constexpr double kFaces = 1e-6;

TEST(Clusters, KeepTheErrorBelowTheToleranceInAnyPoseAndMotion) {
  support::Random random(61);
  const Sea sea{.density = 1025};
  int all = 0, differs = 0;
  for (const Hull& hull : large_hulls(random)) {
    for (const ViscousDrag& law : laws()) {
      for (int i = 0; i < support::repeats(12); ++i) {
        const BodyState state = motion(i, hull, random);
        const Wrench each = drag(hull, state, sea, law, {.branches = false});
        const double scale = scale_of(hull, state, sea, law);
        for (const double wanted : {1e-2, 1e-4, 1e-6}) {
          SCOPED_TRACE(testing::Message()
                       << hull.mesh_B.face_count() << " faces, motion " << i << ", law "
                       << static_cast<int>(law.law) << ", " << wanted);
          const Wrench ours = drag(hull, state, sea, law, {.wave_tolerance = wanted});
          const double error = support::tolerance(wanted + kFaces) * scale;
          EXPECT_LE((ours.force - each.force).norm(), error);
          EXPECT_LE((ours.moment - each.moment).norm(), error * hull.radius);
          ++all;
          if ((ours.force - each.force).norm() > 1e-12 * scale) ++differs;
        }
      }
    }
  }
  EXPECT_GT(differs, all / 8);  // Else hardly a cluster was taken.
}

TEST(Clusters, AreMuchBetterThanTheirBound) {
  support::Random random(62);
  const Hull hull = hydro::make_hull(hydro::make_icosphere(1, 5));
  for (const ViscousDrag& law : laws()) {
    for (int i = 0; i < support::repeats(12); ++i) {
      const BodyState state = motion(i, hull, random);
      const Wrench each = drag(hull, state, {}, law, {.branches = false});
      const Wrench ours = drag(hull, state, {}, law, {.wave_tolerance = 1e-2});
      const double error = support::tolerance(1e-5) * scale_of(hull, state, {}, law);
      EXPECT_LE((ours.force - each.force).norm(), error);
      EXPECT_LE((ours.moment - each.moment).norm(), error);
    }
  }
}

TEST(Clusters, AreNotTakenWithoutATolerance) {
  support::Random random(63);
  for (const Hull& hull : large_hulls(random)) {
    for (const ViscousDrag& law : laws()) {
      for (int i = 0; i < support::repeats(6); ++i) {
        const BodyState state = motion(i, hull, random);
        const Wrench each = drag(hull, state, {}, law, {.branches = false});
        const Wrench ours = drag(hull, state, {}, law, {.wave_tolerance = 0});
        const double error = support::tolerance(1e-12) * scale_of(hull, state, {}, law);
        EXPECT_LE((ours.force - each.force).norm(), error);
        EXPECT_LE((ours.moment - each.moment).norm(), error * hull.radius);
      }
    }
  }
}

TEST(Clusters, AreWithoutDragWhereTheCoefficientIsZero) {
  const Hull hull = hydro::make_hull(hydro::make_box({2, 3, 1}, 32));
  // On no face is the tangential speed below 2 m/s, though the normal one is as large.
  BodyState state{.position = {0, 0, -5}, .linear_velocity = {2.1, 2, -2.2}};
  for (const double wanted : {1e-2, 1e-4, 0.0})
    EXPECT_EQ(support::largest(drag(hull, state, {}, {}, {.wave_tolerance = wanted})), 0);
  state.linear_velocity *= 0.6;
  EXPECT_GT(support::largest(drag(hull, state, {}, {}, {})), 0);
}

TEST(Clusters, TakeEnergyInAnyMotion) {
  support::Random random(64);
  for (const Hull& hull : large_hulls(random)) {
    for (int i = 0; i < support::repeats(12); ++i) {
      const BodyState state = motion(i, hull, random);
      const Wrench load = drag(hull, state, {}, laws()[0], {.wave_tolerance = 0.1});
      EXPECT_LT(load.force.dot(state.linear_velocity) + load.moment.dot(state.angular_velocity), 0);
    }
  }
}

/// The points of a branch are on its faces: the area is theirs, and so is the centroid.
TEST(Clusters, HaveTheAreaAndTheCentroidOfTheirFaces) {
  support::Random random(65);
  for (const Hull& hull : large_hulls(random)) {
    for (std::size_t i = 0; i < hull.tree.nodes.size(); ++i) {
      const hydro::kernel::Node& node = hull.tree.nodes[i];
      const hydro::kernel::Cluster& cluster = hull.tree.clusters[i];
      const int lane = hydro::kernel::kAreaLane;
      const double whole = node.moment[hydro::kernel::kOne][lane];
      double area = 0;
      Eigen::Vector3d first = Eigen::Vector3d::Zero(), faces;
      for (int k = 0; k < cluster.count; ++k) {
        EXPECT_GT(cluster.area[k], 0);
        area += cluster.area[k];
        first +=
            cluster.area[k] * Eigen::Vector3d(cluster.r[0][k], cluster.r[1][k], cluster.r[2][k]);
      }
      for (int axis = 0; axis < 3; ++axis)
        faces[axis] = node.moment[hydro::kernel::kPlace + axis][lane];
      EXPECT_NEAR(area, whole, support::tolerance(1e-12) * whole);
      EXPECT_LE((first - faces).norm(),
                (support::tolerance(1e-12) + cluster.gap[0]) * whole * hull.radius);
    }
  }
}

}  // namespace

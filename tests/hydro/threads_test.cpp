#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "hydro/loads/loads.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"

/// What runs on several threads; these tests run under the thread sanitizer too.

namespace {

using hydro::Loads;

void expect_same(const Loads& a, const Loads& b) {
  EXPECT_EQ(a.total().force, b.total().force);
  EXPECT_EQ(a.total().moment, b.total().moment);
  EXPECT_EQ(a.wetted_area, b.wetted_area);
  EXPECT_EQ(a.displaced_volume, b.displaced_volume);
}

TEST(Threads, LeaveTheLoadsAsTheyAreToTheLastBit) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 4);
  support::Random random(31);
  const hydro::Hull hull = hydro::make_hull(hydro::make_icosphere(1, 5));
  hydro::Sea sea{.density = 1025, .gravity = 9.81, .level = 0.3};
  for (const bool waves : {false, true}) {
    if (waves) sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.2, 3, 0.4, 1, 9.81)}};
    hydro::BodyState state = random.state(0.8, 2);
    state.position.z() += sea.level;
    Loads one;
    tbb::task_arena(1).execute([&] { one = hydro::compute_loads(hull, state, sea, 1, {}); });
    EXPECT_GT(one.wetted_area, 0);
    for (const int threads : {2, 3, 4}) {
      Loads many;
      tbb::task_arena(threads).execute(
          [&] { many = hydro::compute_loads(hull, state, sea, 1, {}); });
      expect_same(many, one);
    }
  }
}

TEST(Threads, FindTheSameFirstOverlapOfAMesh) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 4);
  const hydro::TriMesh ball = hydro::make_icosphere(1, 3);
  const hydro::TriMesh two = support::united(ball, hydro::translated(ball, {1.1, 0.2, 0.3}));
  hydro::MeshReport one;
  tbb::task_arena(1).execute([&] { one = hydro::check_mesh(two); });
  EXPECT_GT(one.self_overlaps.count, 0);
  for (const int threads : {2, 4}) {
    hydro::MeshReport many;
    tbb::task_arena(threads).execute([&] { many = hydro::check_mesh(two); });
    EXPECT_EQ(many.self_overlaps.count, one.self_overlaps.count);
    EXPECT_EQ(many.self_overlaps.first, one.self_overlaps.first);
  }
}

}  // namespace

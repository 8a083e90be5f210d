#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "hydro/added_mass/surface_added_mass.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/loads/loads.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"
#include "hydro/parallel.h"
#include "hydro/radiation/diffraction_load.h"
#include "tests/support/meshes.h"
#include "tests/support/random_pose.h"
#include "tests/support/water_planes.h"

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

/// Two poses a thread, some of which need the same nodes of the grid.
TEST(Threads, ShareWhatASurfaceModelHasSolved) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 4);
  const hydro::TriMesh mesh = hydro::make_box({4, 2, 1}, 2);
  constexpr int kPatches = 16;
  std::vector<hydro::WaterPlane> planes = support::some_planes(mesh, 4);
  planes.insert(planes.end(), planes.begin(), planes.end());
  const hydro::SurfaceAddedMass one(mesh, {}, kPatches), other(mesh, {}, kPatches);
  std::vector<hydro::Matrix6d> found(planes.size());
  tbb::task_arena(4).execute([&] {
    hydro::parallel_for(planes.size(), [&](std::size_t i) {
      found[i] = other.under(planes[i]);
      EXPECT_LE(other.nodes().size(), 80u);
    });
  });
  for (std::size_t i = planes.size(); i-- > 0;) EXPECT_EQ(one.under(planes[i]), found[i]);
  EXPECT_EQ(one.solves(), other.solves());
}

TEST(Threads, AskOneWettedModelAtOnce) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 4);
  const hydro::TriMesh mesh = hydro::make_box({2, 1.5, 1}, 3);
  hydro::AddedMassSolution solution;
  solution.potentials.assign(static_cast<std::size_t>(mesh.face_count()),
                             hydro::CornerPotentials::Random());
  const hydro::WettedAddedMass model(mesh, solution);
  hydro::Sea sea{.density = 1025};
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.1, 1.3, 0.4, 1, 9.81)}};
  support::Random random(33);
  std::vector<hydro::BodyState> states;
  for (int i = 0; i < 16; ++i) states.push_back(random.state(0.4, 0));
  std::vector<hydro::Matrix6d> found(states.size());
  tbb::task_arena(4).execute([&] {
    hydro::parallel_for(states.size(),
                        [&](std::size_t i) { found[i] = model.at(states[i], sea, 0.5); });
  });
  for (std::size_t i = 0; i < states.size(); ++i)
    EXPECT_EQ(model.at(states[i], sea, 0.5), found[i]);
}

TEST(Threads, MakeTheDiffractionOfASeaOnce) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 4);
  hydro::RadiationData data;
  data.frequencies = {1, 2};
  data.headings = {0};
  data.diffraction.resize(2, hydro::Vector6cd::Constant({0.3, 0.4}));
  const hydro::DiffractionLoad load(data), same(data);
  const auto at = [](const hydro::DiffractionLoad& of, int wave) {
    hydro::Sea sea;
    sea.surface =
        hydro::WaveSurface{{hydro::deep_water_wave(0.2, 3 + wave % 3, 0.4, 1, sea.gravity)}};
    return of.at(Eigen::Vector3d::Zero(), {}, {}, sea, wave).force;
  };
  std::vector<Eigen::Vector3d> forces(60);
  tbb::task_arena(4).execute([&] {
    hydro::parallel_for(forces.size(),
                        [&](std::size_t i) { forces[i] = at(load, static_cast<int>(i)); });
  });
  for (std::size_t i = 0; i < forces.size(); ++i)
    EXPECT_EQ(forces[i], at(same, static_cast<int>(i)));
}

}  // namespace

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include "app/assembly/mesh_io.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/loads/loads.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/benchmarks/benches.h"

/// @file
/// The added mass of a body's wetted part in waves and the load of the waves on it, beside all
/// loads of the default coefficients in the same state; each is computed once a substep. Names are
/// BM_WettedAddedMass/TRIANGLES, BM_WaveLoad/TRIANGLES and BM_LoadsBeside/TRIANGLES: 1,620
/// triangles are the barge of scenes/barge_in_swell.yaml in its two waves, whose faces are split;
/// others are a half-immersed sphere in one wave. On one thread.

namespace bench {
namespace {

using hydro::Sea;
using hydro::TriMesh;

struct Wetted {
  TriMesh mesh;
  Sea sea;
  hydro::BodyState state;
};

Wetted sphere(int subdivisions) {
  Wetted wetted{.mesh = hydro::make_icosphere(1, subdivisions), .sea = {.density = 1025}};
  wetted.sea.surface =
      hydro::WaveSurface{{hydro::deep_water_wave(0.3, 12, 0.3, 0, wetted.sea.gravity)}};
  wetted.state = {.orientation = Eigen::Quaterniond(0.6, 0.3, -0.5, 0.5).normalized(),
                  .linear_velocity = {1, 0.3, -0.2},
                  .angular_velocity = {0.3, -0.2, 0.5}};
  return wetted;
}

Wetted barge() {
  const TriMesh mesh = assembly::read_mesh(PLIMSOLL_SOURCE_DIR "/scenes/meshes/barge.obj");
  Wetted wetted{.mesh = hydro::translated(mesh, -hydro::solid_properties(mesh).centroid),
                .sea = {.density = 1025}};
  const double g = wetted.sea.gravity;
  wetted.sea.surface = hydro::WaveSurface{
      {hydro::deep_water_wave(0.6, 26, 3.58, 0, g), hydro::deep_water_wave(0.2, 12, 1.92, 0.7, g)}};
  wetted.state = {.position = {0, 0, -0.1},
                  .orientation = Eigen::Quaterniond(0.99, 0.02, -0.03, 0.05).normalized(),
                  .linear_velocity = {0.3, 0.1, -0.2},
                  .angular_velocity = {0.03, -0.02, 0.05}};
  return wetted;
}

/// Potentials that need no solver: their values do not change the cost.
hydro::AddedMassSolution linear_potentials(const TriMesh& mesh) {
  hydro::AddedMassSolution solution;
  for (const auto& face : mesh.faces.colwise()) {
    std::array<Eigen::Vector3d, 3> corners;
    hydro::CornerPotentials psi = hydro::CornerPotentials::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = mesh.vertices.col(face[static_cast<Eigen::Index>(i)]);
      psi.col(static_cast<Eigen::Index>(i)).head<3>() = corners[i] / 2;
    }
    solution.matrix += hydro::triangle_share(corners, psi);
    solution.potentials.push_back(psi);
  }
  return solution;
}

void added_mass(benchmark::State& state, const Wetted& wetted) {
  const hydro::WettedAddedMass model(wetted.mesh, linear_potentials(wetted.mesh));
  for (auto _ : state) benchmark::DoNotOptimize(model.at(wetted.state, wetted.sea, 0.7));
}

void wave_load(benchmark::State& state, const Wetted& wetted) {
  const hydro::WettedAddedMass model(wetted.mesh, linear_potentials(wetted.mesh));
  for (auto _ : state) benchmark::DoNotOptimize(model.wave_share(wetted.state, wetted.sea, 0.7));
}

void loads(benchmark::State& state, const Wetted& wetted) {
  const hydro::Hull hull = hydro::make_hull(wetted.mesh);
  tbb::task_arena arena(1);
  for (auto _ : state) {
    arena.execute([&] {
      benchmark::DoNotOptimize(hydro::compute_loads(hull, wetted.state, wetted.sea, 0.7, {}));
    });
  }
}

void add(const Wetted& wetted) {
  const auto triangles = wetted.mesh.face_count();
  const auto named = [&](const char* kind) { return fmt::format("{}/{}", kind, triangles); };
  benchmark::RegisterBenchmark(named("BM_WettedAddedMass").c_str(),
                               [=](benchmark::State& state) { added_mass(state, wetted); });
  benchmark::RegisterBenchmark(named("BM_WaveLoad").c_str(),
                               [=](benchmark::State& state) { wave_load(state, wetted); });
  benchmark::RegisterBenchmark(named("BM_LoadsBeside").c_str(),
                               [=](benchmark::State& state) { loads(state, wetted); });
}

}  // namespace

void register_wetted_added_mass() {
  add(barge());
  add(sphere(4));
}

}  // namespace bench

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include "hydro/added_mass/added_mass.h"
#include "hydro/mesh/primitives.h"
#include "tests/benchmarks/benches.h"

/// @file
/// Solving for the added mass of a sphere of its own triangles. A name is BM_AddedMass/TRIANGLES;
/// on one thread. The program keeps what it has solved, so that a scene pays this once.

namespace bench {
namespace {

void added_mass(benchmark::State& state, int subdivisions) {
  const hydro::TriMesh mesh = hydro::make_icosphere(1, subdivisions);
  tbb::task_arena arena(1);
  int unknowns = 0;
  for (auto _ : state) arena.execute([&] { unknowns = hydro::solve_added_mass(mesh).unknowns; });
  state.counters["unknowns"] = unknowns;
}

}  // namespace

void register_added_mass() {
  for (const int subdivisions : {2, 3, 4}) {
    const std::string name = fmt::format("BM_AddedMass/{}", 20 << (2 * subdivisions));
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) {
      added_mass(s, subdivisions);
    })->Unit(benchmark::kMillisecond);
  }
}

}  // namespace bench

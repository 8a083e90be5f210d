#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <deque>
#include <filesystem>

#include "app/assembly/build.h"
#include "app/scene/reader.h"
#include "engine/motion/hulls.h"
#include "engine/simulation.h"
#include "hydro/parallel.h"
#include "tests/benchmarks/benches.h"

/// @file
/// Many simulations of one floating buoy at once, which share its hull and its added mass: what a
/// program in C++ reaches, for comparison with plimsoll.Batch (python_bench.py). A name is
/// BM_Fleet/SIMULATIONS/THREADS; an iteration is ten steps of each. Read the real time.

namespace bench {
namespace {

constexpr int kSteps = 10;

void fleet(benchmark::State& state) {
  const scene::Scene scene = scene::read(
      std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "tests" / "benchmarks" / "buoy.yaml", {});
  assembly::AddedMassStore store(assembly::cache_folder());
  engine::SimulationSpec spec = assembly::build(scene, store).spec;
  engine::Hulls hulls;
  engine::keep_hulls(spec, hulls);
  std::deque<engine::Simulation> buoys;
  for (int i = 0; i < state.range(0); ++i) buoys.emplace_back(spec);
  tbb::task_arena threads(static_cast<int>(state.range(1)));
  for (auto _ : state)
    threads.execute([&] {
      hydro::parallel_for(buoys.size(), [&](std::size_t i) {
        for (int n = 0; n < kSteps; ++n) buoys[i].step();
      });
    });
  state.SetItemsProcessed(state.iterations() * kSteps * state.range(0));
}

}  // namespace

void register_fleet() {
  benchmark::RegisterBenchmark("BM_Fleet", fleet)
      ->Args({1, 1})
      ->Args({256, 1})
      ->Args({256, 2})
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace bench

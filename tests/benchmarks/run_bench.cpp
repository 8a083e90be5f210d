#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "app/assembly/mesh_io.h"
#include "app/run/run.h"
#include "tests/benchmarks/benches.h"

/// @file
/// Whole runs, as `plimsoll run --no-render --quiet` does them: a scene and its meshes are read and
/// checked, the stored added mass is taken, all steps are simulated and logged. Read the real time.
///
/// BM_Run/TRIANGLES is the teapot drop, 3.6 s in steps of 10 ms. BM_CratesInContact/CRATES, on one
/// thread, and BM_Raft/CRATES, on two, are of crates of 12 triangles with their added mass.
/// BM_Storm/BODIES, on two threads, is of 300 mixed bodies about a boat in 64 waves.
/// `simulated_per_second` is how many seconds of the scene pass in one of the run.
namespace bench {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = PLIMSOLL_SOURCE_DIR;

/// @param duration   Simulated time [s].
void run(benchmark::State& state, app::RunOptions options, double duration) {
  options.out = fs::temp_directory_path() / fmt::format("plimsoll_bench_run_{}", getpid());
  options.render = false;
  options.quiet = true;
  app::run(options);  // Stores the added mass if it is the first.
  for (auto _ : state) benchmark::DoNotOptimize(app::run(options));
  state.counters["simulated_per_second"] =
      benchmark::Counter(duration, benchmark::Counter::kIsIterationInvariantRate);
  fs::remove_all(options.out);
}

void add(const std::string& name, const app::RunOptions& options, double duration) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { run(state, options, duration); })
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_run() {
  const fs::path scenes = kSource / "scenes", crowds = kSource / "tests" / "benchmarks";
  const hydro::TriMesh mesh = assembly::read_mesh(scenes / "meshes" / "teapot.obj");
  add(fmt::format("BM_Run/{}", mesh.face_count()), {.scene = scenes / "teapot_drop.yaml"}, 3.6);
  add("BM_CratesInContact/1000", {.scene = crowds / "crates_in_contact.yaml", .threads = 1}, 2);
  add("BM_Raft/10000", {.scene = crowds / "raft.yaml", .threads = 2}, 4);
  add("BM_Storm/301", {.scene = crowds / "storm.yaml", .threads = 2}, 5);
}

}  // namespace bench

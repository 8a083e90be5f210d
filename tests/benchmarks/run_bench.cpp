#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "app/assembly/mesh_io.h"
#include "app/run/run.h"
#include "tests/benchmarks/benches.h"

/// @file
/// The teapot drop as a whole, as `plimsoll run --no-render --quiet` does it in steps of 10 ms: the
/// scene and the mesh are read and checked, the stored added mass is taken, 3.6 s are simulated and
/// logged. A name is BM_Run/TRIANGLES. Read the real time.

namespace bench {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = fs::path(PLIMSOLL_SOURCE_DIR) / "scenes";

void run(benchmark::State& state) {
  const fs::path out = fs::temp_directory_path() / fmt::format("plimsoll_bench_run_{}", getpid());
  const app::RunOptions options{
      .scene = kScenes / "teapot_drop.yaml", .out = out, .render = false, .quiet = true};
  app::run(options);  // Stores the added mass if it is the first.
  for (auto _ : state) benchmark::DoNotOptimize(app::run(options));
  fs::remove_all(out);
}

}  // namespace

void register_run() {
  const hydro::TriMesh mesh = assembly::read_mesh(kScenes / "meshes" / "teapot.obj");
  benchmark::RegisterBenchmark(fmt::format("BM_Run/{}", mesh.face_count()).c_str(), run)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace bench

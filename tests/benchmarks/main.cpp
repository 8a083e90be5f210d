#include <benchmark/benchmark.h>

#include "tests/benchmarks/benches.h"

/// The project's benchmarks; `tools/benchmark` runs them and draws what they say.
int main(int argc, char** argv) {
  bench::register_hydro();
  bench::register_step();
  bench::register_hollow();
  bench::register_added_mass();
  bench::register_wetted_added_mass();
  bench::register_machines();
  bench::register_rigs();
  bench::register_mesh();
  bench::register_frame();
  bench::register_run();
  bench::register_fleet();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

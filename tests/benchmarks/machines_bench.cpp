#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "hydro/lines/catenary.h"
#include "hydro/machines/foil.h"
#include "hydro/machines/propeller.h"
#include "tests/benchmarks/benches.h"

/// @file
/// A mooring line, a screw and a rudder, as a step asks for them. BM_Catenary/FORM follows a
/// fairlead that moves by 5 mm a solve, each from the solution before; BM_Catenary/FORM/cold starts
/// from nothing. Read the CPU time.

namespace bench {
namespace {

constexpr hydro::CatenaryLine kChain{500, 800, 7.5e8, 0.5};

void catenary(benchmark::State& state, double span, bool warm) {
  hydro::CatenarySolution last = hydro::solve_catenary(kChain, span, 200, true);
  double phase = 0;
  for (auto _ : state) {
    phase += 0.01;
    const double x = span + 0.5 * std::sin(phase);
    last = warm ? hydro::solve_catenary(kChain, x, 200, true,
                                        Eigen::Vector2d(last.horizontal, last.vertical))
                : hydro::solve_catenary(kChain, x, 200, true);
    benchmark::DoNotOptimize(last);
  }
}

void propeller(benchmark::State& state) {
  const hydro::PropellerCurves curves({.model = hydro::WageningenB{}, .diameter = 2});
  double phase = 0;
  for (auto _ : state) {
    phase += 0.01;
    benchmark::DoNotOptimize(curves.load(3 * std::cos(phase), 4 * std::sin(phase), 1025, 1));
  }
}

void foil(benchmark::State& state) {
  const hydro::Foil rudder{.span = 3, .chord = 1.5};
  double phase = 0;
  for (auto _ : state) {
    phase += 0.01;
    const Eigen::Vector3d flow(-4 * std::cos(phase), 4 * std::sin(phase), 0.3);
    benchmark::DoNotOptimize(
        hydro::foil_force(rudder, flow, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), 1025));
  }
}

}  // namespace

void register_machines() {
  for (const bool warm : {true, false}) {
    const std::string how = warm ? "" : "/cold";
    benchmark::RegisterBenchmark(("BM_Catenary/on_bottom" + how).c_str(),
                                 [=](benchmark::State& s) { catenary(s, 400, warm); });
    benchmark::RegisterBenchmark(("BM_Catenary/suspended" + how).c_str(),
                                 [=](benchmark::State& s) { catenary(s, 455, warm); });
  }
  benchmark::RegisterBenchmark("BM_Propeller", propeller);
  benchmark::RegisterBenchmark("BM_Foil", foil);
}

}  // namespace bench

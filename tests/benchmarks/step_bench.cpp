#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

#include "engine/simulation.h"
#include "hydro/mass_properties.h"
#include "hydro/primitives.h"
#include "tests/benchmarks/benches.h"

/// @file
/// A step of 1/60 s of crates afloat in still water, on one thread. A name is BM_Step/BODIES, 2 m
/// between them, or BM_Step/BODIES/crates, the same in a heap three high. Each has 192 triangles,
/// the default coefficients, half the density of the water, and rocks. The second of motion that
/// is measured begins a second after the start and is run again and again; `held` is the share of
/// the bodies' steps in it that contacts had a part in.

namespace bench {
namespace {

constexpr int kSettling = 60;  // Steps.
constexpr int kMeasured = 60;

Eigen::Vector3d place(int body, int bodies, bool heap) {
  const int layers = heap ? 3 : 1;
  const int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(bodies) / layers)));
  const double pitch = heap ? 1.05 : 3;
  return pitch * Eigen::Vector3d(body % side, body / side % side, body / (side * side));
}

engine::SimulationSpec crates(int bodies, bool heap) {
  const hydro::TriMesh mesh = hydro::make_box({1, 1, 1}, 4);
  const hydro::SolidProperties solid = hydro::solid_properties(mesh);
  const double density = 500;
  engine::SimulationSpec spec;
  spec.sea = hydro::Sea{};
  for (int i = 0; i < bodies; ++i) {
    engine::BodySpec& body = spec.bodies.emplace_back();
    body.name = fmt::format("crate{}", i + 1);
    body.mesh_B = mesh;
    body.mass = density * solid.volume;
    body.inertia_B = density * solid.inertia;
    body.initial.position = place(i, bodies, heap);
    const Eigen::Vector3d axis(std::cos(i), std::sin(i), 0);
    body.initial.orientation = Eigen::AngleAxisd(0.05, axis);
  }
  return spec;
}

/// The world a second later, made once.
const engine::SimulationSpec& settled(int bodies, bool heap) {
  static std::map<std::pair<int, bool>, engine::SimulationSpec> made;
  const auto [entry, is_new] = made.try_emplace({bodies, heap});
  if (!is_new) return entry->second;
  engine::Simulation simulation(crates(bodies, heap));
  for (int i = 0; i < kSettling; ++i) simulation.step();
  entry->second = simulation.spec();
  for (int i = 0; i < bodies; ++i) entry->second.bodies[i].initial = simulation.states()[i];
  return entry->second;
}

double held_share(const engine::Simulation& simulation) {
  double held = 0, all = 0;
  for (const engine::Path& path : simulation.paths()) {
    held += static_cast<double>(path.constrained);
    all += static_cast<double>(path.constrained + path.free);
  }
  return held / all;
}

void step(benchmark::State& state, int bodies, bool heap) {
  const engine::SimulationSpec& spec = settled(bodies, heap);
  engine::Simulation simulation(spec);
  for (auto _ : state) {
    if (simulation.steps() == kMeasured) {
      state.PauseTiming();
      simulation = engine::Simulation(spec);
      state.ResumeTiming();
    }
    simulation.step();
  }
  state.counters["held"] = held_share(simulation);
  state.counters["us_per_body"] = benchmark::Counter(
      bodies * 1e-6, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

void register_step() {
  for (const bool heap : {false, true}) {
    for (const int bodies : {1, 10, 100, 1000}) {
      if (heap && bodies == 1) continue;
      const std::string name = fmt::format("BM_Step/{}{}", bodies, heap ? "/crates" : "");
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) {
        step(s, bodies, heap);
      })->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace bench

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <compare>
#include <map>

#include "engine/simulation.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/benchmarks/benches.h"

/// @file
/// A step of 1/60 s of crates afloat in still water, on one thread. A name is BM_Step/BODIES, 2 m
/// between them, BM_Step/BODIES/crates, the same in heaps of ten, three high, or
/// BM_Step/BODIES/heap, all in one heap. Each crate has 192 triangles, the default coefficients,
/// half the density of the water, and rocks; those of BM_Step/BODIES/boxes, apart, and
/// BM_Step/BODIES/boxes_heap have 12 triangles and no viscous drag. The half second of motion that
/// is measured begins two seconds after the start; `held` is the share of the bodies' steps that
/// contacts had a part in.
namespace bench {
namespace {

constexpr int kSettling = 120;  // Steps.
constexpr int kWarmUp = 3;
constexpr int kMeasured = 30;

/// Crates in heaps of so many.
struct Crates {
  int bodies = 1;
  int heap = 1;
  bool plain = false;  ///< Boxes of 12 triangles without viscous drag.
  auto operator<=>(const Crates&) const = default;
};

/// Of a body in rows and layers of `side` × `side`.
Eigen::Vector3d in_grid(int index, int side) {
  return Eigen::Vector3d(index % side, index / side % side, index / (side * side));
}

int side_of(double squares) { return static_cast<int>(std::ceil(std::sqrt(squares))); }

Eigen::Vector3d place(int body, const Crates& crates) {
  const int heaps = crates.bodies / crates.heap;
  return (crates.heap == 1 ? 3 : 8) * in_grid(body / crates.heap, side_of(heaps)) +
         1.05 * in_grid(body % crates.heap, side_of(crates.heap / 3.0));
}

engine::SimulationSpec world_of(const Crates& crates) {
  const hydro::TriMesh mesh = hydro::make_box({1, 1, 1}, crates.plain ? 1 : 4);
  const hydro::SolidProperties solid = hydro::solid_properties(mesh);
  const double density = 500;
  engine::SimulationSpec spec;
  spec.sea = hydro::Sea{};
  for (int i = 0; i < crates.bodies; ++i) {
    engine::BodySpec& body = spec.bodies.emplace_back();
    body.name = fmt::format("crate{}", i + 1);
    body.mesh_B = mesh;
    body.collision = engine::CollisionShape::box;  // As a scene's boxes have it.
    body.mass = density * solid.volume;
    body.inertia_B = density * solid.inertia;
    if (crates.plain) body.coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
    body.initial.position = place(i, crates);
    const Eigen::Vector3d axis(std::cos(i), std::sin(i), 0);
    body.initial.orientation = Eigen::AngleAxisd(0.05, axis);
  }
  return spec;
}

/// The world once they have settled, made once.
const engine::SimulationSpec& settled(const Crates& crates) {
  static std::map<Crates, engine::SimulationSpec> made;
  const auto [entry, is_new] = made.try_emplace(crates);
  if (!is_new) return entry->second;
  engine::Simulation simulation(world_of(crates));
  for (int i = 0; i < kSettling; ++i) simulation.step();
  entry->second = simulation.spec();
  for (int i = 0; i < crates.bodies; ++i) entry->second.bodies[i].initial = simulation.states()[i];
  return entry->second;
}

double held_share(const engine::Simulation& simulation) {
  double held = 0, all = 0;
  for (const engine::Counts& counts : simulation.counts()) {
    held += static_cast<double>(counts.constrained);
    all += static_cast<double>(counts.constrained + counts.free);
  }
  return held / all;
}

void step(benchmark::State& state, const Crates& crates) {
  engine::Simulation simulation(settled(crates));
  // Memory is filled for the first time.
  for (int i = 0; i < kWarmUp; ++i) simulation.step();
  for (auto _ : state) simulation.step();
  state.counters["held"] = held_share(simulation);
  state.counters["us_per_body"] =
      benchmark::Counter(crates.bodies * 1e-6, benchmark::Counter::kIsIterationInvariantRate |
                                                   benchmark::Counter::kInvert);
}

void add_step(const Crates& crates, const char* arrangement) {
  const std::string name = fmt::format("BM_Step/{}{}", crates.bodies, arrangement);
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) { step(s, crates); })
      ->Iterations(kMeasured)
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_step() {
  for (const int bodies : {1, 10, 100, 1000}) add_step({bodies, 1}, "");
  for (const int bodies : {10, 100, 1000}) {
    add_step({bodies, 10}, "/crates");
    add_step({bodies, bodies}, "/heap");
  }
  add_step({.bodies = 1000, .plain = true}, "/boxes");
  add_step({.bodies = 1000, .heap = 1000, .plain = true}, "/boxes_heap");
}

}  // namespace bench

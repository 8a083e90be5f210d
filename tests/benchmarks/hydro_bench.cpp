#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <memory>

#include "hydro/loads/loads.h"
#include "hydro/loads/plain_loads.h"
#include "hydro/loads/wind.h"
#include "hydro/mesh/primitives.h"
#include "hydro/water/simulated_water.h"
#include "hydro/wave_spectrum.h"
#include "tests/benchmarks/bare_loop.h"
#include "tests/benchmarks/benches.h"

/// @file
/// Loads on one body. A name is BM_Hydro/SHAPE/TRIANGLES/STATE/THREADS[/WHAT]: without WHAT all
/// loads of the default coefficients but viscous drag, with the tree; `viscous` adds that,
/// `no_tree` takes every leaf, `plain` is the sum that the tests compare with, `wind` is the load
/// of the air alone by the power law and `uniform_wind` that of a uniform wind, to be compared with
/// the water's loads on the same body. For one thread read the CPU time, for more the real time.
/// BM_BareLoop is the floor to compare with.

namespace bench {
namespace {

using hydro::BodyState;
using hydro::Sea;

const hydro::Coefficients kInviscid{.viscous_drag = {hydro::ViscousDrag::Law::none}};

struct Case {
  std::string state = "half";  ///< submerged, half, high, waves, field, jonswap or jonswap256.
  std::string what;
  int subdivisions = 4;  ///< Of an icosphere; 0 is a box of twelve triangles.
  int threads = 1;

  hydro::TriMesh mesh() const {
    return subdivisions > 0 ? hydro::make_icosphere(1, subdivisions) : hydro::make_box({2, 2, 2});
  }
};

/// A body that moves and turns, its centre in the surface, 5 m below or 0.6 m above: then 80 % of a
/// unit sphere are dry.
BodyState state_of(const std::string& name) {
  BodyState state{.orientation = Eigen::Quaterniond(0.6, 0.3, -0.5, 0.5).normalized(),
                  .linear_velocity = {1, 0.3, -0.2},
                  .angular_velocity = {0.3, -0.2, 0.5}};
  if (name == "submerged") state.position.z() = -5;
  if (name == "high") state.position.z() = 0.6;
  return state;
}

/// 256×256 heights of a swell of 12 m and a cross sea of 7 m, 0.25 m apart.
hydro::HeightField swell() {
  Eigen::MatrixXd heights(256, 256);
  for (int row = 0; row < 256; ++row) {
    for (int column = 0; column < 256; ++column) {
      const double x = 0.25 * column, y = 0.25 * row;
      heights(row, column) = 0.3 * std::cos(2 * M_PI * x / 12) + 0.1 * std::cos(2 * M_PI * y / 7);
    }
  }
  return hydro::make_height_field(heights, 0.25, {-32, -32});
}

Sea sea_of(const std::string& name) {
  Sea sea{.density = 1025};
  if (name == "waves")
    sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.3, 12, 0.3, 0, sea.gravity)}};
  if (name == "field") sea.surface = swell();
  if (name.starts_with("jonswap"))
    sea.surface = hydro::jonswap_sea(
        {.significant_height = 1.5, .spreading = 4, .components = name == "jonswap" ? 64 : 256},
        sea);
  return sea;
}

using Compute = hydro::Loads (*)(const hydro::Hull&, const BodyState&, const Sea&, double,
                                 const hydro::Coefficients&);

void count(benchmark::State& state, Eigen::Index triangles) {
  state.counters["ns_per_triangle"] = benchmark::Counter(
      static_cast<double>(triangles) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void loads_of_a_body(benchmark::State& state, const Case& c) {
  const hydro::Hull hull = hydro::make_hull(c.mesh());
  const Sea sea = sea_of(c.state);
  BodyState motion = state_of(c.state);
  if (c.what == "rest") motion.linear_velocity = motion.angular_velocity = {1e-200, 0, 1e-160};
  const hydro::Coefficients coefficients =
      c.what.starts_with("viscous") ? hydro::Coefficients{} : kInviscid;
  const bool plain = c.what == "plain" || c.what == "plain_viscous";
  const hydro::LoadAccuracy how{.branches = !c.what.ends_with("no_tree")};
  tbb::task_arena arena(c.threads);
  for (auto _ : state) {
    arena.execute([&] {
      benchmark::DoNotOptimize(
          plain ? hydro::plain_loads(hull, motion, sea, 0.7,
                                     c.what == "plain" ? kInviscid : hydro::Coefficients{})
                : hydro::compute_loads(hull, motion, sea, 0.7, coefficients, how));
    });
  }
  count(state, hull.mesh_B.face_count());
}

void load_of_wind(benchmark::State& state, const Case& c) {
  const hydro::Hull hull = hydro::make_hull(c.mesh());
  Sea sea = sea_of(c.state);
  sea.air = hydro::Air{.wind = {.velocity = {12, 5, 0}, .exponent = c.what == "wind" ? 0.11 : 0}};
  const BodyState motion = state_of(c.state);
  for (auto _ : state)
    benchmark::DoNotOptimize(hydro::wind_load(hull, motion, sea, 0.7, kInviscid));
  count(state, hull.mesh_B.face_count());
}

void bare(benchmark::State& state, int subdivisions) {
  const hydro::TriMesh mesh = hydro::make_icosphere(1, subdivisions);
  const BareTriangles triangles(mesh);
  const BodyState motion = state_of("half");
  for (auto _ : state)
    benchmark::DoNotOptimize(bare_loop(triangles, Eigen::Vector3d(0.6, 0, 0.8), 0.1,
                                       {motion.linear_velocity, motion.angular_velocity}));
  count(state, mesh.face_count());
}

/// A step of the waves that a ball makes as it goes on at 3 m/s.
void bodies_waves(benchmark::State& state, int cells) {
  const hydro::TriMesh ball = hydro::make_icosphere(1, 2);
  hydro::SimulatedWater water(Sea(), {{&ball, 1}}, {.cells = cells, .cell = 0.1});
  std::vector<BodyState> body(1);
  body[0].linear_velocity.x() = 3;
  for (double time = 0; auto _ : state) {
    water.follow(time += 0.1, body);
    body[0].position.x() += 0.3;
  }
}

void add(const Case& c) {
  const std::string shape = c.subdivisions > 0 ? "icosphere" : "box";
  const std::string name = fmt::format("BM_Hydro/{}/{}/{}/{}{}{}", shape, c.mesh().face_count(),
                                       c.state, c.threads, c.what.empty() ? "" : "/", c.what);
  benchmark::RegisterBenchmark(name.c_str(), [c](benchmark::State& s) {
    if (c.what.ends_with("wind")) return load_of_wind(s, c);
    loads_of_a_body(s, c);
  });
}

}  // namespace

void register_hydro() {
  for (const int subdivisions : {2, 3, 4, 5, 6}) {
    const std::string name = fmt::format("BM_BareLoop/icosphere/{}", 20 << (2 * subdivisions));
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) { bare(s, subdivisions); });
    for (const char* state : {"submerged", "half", "waves", "field", "jonswap"})
      for (const char* what :
           {"", "no_tree", "viscous", "viscous_no_tree", "plain", "plain_viscous"})
        add({state, what, subdivisions, 1});
  }
  for (const int subdivisions : {3, 6}) add({"jonswap256", "", subdivisions, 1});
  for (const int subdivisions : {0, 2, 3, 4, 6})
    for (const char* state : {"half", "waves", "jonswap"})
      for (const char* what : {"wind", "uniform_wind"}) add({state, what, subdivisions, 1});
  for (const char* state : {"half", "waves", "jonswap"})
    for (const char* what : {"", "viscous"}) add({state, what, 0, 1});
  for (const char* what : {"", "viscous", "wind", "uniform_wind"}) add({"high", what, 3, 1});
  for (const int cells : {256, 512})
    benchmark::RegisterBenchmark(fmt::format("BM_SimulatedWater/{}", cells).c_str(),
                                 [=](benchmark::State& s) { bodies_waves(s, cells); });
  add({"half", "rest", 4, 1});
  add({"half", "no_tree", 6, 2});
  add({"jonswap256", "viscous", 4, 1});
}

}  // namespace bench

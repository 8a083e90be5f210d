#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation.h"
#include "hydro/interior/lids.h"
#include "hydro/mesh/mass_properties.h"
#include "tests/benchmarks/benches.h"
#include "tests/support/hollows.h"

/// @file
/// A step of 1/60 s of an open box that floats and rolls, dry inside, and of the same hull under a
/// lid. A name is BM_HollowHull/TRIANGLES, BM_LiddedHull/TRIANGLES, or one of these with InWave;
/// the count is that of the open hull in each.
namespace bench {
namespace {

constexpr double kLength = 2, kBreadth = 1, kDepth = 1, kWall = 0.05;  // [m]
constexpr double kKeel = -0.35;  // Below the centre of mass [m].
constexpr int kFirstSteps = 30;
constexpr int kTimedSteps = 300;

/// Coordinates from one end to the other with planes at both faces of the walls, `spacing` apart at
/// most.
std::vector<double> planes(const std::vector<double>& walls, double spacing) {
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < walls.size(); ++i) {
    const double width = walls[i + 1] - walls[i];
    const int parts = std::max(1, static_cast<int>(std::round(width / spacing)));
    for (int k = 0; k < parts; ++k) all.push_back(walls[i] + width * k / parts);
  }
  all.push_back(walls.back());
  return all;
}

hydro::TriMesh open_hull(double spacing) {
  const double x = kLength / 2, y = kBreadth / 2;
  const std::array<std::vector<double>, 3> grid = {
      planes({-x, kWall - x, x - kWall, x}, spacing),
      planes({-y, kWall - y, y - kWall, y}, spacing),
      planes({kKeel, kKeel + kWall, kKeel + kDepth}, spacing)};
  const auto middle = [&](int axis, int i) { return (grid[axis][i] + grid[axis][i + 1]) / 2; };
  return support::blocks(grid, [&](int i, int j, int k) {
    return std::abs(middle(0, i)) > x - kWall || std::abs(middle(1, j)) > y - kWall ||
           middle(2, k) < kKeel + kWall;
  });
}

engine::SimulationSpec world_of(const hydro::TriMesh& mesh, bool in_wave) {
  engine::SimulationSpec spec{.step = 1.0 / 60};
  spec.sea = hydro::Sea{};
  if (in_wave)
    spec.sea->surface =
        hydro::WaveSurface{{hydro::deep_water_wave(0.05, 6, 0.3, 0, spec.sea->gravity)}};
  engine::BodySpec& body = spec.bodies.emplace_back();
  body.name = "hull";
  body.mesh_B = mesh;
  body.mass = 400;
  body.inertia_B = Eigen::Vector3d(60, 160, 170).asDiagonal();
  body.collision = engine::CollisionShape::none;
  body.interior = engine::Interior::flooding;
  body.initial.position.z() = 0.15;
  body.initial.orientation = Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, 0.3, 0).normalized());
  return spec;
}

void step(benchmark::State& state, const hydro::TriMesh& mesh, bool in_wave) {
  engine::Simulation simulation(world_of(mesh, in_wave));
  for (int i = 0; i < kFirstSteps; ++i) simulation.step();
  for (auto _ : state) simulation.step();
}

}  // namespace

void register_hollow() {
  const hydro::TriMesh open = open_hull(0.0165);
  const hydro::TriMesh lidded =
      hydro::with_lids(open, hydro::find_pockets(open, Eigen::Vector3d::UnitZ()));
  for (const bool in_wave : {false, true})
    for (const auto& [kind, mesh] : {std::pair("Hollow", open), std::pair("Lidded", lidded)}) {
      const std::string name =
          fmt::format("BM_{}Hull{}/{}", kind, in_wave ? "InWave" : "", open.face_count());
      benchmark::RegisterBenchmark(
          name.c_str(), [mesh = mesh, in_wave](benchmark::State& s) { step(s, mesh, in_wave); })
          ->Iterations(kTimedSteps)
          ->Unit(benchmark::kMicrosecond);
    }
}

}  // namespace bench

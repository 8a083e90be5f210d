#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <numbers>

#include "engine/simulation.h"
#include "hydro/mesh/primitives.h"
#include "tests/benchmarks/benches.h"

/// @file
/// A step of 1/60 s of a body of 1 m on lines from all sides, without water, on one thread. A name
/// is BM_Lines/KIND/LINES; what a line costs is the difference to none, over their number.
/// `stiff_rope` is a rope that the constraint solver takes, between two bodies.

namespace bench {
namespace {

using Eigen::Vector3d;
using engine::LineSpec;

engine::BodySpec body(const std::string& name, const Vector3d& at) {
  engine::BodySpec body{.name = name, .mesh_B = hydro::make_box({1, 1, 1})};
  body.mass = 1000;
  body.inertia_B = Eigen::Matrix3d::Identity() * 1000 / 6;
  body.initial.position = at;
  body.wet = false;
  body.collision = engine::CollisionShape::none;
  return body;
}

LineSpec line_of(const std::string& kind, int i, int count) {
  const double angle = 2 * std::numbers::pi * i / count;
  const Vector3d out(std::cos(angle), std::sin(angle), 0);
  LineSpec line{.name = fmt::format("line{}", i), .first = {0, 0.5 * out}};
  if (kind == "mooring") {
    line.kind = LineSpec::Kind::mooring;
    line.second.at = 400 * out - 200 * Vector3d::UnitZ();
    line.length = 500;
    line.stiffness = 7.5e8;
    line.weight = 8;
    return line;
  }
  line.second.at = 5 * out;
  line.length = 4;
  line.stiffness = 1e3;
  line.damping = 10;
  return line;
}

void lines(benchmark::State& state, const std::string& kind, int count) {
  engine::SimulationSpec spec;
  spec.bodies = {body("body", Vector3d::Zero())};
  spec.bodies[0].initial.angular_velocity = {0.1, 0.2, 0.3};  // A line turns the body anyway.
  if (count == 0) spec.gravity = 0;                           // It would fall beyond all bounds.
  for (int i = 0; i < count; ++i) spec.lines.push_back(line_of(kind, i, count));
  engine::Simulation simulation(std::move(spec));
  for (auto _ : state) simulation.step();
}

void stiff_rope(benchmark::State& state) {
  engine::SimulationSpec spec;
  spec.bodies = {body("first", Vector3d::Zero()), body("second", {4, 0, 0})};
  spec.gravity = 0;
  spec.bodies[1].initial.linear_velocity = {0, 1, 0};
  spec.lines = {{.name = "rope",
                 .kind = LineSpec::Kind::rope,
                 .first = {0, Vector3d::Zero()},
                 .second = {1, Vector3d::Zero()},
                 .length = 4,
                 .stiffness = 1e9}};
  engine::Simulation simulation(std::move(spec));
  for (auto _ : state) simulation.step();
}

}  // namespace

void register_rigs() {
  for (const char* kind : {"spring", "mooring"})
    for (const int count : {0, 1, 8})
      benchmark::RegisterBenchmark(
          fmt::format("BM_Lines/{}/{}", kind, count).c_str(),
          [kind, count](benchmark::State& state) { lines(state, kind, count); });
  benchmark::RegisterBenchmark("BM_Lines/stiff_rope/1", stiff_rope);
}

}  // namespace bench

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "app/assembly/mesh_io.h"
#include "app/base/program_files.h"
#include "app/render/renderer.h"
#include "tests/benchmarks/benches.h"

/// @file
/// One picture of 960×720 pixels of a teapot half in still water, by the software rasteriser. A
/// name is BM_Frame/TRIANGLES. Read the real time: the rasteriser has threads of its own.

namespace bench {
namespace {

void frame(benchmark::State& state, const hydro::TriMesh& mesh) {
  render::SceneDescription picture;
  picture.sea = hydro::Sea{};
  picture.pressure.max = 10e3;
  picture.camera = {.from = {3.5, -6, 2.4}, .to = {0, 0, 0}};
  picture.bodies = {{.mesh_B = mesh}};
  const hydro::BodyState floating{.position = {0, 0, -0.7}};
  try {
    render::Renderer renderer(picture, app::program_files("shaders"));
    renderer.draw({floating}, 0);
    for (auto _ : state) benchmark::DoNotOptimize(renderer.draw({floating}, 0));
  } catch (const render::Error& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace

void register_frame() {
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  const std::filesystem::path file =
      std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "scenes" / "meshes" / "teapot_20k.obj";
  const hydro::TriMesh mesh = assembly::read_mesh(file);
  const std::string name = fmt::format("BM_Frame/{}", mesh.face_count());
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) { frame(s, mesh); })
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace bench

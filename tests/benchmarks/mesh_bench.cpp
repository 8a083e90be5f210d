#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <fmt/os.h>
#include <unistd.h>

#include <filesystem>

#include "app/assembly/mesh_io.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"
#include "tests/benchmarks/benches.h"

/// @file
/// A mesh file as the program takes it in: read, welded, checked. A name is BM_MeshLoad/TRIANGLES;
/// the file is an OBJ of a sphere in a folder of its own, removed afterwards. Read the real time.
/// BM_MeshLoad/20 is the cost of the process in which a mesh is read.

namespace bench {
namespace {

/// A mesh as an OBJ file, for as long as this lives.
class MeshFile {
 public:
  explicit MeshFile(const hydro::TriMesh& mesh) {
    std::filesystem::create_directories(folder_);
    fmt::ostream out = fmt::output_file(path().string());
    for (const auto& v : mesh.vertices.colwise())
      out.print("v {:.9g} {:.9g} {:.9g}\n", v.x(), v.y(), v.z());
    for (const auto& f : mesh.faces.colwise())
      out.print("f {} {} {}\n", f.x() + 1, f.y() + 1, f.z() + 1);
  }
  ~MeshFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  MeshFile(const MeshFile&) = delete;
  MeshFile& operator=(const MeshFile&) = delete;

  std::filesystem::path path() const { return folder_ / "sphere.obj"; }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("plimsoll_bench_{}", getpid());
};

void load(benchmark::State& state, int subdivisions) {
  const MeshFile file(hydro::make_icosphere(1, subdivisions));
  for (auto _ : state) {
    const hydro::RepairedMesh mesh = hydro::repaired(assembly::read_mesh(file.path()));
    if (!mesh.report.sound() || mesh.mesh.face_count() != 20 << (2 * subdivisions)) {
      state.SkipWithError("the sphere did not come back whole");
      break;
    }
  }
  state.counters["seconds"] = benchmark::Counter(
      1, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

void register_mesh() {
  for (const int subdivisions : {0, 5, 7, 8}) {
    const std::string name = fmt::format("BM_MeshLoad/{}", 20 << (2 * subdivisions));
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) { load(s, subdivisions); })
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace bench

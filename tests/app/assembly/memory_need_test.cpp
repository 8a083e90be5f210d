#include "app/assembly/memory_need.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstring>
#include <functional>
#include <string>

#include "app/base/forked_call.h"
#include "app/base/machine.h"
#include "hydro/added_mass/added_mass.h"
#include "hydro/loads/loads.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"

namespace {

using testing::HasSubstr;

constexpr double kGibibyte = 1024.0 * 1024 * 1024;

TEST(MemoryNeed, CountsTheTrianglesThatAShapeWillHave) {
  const std::pair<scene::Shape, hydro::TriMesh> shapes[] = {
      {scene::Box{.size = {1, 2, 3}, .divisions = 5}, hydro::make_box({1, 2, 3}, 5)},
      {scene::Sphere{.radius = 1, .slices = 7, .stacks = 5}, hydro::make_sphere(1, 7, 5)},
      {scene::Icosphere{.radius = 1, .subdivisions = 3}, hydro::make_icosphere(1, 3)},
      {scene::Cylinder{.radius = 1, .height = 2, .slices = 24, .stacks = 7},
       hydro::make_cylinder(1, 2, 24, 7)}};
  for (const auto& [shape, mesh] : shapes)
    EXPECT_EQ(assembly::triangles_of(shape), static_cast<double>(mesh.face_count()));
}

TEST(MemoryNeed, IsJudgedByWhatIsFree) {
  EXPECT_FALSE(app::judged_need(1e9, 2e9));
  EXPECT_FALSE(app::judged_need(1e15, std::nullopt));
  const auto tight = app::judged_need(3 * kGibibyte, 2 * kGibibyte);
  ASSERT_TRUE(tight);
  EXPECT_FALSE(tight->fault);
  const auto hopeless = app::judged_need(38 * kGibibyte, 18 * kGibibyte);
  ASSERT_TRUE(hopeless);
  EXPECT_TRUE(hopeless->fault);
  EXPECT_EQ(hopeless->text, "needs about 38 GiB of memory, and this machine has 18 GiB free");
}

#if !defined(__SANITIZE_ADDRESS__)
/// Returns how much the work raises the largest resident size of a process [bytes].
double peak_of(const std::function<void()>& work) {
  const app::CallResult result = app::forked_call(
      [&](const app::CallOutput& output) {
        const auto peak = [] {
          rusage usage = {};
          ::getrusage(RUSAGE_SELF, &usage);
          return 1024.0 * static_cast<double>(usage.ru_maxrss);
        };
        const double before = peak();
        work();
        const double grown = peak() - before;
        output({reinterpret_cast<const char*>(&grown), sizeof grown});
      },
      {.memory = std::size_t{8} << 30, .cpu_seconds = 300, .wall_seconds = 1000});
  double grown = 0;
  EXPECT_EQ(result.bytes.size(), sizeof grown);
  if (result.bytes.size() == sizeof grown) std::memcpy(&grown, result.bytes.data(), sizeof grown);
  return grown;
}

TEST(MemoryNeed, OfABodyIsThatMeasuredToAFactorOfTwo) {
  const double peak = peak_of([] {
    hydro::RepairedMesh mesh = hydro::repaired(hydro::make_icosphere(1, 7));
    const hydro::TriMesh centered = hydro::translated(mesh.mesh, {1, 0, 0});
    const hydro::Hull hull = hydro::make_hull(mesh.mesh);
    EXPECT_EQ(hull.mesh_B.face_count(), centered.face_count());
  });
  const double estimate = assembly::body_bytes(20 << 14);
  RecordProperty("bytes_per_triangle", std::to_string(peak / (20 << 14)));
  EXPECT_GT(peak, estimate / 2);
  EXPECT_LT(peak, estimate * 2);
}

TEST(MemoryNeed, OfAddedMassIsThatMeasuredToAFactorOfTwo) {
  // A tolerance that no splitting meets drives a small mesh to the largest number of panels; what
  // is measured is smaller because a last split that would exceed it is not solved.
  const hydro::AddedMassOptions constant{.method = hydro::AddedMassMethod::constant};
  const hydro::TriMesh mesh = hydro::make_icosphere(1, 4);
  const auto faces = static_cast<double>(mesh.face_count());
  const double peak = peak_of([&] { hydro::solve_added_mass(mesh, constant); });
  const double estimate = assembly::added_mass_bytes(faces, constant);
  EXPECT_GT(peak, estimate / 2);
  EXPECT_LT(peak, estimate * 2);
}
#endif

}  // namespace

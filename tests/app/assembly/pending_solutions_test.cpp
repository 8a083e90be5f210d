#include "app/assembly/pending_solutions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/assembly/build.h"
#include "app/assembly/solve_time.h"
#include "tests/app/scene_text.h"

namespace {

namespace fs = std::filesystem;
using assembly::PendingSolution;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

std::vector<PendingSolution> pending_of(const std::string& bodies, const fs::path& folder) {
  const scene::Scene scene =
      support::read_scene_text("plimsoll: 1\nduration: 1\nwater: {}\nbodies:\n" + bodies);
  return assembly::pending_solutions(scene, assembly::build_without_added_mass(scene), folder, 2);
}

TEST(PendingSolutions, AreThoseThatTheStoreLacks) {
  const fs::path folder = fs::path(testing::TempDir()) / "plimsoll_pending_solutions";
  fs::remove_all(folder);
  const std::string shape = "icosphere: {radius: 0.5, subdivisions: 1}, density: 500, ";
  // Dropped from a height neither floats; they share a solution. Held and given ones need none.
  const std::string bodies = "  - {name: a, " + shape + "position: [0, 0, 9]}\n  - {name: b, " +
                             shape + "position: [3, 0, 9]}\n  - {name: held, " + shape +
                             "lock: all}\n  - {name: none, " + shape +
                             "hydro: {added_mass: none}}\n";
  EXPECT_THAT(pending_of(bodies, folder),
              ElementsAre(Field(&PendingSolution::what, "added mass of a")));
  EXPECT_THAT(pending_of("  - {name: float, box: {size: [2, 2, 1]}, density: 500}\n", folder),
              ElementsAre(Field(&PendingSolution::what, "radiation of float")));
  const scene::Scene scene =
      support::read_scene_text("plimsoll: 1\nduration: 1\nwater: {}\nbodies:\n" + bodies);
  assembly::AddedMassStore store(folder);
  assembly::build(scene, store, app::quiet());
  EXPECT_THAT(pending_of(bodies, folder), IsEmpty());
  fs::remove_all(folder);
}

TEST(PendingSolutions, AreToldInOneLine) {
  EXPECT_EQ(assembly::pending_text({}), "");
  EXPECT_EQ(assembly::pending_text({{"radiation of hull", 200}}),
            "radiation of hull, once for all runs: some 3 min");
  std::vector<PendingSolution> many;
  for (const char* name : {"a", "b", "c", "d", "e"})
    many.push_back({std::string("added mass of ") + name, 2});
  EXPECT_EQ(assembly::pending_text(many),
            "added mass of a, added mass of b, added mass of c and 2 more, once for all runs: some "
            "10 s");
}

TEST(PendingSolutions, TakeLongerWithMoreTrianglesAndFewerThreads) {
  double before = 0;
  for (const double triangles : {100, 1000, 5000, 5001, 20000, 1000000}) {
    const double seconds = assembly::added_mass_seconds(triangles, 2);
    EXPECT_GT(seconds, before);
    EXPECT_DOUBLE_EQ(assembly::added_mass_seconds(triangles, 1), 2 * seconds);
    EXPECT_GT(assembly::radiation_seconds(triangles, 2), seconds);
    before = seconds;
  }
}

}  // namespace

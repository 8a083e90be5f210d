#include "app/run/closing_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hydro/added_mass/added_mass.h"

namespace {

using testing::HasSubstr;
using testing::Not;

class ClosingLines : public testing::Test {
 protected:
  std::string first_line() const { return app::closing_lines(summary, "out/x").front(); }

  scene::Scene scene;
  assembly::BuiltScene built;
  std::vector<scene::Override> overrides;
  app::RunSummary summary{.scene = scene, .built = built, .overrides = overrides};
};

TEST_F(ClosingLines, TellTheTimeOfEachPartOfARun) {
  built.added_mass_seconds = 6.9;
  summary.steps = 9;
  summary.simulated = 1.8;
  summary.wall = 7.2;
  summary.timings.hydro = 0.04;
  EXPECT_EQ(first_line(),
            "out/x: 9 steps, 1.8 s simulated in 7.20 s (added mass and radiation 6.90, hydro 0.04, "
            "collision 0.00, engine 0.00, log 0.00, pictures 0.00)");
}

TEST_F(ClosingLines, TellWhatWasSolvedAndNotWhatTheStoreHad) {
  const auto solution = std::make_shared<const hydro::AddedMassSolution>();
  const auto other = std::make_shared<const hydro::AddedMassSolution>();
  const auto radiation = std::make_shared<const hydro::RadiationSolution>();
  const assembly::AddedMassReport solved{.stored = {{.solution = solution}}};
  const assembly::AddedMassReport known{.stored = {{.solution = other, .from_store = true}}};
  built.added_mass = {known, std::nullopt};
  EXPECT_THAT(first_line(), Not(HasSubstr("solved")));
  built.added_mass = {solved, solved, known};
  built.radiation.resize(2);
  built.radiation[1].stored = assembly::StoredRadiation{.solution = radiation};
  EXPECT_THAT(first_line(), HasSubstr("; solved: added mass of 1 mesh, radiation of 1 mesh"));
}

}  // namespace

#include "app/assembly/radiation_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "hydro/mesh/primitives.h"
#include "tests/support/files.h"
#include "tests/support/random_pose.h"

namespace {

namespace fs = std::filesystem;
using assembly::RadiationProblem;
using assembly::RadiationStore;
using hydro::RadiationSolution;
using testing::HasSubstr;
using testing::IsEmpty;

struct KeptWarnings : app::Reporter {
  std::string text;
  void warning(const std::string& message) override { text += message + '\n'; }
};

class StoreOfRadiation : public testing::Test {
 protected:
  StoreOfRadiation()
      : folder(fs::path(testing::TempDir()) /
               (std::string("plimsoll_radiation_") +
                testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder);
  }
  ~StoreOfRadiation() override { fs::remove_all(folder); }

  /// Numbers that no solver need have found. They couple two motions alone, to which oscillators
  /// are fitted forty times faster than to six.
  RadiationSolution some_solution() const {
    support::Random random(1);
    const auto fill = [&](auto&& entries) {
      for (auto& entry : entries) entry = random.uniform(-1, 1);
    };
    RadiationSolution solution{.unknowns = 567, .mismatch = 1e-3};
    hydro::RadiationData& data = solution.data;
    data.pose = pose;
    data.volume = 3;
    data.frequencies = {1, 2.5, 3};
    data.headings = {0, M_PI};
    fill(data.infinite_added_mass.topLeftCorner<2, 2>().reshaped());
    for (int i = 0; i < 3; ++i) {
      for (auto* matrices : {&data.added_mass, &data.damping})
        fill(matrices->emplace_back(hydro::Matrix6d::Zero()).topLeftCorner<2, 2>().reshaped());
      for (auto* loads : {&data.froude_krylov, &data.diffraction})
        for (auto& entry : loads->emplace_back(6, 2).reshaped())
          entry = {random.uniform(-1, 1), random.uniform(-1, 1)};
    }
    return solution;
  }

  RadiationProblem problem() const { return {.mesh_B = mesh, .pose = pose}; }

  fs::path folder;
  KeptWarnings warnings;
  hydro::TriMesh mesh = hydro::make_icosphere(1, 1);
  hydro::MeanPose pose{.height = 0.1};
};

TEST_F(StoreOfRadiation, KeepsASolutionToTheLastBit) {
  EXPECT_FALSE(RadiationStore(folder).find(problem(), warnings));
  const RadiationSolution kept = some_solution();
  EXPECT_FALSE(RadiationStore(folder).keep(problem(), kept, 1.5, warnings).from_store);
  const auto found = RadiationStore(folder).find(problem(), warnings);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->from_store);
  EXPECT_EQ(found->seconds, 1.5);
  const RadiationSolution& solution = *found->solution;
  EXPECT_EQ(solution.unknowns, kept.unknowns);
  EXPECT_EQ(solution.mismatch, kept.mismatch);
  const hydro::RadiationData &a = solution.data, &b = kept.data;
  EXPECT_EQ(a.pose, b.pose);
  EXPECT_EQ(a.water, b.water);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.frequencies, b.frequencies);
  EXPECT_EQ(a.headings, b.headings);
  EXPECT_EQ(a.infinite_added_mass, b.infinite_added_mass);
  EXPECT_EQ(a.added_mass, b.added_mass);
  EXPECT_EQ(a.damping, b.damping);
  EXPECT_EQ(a.froude_krylov, b.froude_krylov);
  EXPECT_EQ(a.diffraction, b.diffraction);
  EXPECT_THAT(warnings.text, IsEmpty());
}

TEST_F(StoreOfRadiation, KeepsTheOscillatorsThatWereFittedToTheLastBit) {
  const auto kept = RadiationStore(folder).keep(problem(), some_solution(), 1, warnings).memory;
  const auto found = RadiationStore(folder).find(problem(), warnings)->memory;
  ASSERT_TRUE(kept && found);
  EXPECT_EQ(kept->frequencies, hydro::fit_memory(some_solution().data).frequencies);
  EXPECT_GT(kept->size(), 0);
  EXPECT_EQ(found->frequencies, kept->frequencies);
  EXPECT_EQ(found->damping, kept->damping);
  EXPECT_EQ(found->port, kept->port);
  EXPECT_EQ(found->rms_error, kept->rms_error);
  EXPECT_EQ(found->largest_error, kept->largest_error);
}

TEST_F(StoreOfRadiation, HasAFileForEverythingThatMatters) {
  const RadiationStore store(folder);
  const fs::path file = store.file_of(problem());
  const auto file_with = [&](const auto& change) {
    RadiationProblem other = problem();
    change(other);
    return store.file_of(other);
  };
  EXPECT_EQ(file_with([](RadiationProblem&) {}), file);
  EXPECT_NE(file_with([](RadiationProblem& p) { p.pose.height = 0.2; }), file);
  EXPECT_NE(file_with([](RadiationProblem& p) { p.pose.orientation = {0.8, 0.6, 0, 0}; }), file);
  EXPECT_NE(file_with([](RadiationProblem& p) { p.water.gravity = 9.82; }), file);
  EXPECT_NE(file_with([](RadiationProblem& p) { p.options.patches = 120; }), file);
  EXPECT_NE(file_with([](RadiationProblem& p) { p.options.frequencies = {1, 2}; }), file);
  const hydro::TriMesh larger = hydro::scaled(mesh, 1.1);
  EXPECT_NE(store.file_of({.mesh_B = larger, .pose = pose}), file);
}

TEST_F(StoreOfRadiation, WarnsOfADamagedFileAndReplacesIt) {
  const auto size = [&] { return fs::file_size(RadiationStore(folder).file_of(problem())); };
  RadiationStore(folder).keep(problem(), some_solution(), 1, warnings);
  const auto whole = size();
  fs::resize_file(RadiationStore(folder).file_of(problem()), whole - 8);
  EXPECT_FALSE(RadiationStore(folder).find(problem(), warnings));
  EXPECT_THAT(warnings.text, HasSubstr("the radiation is computed anew"));
  RadiationStore(folder).keep(problem(), some_solution(), 1, warnings);
  EXPECT_EQ(size(), whole);
}

TEST_F(StoreOfRadiation, SolvesOnceForBodiesWithOneMeanPose) {
  mesh = hydro::make_icosphere(1, 2);
  RadiationStore store(std::nullopt);
  RadiationProblem small = problem();
  small.options = {.frequencies = {2}, .headings = 4, .patches = 30};
  const auto first = assembly::solved_radiation("a", small, store, warnings);
  const auto second = assembly::solved_radiation("b", small, store, warnings);
  EXPECT_EQ(first.solution, second.solution);
  EXPECT_GT(first.solution->unknowns, 0);
}

TEST(RoundedPose, IsOneForPosesThatDifferByRoundOff) {
  const hydro::MeanPose pose{.orientation = Eigen::Quaterniond(
                                 Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized())),
                             .height = 0.123456789012};
  hydro::MeanPose other = pose;
  other.orientation.coeffs() = -other.orientation.coeffs();
  other.orientation.coeffs()[0] += 1e-15;
  other.height -= 1e-15;
  EXPECT_EQ(assembly::rounded(pose, 2), assembly::rounded(other, 2));
  EXPECT_NEAR(assembly::rounded(pose, 2).height, pose.height, 1e-7);
  EXPECT_LT(assembly::rounded(pose, 2).orientation.angularDistance(pose.orientation), 3e-7);
}

}  // namespace

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/databases/bad_ends.h"
#include "tests/app/databases/sphere_database.h"

namespace {

namespace fs = std::filesystem;
using databases::BodyData;
using databases::Database;
using hydro::RadiationData;
using support::sphere_data;
using testing::Contains;
using testing::HasSubstr;

class DatabaseChecks : public support::SphereDatabase {};

TEST_F(DatabaseChecks, WithoutLoadsOfWavesItServesInStillWater) {
  databases::write_wamit(file("ball"), written(sphere_data(24)));
  fs::remove(file("ball.3"));
  const BodyData found = read({.file = file("ball.1")}, false);
  EXPECT_TRUE(found.data.headings.empty());
  EXPECT_THAT(found.notes, Contains("the file has no loads of waves, and the water is still"));
  EXPECT_EQ(fault({.file = file("ball.1")}),
            "ball.1: has no loads of waves, and the scene's water has waves");
}

TEST_F(DatabaseChecks, WhatContradictsTheBodyIsRefused) {
  RadiationData data = sphere_data(24);
  databases::write_wamit(file("ball"), written(data));
  EXPECT_THAT(fault({.file = file("ball.1"), .length = 2}),
              HasSubstr("ball.1: found a waterplane of 12.5"));
  data.volume = 3;
  databases::write_capytaine(file("ball.nc"), written(data));
  EXPECT_THAT(fault({.file = file("ball.nc")}),
              HasSubstr("ball.nc: found a displaced volume of 3 m^3, and the body's is 2.08"));
  data = sphere_data(24);
  for (hydro::Loads6cd& load : data.diffraction) load *= -2;
  databases::write_capytaine(file("ball.nc"), written(data));
  EXPECT_THAT(fault({.file = file("ball.nc")}),
              testing::AllOf(HasSubstr("(Haskind's relation), and at"),
                             HasSubstr("of 12 frequencies by more than 30 %")));
}

TEST_F(DatabaseChecks, SingleFrequenciesThatContradictHaskindAreLeftOut) {
  RadiationData data = sphere_data(24);
  for (const std::size_t f : {7, 9}) data.diffraction[f] *= 30;
  databases::write_capytaine(file("ball.nc"), written(data));
  const BodyData found = read({.file = file("ball.nc")});
  ASSERT_EQ(found.data.frequencies.size(), 10u);
  EXPECT_EQ(found.data.frequencies[7], data.frequencies[8]);
  EXPECT_LT((found.data.damping[7] - data.damping[8]).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((found.data.diffraction[8] - data.diffraction[10]).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_THAT(found.notes,
              Contains("2 of 12 frequencies contradict Haskind's relation and are left "
                       "out: 2.801, 3.835 rad/s"));
}

TEST_F(DatabaseChecks, WhatContradictsItselfIsRefused) {
  RadiationData data = sphere_data(24);
  for (const std::size_t f : {4, 6, 7}) data.damping[f](2, 2) = -0.5;
  databases::write_capytaine(file("ball.nc"), written(data));
  EXPECT_THAT(fault({.file = file("ball.nc")}),
              testing::AllOf(HasSubstr("damping at 1.627"), HasSubstr("has an eigenvalue of -"),
                             HasSubstr("in row 3, column 3 (-0.5 for water of density 1)")));
  data = sphere_data(24);
  for (const std::size_t f : {2, 4, 6}) data.added_mass[f](0, 1) = 1;
  databases::write_capytaine(file("ball.nc"), written(data));
  EXPECT_THAT(fault({.file = file("ball.nc")}),
              testing::AllOf(HasSubstr("added mass at 0.990"), HasSubstr("row 1, column 2"),
                             HasSubstr("expected a symmetric matrix")));
}

TEST_F(DatabaseChecks, SingleFrequenciesThatContradictThemselvesAreLeftOut) {
  RadiationData data = sphere_data(24);
  data.damping[4](2, 2) = -0.5;
  data.added_mass[7](0, 1) = 1e3;  // Beside it nothing else looks wrong.
  databases::write_capytaine(file("ball.nc"), written(data));
  const BodyData found = read({.file = file("ball.nc")});
  ASSERT_EQ(found.data.frequencies.size(), 10u);
  EXPECT_EQ(found.data.frequencies[4], data.frequencies[5]);
  EXPECT_LT((found.data.added_mass[6] - data.added_mass[8]).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_THAT(found.notes, Contains(testing::StartsWith("2 of 12 frequencies are left out, 1.627, "
                                                        "2.801 rad/s; damping at 1.627")));
}

TEST_F(DatabaseChecks, ABadEndIsLeftOutAndNoted) {
  RadiationData data = sphere_data(24);
  data.damping[0](2, 2) = data.damping[11](2, 2) = -0.5;
  data.added_mass[9](0, 1) = 1;
  databases::write_capytaine(file("ball.nc"), written(data));
  const BodyData found = read({.file = file("ball.nc")});
  ASSERT_EQ(found.data.frequencies.size(), 8u);
  EXPECT_EQ(found.data.frequencies[0], data.frequencies[1]);
  EXPECT_LT((found.data.added_mass[7] - data.added_mass[8]).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((found.data.diffraction[7] - data.diffraction[8]).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_THAT(found.notes, Contains(testing::AllOf(testing::StartsWith(
                               "4 of 12 frequencies are left out, those below 0.7002 and "
                               "above 3.284 rad/s; damping at 0.442869 rad/s: has an"))));
}

TEST_F(DatabaseChecks, ABadEndOfItsLoadsIsLeftOut) {
  RadiationData data = sphere_data(24);
  for (const std::size_t f : {8, 9, 11}) data.diffraction[f] *= 30;
  databases::write_capytaine(file("ball.nc"), written(data));
  const BodyData found = read({.file = file("ball.nc")});
  EXPECT_EQ(found.data.frequencies,
            std::vector<double>(data.frequencies.begin(), data.frequencies.begin() + 8));
  EXPECT_THAT(found.notes, Contains(HasSubstr("4 of 12 frequencies contradict Haskind's")));
  data = sphere_data(24);
  for (const std::size_t f : {7, 8, 9}) data.diffraction[f] *= 30;  // In the middle, too.
  databases::write_capytaine(file("ball.nc"), written(data));
  EXPECT_THAT(fault({.file = file("ball.nc")}), HasSubstr("and at 3 of 12 frequencies by more"));
}

TEST(BadEnds, BeginAtTheFirstOrLastEntryAndAreBadForHalf) {
  using Marks = std::vector<bool>;
  EXPECT_EQ(databases::bad_ends(Marks{1, 0, 0, 0, 0, 0, 0, 0, 0}),
            (Marks{1, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(databases::bad_ends(Marks{0, 0, 1, 0, 0, 0, 1, 0, 1}),
            (Marks{0, 0, 0, 0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(databases::bad_ends(Marks{0, 0, 0, 1, 0, 1, 1, 1, 1}),  // Of these a third at most.
            (Marks{0, 0, 0, 0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(databases::bad_ends({}), Marks{});
}

TEST_F(DatabaseChecks, HeldNeighboursPushTheBodyInLongWaves) {
  databases::write_wamit(file("ball"), written(sphere_data(24)));
  const scene::RadiationFile source{.file = file("ball.1"),
                                    .reference_point = Eigen::Vector3d(0, 0, 0)};
  Database d = databases::read_database(source, 9.80665);
  ASSERT_TRUE(d.neighbours.empty());
  const auto fitted = [&] {
    return databases::fit_to_body(d, source, {.mesh_B = mesh_, .pose = {}, .water = {}});
  };
  const auto error_of = [](const BodyData& found) {
    for (const databases::Check& check : found.checks)
      if (check.name == "excitation in long waves against the mesh") return check.value;
    return -1.0;
  };
  const double alone = error_of(fitted());
  EXPECT_GT(alone, 0);
  // The frequency that is compared is 1.627 rad/s, at which the waves are 23 radii long.
  const double g = 9.80665, k = d.frequencies[4] * d.frequencies[4] / g, heave = 4.5;
  d.neighbours.assign(d.frequencies.size(), Eigen::Matrix<double, 6, 3>::Zero());
  d.neighbours[4](2, 2) = heave;
  d.excitation[4].row(2).array() -= heave * g * k;
  EXPECT_NEAR(error_of(fitted()), alone, 0.02);
  d.neighbours.clear();
  try {
    fitted();
    FAIL();
  } catch (const scene::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("excitation in long waves at 1.627 rad/s, row 3"));
  }
}

TEST_F(DatabaseChecks, ARangeOfFrequenciesLimitsWhatIsTaken) {
  RadiationData data = sphere_data(24);
  data.damping[6](2, 2) = -0.5;
  databases::write_capytaine(file("ball.nc"), written(data));
  Database d = databases::read_database({.file = file("ball.nc")}, 9.80665);
  EXPECT_EQ(databases::limit_frequencies(data.frequencies[1], data.frequencies[5], d), 5u);
  const BodyData found = databases::fit_to_body(d, {.file = file("ball.nc")},
                                                {.mesh_B = mesh_, .pose = {}, .water = {}});
  EXPECT_EQ(found.data.frequencies,
            std::vector<double>(data.frequencies.begin() + 1, data.frequencies.begin() + 6));
  EXPECT_LT((found.data.damping[4] - data.damping[5]).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(databases::limit_frequencies(90, 99, d), 0u);
}

TEST_F(DatabaseChecks, SmallFaultsAreNotedAndTakenOut) {
  RadiationData data = sphere_data(24);
  data.added_mass[2](0, 1) = 0.05;
  data.damping[0](0, 0) = -0.03;
  databases::write_capytaine(file("ball.nc"), written(data));
  const BodyData found = read({.file = file("ball.nc")});
  EXPECT_EQ(found.data.added_mass[2](0, 1), found.data.added_mass[2](1, 0));
  EXPECT_NEAR(found.data.damping[0](0, 0), 0, 1e-12);
  EXPECT_THAT(found.notes, Contains(HasSubstr("asymmetry of added mass 2.")));
  EXPECT_THAT(found.notes, Contains(HasSubstr("least eigenvalue of damping -0.9")));
}

TEST_F(DatabaseChecks, AMissingLimitMustFollow) {
  databases::write_wamit(file("ball"), written(sphere_data(24)));
  std::ifstream in(file("ball.1"));
  std::string line, without;
  while (std::getline(in, line))
    if (line.find("  0.000000E+00") != 0) without += line + "\n";
  write("short.1", without.substr(0, without.find("\n", 150 * 60) + 1));
  EXPECT_THAT(fault({.file = file("short.1")}, false), HasSubstr("short.1: "));
  write("full.1", without);
  EXPECT_THAT(read({.file = file("full.1")}, false).notes,
              Contains(HasSubstr("added mass at infinite frequency: by Ogilvie's relation")));
}

}  // namespace

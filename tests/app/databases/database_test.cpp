#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "app/databases/bad_ends.h"
#include "app/databases/fit_to_body.h"
#include "app/databases/heading_grid.h"
#include "app/databases/ogilvie.h"
#include "app/databases/write_database.h"
#include "app/scene/diagnostics.h"
#include "hydro/mesh/primitives.h"
#include "hydro/radiation/froude_krylov.h"
#include "tests/support/radiating_sphere.h"

namespace {

namespace fs = std::filesystem;
using databases::BodyData;
using databases::Database;
using hydro::RadiationData;
using testing::Contains;
using testing::HasSubstr;

/// A sphere of radius 1 that floats half submerged, its centre of mass in its centre, with the
/// loads of waves that radiate its damping.
RadiationData sphere_data(int headings) {
  RadiationData data = support::radiating_sphere(1);
  for (int h = 0; h < headings; ++h) data.headings.push_back(2 * M_PI * h / headings);
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    const double omega = data.frequencies[f], g = data.water.gravity, k = omega * omega / g;
    const double heave = g * std::sqrt(2 * data.damping[f](2, 2) / (k * omega));
    const double surge = g * std::sqrt(4 * data.damping[f](0, 0) / (k * omega));
    hydro::Loads6cd X = hydro::Loads6cd::Zero(6, headings);
    for (int h = 0; h < headings; ++h) {
      const double beta = data.headings[static_cast<std::size_t>(h)];
      X.col(h).head<3>() << std::complex<double>(0, -surge * std::cos(beta)),
          std::complex<double>(0, -surge * std::sin(beta)), heave;
    }
    data.diffraction.push_back(X);
  }
  data.froude_krylov = hydro::froude_krylov(hydro::make_icosphere(1, 4), data.pose, data.water,
                                            data.frequencies, data.headings);
  for (std::size_t f = 0; f < data.frequencies.size(); ++f)
    data.diffraction[f] -= data.froude_krylov[f];
  return data;
}

/// The first headings alone.
RadiationData only_headings(RadiationData data, int count) {
  data.headings.resize(static_cast<std::size_t>(count));
  for (auto* loads : {&data.froude_krylov, &data.diffraction})
    for (hydro::Loads6cd& load : *loads) load = load.leftCols(count).eval();
  return data;
}

double largest_difference(const std::vector<hydro::Loads6cd>& a,
                          const std::vector<hydro::Loads6cd>& b) {
  double largest = 0;
  for (std::size_t f = 0; f < a.size(); ++f)
    largest = std::max(largest, (a[f] - b[f]).cwiseAbs().maxCoeff());
  return largest;
}

class RadiationDatabase : public testing::Test {
 protected:
  RadiationDatabase() { fs::create_directories(folder_); }
  ~RadiationDatabase() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name) const { return folder_ / name; }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
  }
  databases::WrittenBody written(const RadiationData& data) const {
    return {.name = "ball",
            .data = data,
            .density = 1025,
            .statics = hydro::hydrostatics(mesh_, data.pose.height)};
  }
  BodyData read(const scene::RadiationFile& source, bool waves = true) const {
    const Database database = databases::read_database(source, 9.80665);
    return databases::fit_to_body(database, source,
                                  {.mesh_B = mesh_, .pose = {}, .water = {}, .waves = waves});
  }
  std::string fault(const scene::RadiationFile& source, bool waves = true) const {
    try {
      read(source, waves);
    } catch (const scene::InputError& error) {
      const std::string text = error.what();
      return text.substr(text.find(source.file.stem().string()));
    }
    return "none";
  }

  hydro::TriMesh mesh_ = hydro::make_icosphere(1, 4);

 private:
  fs::path folder_ =
      fs::path(testing::TempDir()) /
      (std::string("database_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(RadiationDatabase, CapytainesDatasetKeepsEveryDigit) {
  const RadiationData data = sphere_data(24);
  databases::write_capytaine(file("ball.nc"), written(data));
  const BodyData found = read({.file = file("ball.nc")});
  EXPECT_THAT(found.notes, testing::IsEmpty());
  ASSERT_EQ(found.data.frequencies, data.frequencies);
  ASSERT_EQ(found.data.headings, data.headings);
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    EXPECT_LT((found.data.added_mass[f] - data.added_mass[f]).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((found.data.damping[f] - data.damping[f]).cwiseAbs().maxCoeff(), 1e-12);
  }
  EXPECT_LT((found.data.infinite_added_mass - data.infinite_added_mass).cwiseAbs().maxCoeff(),
            1e-12);
  EXPECT_LT(largest_difference(found.data.froude_krylov, data.froude_krylov), 1e-12);
  EXPECT_LT(largest_difference(found.data.diffraction, data.diffraction), 1e-12);
}

TEST_F(RadiationDatabase, WamitsFilesKeepSixDigits) {
  const RadiationData data = sphere_data(24);
  databases::write_wamit(file("ball"), written(data));
  const BodyData found =
      read({.file = file("ball.1"), .reference_point = Eigen::Vector3d(0, 0, 0)});
  ASSERT_EQ(found.data.frequencies.size(), data.frequencies.size());
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    EXPECT_NEAR(found.data.frequencies[f], data.frequencies[f], 1e-5);
    EXPECT_LT((found.data.added_mass[f] - data.added_mass[f]).cwiseAbs().maxCoeff(), 1e-5);
    EXPECT_LT((found.data.damping[f] - data.damping[f]).cwiseAbs().maxCoeff(), 1e-4);
    const hydro::Loads6cd have = found.data.froude_krylov[f] + found.data.diffraction[f];
    const hydro::Loads6cd want = data.froude_krylov[f] + data.diffraction[f];
    EXPECT_LT((have - want).cwiseAbs().maxCoeff(), 1e-3);
  }
  EXPECT_THAT(found.notes, Contains("Froude-Krylov forces: those on the mesh"));
}

TEST_F(RadiationDatabase, OneHeadingOfABodyOfRevolutionIsTurned) {
  const RadiationData data = sphere_data(36);
  databases::write_capytaine(file("ball.nc"), written(only_headings(data, 1)));
  const BodyData found = read({.file = file("ball.nc")});
  // The mesh is no exact body of revolution: its Froude-Krylov force differs by 1e-3 of some 15.
  EXPECT_LT(largest_difference(found.data.diffraction, data.diffraction), 0.03);
  EXPECT_THAT(found.notes,
              Contains("loads of waves: those of the heading 0°, turned about the axis "
                       "of revolution"));
}

TEST_F(RadiationDatabase, MirrorsCompleteHalfAndQuarterOfTheCircle) {
  const RadiationData data = sphere_data(36);
  for (const int count : {10, 19}) {
    databases::write_capytaine(file("ball.nc"), written(only_headings(data, count)));
    const BodyData found = read({.file = file("ball.nc")});
    EXPECT_LT(largest_difference(found.data.diffraction, data.diffraction), 1e-12);
    EXPECT_THAT(found.notes, Contains(HasSubstr("headings and their mirror images")));
  }
}

TEST(CompleteCircle, SplinesGoThroughUnevenHeadings) {
  databases::LoadTable table;
  for (int h = 0; h < 24; ++h) table.headings.push_back(2 * M_PI * h / 24 + 0.05 * std::sin(h));
  const auto wave = [](double beta) {
    return std::complex<double>(std::cos(2 * beta), std::sin(beta));
  };
  hydro::Loads6cd loads(6, 24);
  for (int h = 0; h < 24; ++h)
    loads.col(h).setConstant(wave(table.headings[static_cast<std::size_t>(h)]));
  table.loads = {loads};
  databases::complete_circle({}, {&table});
  ASSERT_EQ(table.headings.size(), 36u);
  // The cubic spline errs by some (5/384) h⁴ f'''', with h = 0.31 and f'''' = 16.
  for (int h = 0; h < 36; ++h)
    EXPECT_LT(std::abs(table.loads[0](0, h) - wave(2 * M_PI * h / 36)), 2.5e-3);
}

TEST(CompleteCircle, AHoleInTheCircleIsRefused) {
  databases::LoadTable table{{0, 0.5, 1, 1.5}, {hydro::Loads6cd::Ones(6, 4)}};
  try {
    databases::complete_circle({}, {&table});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "has 4 headings with 274° between two of them, and the body may turn to all; "
                 "expected at most 45°");
  }
}

TEST(Ogilvie, GivesTheLimitOfASphereInHeave) {
  const RadiationData data = support::radiating_sphere(1);
  const auto found =
      databases::infinite_added_mass(data.frequencies, data.added_mass, data.damping);
  ASSERT_TRUE(found);
  // The frequencies reach kR = 3.7, where the damping in heave is a fifth of its largest.
  EXPECT_NEAR(found->matrix(2, 2), data.infinite_added_mass(2, 2), 0.03);
  EXPECT_LT(found->spread(2, 2), 0.02);
  EXPECT_FALSE(databases::infinite_added_mass({1, 2}, data.added_mass, data.damping));
}

TEST_F(RadiationDatabase, WithoutLoadsOfWavesItServesInStillWater) {
  databases::write_wamit(file("ball"), written(sphere_data(24)));
  fs::remove(file("ball.3"));
  const BodyData found = read({.file = file("ball.1")}, false);
  EXPECT_TRUE(found.data.headings.empty());
  EXPECT_THAT(found.notes, Contains("the file has no loads of waves, and the water is still"));
  EXPECT_EQ(fault({.file = file("ball.1")}),
            "ball.1: has no loads of waves, and the scene's water has waves");
}

TEST_F(RadiationDatabase, WhatContradictsTheBodyIsRefused) {
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

TEST_F(RadiationDatabase, SingleFrequenciesThatContradictHaskindAreLeftOut) {
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

TEST_F(RadiationDatabase, WhatContradictsItselfIsRefused) {
  RadiationData data = sphere_data(24);
  data.damping[4](2, 2) = -0.5;
  databases::write_capytaine(file("ball.nc"), written(data));
  EXPECT_THAT(fault({.file = file("ball.nc")}),
              testing::AllOf(HasSubstr("damping at 1.627"), HasSubstr("has an eigenvalue of -"),
                             HasSubstr("in row 3, column 3 (-0.5 for water of density 1)")));
  data = sphere_data(24);
  data.added_mass[2](0, 1) = 1;
  databases::write_capytaine(file("ball.nc"), written(data));
  EXPECT_THAT(fault({.file = file("ball.nc")}),
              testing::AllOf(HasSubstr("added mass at 0.990"), HasSubstr("row 1, column 2"),
                             HasSubstr("expected a symmetric matrix")));
}

TEST_F(RadiationDatabase, ABadEndIsLeftOutAndNoted) {
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

TEST_F(RadiationDatabase, ABadEndOfItsLoadsIsLeftOut) {
  RadiationData data = sphere_data(24);
  for (const std::size_t f : {8, 9, 11}) data.diffraction[f] *= 30;  // A quarter of all.
  databases::write_capytaine(file("ball.nc"), written(data));
  const BodyData found = read({.file = file("ball.nc")});
  EXPECT_EQ(found.data.frequencies,
            std::vector<double>(data.frequencies.begin(), data.frequencies.begin() + 8));
  EXPECT_THAT(found.notes, Contains(HasSubstr("4 of 12 frequencies contradict Haskind's")));
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

TEST_F(RadiationDatabase, HeldNeighboursPushTheBodyInLongWaves) {
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

TEST_F(RadiationDatabase, WamitsColumnsOfOtherBodiesAreSummed) {
  write("hulls.1",
        " 0 7 7 2.0\n 3.0 7 7 2.5 0.1\n 3.0 7 1 0.5 0.1\n 3.0 7 13 0.25 0.1\n"
        " 3.0 7 4 8 0.1\n 2.0 7 7 2.5 0.1\n 2.0 13 13 1 0.1\n");
  const Database d = databases::read_database({.file = file("hulls.1"), .body = "2"}, 9.8);
  ASSERT_EQ(d.neighbours.size(), 2u);
  EXPECT_EQ(d.neighbours[0](0, 0), 0.75);
  EXPECT_EQ(d.neighbours[0].sum(), 0.75);
  EXPECT_EQ(d.neighbours[1].norm(), 0);
}

TEST_F(RadiationDatabase, ARangeOfFrequenciesLimitsWhatIsTaken) {
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

TEST_F(RadiationDatabase, SmallFaultsAreNotedAndTakenOut) {
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

TEST_F(RadiationDatabase, AMissingLimitMustFollow) {
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

TEST_F(RadiationDatabase, AFaultOfATextFileHasItsPlace) {
  const std::string good = " 0 1 1 2.0\n 3.0 1 1 2.5 0.1\n 2.0 1 1 2.5 0.1\n";
  const auto fault_of = [&](const std::string& text) {
    write("hull.1", text);
    return fault({.file = file("hull.1")}, false);
  };
  EXPECT_EQ(fault_of(""), "hull.1: the file has no rows of numbers");
  EXPECT_EQ(fault_of(good + " 1.0 1 1\n"),
            "hull.1:4:1: the row has 3 numbers, expected PER, I, J, A and B");
  EXPECT_EQ(fault_of(good + " 1.0 1.5 1 2 3\n"),
            "hull.1:4:1: found 1.5 in column 2, expected the number of a motion");
  EXPECT_EQ(fault_of(good + " 1.0 1 1 nan 3\n"),
            "hull.1:4:10: found 'nan', expected a finite number");
  EXPECT_EQ(fault_of(" 0 1 1 2.0\n 3.0 1 1 2.5 0.1\n"),
            "hull.1: has 1 frequencies above 0, expected at least 2");
  write("hull.3", " 3.0 0 1 1 0 1 0\n");
  EXPECT_EQ(fault_of(good), "hull.3: has no loads at the period 2 and the heading 0");
  write("hull.3", " 4.0 0 1 1 0 1 0\n");
  EXPECT_EQ(fault_of(good), "hull.3:1:1: found the period 4, which hull.1 does not have");
  write("hull.3", " 3.0 0 1 1 0 1\n");
  EXPECT_EQ(fault_of(good),
            "hull.3:1:1: the row has 6 numbers, expected PER, BETA, I, MOD, PHASE, RE and IM");
}

TEST_F(RadiationDatabase, ABodyIsChosenByNameOrNumber) {
  const std::string two = " 0 7 7 2.0\n 3.0 7 7 2.5 0.1\n 2.0 1 1 2.5 0.1\n";
  write("hulls.1", two);
  EXPECT_EQ(fault({.file = file("hulls.1")}),
            "hulls.1: has 2 bodies, expected the key body with one of 1, 2");
  EXPECT_EQ(fault({.file = file("hulls.1"), .body = "3"}),
            "hulls.1: has no body 3, expected one of 1, 2");
  write("hulls.txt", "");
  EXPECT_THAT(fault({.file = file("hulls.txt")}), HasSubstr("hulls.txt: expected a file .nc of"));
}

TEST_F(RadiationDatabase, ATruncatedDatasetIsAFaultAtEveryLength) {
  databases::write_capytaine(file("ball.nc"), written(only_headings(sphere_data(8), 2)));
  std::ifstream in(file("ball.nc"), std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(in), {});
  for (std::size_t size = 0; size < whole.size(); size += size < 3000 ? 37 : 2001) {
    write("cut.nc", whole.substr(0, size));
    EXPECT_THAT(fault({.file = file("cut.nc")}), HasSubstr("cut.nc: ")) << size;
  }
  // Any byte of the head may be wrong.
  for (std::size_t i = 0; i < 2500; i += 11) {
    std::string wrong = whole;
    wrong[i] = static_cast<char>(wrong[i] ^ 0x55);
    write("cut.nc", wrong);
    EXPECT_NE(fault({.file = file("cut.nc")}), "");  // Whatever it finds, it returns.
  }
}

TEST_F(RadiationDatabase, NemohsFilesNeedTheirCalculation) {
  write("RadiationCoefficients.tec", "VARIABLES=\"w (rad/s)\"\n");
  EXPECT_EQ(
      fault({.file = file("RadiationCoefficients.tec")}),
      "RadiationCoefficients.tec: has no Nemoh.cal in its folder or the one above, which tells "
      "the density");
  write("Nemoh.cal", "--- Environment\n1000 ! RHO\nnine\n");
  try {
    read({.file = file("RadiationCoefficients.tec")});
    FAIL();
  } catch (const scene::InputError& error) {
    EXPECT_THAT(error.what(),
                testing::EndsWith("Nemoh.cal:3:1: expected 1 numbers at the line's start"));
  }
}

}  // namespace

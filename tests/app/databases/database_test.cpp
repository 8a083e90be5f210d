#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/databases/heading_grid.h"
#include "app/databases/ogilvie.h"
#include "tests/app/databases/sphere_database.h"

namespace {

namespace fs = std::filesystem;
using databases::BodyData;
using databases::Database;
using hydro::RadiationData;
using support::largest_difference;
using support::only_headings;
using support::sphere_data;
using testing::Contains;
using testing::HasSubstr;

class RadiationDatabase : public support::SphereDatabase {};

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

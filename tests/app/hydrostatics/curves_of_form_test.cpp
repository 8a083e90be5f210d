#include "app/hydrostatics/curves_of_form.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/app/program/program.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr double kRadiansADegree = std::numbers::pi / 180;
const double kCurveRoundOff = support::tolerance(1e-12);

/// A box of 20 × 8 × 4 m whose keel is at z = −1.5 m of its frame and whose middle is at x = 3 m,
/// in a folder of this test: others run at the same time.
std::string box_mesh() {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto folder = std::filesystem::path(testing::TempDir()) / ("curves_" + test);
  std::filesystem::create_directories(folder);
  const std::string file = (folder / "curves_box.obj").string();
  std::ofstream mesh(file);
  for (const double z : {-1.5, 2.5})
    for (const auto& [x, y] : {std::pair(-7, -4), {13, -4}, {13, 4}, {-7, 4}})
      mesh << "v " << x << ' ' << y << ' ' << z << '\n';
  mesh << "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\n"
          "f 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n";
  return file;
}

std::string curves_output(std::vector<std::string> words) {
  words.insert(words.begin(), "hydrostatics");
  return support::output_of(std::move(words));
}

json curves_of(std::vector<std::string> words, const std::string& body = "curves_box") {
  words.push_back("--json");
  return json::parse(curves_output(std::move(words)))["bodies"][body];
}

void expect_numbers(const json& row, const std::vector<std::pair<std::string, double>>& expected) {
  for (const auto& [key, value] : expected)
    EXPECT_NEAR(row[key].get<double>(), value, kCurveRoundOff * std::max(1.0, std::abs(value)))
        << key;
}

TEST(CurvesOfForm, OfABoxAreItsClosedForms) {
  const json curves =
      curves_of({box_mesh(), "--draught", "1:3:0.5", "--density", "1025"})["curves_of_form"];
  ASSERT_EQ(curves.size(), 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const double T = 1 + 0.5 * static_cast<double>(i), V = 160 * T;
    const double bm_t = 8 * 8 / (12 * T), bm_l = 20 * 20 / (12 * T);
    expect_numbers(curves[i], {{"draught", T},
                               {"volume", V},
                               {"displacement", 1025 * V},
                               {"kb", T / 2},
                               {"bm_t", bm_t},
                               {"km_t", T / 2 + bm_t},
                               {"bm_l", bm_l},
                               {"km_l", T / 2 + bm_l},
                               {"waterplane_area", 160},
                               {"wetted_surface", 160 + 56 * T},
                               {"lcb", 3},
                               {"lcf", 3},
                               {"tpc", 1025 * 160 * 0.01 / 1000},
                               {"mct", 1.025 * V * bm_l / (100 * 20)},
                               {"length", 20},
                               {"breadth", 8},
                               {"midship_area", 8 * T},
                               {"cb", 1},
                               {"cw", 1},
                               {"cm", 1},
                               {"cp", 1}});
  }
}

TEST(CurvesOfForm, AtATrimOfABoxAreThoseOfItsTrapezium) {
  // The waterline amidships stays at T, and the volume with it; it deepens towards +x by tan θ a
  // metre. B moves by L² tan θ/(12 T) along the box and by half of that times tan θ up, and the
  // waterplane is longer by 1/cos θ.
  const double T = 2, slope = std::tan(3 * kRadiansADegree), stretch = std::hypot(1, slope);
  const json curves = curves_of({box_mesh(), "--draught", "2,2.5", "--trim", "3"});
  EXPECT_NEAR(curves["trim_deg"], 3, kCurveRoundOff);
  const double V = 160 * T, ahead = 400 * slope / (12 * T);
  expect_numbers(curves["curves_of_form"][0], {{"volume", V},
                                               {"lcb", 3 + ahead},
                                               {"kb", T / 2 + ahead * slope / 2},
                                               {"lcf", 3},
                                               {"waterplane_area", 160 * stretch},
                                               {"length", 20 * stretch},
                                               {"breadth", 8},
                                               {"bm_t", 64 / (12 * T) * stretch},
                                               {"bm_l", 400 / (12 * T) * std::pow(stretch, 3)}});
}

TEST(CurvesOfForm, CountFromTheKeelThatIsNamedAndLeaveOutWhatDoesNotCutTheBody) {
  const json curves = curves_of({box_mesh(), "--keel", "-0.5", "--draught", "-2:9:1"});
  ASSERT_EQ(curves["curves_of_form"].size(), 2) << "1 and 2 m: the top is 3 m over that keel";
  expect_numbers(curves["curves_of_form"][0], {{"draught", 1}, {"volume", 320}, {"kb", 0}});
  EXPECT_THAT(curves_output({box_mesh(), "--draught", "5:9:1"}),
              HasSubstr("--draught: no draught at which the waterline cuts a body, expected "
                        "curves_box between 0 and 4 m"));
}

TEST(CurvesOfForm, OfASceneAreThoseOfItsUprightMesh) {
  const std::string scene = support::write_scene(
      "plimsoll: 1\nduration: 1\nwater: {density: 1025, level: 3}\nbodies:\n"
      "  - {name: lying, box: {size: [20, 4, 8]}, mass: 1000, center_of_mass: [2, 1, 0.5],\n"
      "     orientation: {euler_deg: [95, 2, 130]}}\n");
  const json row = curves_of({scene, "--draught", "2,3"}, "lying")["curves_of_form"][0];
  expect_numbers(row, {{"displacement", 1025 * 320.0}, {"kb", 1}, {"bm_t", 8 / 3.0}, {"lcb", 0}});
}

TEST(CurvesOfForm, HaveTheCrossCurvesOfTheRightingArms) {
  // KN − KG sin φ is the righting arm of the body with its centre of mass at KG over the keel.
  const json curves = curves_of({box_mesh(), "--draught", "2,2.5", "--heel", "0:20:10"});
  ASSERT_EQ(curves["kn"].size(), 6);
  const double phi = 20 * kRadiansADegree, tangent = std::tan(phi);
  const double bm = 64 / (12 * 2.0);
  EXPECT_NEAR(curves["kn"][2]["kn"], (1 + bm * (1 + tangent * tangent / 2)) * std::sin(phi), 1e-9);
  EXPECT_NEAR(curves["kn"][0]["kn"], 0, kCurveRoundOff);
  EXPECT_NEAR(curves["kn"][5]["displacement"], 1000 * 400.0, kCurveRoundOff * 4e5);
}

TEST(CurvesOfForm, HaveTheSameNumbersInAllOutputs) {
  const std::string csv =
      curves_output({box_mesh(), "--draught", "1:2:1", "--heel", "0:10:10", "--csv"});
  EXPECT_THAT(csv, testing::StartsWith("body,draught,quantity,heel_deg,value,unit\n"));
  EXPECT_THAT(csv, HasSubstr("\ncurves_box,2,tpc,,1.6,t/cm\n"));
  EXPECT_THAT(csv, HasSubstr("\ncurves_box,1,kn,0,"));
  const std::string table = curves_output({box_mesh(), "--draught", "1:2:1", "--heel", "0:10:10"});
  for (const char* text : {"waterplane_area", "t m/cm", "KN 10°", "cp = volume"})
    EXPECT_THAT(table, HasSubstr(text));
}

std::string drawn(std::vector<std::string> words) {
  const std::filesystem::path file = testing::TempDir() + "curves.svg";
  words.insert(words.end(), {"--plot", file.string()});
  curves_output(std::move(words));
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(CurvesOfForm, AreDrawnAsTheRightingArmsAre) {
  const std::string form = drawn({box_mesh(), "--draught", "1:3:0.5", "--heel", "10:20:10"});
  for (const char* text : {"<svg", "curves of form, upright", "displacement [t]", "TPC [t/cm]",
                           "KN [m]", "draught [m]"})
    EXPECT_THAT(form, HasSubstr(text));
  const std::string arms = drawn({box_mesh(), "--draught", "2"});
  for (const char* text : {"<svg", "GZ [m]", "heel [°]", "curves_box"})
    EXPECT_THAT(arms, HasSubstr(text));
}

TEST(CurvesOfForm, RefuseWhatIsWrong) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{box_mesh(), "--draught", "1:2:1", "--mass", "9"}, "--mass: given beside several draughts"},
      {{box_mesh(), "--draught", "2:1:1"}, "--draught: found 2:1:1, expected FIRST <= LAST"},
      {{box_mesh(), "--draught", "deep"}, "--draught: found deep, expected FIRST:LAST:STEP"},
      {{box_mesh(), "--draught", "2", "--trim", "1"}, "--trim: is for the curves of form"},
      {{box_mesh(), "--draught", "1,2", "--trim", "60"}, "--trim: expected less than 45"},
      {{box_mesh(), "--draught", "1,2", "--trim", "1", "--heel", "0:9:1"},
       "--heel: given beside --trim"},
      {{box_mesh(), "--draught", "1,2", "--water", "1"}, "--water: is for one draught"},
      {{box_mesh(), "--draught", "1,2", "--plot", "a.png"}, "--plot: found a.png"},
  };
  for (const auto& [words, fault] : cases)
    EXPECT_THAT(curves_output(words), HasSubstr(fault)) << words.back();
}

}  // namespace

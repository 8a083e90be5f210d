#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program/program.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using nlohmann::json;
using support::tolerance;
using testing::HasSubstr;

const std::string kScene =
    "plimsoll: 1\n"
    "duration: 1\n"
    "water: {density: 1025}\n"
    "bodies:\n"
    "  - {name: ball, icosphere: {radius: 1, subdivisions: 3}, density: 500, position: [3, 1, 9]}\n"
    "  - {name: box, box: {size: [1, 1, 1]}, mass: 10, center_of_mass: [0.1, 0, 0]}\n";

std::string mesh_file(const std::string& name) {
  return (std::filesystem::path(PLIMSOLL_SOURCE_DIR) / name).string();
}

/// What the command prints, or the fault it throws.
std::string output_of(std::vector<std::string> words) {
  words.insert(words.begin(), "addedmass");
  return support::output_of(std::move(words));
}

TEST(AddedMassCommand, TakesBodiesAndWaterOfAScene) {
  const std::string file = support::write_scene(kScene);
  const json bodies = json::parse(output_of({file, "--json", "--tolerance", "0.1"}))["bodies"];
  const json& ball = bodies["ball"];
  const double volume = ball["volume"];
  EXPECT_EQ(ball["com"].size(), 3);
  EXPECT_EQ(ball["density"], 1025);
  const double half = 1025 * volume / 2;
  EXPECT_NEAR(ball["added_mass"][0][0], half, tolerance(1e-3) * half);
  EXPECT_EQ(ball["added_mass"].size(), 6);
  EXPECT_EQ(ball["added_mass"][5].size(), 6);
  // About a centre of mass off the middle, sway turns the box: A_26 = −0.1 m · A_22.
  const json& box = bodies["box"];
  EXPECT_EQ(box["com"][0], 0.1);
  const double sway = box["added_mass"][1][1];
  EXPECT_NEAR(box["added_mass"][1][5], -0.1 * sway, tolerance(1e-2) * 0.1 * sway);
  EXPECT_GT(box["error_estimate"], 0);
}

TEST(AddedMassCommand, OfShapesThatTouchIsThatOfTheirUnionAndOfShapesApartTheirSum) {
  const std::string file = support::write_scene(
      "plimsoll: 1\nduration: 1\nwater: {}\nbodies:\n"
      "  - {name: whole, density: 500, box: {size: [2, 1, 1]}}\n"
      "  - {name: halves, density: 500, shapes: [{box: {size: [1, 1, 1]}},"
      " {box: {size: [1, 1, 1]}, position: [1, 0, 0]}]}\n"
      "  - {name: balls, density: 500, shapes: [{icosphere: {radius: 1, subdivisions: 2}},"
      " {icosphere: {radius: 1, subdivisions: 2}, position: [0, 40, 0]}]}\n");
  const json bodies = json::parse(output_of({file, "--json", "--tolerance", "0.05"}))["bodies"];
  for (int i = 0; i < 6; ++i) {
    const double whole = bodies["whole"]["added_mass"][i][i];
    EXPECT_NEAR(bodies["halves"]["added_mass"][i][i], whole, tolerance(0.01) * whole) << i;
  }
  const double half = 1000 * bodies["balls"]["volume"].get<double>() / 2;
  for (int i = 0; i < 3; ++i)  // the other ball changes it by the cube of 1/40
    EXPECT_NEAR(bodies["balls"]["added_mass"][i][i], half, tolerance(5e-3) * half) << i;
}

TEST(AddedMassCommand, TakesDensityAndMethodOfAMesh) {
  const std::string mesh = mesh_file("scenes/meshes/barge.obj");
  const auto surge = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {mesh, "--json", "--method", "constant"};
    words.insert(words.end(), options.begin(), options.end());
    return json::parse(output_of(words))["bodies"]["barge"]["added_mass"][0][0].get<double>();
  };
  EXPECT_NEAR(surge({"--density", "500"}), surge({}) / 2, tolerance(1e-12) * surge({}));
}

TEST(AddedMassCommand, TellsTheErrorInItsTable) {
  const std::string file = support::write_scene(kScene);
  const std::string text = output_of({file, "--tolerance", "0.1"});
  EXPECT_THAT(text, HasSubstr("ball: volume"));
  EXPECT_THAT(text, HasSubstr("error below"));
}

TEST(AddedMassCommand, RefusesWhatIsWrong) {
  const std::string mesh = mesh_file("scenes/meshes/barge.obj");
  EXPECT_THAT(output_of({mesh_file("tests/data/bad_meshes/open.obj")}), HasSubstr("are open"));
  EXPECT_THAT(output_of({mesh, "--density", "0"}), HasSubstr("--density: found 0"));
  EXPECT_THAT(output_of({mesh, "--tolerance", "-1"}), HasSubstr("--tolerance: found -1"));
  EXPECT_THAT(output_of({mesh, "--set", "gravity=1"}), HasSubstr("--set is for a scene"));
  EXPECT_THAT(output_of({"nowhere.obj"}), HasSubstr("nowhere.obj"));
}

}  // namespace

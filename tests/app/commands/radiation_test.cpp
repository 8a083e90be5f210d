#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program/program.h"
#include "tests/app/scene_text.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kBuoy =
    "plimsoll: 1\n"
    "duration: 1\n"
    "gravity: 9.81\n"
    "water: {density: 1025}\n"
    "bodies:\n"
    "  - {name: buoy, icosphere: {radius: 1, subdivisions: 2}, density: 512.5,\n"
    "     start: equilibrium}\n"
    "  - {name: stone, icosphere: {radius: 1, subdivisions: 1}, density: 2000, position: [9, 0, "
    "-9]}\n";

/// What the command prints, or the fault it throws.
std::string radiation_of(std::vector<std::string> words) {
  words.insert(words.begin(), "radiation");
  return support::output_of(std::move(words));
}

TEST(RadiationCommand, TakesTheBodiesOfASceneThatMakeWaves) {
  const std::string file = support::write_scene(kBuoy);
  const json bodies = json::parse(
      radiation_of({file, "--json", "--no-store", "--frequencies", "1,2.2147"}))["bodies"];
  ASSERT_EQ(bodies.size(), 1);
  const json& buoy = bodies["buoy"];
  const json& row = buoy["frequencies"][1];
  EXPECT_EQ(row["omega"], 2.2147);  // kR = 0.5
  const double mass = 1025 * buoy["displaced_volume"].get<double>();
  EXPECT_NEAR(row["added_mass"][2][2].get<double>() / mass, 0.586, 0.02);
  EXPECT_NEAR(row["damping"][2][2].get<double>() / (2.2147 * mass), 0.339, 0.02);
  const double real =
      row["froude_krylov_real"][0][2].get<double>() + row["diffraction_real"][0][2].get<double>();
  const double imag =
      row["froude_krylov_imag"][0][2].get<double>() + row["diffraction_imag"][0][2].get<double>();
  EXPECT_NEAR(std::hypot(real, imag) / (1025 * 9.81 * M_PI), 0.537, 0.03);
  EXPECT_EQ(buoy["headings"].size(), 36);
}

TEST(RadiationCommand, ShowsAllSixMotionsAndTheNaturalPeriods) {
  const std::string file = support::write_scene(kBuoy);
  const std::string text = radiation_of({file, "--no-store"});
  EXPECT_THAT(text,
              HasSubstr("       surge        sway       heave        roll       pitch         "
                        "yaw\n"));
  EXPECT_THAT(text, HasSubstr("|X| of waves that travel toward 90 deg"));
  EXPECT_THAT(text, HasSubstr("natural periods: "));
  const json buoy = json::parse(radiation_of({file, "--no-store", "--json"}))["bodies"]["buoy"];
  // A half-submerged sphere heaves where kR = 1.055; the polyhedron is 3 % smaller.
  for (const json& mode : buoy["natural_periods"]["modes"])
    if (mode["motion"] == "heave") {
      EXPECT_NEAR(mode["period"].get<double>(), 2 * M_PI / std::sqrt(9.81 * 1.055), 0.04);
      return;
    }
  ADD_FAILURE() << buoy["natural_periods"];
}

TEST(RadiationCommand, WritesWhatOtherProgramsRead) {
  const std::string file = support::write_scene(kBuoy);
  const std::filesystem::path stem = std::filesystem::path(testing::TempDir()) / "radiation_buoy";
  const std::string text =
      radiation_of({file, "--no-store", "--frequencies", "2.2147", "--wamit", stem.string()});
  EXPECT_THAT(text, HasSubstr("assumed: small motions"));
  EXPECT_THAT(text, HasSubstr("2.215"));
  std::ifstream radiation(stem.string() + ".1");
  double period = 0, A = 0, B = 0, heave = 0;
  int i = 0, j = 0, rows = 0;
  std::string line;
  while (std::getline(radiation, line)) {
    std::istringstream words(line);
    words >> period >> i >> j >> A;
    ++rows;
    if (period > 0 && i == 3 && j == 3 && words >> B) heave = A;
  }
  EXPECT_EQ(rows, 72);  // Of the limit and of one frequency.
  EXPECT_NEAR(period, 2 * M_PI / 2.2147, 1e-5);
  EXPECT_NEAR(heave, 0.586 * 2.03, 0.06);  // Over the density, of the polyhedron's volume.
}

TEST(RadiationCommand, ReadsWhatItHasWritten) {
  const std::filesystem::path folder = testing::TempDir();
  const std::string scene = support::write_scene(kBuoy);
  const std::string dataset = (folder / "buoy.nc").string(),
                    picture = (folder / "buoy.svg").string();
  const json solved =
      json::parse(radiation_of({scene, "--json", "--no-store", "--frequencies", "1,2.2147",
                                "--capytaine", dataset, "--plot", picture}))["bodies"]["buoy"];
  const std::string by_file = support::write_scene(kBuoy);
  const std::string set = "--set=bodies[buoy].hydro.radiation={file: " + dataset + "}";
  const json read = json::parse(radiation_of({by_file, "--json", set}))["bodies"]["buoy"];
  EXPECT_EQ(read["format"], "Capytaine");
  EXPECT_EQ(read["file"], dataset);
  EXPECT_EQ(read["notes"], json::array());
  ASSERT_EQ(read["frequencies"].size(), 2);
  for (const char* key : {"added_mass", "damping"})
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(read["frequencies"][1][key][i][i].get<double>(),
                  solved["frequencies"][1][key][i][i].get<double>(), 1e-9);
  EXPECT_EQ(read["headings"], solved["headings"]);
  EXPECT_THAT(radiation_of({by_file, set}), HasSubstr("2 frequencies and 36 headings of"));
  EXPECT_THAT(radiation_of({by_file, set, "--frequencies", "1"}),
              HasSubstr("--frequencies: is for bodies that are solved"));
  const std::string narrow =
      "--set=bodies[buoy].hydro.radiation={file: " + dataset + ", frequencies: [0.5, 1.5]}";
  EXPECT_THAT(radiation_of({by_file, narrow}),
              HasSubstr("hydro.radiation.frequencies: found [0.5, 1.5], in which lie 1 of the "
                        "file's frequencies, 1 to 2.215 rad/s; expected at least 2"));
  EXPECT_THAT(radiation_of({by_file, "--plot", "buoy.png"}),
              HasSubstr("--plot: found buoy.png, expected a file .svg"));
  std::ifstream drawn(picture);
  const std::string svg(std::istreambuf_iterator<char>(drawn), {});
  EXPECT_THAT(svg,
              testing::AllOf(testing::StartsWith("<svg"), testing::EndsWith("</svg>\n"),
                             HasSubstr("added mass A [kg]"), HasSubstr("|X| over heading, yaw")));
}

TEST(RadiationCommand, TellsADatabaseWithoutLoadsOfWaves) {
  const std::filesystem::path stem = std::filesystem::path(testing::TempDir()) / "still_buoy";
  const std::string scene = support::write_scene(kBuoy);
  radiation_of({scene, "--no-store", "--frequencies", "0.5,1,2", "--wamit", stem.string()});
  std::filesystem::remove(stem.string() + ".3");
  const std::string set = "--set=bodies[buoy].hydro.radiation={file: " + stem.string() + ".1}";
  const std::string picture = stem.string() + ".svg";
  const json buoy =
      json::parse(radiation_of({scene, "--json", set, "--plot", picture, "--capytaine",
                                stem.string() + ".nc"}))["bodies"]["buoy"];
  EXPECT_EQ(buoy["headings"], json::array());
  EXPECT_FALSE(buoy["frequencies"][0].contains("diffraction_real"));
  EXPECT_GT(std::filesystem::file_size(picture), 1000u);
  for (const char* format : {"--csv", "--no-store"})
    EXPECT_THAT(radiation_of({scene, set, format}), HasSubstr("buoy"));
}

TEST(RadiationCommand, TakesAMeshAsAUniformBody) {
  const std::string mesh =
      (std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "scenes/meshes/barge.obj").string();
  const std::string rows = radiation_of({mesh, "--csv", "--no-store", "--frequencies", "1"});
  EXPECT_THAT(rows, HasSubstr("barge,1,added_mass,surge,surge,"));
  EXPECT_THAT(rows, HasSubstr("barge,1,excitation_imag,yaw,350,"));
  const std::string shallow =
      radiation_of({mesh, "--no-store", "--frequencies", "1", "--depth", "3"});
  EXPECT_THAT(shallow, HasSubstr("water 3 m deep everywhere"));
  EXPECT_THAT(shallow, HasSubstr("        1     32.34"));  // ω² = g k tanh 3k
}

TEST(RadiationCommand, RefusesWhatIsWrong) {
  const std::string file = support::write_scene(kBuoy);
  EXPECT_THAT(radiation_of({file, "--set", "integrator.method=ode"}),
              HasSubstr("no body of the scene makes waves; stone:"));
  EXPECT_THAT(radiation_of({file, "--frequencies", "2,1"}), HasSubstr("that ascend"));
  const std::string mesh =
      (std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "scenes/meshes/barge.obj").string();
  EXPECT_THAT(radiation_of({mesh, "--relative-density", "1.2"}),
              HasSubstr("--relative-density: found 1.2"));
  EXPECT_THAT(radiation_of({mesh, "--depth", "1.5"}),
              HasSubstr("--depth: found 1.5, expected more than the draught of 1.633 m"));
  EXPECT_THAT(radiation_of({mesh, "--density", "0"}), HasSubstr("--density: found 0"));
  EXPECT_THAT(radiation_of({mesh, "--set", "gravity=1"}), HasSubstr("--set is for a scene"));
}

}  // namespace

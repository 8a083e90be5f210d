#include "app/hydrostatics/hydrostatics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "app/assembly/build.h"
#include "app/assembly/build_start.h"
#include "tests/app/program/program.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using nlohmann::json;
using testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;

/// Sums of some hundred terms of the size of the result.
const double kRoundOff = support::tolerance(1e-12);

/// A barge of 20 × 8 × 4 m that draws 2 m and an anchor, in water at z = 3 m.
const std::string kBarge =
    "plimsoll: 1\n"
    "duration: 1\n"
    "gravity: 10\n"
    "water: {density: 1025, level: 3}\n"
    "bodies:\n"
    "  - name: barge\n"
    "    box: {size: [20, 8, 4]}\n"
    "    mass: 328000\n"
    "    center_of_mass: [0, 0, 0.5]\n"
    "    position: [7, -5, 40]\n"
    "    orientation: {euler_deg: [12, -7, 130]}\n";
const std::string kAnchor =
    "  - {name: anchor, sphere: {radius: 0.3}, density: 7800, position: [0, 9, 0]}\n";

std::filesystem::path mesh_file(const std::string& name) {
  return std::filesystem::path(PLIMSOLL_SOURCE_DIR) / name;
}

std::vector<app::FloatingReport> reports_of(const std::string& scene) {
  std::vector<app::FloatingReport> reports;
  for (const app::FloatingBody& body : app::floating_bodies({.file = support::write_scene(scene)}))
    reports.push_back(app::floating_report(body, {0, 10 * kDegree, 20 * kDegree}));
  return reports;
}

TEST(HydrostaticsReport, OfABargeHasTheClosedForms) {
  const json body = json::parse(app::floating_json(reports_of(kBarge)))["bodies"]["barge"];
  const json& rest = body["rest"];
  EXPECT_TRUE(body["floats"]);
  EXPECT_EQ(rest["stability"], "stable");
  EXPECT_NEAR(body["reserve_buoyancy"], 0.5, kRoundOff);
  const std::vector<std::pair<std::string, double>> expected = {
      {"heel_deg", 0},
      {"trim_deg", 0},
      {"draught", 2},
      {"com_height", 0.5},
      {"displaced_volume", 320},
      {"waterplane_area", 160},
      {"wetted_surface", 160 + 2 * 28 * 2},
      {"kb", 1},
      {"kg", 2.5},
      {"bm_t", 8 / 3.0},
      {"bm_l", 50 / 3.0},
      {"gm_t", 8 / 3.0 - 1.5},
      {"gm_l", 50 / 3.0 - 1.5},
      {"gm_least", 8 / 3.0 - 1.5},
      {"second_moment_transverse", 20 * 512 / 12.0},
      {"second_moment_longitudinal", 8 * 8000 / 12.0},
      {"c33", 10250 * 160.0},
      {"c44", 3.28e6 * (8 / 3.0 - 1.5)},
      {"c55", 3.28e6 * (50 / 3.0 - 1.5)},
  };
  for (const auto& [key, value] : expected)
    EXPECT_NEAR(rest[key].get<double>(), value, kRoundOff * std::max(1.0, value)) << key;
  EXPECT_NEAR(rest["centre_of_buoyancy"][2], -1, kRoundOff);
  EXPECT_NEAR(rest["centre_of_flotation"][2], 0, kRoundOff);
  const double tangent = std::tan(20 * kDegree);
  EXPECT_NEAR(body["gz"][2]["gz"],
              (8 / 3.0 - 1.5 + 4 / 3.0 * tangent * tangent) * std::sin(20 * kDegree), kRoundOff);
}

TEST(HydrostaticsReport, KeepsTheHeadingOfTheScene) {
  const json rest = json::parse(app::floating_json(reports_of(kBarge)))["bodies"]["barge"]["rest"];
  EXPECT_NEAR(rest["quaternion"][0], std::cos(65 * kDegree), kRoundOff);
  EXPECT_NEAR(rest["quaternion"][3], std::sin(65 * kDegree), kRoundOff);
}

TEST(HydrostaticsReport, TellsWhatSinksBesideWhatFloats) {
  const std::vector<app::FloatingReport> reports = reports_of(kBarge + kAnchor);
  ASSERT_EQ(reports.size(), 2);
  EXPECT_EQ(reports[0].not_afloat, "");
  EXPECT_THAT(reports[1].not_afloat, HasSubstr("sinks"));
  const json anchor = json::parse(app::floating_json(reports))["bodies"]["anchor"];
  EXPECT_FALSE(anchor["floats"]);
  EXPECT_THAT(anchor["reason"].get<std::string>(), HasSubstr("sinks"));
  EXPECT_THAT(app::floating_table(reports), HasSubstr("sinks"));
  EXPECT_THAT(app::floating_csv(reports), HasSubstr("anchor,body,mass,,"));
}

TEST(HydrostaticsReport, OfAMeshDoesNotDependOnWhereItsOriginIs) {
  app::FloatingBody body = app::floating_bodies({.file = mesh_file("scenes/meshes/wigley.obj"),
                                                 .mass = 2000,
                                                 .center_of_mass = Vector3d(0.2, 0.05, -0.3)})[0];
  const app::FloatingReport here = app::floating_report(body, {});
  body.com_M += Vector3d(100, -50, 20);
  const app::FloatingReport moved = app::floating_report(body, {});
  const auto point = [](const app::FloatingReport& r) {
    for (const app::Quantity& q : app::state_quantities(r.body, r.rest, r.orientation))
      if (q.key == "centre_of_buoyancy") return Vector3d(q.values[0], q.values[1], q.values[2]);
    return Vector3d(Vector3d::Zero());
  };
  // Adding 100 m costs digits of a metre's fraction.
  EXPECT_LT((point(moved) - point(here) - Vector3d(100, -50, 20)).norm(),
            support::tolerance(1e-13));
  EXPECT_EQ(moved.rest.flotation.draught, here.rest.flotation.draught);
}

TEST(HydrostaticsReport, OfADraughtIsThatOfTheMassThatDrawsIt) {
  const std::filesystem::path file = mesh_file("scenes/meshes/barge.obj");
  const app::FloatingBody body =
      app::floating_bodies({.file = file, .draught = 1.2, .density = 1025.0})[0];
  EXPECT_EQ(body.density, 1025);
  const app::FloatingReport report = app::floating_report(body, {});
  EXPECT_NEAR(report.start.flotation.draught, 1.2, kRoundOff);
  EXPECT_EQ(report.start.stability, hydro::Stability::stable);
}

TEST(HydrostaticsReport, ADraughtCountsFromTheKeelThatIsNamed) {
  const std::filesystem::path file = mesh_file("scenes/meshes/wigley.obj");  // lowest at -0.625
  const double from_below = app::floating_bodies({.file = file, .draught = 0.5})[0].mass;
  const app::FloatingBody body =
      app::floating_bodies({.file = file, .draught = 0.325, .keel = -0.45})[0];
  EXPECT_NEAR(body.mass, from_below, kRoundOff * from_below);
  const app::FloatingReport report = app::floating_report(body, {});
  const json start = json::parse(app::floating_json({report}))["bodies"]["wigley"]["start"];
  EXPECT_NEAR(start["draught_from_keel"], 0.325, kRoundOff);
  EXPECT_THAT(app::floating_table({report}), HasSubstr("draught: depth of the lowest point"));
}

TEST(HydrostaticsReport, HeelCountsFromTheAttitudeThatTheSceneGives) {
  std::string lying = kBarge;  // drawn with y up
  const auto put = [&](const std::string& old, const std::string& text) {
    lying.replace(lying.find(old), old.size(), text);
  };
  put("[20, 8, 4]", "[20, 4, 8]");
  put("[0, 0, 0.5]", "[0, 0.5, 0]");
  put("[12, -7, 130]", "[95, 2, 130]");
  const app::FloatingReport expected = reports_of(kBarge)[0], found = reports_of(lying)[0];
  ASSERT_EQ(found.righting_arms.size(), expected.righting_arms.size());
  for (std::size_t i = 0; i < found.righting_arms.size(); ++i)
    EXPECT_NEAR(found.righting_arms[i].lever, expected.righting_arms[i].lever,
                support::tolerance(1e-9))
        << i;
  EXPECT_NEAR(found.intact.criteria[0].value, expected.intact.criteria[0].value,
              support::tolerance(1e-9));
}

/// The lines of a text, split at commas.
std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& cells = rows.emplace_back();
    std::istringstream stream(line + ",");
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  }
  return rows;
}

/// A quantity of the criteria of stability as the JSON has it.
double imo_value(const json& body, const std::string& name) {
  if (name == "downflooding_deg") return body[name].get<double>();
  for (const json& criterion : body["imo_criteria"])
    if (criterion["name"] == name) return criterion["value"].get<double>();
  ADD_FAILURE() << name;
  return 0;
}

TEST(HydrostaticsReport, HasTheSameNumbersInCsvAsInJson) {
  const auto reports = reports_of(kBarge);
  const json body = json::parse(app::floating_json(reports))["bodies"]["barge"];
  int numbers = 0;
  for (const auto& row : rows_of(app::floating_csv(reports))) {
    ASSERT_EQ(row.size(), 6);
    if (row[0] == "body") continue;  // the header
    const double value = std::stod(row[4]);
    const std::size_t bracket = row[2].find('[');
    const std::string key = row[2].substr(0, bracket);
    if (row[1] == "gz") {
      const long i = std::lround(std::stod(row[3]) / 10);
      EXPECT_EQ(body["gz"][i][key].get<double>(), value);
    } else if (row[1] == "imo") {
      EXPECT_EQ(imo_value(body, row[2]), value);
    } else {
      const json& at = row[1] == "body" ? body[key] : body[row[1]][key];
      EXPECT_EQ((at.is_array() ? at[std::stoi(row[2].substr(bracket + 1))] : at).get<double>(),
                value);
    }
    ++numbers;
  }
  EXPECT_GT(numbers, 70);
}

/// What the command prints, or the fault it throws.
std::string output_of(std::vector<std::string> words) {
  words.insert(words.begin(), "hydrostatics");
  return support::output_of(std::move(words));
}

TEST(HydrostaticsCommand, TakesMassCentreOfMassAndHeelsOfAMesh) {
  const std::string text = output_of({mesh_file("scenes/meshes/barge.obj"), "--mass", "1e5",
                                      "--com", "-0.5,0,1", "--heel", "-10:10:4", "--json"});
  const json body = json::parse(text)["bodies"]["barge"];
  EXPECT_EQ(body["mass"], 1e5);
  EXPECT_EQ(body["com"], json({-0.5, 0, 1}));
  EXPECT_LT(body["rest"]["trim_deg"], -0.1);  // its −x end is down
  ASSERT_EQ(body["gz"].size(), 6);
  EXPECT_NEAR(body["gz"][5]["heel_deg"], 10, kRoundOff);
}

TEST(HydrostaticsCommand, TakesAxisUnitAndScaleOfAMesh) {
  const std::string mesh = mesh_file("tests/data/meshes/hull_mm.obj");
  const std::string text =
      output_of({mesh, "--mass", "1536", "--up", "y", "--unit", "mm", "--json"});
  const json body = json::parse(text)["bodies"]["hull_mm"];
  EXPECT_NEAR(body["volume"], 3.2 * 1.2 * 0.8, kRoundOff);
  EXPECT_NEAR(body["rest"]["draught"], 0.4, kRoundOff);
  const std::string below =
      output_of({mesh, "--mass", "1536", "--up=-y", "--unit=m", "--scale=0.001", "--json"});
  EXPECT_NEAR(json::parse(below)["bodies"]["hull_mm"]["com"][2], -0.4, kRoundOff);
}

TEST(HydrostaticsCommand, SetsKeysOfAScene) {
  const std::string file = support::write_scene(kBarge);
  const std::string text = output_of({file, "--set", "bodies[barge].mass=164000", "--csv"});
  EXPECT_THAT(text, HasSubstr("barge,body,mass,,164000,kg\n"));
  EXPECT_THAT(output_of({file}), HasSubstr("at rest: stable"));
}

TEST(HydrostaticsCommand, RefusesWhatIsWrong) {
  const std::string mesh = mesh_file("scenes/meshes/barge.obj");
  const std::string scene = support::write_scene(kBarge);
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{mesh}, "--mass: missing"},
      {{mesh, "--mass", "1", "--draught", "1"}, "--draught: given beside --mass"},
      {{mesh, "--mass", "-1"}, "--mass: found -1, expected a positive number [kg]"},
      {{mesh, "--mass", "nan"}, "--mass: found nan"},
      {{mesh, "--draught", "0"}, "--draught: found 0"},
      {{mesh, "--draught", "50"}, "expected between 0 and 3 m"},
      {{mesh, "--mass", "1", "--density", "0"}, "--density: found 0"},
      {{mesh, "--mass", "1", "--com", "inf,0,0"}, "--com: expected finite numbers"},
      {{mesh, "--mass", "1", "--set", "gravity=1"}, "--set is for a scene"},
      {{mesh, "--mass", "1", "--json", "--csv"}, "--csv: given beside --json"},
      {{mesh, "--mass", "1", "--heel", "0:60"}, "--heel: found 0:60"},
      {{mesh, "--mass", "1", "--heel", "0:60:0"}, "--heel"},
      {{mesh, "--mass", "1", "--heel", "0:60:5x"}, "--heel"},
      {{mesh, "--mass", "1", "--heel", "9:0:5"}, "--heel"},
      {{mesh, "--mass", "1", "--heel", "0:nan:5"}, "--heel"},
      {{mesh, "--mass", "1e9"}, "barge: it sinks: its mass is 1e+09 kg"},
      {{mesh_file("tests/data/bad_meshes/open.obj"), "--mass", "1"}, "edges are open"},
      {{"nowhere.obj", "--mass", "1"}, "nowhere.obj: "},
      {{scene, "--mass", "1"}, "--mass: is for a mesh"},
      {{scene, "--draught", "1"}, "--draught: is for a mesh"},
      {{scene, "--density", "1"}, "--density: is for a mesh"},
      {{scene, "--com", "1,2,3"}, "--com: is for a mesh"},
      {{mesh, "--draught", "1", "--keel", "nan"}, "--keel: expected a finite number"},
      {{mesh, "--draught", "1", "--keel", "-5"}, "--draught: found 1, expected between 5 and 8 m"},
      {{scene, "--keel", "1"}, "--keel: is for a mesh"},
      {{scene, "--up", "y"}, "--up: is for a mesh"},
      {{scene, "--unit", "mm"}, "--unit: is for a mesh"},
      {{scene, "--scale", "2"}, "--scale: is for a mesh"},
      {{scene, "--set", "gravity=0"}, "gravity: found 0"},
      {{scene, "--set", "bodies[0].mass=1e7"}, "barge: it sinks"},
      {{scene, "--set", "hydro.buoyancy=false"}, "has no body with buoyancy"},
  };
  for (const auto& [words, fault] : cases)
    EXPECT_THAT(output_of(words), HasSubstr(fault)) << words.back();
}

TEST(HydrostaticsCommand, NeedsWater) {
  const std::string scene = support::write_scene(support::kSmallScene);
  EXPECT_THAT(output_of({scene}), HasSubstr("water: missing"));
}

/// Force and moment of water and weight on a body as it is assembled.
hydro::Wrench net_load(const assembly::BuiltScene& built, std::size_t i) {
  const engine::BodySpec& body = built.spec.bodies[i];
  hydro::Sea still = *built.spec.sea;
  still.surface = hydro::FlatSurface{};
  hydro::Wrench net =
      hydro::compute_loads(hydro::make_hull(body.mesh_B), body.initial, still, 0, body.coefficients)
          .buoyancy;
  net.force.z() -= body.mass * built.spec.gravity;
  return net;
}

const std::string kSpar =
    "  - name: spar\n"
    "    ellipsoid: {semi_axes: [3, 1, 1.5], slices: 16, stacks: 16}\n"
    "    mass: 9000\n"
    "    center_of_mass: [0.3, 0.1, -0.2]\n"
    "    position: [7, -5, 40]\n"
    "    orientation: {euler_deg: [12, -7, 130]}\n"
    "    start: equilibrium\n";
const std::string kWater = "plimsoll: 1\nduration: 1\nwater: {density: 1025, level: 3}\nbodies:\n";

TEST(StartInEquilibrium, LeavesNoLoadAndKeepsXYAndHeading) {
  const assembly::BuiltScene built =
      assembly::build_without_added_mass(support::read_scene_text(kWater + kSpar));
  const engine::BodySpec& body = built.spec.bodies[0];
  const double weight = 9000 * 9.80665;
  const hydro::Wrench net = net_load(built, 0);
  EXPECT_LT(net.force.norm(), support::tolerance(1e-12) * weight);
  EXPECT_LT(net.moment.norm(), support::tolerance(1e-12) * weight);
  const Eigen::Quaterniond& R = body.initial.orientation;
  const Vector3d origin = body.initial.position - R * built.centers_of_mass[0];
  EXPECT_NEAR(origin.x(), 7, kRoundOff);
  EXPECT_NEAR(origin.y(), -5, kRoundOff);
  EXPECT_NEAR(hydro::euler_angles(R)[2], 130 * kDegree, kRoundOff);
}

TEST(StartInEquilibrium, IsReportedFromTheOrientationThatWasGiven) {
  const app::FloatingReport report = reports_of(kWater + kSpar)[0];
  const Vector3d given = hydro::euler_angles(report.start.flotation.orientation);
  EXPECT_LT((given - Vector3d(12, -7, 0) * kDegree).norm(), kRoundOff);
}

TEST(StartInEquilibrium, IsAboutTheStillLevelInWaves) {
  const assembly::BuiltScene still =
      assembly::build_without_added_mass(support::read_scene_text(kWater + kSpar));
  const assembly::BuiltScene waves = assembly::build_without_added_mass(support::read_scene_text(
      kWater + kSpar, {"water.surface={waves: [{amplitude: 1, wavelength: 20}]}"}));
  EXPECT_TRUE(waves.spec.bodies[0].initial == still.spec.bodies[0].initial);
}

TEST(StartInEquilibrium, IsAskedForBodyByBody) {
  const assembly::BuiltScene built = assembly::build_without_added_mass(
      support::read_scene_text(kBarge + kSpar, {"bodies[spar].position=[0, 0, 0]"}));
  const hydro::BodyState& given = built.spec.bodies[0].initial;
  EXPECT_NEAR((given.position - given.orientation * Vector3d(0, 0, 0.5)).z(), 40, kRoundOff);
  EXPECT_GT(net_load(built, 0).force.norm(), 1e6);
  EXPECT_LT(net_load(built, 1).force.norm(), support::tolerance(1e-12) * 9e4);
}

TEST(StartInEquilibrium, TellsTheMassOfABodyAndOfTheWaterInItApart) {
  EXPECT_EQ(assembly::why_not_afloat({.body = 1e5, .water = 32500}, 132, 1000),
            "it sinks: its mass is 100000 kg, the water in it weighs 32500 kg, and its volume of "
            "132 m^3 displaces 132000 kg");
  EXPECT_EQ(assembly::why_not_afloat({.body = 1e5, .water = 32500}, 133, 1000), "");
}

TEST(StartInEquilibrium, OfABodyThatSinksIsAFaultAtItsPlace) {
  const scene::Scene scene = support::read_scene_text(kWater + kSpar, {"water.density=100"});
  try {
    assembly::build_without_added_mass(scene);
    FAIL() << "assembled";
  } catch (const scene::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(":11:12: bodies[0].start: it sinks: its mass is 9000 kg"));
  }
}

TEST(StartInEquilibrium, OfABodyAsHeavyAsWaterIsAFault) {
  const scene::Scene scene = support::read_scene_text(
      support::kSmallScene, {"water={}", "bodies[a].density=1000", "bodies[a].start=equilibrium"});
  try {
    assembly::build_without_added_mass(scene);
    FAIL() << "assembled";
  } catch (const scene::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("bodies[0].start: it hovers"));
  }
}

}  // namespace

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numbers>
#include <regex>
#include <set>
#include <sstream>

#include "app/scene/key_catalogue.h"
#include "app/scene/schema.h"
#include "tests/app/scene_text.h"
#include "tests/support/tolerance.h"

namespace {

using support::read_scene_text;

constexpr double kDegree = std::numbers::pi / 180;

/// Angles pass through one multiplication by π/180 and Eigen's half-angle functions: a few ulp.
const double kRoundOff = support::tolerance(1e-15);

const std::string kMending = "weld: 1e-3, cap: true, mirror: y, unite: true, thickness: 0.02";

/// Every key but those of the other surfaces and grounds, with values that no default has.
std::string every_key() {
  const std::string folder = support::data_folder().string();
  return "plimsoll: 1\n"
         "title: Every key\n"
         "duration: 010\n"
         "step: +2.5e-3\n"
         "gravity: 1.62\n"
         "integrator: {method: split, tolerance: 0.5}\n"
         "water:\n"
         "  simulated: {size: [128, 128], spacing: 0.25, edge: 9}\n"
         "  density: 1025\n"
         "  viscosity: 1.2e-6\n"
         "  level: -1.5\n"
         "  depth: 30\n"
         "  current: [1, 2, 3]\n"
         "  surface:\n"
         "    waves:\n"
         "      - {amplitude: 0.5, wavelength: 20, heading_deg: 90, phase_deg: -45}\n"
         "      - {amplitude: 0, period: 4}\n"
         "    kinematics: hydrostatic\n"
         "    ramp: 12.5\n"
         "air: {density: 1.5, wind: {speed: 8, heading_deg: 90, height: 12, profile: power,"
         " exponent: 0.2}}\n"
         "ground: {z: -10, friction: 0.25, restitution: 0.125, suction: {pressure: 2e4, time: "
         "30}}\n"
         "hydro: {preset: thesis, buoyancy: true, pressure_drag: 0.5, lift: 0.25,"
         " viscous_drag: ittc57, length: 7, wave_tolerance: 2e-3, radiation: none,"
         " resistance: {wave: michell},"
         " added_mass: {model: deep, tolerance: 2e-3}}\n"
         "bodies:\n"
         "  - name: a\n"
         "    mesh: {file: " +
         folder + "/shore.obj, up: -y, unit: ft, scale: 2, " + kMending +
         "}\n"
         "    mass: 5\n"
         "    center_of_mass: [1, 2, 3]\n"
         "    inertia: [2, 3, 4, 0.1, 0.2, 0.3]\n"
         "    position: [4, 5, 6]\n"
         "    orientation: {euler_deg: [10, 20, 30]}\n"
         "    start: given\n"
         "    linear_velocity: [7, 8, 9]\n"
         "    angular_velocity: [-1, -2, -3]\n"
         "    hydro: {preset: fitted, buoyancy: false, pressure_drag: {front: 0.75, back: 0.5,"
         "      blunt: 0.25},"
         " lift: 1, viscous_drag: ittc57, length: 3, wave_tolerance: 0,"
         " radiation: {file: " +
         folder +
         "/shore.obj, body: 2, reference_point: [1, 2, 3], center_of_mass: [4, 5, 6],"
         " heading_deg: 90, length: 7, frequencies: [0.5, 2], pose: start},"
         " resistance: {file: " +
         folder +
         "/shore.obj},"
         " added_mass: {matrix: [[6, 0, 0, 0, 0, 0], [0, 5, 0, 0, 0, 1], [0, 0, 4, 0, 0, 0],"
         " [0, 0, 0, 3, 0, 0], [0, 0, 0, 0, 2, 0], [0, 1, 0, 0, 0, 1]]}}\n"
         "    calibrate: {drag: [1, 2, 3]}\n"
         "    collision: sphere\n"
         "    friction: 0.75\n"
         "    restitution: 0.5\n"
         "    lock: [x, yaw]\n"
         "    interior: flooding\n"
         "    air: true\n"
         "    interior_water: [{at: [1, 2, 3], volume: 4}, {at: [5, 6, 7], level: 8}]\n"
         "    openings: [{at: [1, 2, 3], area: 0.25, discharge: 0.5}]\n"
         "    pumps: [{name: q, from: [1, 2, 3], to: [4, 5, 6], rate: 0.5, head: 8},\n"
         "      {name: r, from: [0, 0, 1], to: sea, rate: 0}]\n"
         "    forces:\n"
         "      - {force: [1, 2, 3], torque: [4, 5, 6], frame: body, at: [7, 8, 9], start: 1,"
         " end: 2, sine: {frequency_hz: 0.5, phase_deg: 90}}\n"
         "      - {force: [1, 0, 0]}\n"
         "    color: [0.1, 0.2, 0.3]\n"
         "  - {name: b, box: {size: [1, 2, 3], divisions: 8}, density: 550, lock: all,"
         " orientation: {quaternion: [0, 0, 0, 2]}, hydro: {lift: false}}\n"
         "  - {name: c, sphere: {radius: 2, slices: 10, stacks: 11}, density: 1,"
         " orientation: {axis: [0, 0, 3], angle_deg: 30}, collision: none}\n"
         "  - {name: d, icosphere: {radius: 3, subdivisions: 2}, density: 1, collision: box}\n"
         "  - {name: e, ellipsoid: {semi_axes: [3, 2, 1], slices: 12, stacks: 13}, density: 1}\n"
         "  - {name: f, cylinder: {radius: 4, height: 5, slices: 14, stacks: 15}, density: 1,"
         " collision: mesh}\n"
         "joints:\n"
         "  - {name: j, type: universal, bodies: [a, b], anchor: [1, 2, 3], axis: [0, 2, 0],"
         " axis2: [3, 0, 0]}\n"
         "  - {type: slider, bodies: [c, world], axis: [1, 0, 0]}\n"
         "contacts:\n"
         "  - {bodies: [a, world], friction: 0}\n"
         "  - {bodies: [d, a], friction: 2, restitution: 1}\n"
         "log: {every: 0.5, forces: true, probes: [{name: g, wave: [1, 2], depth: 3},\n"
         "      {name: p, body: b, at: [4, 5, 6]}]}\n"
         "render:\n"
         "  size: [320, 16]\n"
         "  every: 0.25\n"
         "  camera: {from: [1, 2, 3], to: [4, 5, 6], fov_deg: 90, follow: b,"
         " orbit: -12}\n"
         "  sheet: {columns: 5}\n"
         "  show: [wireframe, forces, joints]\n"
         "  overlay: false\n"
         "  grid: false\n"
         "  pressure: {shows: dynamic, colors: coolwarm, min: -100, max: 5e3}\n";
}

const std::string kSpectrum =
    "water.surface={spectrum: {type: jonswap, significant_height: 1.5, peak_period: 7, gamma: 2,"
    " heading_deg: 180, spreading: 4, seed: -3, components: 32}}";

const std::vector<std::string> kCameras = {
    "render.camera=null",
    "render.cameras={stern: {}, NAME: {from: [1, 2, 3], to: [0, 0, 1], fov_deg: 50, follow: a,"
    " orbit: 1}}"};

const std::vector<std::string> kListedCameras = {
    "render.camera=null",
    "render.cameras=[{name: stern, orbit: 1, follow: a}, {name: deck, on: b, from: [0, 0, 3],"
    " to: [10, 0, 2], fov_deg: 50}]"};

std::string picture(const std::string& block) {
  return block + "={heightfield: {file: " + support::data_folder().string() +
         "/heights.png, cell: 0.5, origin: [-1, -2], range: [-3, 4]}}";
}

std::string shore() {
  return "ground={mesh: {file: " + support::data_folder().string() +
         "/shore.obj, up: y, unit: cm, scale: 3, " + kMending + "}}";
}

std::string zero_matrix() {
  const std::string row = "[0, 0, 0, 0, 0, 0]";
  std::string rows = row;
  for (int i = 1; i < 6; ++i) rows += ", " + row;
  return "{matrix: [" + rows + "]}";
}

TEST(SceneKeys, AirIsRead) {
  const hydro::Air air = *read_scene_text(every_key()).air;
  EXPECT_EQ(air.density, 1.5);
  EXPECT_LT((air.wind.velocity - Eigen::Vector3d(0, 8, 0)).norm(), 8 * kRoundOff);
  EXPECT_EQ(air.wind.height, 12);
  EXPECT_EQ(air.wind.exponent, 0.2);
  const hydro::Air uniform = *read_scene_text(every_key(), {"air={wind: [3, -4, 0]}"}).air;
  EXPECT_EQ(uniform.density, 1.225);
  EXPECT_EQ(uniform.wind.velocity, Eigen::Vector3d(3, -4, 0));
  EXPECT_TRUE(uniform.wind.uniform());
  const hydro::Air power = *read_scene_text(every_key(), {"air={wind: {speed: 5}}"}).air;
  EXPECT_EQ(power.wind.height, 10);
  EXPECT_EQ(power.wind.exponent, 0.11);
  EXPECT_TRUE(
      read_scene_text(every_key(), {"air.wind={speed: 5, profile: uniform}"}).air->wind.uniform());
}

TEST(SceneKeys, TopLevelIsRead) {
  const scene::Scene scene = read_scene_text(every_key());
  EXPECT_EQ(scene.title, "Every key");
  EXPECT_EQ(scene.duration, 10);  // 010 is decimal
  EXPECT_EQ(scene.step, 2.5e-3);
  EXPECT_EQ(scene.gravity, 1.62);
  EXPECT_EQ(scene.integrator.tolerance, 0.5);
  EXPECT_EQ(scene.log_every, 0.5);
  EXPECT_TRUE(scene.log_forces);
  ASSERT_EQ(scene.probes.size(), 2u);
  EXPECT_EQ(scene.probes[0].name, "g");
  EXPECT_EQ(scene.probes[0].wave, Eigen::Vector2d(1, 2));
  EXPECT_EQ(scene.probes[0].depth, 3);
  EXPECT_EQ(scene.probes[1].body, "b");
  EXPECT_EQ(scene.probes[1].at, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(std::get<scene::PlaneGround>(scene.ground).z, -10);
}

const char* const kTable = "water.current={depths: [1, 4], velocities: [[1, 2, 0], [0.5, 0, 0]]}";

TEST(SceneKeys, ATableOfTheCurrentIsRead) {
  const scene::Water water = *read_scene_text(support::kSmallScene, {"water={}", kTable}).water;
  EXPECT_EQ(water.current, Eigen::Vector3d(1, 2, 0));
  ASSERT_EQ(water.current_profile.size(), 2U);
  EXPECT_EQ(water.current_profile[1].depth, 4);
  EXPECT_EQ(water.current_profile[1].velocity, Eigen::Vector2d(0.5, 0));
}

TEST(SceneKeys, WaterIsRead) {
  const scene::Scene scene = read_scene_text(every_key());
  ASSERT_TRUE(scene.water.has_value());
  EXPECT_EQ(scene.water->density, 1025);
  EXPECT_EQ(scene.water->level, -1.5);
  EXPECT_EQ(scene.water->depth, 30);
  const scene::SimulatedWater& simulated = scene.water->simulated;
  EXPECT_EQ(simulated.kind, scene::SimulatedWater::Kind::felt);
  EXPECT_EQ((*simulated.size)[0], 128);
  EXPECT_EQ(*simulated.spacing, 0.25);
  EXPECT_EQ(*simulated.edge, 9);
  EXPECT_EQ(scene.water->kinematics, hydro::Kinematics::hydrostatic);
  EXPECT_EQ(scene.water->current, Eigen::Vector3d(1, 2, 3));
  const auto& waves = std::get<std::vector<scene::Wave>>(scene.water->surface);
  ASSERT_EQ(waves.size(), 2);
  EXPECT_EQ(waves[0].amplitude, 0.5);
  EXPECT_EQ(waves[0].wavelength, 20);
  EXPECT_EQ(waves[0].period, std::nullopt);
  EXPECT_NEAR(waves[0].heading, 90 * kDegree, kRoundOff);
  EXPECT_NEAR(waves[0].phase, -45 * kDegree, kRoundOff);
  EXPECT_EQ(waves[1].period, 4);
  EXPECT_EQ(waves[1].wavelength, std::nullopt);
  EXPECT_EQ(waves[1].heading, 0);
  EXPECT_EQ(scene.water->ramp, 12.5);
}

TEST(SceneKeys, SpectrumIsRead) {
  const scene::Scene scene = read_scene_text(every_key(), {kSpectrum});
  const auto& spectrum = std::get<scene::Spectrum>(scene.water->surface);
  EXPECT_EQ(spectrum.type, scene::Spectrum::Type::jonswap);
  EXPECT_EQ(spectrum.significant_height, 1.5);
  EXPECT_EQ(spectrum.peak_period, 7);
  EXPECT_EQ(spectrum.gamma, 2);
  EXPECT_NEAR(spectrum.heading, 180 * kDegree, kRoundOff);
  EXPECT_EQ(spectrum.spreading, 4);
  EXPECT_EQ(spectrum.seed, -3);
  EXPECT_EQ(spectrum.components, 32);
}

TEST(SceneKeys, TypesAndPeaksOfSpectraAreRead) {
  using Type = scene::Spectrum::Type;
  const auto read = [](const std::string& keys) {
    const scene::Scene scene = read_scene_text(
        every_key(),
        {"water.surface={spectrum: {significant_height: 1.5, peak_period: 7, " + keys + "}}"});
    return std::get<scene::Spectrum>(scene.water->surface);
  };
  EXPECT_EQ(read("type: jonswap").gamma, 3.3);
  EXPECT_EQ(read("type: jonswap, gamma: auto").gamma, std::nullopt);
  EXPECT_EQ(read("type: tma, gamma: 1").gamma, 1);
  EXPECT_EQ(read("type: tma").type, Type::tma);
  EXPECT_EQ(read("type: pierson_moskowitz").type, Type::pierson_moskowitz);
  EXPECT_EQ(read("type: bretschneider").type, Type::bretschneider);
  EXPECT_EQ(read("type: jonswap").file, std::nullopt);
}

TEST(SceneKeys, ASpectrumInAFileIsRead) {
  const std::string file = support::data_folder().string() + "/spectrum.csv";
  const scene::Scene scene = read_scene_text(
      every_key(), {"water.surface={spectrum: {type: file, file: " + file + ", spreading: 2}}"});
  const auto& spectrum = std::get<scene::Spectrum>(scene.water->surface);
  EXPECT_EQ(spectrum.type, scene::Spectrum::Type::file);
  EXPECT_EQ(spectrum.file, file);
  EXPECT_EQ(spectrum.spreading, 2);
}

TEST(SceneKeys, AMeasuredElevationIsRead) {
  const std::string file = support::data_folder().string() + "/elevation.csv";
  const std::string block = "water.surface={elevation: {file: " + file;
  const auto read = [&](const std::string& keys) {
    return std::get<scene::Elevation>(
        read_scene_text(every_key(), {block + keys + "}}"}).water->surface);
  };
  const scene::Elevation all = read(
      ", at: [1, 2], heading_deg: 90, start: 0.5, lowest_frequency_hz: 0.25,"
      " highest_frequency_hz: 3, components: 5");
  EXPECT_EQ(all.file, file);
  EXPECT_EQ(all.at, Eigen::Vector2d(1, 2));
  EXPECT_NEAR(all.heading, 90 * kDegree, kRoundOff);
  EXPECT_EQ(all.start, 0.5);
  EXPECT_NEAR(all.lowest.value(), 0.5 * M_PI, kRoundOff);
  EXPECT_NEAR(all.highest.value(), 6 * M_PI, 10 * kRoundOff);
  EXPECT_EQ(all.components, 5);
  const scene::Elevation least = read("");
  EXPECT_EQ(least.at, Eigen::Vector2d(0, 0));
  EXPECT_EQ(least.start, std::nullopt);
  EXPECT_EQ(least.lowest, std::nullopt);
  EXPECT_EQ(least.highest, std::nullopt);
  EXPECT_EQ(least.components, 1024);
}

TEST(SceneKeys, HeightFieldsAndGroundMeshAreRead) {
  const scene::Scene scene = read_scene_text(every_key(), {picture("water.surface"), shore()});
  const auto& field = std::get<scene::HeightField>(scene.water->surface);
  EXPECT_EQ(field.file, support::data_folder() / "heights.png");
  EXPECT_EQ(field.cell, 0.5);
  EXPECT_EQ(field.origin, Eigen::Vector2d(-1, -2));
  EXPECT_EQ(field.range, (std::array<double, 2>{-3, 4}));
  EXPECT_EQ(std::get<scene::Mesh>(scene.ground).scale, 3);
  EXPECT_EQ(std::get<scene::Mesh>(scene.ground).unit, 0.01);
  const scene::Scene sloping = read_scene_text(every_key(), {picture("ground")});
  EXPECT_EQ(std::get<scene::HeightField>(sloping.ground).cell, 0.5);
}

TEST(SceneKeys, ShapesAreRead) {
  const scene::Scene scene = read_scene_text(every_key());
  const auto& mesh = std::get<scene::Mesh>(scene.bodies[0].shape);
  EXPECT_EQ(mesh.file, support::data_folder() / "shore.obj");
  EXPECT_EQ(mesh.scale, 2);
  EXPECT_EQ(mesh.up, scene::UpAxis::minus_y);
  EXPECT_EQ(mesh.unit, 0.3048);
  const auto& box = std::get<scene::Box>(scene.bodies[1].shape);
  EXPECT_EQ(box.size, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(box.divisions, 8);
  const auto& sphere = std::get<scene::Sphere>(scene.bodies[2].shape);
  EXPECT_EQ(std::tuple(sphere.radius, sphere.slices, sphere.stacks), std::tuple(2, 10, 11));
  const auto& icosphere = std::get<scene::Icosphere>(scene.bodies[3].shape);
  EXPECT_EQ(std::tuple(icosphere.radius, icosphere.subdivisions), std::tuple(3, 2));
  const auto& ellipsoid = std::get<scene::Ellipsoid>(scene.bodies[4].shape);
  EXPECT_EQ(ellipsoid.semi_axes, Eigen::Vector3d(3, 2, 1));
  EXPECT_EQ(std::tuple(ellipsoid.slices, ellipsoid.stacks), std::tuple(12, 13));
  const auto& cylinder = std::get<scene::Cylinder>(scene.bodies[5].shape);
  EXPECT_EQ(std::tuple(cylinder.radius, cylinder.height, cylinder.slices, cylinder.stacks),
            std::tuple(4, 5, 14, 15));
}

/// A body of every shape, each placed.
std::string shapes() {
  const std::string mesh = "mesh: {file: " + support::data_folder().string() +
                           "/shore.obj, up: y, unit: mm, scale: 2, " + kMending + "}";
  std::string list;
  for (const std::string& shape :
       {mesh, std::string("box: {size: [1, 2, 3], divisions: 2}"),
        std::string("sphere: {radius: 1, slices: 5, stacks: 6}"),
        std::string("icosphere: {radius: 1, subdivisions: 2}"),
        std::string("ellipsoid: {semi_axes: [1, 2, 3], slices: 5, stacks: 6}"),
        std::string("cylinder: {radius: 1, height: 2, slices: 5, stacks: 6}")})
    list += "{" + shape + ", position: [1, 2, 3], orientation: {euler_deg: [90, 0, 0]}}, ";
  return "bodies[1]={name: b, density: 500, shapes: [" + list +
         "{box: {size: [1, 1, 1]}, orientation: {quaternion: [1, 0, 0, 0]}}, "
         "{box: {size: [1, 1, 1]}, orientation: {axis: [1, 0, 0], angle_deg: 9}}]}";
}

TEST(SceneKeys, SeveralShapesAreRead) {
  const scene::Scene scene = read_scene_text(every_key(), {shapes()});
  const auto& parts = std::get<scene::Shapes>(scene.bodies[1].shape).parts;
  ASSERT_EQ(parts.size(), 8u);
  EXPECT_EQ(std::get<scene::Mesh>(parts[0].shape).unit, 1e-3);
  EXPECT_EQ(std::get<scene::Cylinder>(parts[5].shape).height, 2);
  EXPECT_EQ(parts[1].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_LT((parts[1].orientation * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(),
            kRoundOff);
  EXPECT_THAT(support::faults_of("plimsoll: 1\nduration: 1\nbodies:\n  - {name: a, density: 1, "
                                 "shapes: []}\n"),
              testing::ElementsAre(testing::HasSubstr("expected one shape at least")));
}

TEST(SceneKeys, MassAndMotionAreRead) {
  const scene::Body body = read_scene_text(every_key()).bodies[0];
  EXPECT_EQ(body.name, "a");
  EXPECT_EQ(body.mass, 5);
  EXPECT_EQ(body.density, std::nullopt);
  EXPECT_EQ(body.center_of_mass, Eigen::Vector3d(1, 2, 3));
  ASSERT_TRUE(body.inertia.has_value());
  const scene::Inertia& i = *body.inertia;
  EXPECT_EQ(std::tuple(i.xx, i.yy, i.zz), std::tuple(2, 3, 4));
  EXPECT_EQ(std::tuple(i.xy, i.xz, i.yz), std::tuple(0.1, 0.2, 0.3));
  EXPECT_EQ(body.position, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(body.linear_velocity, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(body.angular_velocity, Eigen::Vector3d(-1, -2, -3));
  EXPECT_EQ(body.color, Eigen::Vector3d(0.1, 0.2, 0.3));
}

TEST(SceneKeys, GyradiiAreReadAsMomentsOfInertia) {
  const scene::Body body =
      read_scene_text(every_key(), {"bodies[0].inertia=null", "bodies[0].gyration=[1, 2, 2]"})
          .bodies[0];
  EXPECT_EQ(body.inertia, (scene::Inertia{.xx = 5, .yy = 20, .zz = 20}));
}

TEST(SceneKeys, OrientationsAreRead) {
  const scene::Scene scene = read_scene_text(every_key());
  // R = Rz(yaw) Ry(pitch) Rx(roll), written out: x goes to (cos p cos y, cos p sin y, -sin p).
  const double p = 20 * kDegree, y = 30 * kDegree, r = 10 * kDegree;
  const Eigen::Matrix3d R = scene.bodies[0].orientation.toRotationMatrix();
  const Eigen::Vector3d x(std::cos(p) * std::cos(y), std::cos(p) * std::sin(y), -std::sin(p));
  EXPECT_LE((R.col(0) - x).norm(), kRoundOff);
  EXPECT_NEAR(R(2, 1), std::cos(p) * std::sin(r), kRoundOff);
  EXPECT_NEAR(R(2, 2), std::cos(p) * std::cos(r), kRoundOff);
  EXPECT_EQ(scene.bodies[1].orientation.coeffs(), Eigen::Vector4d(0, 0, 1, 0));  // x, y, z, w
  const Eigen::Quaterniond turned(std::cos(y / 2), 0, 0, std::sin(y / 2));
  EXPECT_LE((scene.bodies[2].orientation.coeffs() - turned.coeffs()).norm(), kRoundOff);
}

TEST(SceneKeys, StartIsReadAndGivenByDefault) {
  const scene::Scene scene = read_scene_text(
      every_key(), {"bodies[c].start=equilibrium", "bodies[c].heel={roll_deg: 10, pitch_deg: -5}"});
  EXPECT_EQ(scene.bodies[0].start, scene::Start::given);
  EXPECT_EQ(scene.bodies[1].start, scene::Start::given);
  EXPECT_EQ(scene.bodies[2].start, scene::Start::equilibrium);
  EXPECT_NEAR(scene.bodies[2].heel.roll, 10 * M_PI / 180, kRoundOff);
  EXPECT_NEAR(scene.bodies[2].heel.pitch, -5 * M_PI / 180, kRoundOff);
}

TEST(SceneKeys, HydroOfABodyOverridesTheScenesKeyByKey) {
  const scene::Scene scene = read_scene_text(every_key());
  using Law = hydro::ViscousDrag::Law;
  const hydro::Coefficients& own = scene.bodies[0].hydro;
  EXPECT_EQ(std::tuple(own.buoyancy, own.pressure_drag, own.lift),
            std::tuple(false, hydro::PressureDrag{0.75, 0.5, 0.25}, 1));
  EXPECT_EQ(own.viscous_drag, (hydro::ViscousDrag{.law = Law::ittc57, .length = 3}));
  EXPECT_EQ(scene.bodies[0].hydro.wave_tolerance, 0);
  EXPECT_EQ(scene.bodies[1].hydro.wave_tolerance, 2e-3);
  const scene::Radiation& radiation = scene.bodies[0].hydro.radiation;
  EXPECT_EQ(radiation.source, scene::Radiation::Source::file);
  EXPECT_EQ(radiation.pose, scene::Radiation::Pose::start);
  EXPECT_EQ(radiation.database.file.filename(), "shore.obj");
  EXPECT_EQ(radiation.database.body, "2");
  EXPECT_EQ(radiation.database.reference_point, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(radiation.database.center_of_mass, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(radiation.database.heading, M_PI / 2);
  EXPECT_EQ(radiation.database.length, 7);
  EXPECT_EQ(radiation.database.frequencies, (std::array<double, 2>{0.5, 2}));
  EXPECT_EQ(scene.bodies[1].hydro.radiation.source, scene::Radiation::Source::none);
  EXPECT_EQ(scene.bodies[0].hydro.resistance.source, scene::Resistance::Source::file);
  EXPECT_EQ(scene.bodies[0].hydro.resistance.file.filename(), "shore.obj");
  EXPECT_EQ(scene.bodies[1].hydro.resistance.source, scene::Resistance::Source::michell);
  const hydro::Coefficients& mixed = scene.bodies[1].hydro;
  EXPECT_EQ(std::tuple(mixed.buoyancy, mixed.pressure_drag, mixed.lift),
            std::tuple(true, hydro::PressureDrag{0.5, 0.5, 0}, 0));
  EXPECT_EQ(mixed.viscous_drag, (hydro::ViscousDrag{.law = Law::ittc57, .length = 7}));
  for (const auto& [text, law, coefficient] :
       {std::tuple("false", Law::none, 0.0), std::tuple("thesis", Law::thesis, 0.0),
        std::tuple("0.125", Law::constant, 0.125)}) {
    const hydro::ViscousDrag drag =
        read_scene_text(every_key(), {std::string("bodies[2].hydro={viscous_drag: ") + text + "}"})
            .bodies[2]
            .hydro.viscous_drag;
    EXPECT_EQ(std::tuple(drag.law, drag.coefficient), std::tuple(law, coefficient));
  }
}

TEST(SceneKeys, APresetIsWhereTheOtherCoefficientsStartFrom) {
  const auto drag = [](const std::string& hydro) {
    return read_scene_text(
               "plimsoll: 1\nduration: 1\nwater: {}\nhydro: {preset: thesis}\nbodies: "
               "[{name: a, box: {size: [1, 1, 1]}, density: 1, hydro: " +
               hydro + "}]\n")
        .bodies[0]
        .hydro.pressure_drag;
  };
  EXPECT_EQ(drag("{}"), (hydro::PressureDrag{0.6316, 0.6316, 0}));
  EXPECT_EQ(drag("{pressure_drag: {back: 0.1}}"), (hydro::PressureDrag{0.6316, 0.1, 0}));
  EXPECT_EQ(drag("{pressure_drag: {blunt: 0.2}}"), (hydro::PressureDrag{0.6316, 0.6316, 0.2}));
  EXPECT_EQ(drag("{preset: fitted}"), hydro::PressureDrag{});
  EXPECT_EQ(drag("{pressure_drag: false}"), (hydro::PressureDrag{0, 0, 0}));
  EXPECT_EQ(drag("{pressure_drag: 0.5}"), (hydro::PressureDrag{0.5, 0.5, 0}));
}

TEST(SceneKeys, AddedMassIsReadAsOneKey) {
  using Model = scene::AddedMass::Model;
  const scene::Scene scene = read_scene_text(every_key());
  const scene::AddedMass& given = scene.bodies[0].hydro.added_mass;
  EXPECT_EQ(given.model, Model::matrix);
  EXPECT_EQ(given.matrix.diagonal(), (hydro::Vector6d{6, 5, 4, 3, 2, 1}));
  EXPECT_EQ(given.matrix(1, 5), 1);
  EXPECT_EQ(given.matrix(0, 1), 0);
  EXPECT_EQ(scene.bodies[1].hydro.added_mass.model, Model::deep);
  EXPECT_EQ(scene.bodies[1].hydro.added_mass.tolerance, 2e-3);
  const auto read = [](const std::string& value) {
    return read_scene_text(every_key(), {"bodies[1].hydro.added_mass=" + value})
        .bodies[1]
        .hydro.added_mass;
  };
  EXPECT_EQ(read("none").model, Model::none);
  EXPECT_EQ(read("{model: none}").model, Model::none);
  EXPECT_EQ(read("{model: surface}").model, Model::surface);
  EXPECT_EQ(read("deep").tolerance, 1e-3);
  EXPECT_EQ(read("{}").model, Model::deep);
  EXPECT_EQ(read(zero_matrix()).model, Model::matrix);
}

TEST(SceneKeys, LocksAndCollisionsAreRead) {
  const scene::Scene scene = read_scene_text(every_key());
  EXPECT_EQ(scene.bodies[0].locked, (std::array{true, false, false, false, false, true}));
  EXPECT_EQ(scene.bodies[1].locked, (std::array{true, true, true, true, true, true}));
  EXPECT_EQ(scene.bodies[2].locked, (std::array<bool, 6>{}));
  std::vector<scene::Collision> collisions;
  for (const scene::Body& body : scene.bodies) collisions.push_back(body.collision);
  using enum scene::Collision;
  EXPECT_THAT(collisions, testing::ElementsAre(sphere, automatic, none, box, automatic, mesh));
}

TEST(SceneKeys, PumpsAreRead) {
  const auto pumps = read_scene_text(every_key()).bodies[0].pumps;
  ASSERT_EQ(pumps.size(), 2);
  EXPECT_EQ(pumps[0].name, "q");
  EXPECT_EQ(pumps[0].from, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(pumps[0].to, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(pumps[0].rate, 0.5);
  EXPECT_EQ(pumps[0].head, 8);
  EXPECT_EQ(pumps[1].to, std::nullopt);
  EXPECT_EQ(pumps[1].head, std::nullopt);
}

TEST(SceneKeys, AppliedLoadsAreRead) {
  const auto loads = read_scene_text(every_key()).bodies[0].forces;
  ASSERT_EQ(loads.size(), 2);
  EXPECT_EQ(loads[0].force, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(loads[0].torque, Eigen::Vector3d(4, 5, 6));
  EXPECT_TRUE(loads[0].in_body_frame);
  EXPECT_EQ(loads[0].at, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(std::tuple(loads[0].start, loads[0].end), std::tuple(1, 2));
  ASSERT_TRUE(loads[0].sine.has_value());
  EXPECT_EQ(loads[0].sine->frequency, 0.5);
  EXPECT_NEAR(loads[0].sine->phase, 90 * kDegree, kRoundOff);
  EXPECT_FALSE(loads[1].in_body_frame);
  EXPECT_EQ(loads[1].at, std::nullopt);
  EXPECT_EQ(loads[1].end, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(loads[1].sine.has_value());
}

TEST(SceneKeys, JointsAreRead) {
  const auto joints = read_scene_text(every_key()).joints;
  ASSERT_EQ(joints.size(), 2);
  EXPECT_EQ(joints[0].name, "j");
  EXPECT_EQ(joints[0].type, scene::Joint::Type::universal);
  EXPECT_EQ(joints[0].bodies, (std::array<std::string, 2>{"a", "b"}));
  EXPECT_EQ(joints[0].anchor, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(joints[0].axis, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(joints[0].axis2, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(joints[1].name, "joint1");
  EXPECT_EQ(joints[1].bodies[1], "world");
  EXPECT_EQ(joints[1].axis2, std::nullopt);
}

TEST(SceneKeys, NamesAreOfLettersOfAnyScriptSpacesAndSigns) {
  const std::vector<std::string> names = {"Blåhaj the 鯊", "a/b %é", "mast 2.0", "a[0]",
                                          "it's; <b>"};
  std::string text = "plimsoll: 1\nduration: 1\nbodies:\n";
  for (const std::string& name : names)
    text += "  - {name: \"" + name + "\", box: {size: [1, 1, 1]}, density: 5}\n";
  text += "joints:\n";
  for (const std::string& name : names)
    text += "  - {name: \"" + name + "\", type: ball, bodies: [\"" + name +
            "\", world], anchor: [0, 0, 0]}\n";
  const scene::Scene scene = read_scene_text(text);
  ASSERT_EQ(scene.joints.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(scene.bodies[i].name, names[i]);
    EXPECT_EQ(scene.joints[i].name, names[i]);
  }
}

TEST(SceneKeys, FrictionAndRestitutionAreRead) {
  const scene::Scene scene = read_scene_text(every_key());
  EXPECT_EQ(scene.ground_friction, 0.25);
  EXPECT_EQ(scene.ground_restitution, 0.125);
  ASSERT_TRUE(scene.suction);
  EXPECT_EQ(scene.suction->pressure, 2e4);
  EXPECT_EQ(scene.suction->time, 30);
  EXPECT_EQ(scene.bodies[0].friction, 0.75);
  EXPECT_EQ(scene.bodies[0].restitution, 0.5);
  EXPECT_EQ(scene.bodies[1].friction, 0.5);
  EXPECT_EQ(scene.bodies[1].restitution, 0);
  ASSERT_EQ(scene.contacts.size(), 2);
  EXPECT_EQ(scene.contacts[0].bodies, (std::array<std::string, 2>{"a", "world"}));
  EXPECT_EQ(scene.contacts[0].friction, 0);
  EXPECT_EQ(scene.contacts[0].restitution, std::nullopt);
  EXPECT_EQ(scene.contacts[1].bodies, (std::array<std::string, 2>{"d", "a"}));
  EXPECT_EQ(scene.contacts[1].friction, 2);
  EXPECT_EQ(scene.contacts[1].restitution, 1);
}

TEST(SceneKeys, RenderIsRead) {
  const auto render = read_scene_text(every_key()).render;
  ASSERT_TRUE(render.has_value());
  EXPECT_EQ(render->size, (std::array{320, 16}));
  EXPECT_EQ(render->every, 0.25);
  EXPECT_EQ(render->camera.from, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(render->camera.to, Eigen::Vector3d(4, 5, 6));
  EXPECT_NEAR(render->camera.field_of_view, 90 * kDegree, kRoundOff);
  EXPECT_EQ(render->camera.follow, "b");
  EXPECT_NEAR(render->camera.orbit, -12 * kDegree, kRoundOff);
  EXPECT_EQ(render->sheet_columns, 5);
  EXPECT_EQ(render->pressure_min.pressure, -100);
  EXPECT_EQ(render->pressure_max.pressure, 5e3);
  EXPECT_EQ(render->shows, scene::ShownPressure::dynamic);
  EXPECT_EQ(render->colors, scene::Colors::coolwarm);
  EXPECT_TRUE(render->show.forces && render->show.wireframe && render->show.joints);
  EXPECT_FALSE(render->show.centres || render->show.waterline);
  EXPECT_FALSE(render->overlay || render->grid);
  EXPECT_TRUE(render->pressure_shown);
}

TEST(SceneKeys, PressureIsAScaleOrNone) {
  const std::string head = "plimsoll: 1\nduration: 0\nrender: {pressure: ";
  EXPECT_FALSE(read_scene_text(head + "none}\n").render->pressure_shown);
  const auto shown = read_scene_text(head + "{max: 5}}\n").render;
  EXPECT_TRUE(shown->pressure_shown && shown->overlay && shown->grid);
  EXPECT_THAT(support::faults_of(head + "no}\n"),
              testing::ElementsAre("3:20: render.pressure: found no, expected none, or a map"));
}

TEST(SceneKeys, DynamicPressureHasALowerEndThatIsFound) {
  const std::string head = "plimsoll: 1\nduration: 0\nrender: {pressure: {";
  EXPECT_EQ(read_scene_text(head + "shows: dynamic}}\n").render->pressure_min.found,
            scene::ScaleEnd::Found::scene);
  EXPECT_EQ(read_scene_text(head + "shows: hydrostatic}}\n").render->pressure_min.found,
            scene::ScaleEnd::Found::given);
  EXPECT_EQ(read_scene_text(head + "min: auto}}\n").render->pressure_min.found,
            scene::ScaleEnd::Found::scene);
  EXPECT_EQ(read_scene_text("plimsoll: 1\nduration: 0\nrender: {}\n").render->pressure_min.found,
            scene::ScaleEnd::Found::given);
}

TEST(SceneKeys, CamerasAreReadInTheirOrder) {
  const auto render = read_scene_text(every_key(), kCameras).render;
  ASSERT_EQ(render->cameras.size(), 2);
  EXPECT_EQ(render->cameras[0].name, "stern");
  EXPECT_FALSE(render->cameras[0].from || render->cameras[0].to);
  EXPECT_EQ(render->cameras[1].name, "NAME");
  EXPECT_EQ(render->cameras[1].from, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(render->cameras[1].follow, "a");
  const auto more = read_scene_text(every_key(), {"render.camera=null", "render.cameras.a.orbit=1",
                                                  "render.cameras.B-2_.to=[1, 1, 1]"})
                        .render;
  ASSERT_EQ(more->cameras.size(), 2);
  EXPECT_EQ(more->cameras[1].name, "B-2_");
}

TEST(SceneKeys, CamerasMayBeAList) {
  const auto render = read_scene_text(every_key(), kListedCameras).render;
  ASSERT_EQ(render->cameras.size(), 2);
  EXPECT_EQ(render->cameras[0].name, "stern");
  EXPECT_EQ(render->cameras[0].follow, "a");
  EXPECT_EQ(render->cameras[1].name, "deck");
  EXPECT_EQ(render->cameras[1].on, "b");
  EXPECT_EQ(render->cameras[1].to, Eigen::Vector3d(10, 0, 2));
}

TEST(SceneKeys, CamerasOfAListHaveNamesAndBodiesOfTheScene) {
  const auto faults = [](const std::string& cameras) {
    return support::faults_of("plimsoll: 1\nduration: 0\nrender: {cameras: [" + cameras + "]}\n");
  };
  EXPECT_THAT(
      faults("{name: a}, {name: A}, {name: b c}, {}"),
      testing::ElementsAre(
          testing::HasSubstr("render.cameras[1].name: differs from a in case alone, expected"),
          testing::HasSubstr("render.cameras[2].name: found the name b c, expected 1 to 64"),
          testing::HasSubstr("render.cameras[3].name: missing, expected a text, unique among the "
                             "cameras")));
  EXPECT_THAT(faults("{name: a, on: hull, from: [0, 0, 1]}"),
              testing::ElementsAre(
                  testing::HasSubstr("render.cameras[0].to: missing, expected a point of the body"),
                  testing::HasSubstr("render.cameras[0].on: there is no body named hull")));
  EXPECT_THAT(faults("{name: a, on: hull, follow: hull, from: [0, 0, 1], to: [1, 0, 1]}"),
              testing::Contains(testing::HasSubstr("expected only one of on and follow")));
}

TEST(SceneKeys, WhatIsLeftOutHasItsDefault) {
  const scene::Scene scene = read_scene_text("plimsoll: 1\nduration: 0\n");
  EXPECT_EQ(scene.step, 1.0 / 60);
  EXPECT_EQ(scene.gravity, 9.80665);
  EXPECT_FALSE(scene.integrator.tolerance.has_value());
  EXPECT_FALSE(scene.water.has_value());
  EXPECT_TRUE(std::holds_alternative<std::monostate>(scene.ground));
  EXPECT_TRUE(scene.bodies.empty());
  EXPECT_FALSE(scene.log_every.has_value());
  EXPECT_FALSE(scene.log_forces);
  EXPECT_FALSE(scene.render.has_value());
  const scene::Scene wet = read_scene_text(support::kSmallScene, {"water={}", "log.every=0"});
  EXPECT_EQ(wet.water->density, 1000);
  EXPECT_EQ(wet.water->depth, std::nullopt);
  EXPECT_EQ(wet.water->kinematics, hydro::Kinematics::airy);
  EXPECT_EQ(wet.water->ramp, 0);
  EXPECT_TRUE(std::holds_alternative<scene::Flat>(wet.water->surface));
  EXPECT_FALSE(wet.log_every.has_value());
  EXPECT_EQ(wet.bodies[0].hydro.pressure_drag, (hydro::PressureDrag{0.71, 0.30, 0.30}));
  EXPECT_EQ(wet.bodies[0].hydro.viscous_drag.law, hydro::ViscousDrag::Law::ittc57);
  EXPECT_EQ(wet.bodies[0].hydro.lift, 0);
  EXPECT_EQ(wet.bodies[0].hydro.added_mass.model, scene::AddedMass::Model::automatic);
}

TEST(SceneKeys, AFilesPlaceIsRelativeToTheScene) {
  const auto file = support::write_scene("plimsoll: 1\nduration: 1\n");
  std::ofstream(file.parent_path() / "beside.obj") << "v 0 0 0\n";
  const scene::Scene scene = scene::read(file, {{"ground", "{mesh: {file: ./beside.obj}}"}});
  EXPECT_EQ(std::get<scene::Mesh>(scene.ground).file, file.parent_path() / "beside.obj");
}

/// `bodies[3].lock[0]` → `bodies[].lock`: as the list of keys has it.
std::string key_of(std::string path) {
  path = std::regex_replace(path, std::regex(R"(\[\d+\])"), "[]");
  path = std::regex_replace(path, std::regex(R"(\.cameras\.\w+)"), ".cameras.NAME");
  while (path.ends_with("[]")) path.resize(path.size() - 2);
  return path;
}

/// Lines, machines and controls with all their keys, in three scenes.
std::vector<std::string> rigs() {
  const std::string line = "stiffness: 1, damping: 1, breaks_at: 9, length: 5";
  const std::string inertia =
      " weight: 1, mass: 2, segments: 3,"
      " drag: {diameter: 0.1, coefficient: 1, along: 0.1, added_mass: 0.9}";
  const std::string ends = "bodies: [a, world], points: [[0, 0, 0], [0, 0, 5]]";
  const std::string foil =
      "body: a, at: [0, 0, 0], span: 1, chord: 1, axis: [0, 0, 1], chord_axis: [1, 0, 0],"
      " angle_deg: 1, aspect_ratio: 2, drag: 0.1, stall_deg: 20";
  const std::string table = "table: {angle_deg: [0, 90], lift: [0, 0], drag: [0, 1]}";
  const std::string file = support::data_folder().string() + "/commands.csv";
  const std::string screw =
      "body: a, at: [0, 0, 0], axis: [1, 0, 0], diameter: 1, speed_rps: 1,"
      " wake: 0.1, deduction: 0.1, rotative_efficiency: 1, reverse: 0.7,"
      " hand: left, azimuth_deg: 0, pivot: [0, 0, 1], inertia: 1";
  return {
      "springs=[{name: s, " + ends + ", " + line + "}]",
      "ropes=[{name: r, " + ends + ", " + line + ", rate: 0, shortest: 1," + inertia + "}]",
      "moorings=[{name: m, body: a, fairlead: [0, 0, 0], anchor: [9, 0, -10], length: 16,"
      " stiffness: 1e5, friction: 0.1, bottom: true, breaks_at: 1e9,"
      " model: dynamic," +
          inertia + "}]",
      "propellers=[{name: p, " + screw +
          ", model: {wageningen: {blades: 4, area_ratio: 0.7, pitch_ratio: 1}}}, {name: q, " +
          screw +
          ", model: {open_water: {advance: [0, 1], kt: [0.4, 0], kq: [0.05, 0.01],"
          " area_ratio: 0.6}}},"
          " {name: o, " +
          screw + ", model: {four_quadrant: {beta_deg: [-90, 90], ct: [1, -1], cq: [0.1, -0.1]}}}]",
      "rudders=[{name: h, " + foil +
          ", law: fujii, behind: p}, {name: g, body: a, at: [0, 0, 0],"
          " span: 1, chord: 1, law: table, " +
          table + "}]",
      "sails=[{name: i, " + foil +
          ", law: fujii}, {name: j, body: a, at: [0, 0, 0],"
          " span: 1, chord: 1, law: table, " +
          table + "}]",
      "controls=[{set: \"springs[s].length\", formula: t, start: 1, rate: 2},"
      " {set: \"ropes[r].rate\", file: " +
          file +
          ", column: value, interpolation: step},"
          " {set: \"rudders[h].angle_deg\", pid: {of: a.speed, target: 1, kp: 1, ki: 1, kd: 1,"
          " limits: [-1, 1]}},"
          " {set: \"propellers[p].speed_rps\", relay: {of: a.x, low: 1, high: 2, values: [1, 2]}}]",
      "bodies[0].forces=[{force: [1, 0, 0], torque: [0, 0, 1], frame: body, at: [0, 0, 0],"
      " start: 0, end: 1, formula: t}, {force: [1, 0, 0], factor: 2}, {force: [1, 0, 0], file: " +
          file + ", column: value, interpolation: linear}]"};
}

TEST(SceneKeys, InertiaOfLinesIsRead) {
  const scene::Scene scene = read_scene_text(every_key(), rigs());
  const scene::Rope& rope = scene.ropes[0];
  const scene::Mooring& mooring = scene.moorings[0];
  EXPECT_EQ(rope.weight, 1);
  for (const auto& [inertia, drag] :
       {std::pair(rope.inertia, rope.drag), std::pair(mooring.inertia, mooring.drag)}) {
    ASSERT_TRUE(inertia);
    EXPECT_EQ(inertia->segments, 3);
    EXPECT_EQ(inertia->mass, 2);
    EXPECT_EQ(drag.diameter, 0.1);
    EXPECT_EQ(drag.coefficient, 1);
    EXPECT_EQ(drag.along, 0.1);
    EXPECT_EQ(drag.added_mass, 0.9);
  }
}

TEST(SceneKeys, MooringsAreAListOrAFileOfMoorDyn) {
  const std::string file = support::data_folder().string() + "/shore.obj";
  const scene::Scene scene =
      read_scene_text(every_key(), {"moorings={moordyn: " + file + ", bodies: [b, a]}"});
  EXPECT_TRUE(scene.moorings.empty());
  ASSERT_TRUE(scene.moordyn.has_value());
  EXPECT_EQ(scene.moordyn->file, file);
  EXPECT_EQ(scene.moordyn->bodies, (std::vector<std::string>{"b", "a"}));
  EXPECT_FALSE(read_scene_text(every_key(), rigs()).moordyn.has_value());
}

/// Joints whose drives have all keys.
std::string drives() {
  const std::string all = ", stiffness: 1, damping: 1, friction: 1, ";
  return "joints=[{type: hinge, bodies: [a, world], anchor: [0, 0, 0], axis: [1, 0, 0]" + all +
         "limits_deg: [-1, 1], rest_deg: 0, motor: {angle_deg: 0, max_torque: 1, rate: 2}},"
         " {type: hinge, bodies: [a, world], anchor: [0, 0, 0], axis: [1, 0, 0],"
         " motor: {torque: 1}},"
         " {type: slider, bodies: [a, world], axis: [1, 0, 0]" +
         all +
         "limits: [-1, 1], rest: 0, motor: {position: 0, max_force: 1}},"
         " {type: slider, bodies: [a, world], axis: [1, 0, 0], motor: {speed: 1}},"
         " {type: slider, bodies: [a, world], axis: [1, 0, 0], motor: {force: 1}}]";
}

TEST(SceneKeys, EveryKeyThatIsListedIsReadAndHasAPlace) {
  std::set<std::string> met;
  for (const std::vector<std::string>& overrides : std::vector<std::vector<std::string>>{
           {},
           {kSpectrum, "hydro.pressure_drag={front: 1, back: 2, blunt: 0.4}"},
           {"water.surface={flat: {}}", kTable, picture("ground")},
           {"water.surface={spectrum: {type: file, file: " + support::data_folder().string() +
            "/spectrum.csv}}"},
           {"water.surface={elevation: {file: " + support::data_folder().string() +
            "/elevation.csv, at: [1, 2], heading_deg: 90, start: 0.5, lowest_frequency_hz: 0.25,"
            " highest_frequency_hz: 3, components: 5}}"},
           {"hydro.added_mass=" + zero_matrix(), "bodies[0].hydro.added_mass={model: none}"},
           {"bodies[0].hydro.added_mass={tolerance: 1}"},
           {"bodies[0].inertia=null", "bodies[0].gyration=[1, 2, 2]"},
           {"hydro.resistance={file: " + support::data_folder().string() + "/shore.obj}",
            "bodies[0].hydro.resistance={wave: michell}"},
           {"bodies[c].start=equilibrium", "bodies[c].heel={roll_deg: 1, pitch_deg: 2}"},
           {"hydro.radiation={file: " + support::data_folder().string() +
            "/shore.obj, body: tug, reference_point: [0, 0, 1], center_of_mass: [0, 1, 0],"
            " heading_deg: 1, length: 2, frequencies: [1, 2], pose: equilibrium}"},
           kCameras,
           kListedCameras,
           {"render.camera={on: a, from: [0, 0, 3], to: [1, 0, 3]}"},
           {"render.camera=null", "render.cameras={NAME: {on: a, from: [0, 0, 3], to: [1, 0, 3]}}"},
           rigs(),
           {"moorings={moordyn: " + support::data_folder().string() +
            "/shore.obj, bodies: [a, b]}"},
           {drives()},
           {shapes()},
           {picture("water.surface"), shore()}})
    for (const auto& [path, place] : read_scene_text(every_key(), overrides).places)
      if (!path.empty()) met.insert(key_of(path));
  std::set<std::string> listed;
  for (const scene::KeyDescription& key : scene::key_catalogue().keys) listed.insert(key.path);
  // A scene that has been read has none of these any more.
  std::erase_if(listed, [](const std::string& key) {
    return key == "include" || key.starts_with("variables") || key.starts_with("bodies[].repeat");
  });
  for (const std::string& key : listed) EXPECT_TRUE(met.contains(key)) << key;
  for (const std::string& key : met) EXPECT_TRUE(listed.contains(key)) << key;
}

std::string document(const std::string& name) {
  std::ifstream stream(std::filesystem::path(PLIMSOLL_SOURCE_DIR) / "scenes" / name);
  std::stringstream page;
  page << stream.rdbuf();
  return page.str();
}

TEST(SceneKeys, TheExamplesOfTheDocumentsAreRight) {
  const std::string page = document("README.md") + document("KEYS.md");
  const std::regex block("```yaml\n([^`]*)```");
  int examples = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), block), end; it != end; ++it) {
    const std::string example =
        std::regex_replace((*it)[1].str(), std::regex("file: meshes/"),
                           "file: " + std::string(PLIMSOLL_SOURCE_DIR) + "/scenes/meshes/");
    const std::string head = example.starts_with("plimsoll") ? "" : "plimsoll: 1\nduration: 1\n";
    EXPECT_EQ(support::faults_of(head + example), std::vector<std::string>{}) << example;
    ++examples;
  }
  EXPECT_GE(examples, 25);
}

TEST(SceneKeys, EveryKeyHasAMeaningAndAShape) {
  std::set<std::string> described;
  for (const scene::KeyDescription& key : scene::key_catalogue().keys) {
    EXPECT_NO_THROW(scene::key_meaning(key.path)) << key.path;
    EXPECT_FALSE(key.shapes.empty()) << key.path;
    described.insert(scene::described_path(key.path));
  }
  const std::vector<std::string> meanings = scene::described_paths();
  EXPECT_THAT(meanings, testing::UnorderedElementsAreArray(described));
}

TEST(SceneKeys, TheReferencePageHasTheTablesOfAllKeys) {
  const std::string page = document("KEYS.md");
  const std::string tables = scene::key_tables();
  const std::string end = ": end -->\n";
  std::size_t begin = 0;
  for (std::size_t stop; (stop = tables.find(end, begin)) != std::string::npos;
       begin = stop + end.size()) {
    const std::string table = tables.substr(begin, stop + end.size() - begin);
    EXPECT_NE(page.find(table), std::string::npos) << "tools/scene_keys writes to scenes/KEYS.md:\n"
                                                   << table;
  }
  EXPECT_EQ(begin, tables.size());
}

}  // namespace

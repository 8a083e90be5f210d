#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "app/assembly/build.h"
#include "app/fmu/fmi3.h"
#include "app/scene/reader.h"
#include "engine/simulation.h"
#include "tests/app/fmu/units.h"

namespace {

using support::Importer;
using support::kTow;
using support::linked_functions;
using support::packed_unit;
using support::UnitFolder;
using testing::HasSubstr;
using testing::IsEmpty;

/// The scene as a simulation of the engine, without what a unit has around it.
engine::Simulation plain_simulation(const UnitFolder& unit) {
  const scene::Scene scene = scene::read(unit.folder / "tow.yaml");
  assembly::AddedMassStore store(std::nullopt);
  return engine::Simulation(assembly::build(scene, store).spec);
}

/// Every number of bodies, lines and set points is the same bit for bit.
void expect_same(const Importer& unit, const engine::Simulation& simulation) {
  EXPECT_EQ(unit.get("time"), simulation.time());
  for (std::size_t i = 0; i < simulation.states().size(); ++i) {
    const hydro::BodyState& state = simulation.states()[i];
    const std::string body = simulation.spec().bodies[i].name + ".";
    const auto expect_vector = [&](const std::string& name, const Eigen::Vector3d& vector) {
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(unit.get(body + name + "xyz"[k]), vector[k]) << body + name;
    };
    expect_vector("", state.position);
    expect_vector("q", state.orientation.vec());
    expect_vector("v", state.linear_velocity);
    expect_vector("w", state.angular_velocity);
    EXPECT_EQ(unit.get(body + "qw"), state.orientation.w());
  }
  const engine::RigReadings rig = simulation.rig();
  EXPECT_EQ(unit.get("ropes[tow].tension"), rig.lines.at(0).tension);
  EXPECT_EQ(unit.get("propellers[main].thrust"), rig.propellers.at(0).thrust);
}

TEST(Unit, IsTheSimulationOfTheSceneToTheLastBit) {
  const UnitFolder folder = packed_unit(kTow);
  Importer unit(linked_functions(), folder.description, folder.resources);
  unit.initialize(true);
  engine::Simulation simulation = plain_simulation(folder);
  expect_same(unit, simulation);
  for (int i = 0; i < 40; ++i) {
    unit.step(1, 0.04);
    simulation.step();
    simulation.step();
  }
  expect_same(unit, simulation);
  // The control of the scene has turned the rudder, and the value of each input is its own.
  EXPECT_GT(std::abs(unit.get("rudders[rudder].angle_deg.reading")), 1);
  EXPECT_TRUE(std::isnan(unit.get("rudders[rudder].angle_deg")));
  EXPECT_GT(unit.get("probes[imu].specific_z"), 5);
}

TEST(Unit, TakesSetPointsAndLoads) {
  const UnitFolder folder = packed_unit(kTow);
  Importer unit(linked_functions(), folder.description, folder.resources);
  unit.initialize();
  engine::Simulation simulation = plain_simulation(folder);
  unit.set("propellers[main].speed_rps", 3);
  unit.set("rudders[rudder].angle_deg", 12.5);
  unit.set("barge.force_y", 4e4);
  unit.set("barge.torque_z", -1e5);
  simulation.set("propellers[main].speed_rps", 3);
  simulation.set("rudders[rudder].angle_deg", 12.5);
  for (int i = 0; i < 20; ++i) {
    simulation.apply(1, {.force = {0, 4e4, 0}, .moment = {0, 0, -1e5}});
    simulation.step();
  }
  unit.step(20, 0.02);
  expect_same(unit, simulation);
  EXPECT_EQ(unit.get("barge.force_y"), 4e4);

  // The scene's control has its rudder again, and the load ends.
  unit.set("rudders[rudder].angle_deg", std::numeric_limits<double>::quiet_NaN());
  unit.set("barge.force_y", 0);
  unit.set("barge.torque_z", 0);
  simulation.release("rudders[rudder].angle_deg");
  for (int i = 0; i < 20; ++i) simulation.step();
  unit.step(1, 0.4);
  expect_same(unit, simulation);
}

TEST(Unit, GivesTheSameAgainAfterAReset) {
  const UnitFolder folder = packed_unit(kTow);
  Importer unit(linked_functions(), folder.description, folder.resources);
  unit.initialize();
  unit.step(25, 0.02);
  const std::vector<double> first = unit.outputs();
  unit.set("tug.force_x", 1e6);
  unit.set("rudders[rudder].angle_deg", 30);
  unit.step(10, 0.02);
  unit.reset();
  unit.initialize();
  EXPECT_EQ(unit.get("tug.force_x"), 0);
  unit.step(25, 0.02);
  EXPECT_THAT(unit.outputs(), testing::ContainerEq(first));
}

TEST(Unit, GoesOnFromAStateToTheSameBits) {
  const UnitFolder folder = packed_unit(kTow);
  Importer unit(linked_functions(), folder.description, folder.resources);
  unit.initialize();
  unit.set("tug.force_y", 2e4);
  unit.set("propellers[main].speed_rps", 1);
  unit.step(10, 0.02);
  fmi3FMUState state = nullptr;
  ASSERT_EQ(fmi3GetFMUState(unit.instance(), &state), fmi3OK) << unit.said();
  std::size_t size = 0;
  ASSERT_EQ(fmi3SerializedFMUStateSize(unit.instance(), state, &size), fmi3OK);
  std::vector<fmi3Byte> bytes(size);
  ASSERT_EQ(fmi3SerializeFMUState(unit.instance(), state, bytes.data(), size), fmi3OK);
  EXPECT_EQ(fmi3SerializeFMUState(unit.instance(), state, bytes.data(), size - 1), fmi3Error);
  EXPECT_THAT(unit.said(), HasSubstr("fmi3SerializeFMUState: found an array of"));

  const auto ten_more = [&](Importer& one) {
    double time = 0.2, last = 0;
    bool flags[3];
    EXPECT_EQ(fmi3DoStep(one.instance(), time, 0.2, true, flags, flags + 1, flags + 2, &last),
              fmi3OK)
        << one.said();
    return one.outputs();
  };
  const std::vector<double> later = ten_more(unit);
  ASSERT_EQ(fmi3SetFMUState(unit.instance(), state), fmi3OK) << unit.said();
  EXPECT_EQ(unit.get("tug.force_y"), 2e4);
  EXPECT_THAT(ten_more(unit), testing::ContainerEq(later));
  EXPECT_EQ(fmi3FreeFMUState(unit.instance(), &state), fmi3OK);
  EXPECT_EQ(state, nullptr);

  Importer other(linked_functions(), folder.description, folder.resources);
  ASSERT_EQ(fmi3DeserializeFMUState(other.instance(), bytes.data(), size, &state), fmi3OK);
  ASSERT_EQ(fmi3SetFMUState(other.instance(), state), fmi3OK) << other.said();
  EXPECT_THAT(ten_more(other), testing::ContainerEq(later));
  EXPECT_EQ(fmi3FreeFMUState(other.instance(), &state), fmi3OK);

  ASSERT_EQ(fmi3DeserializeFMUState(other.instance(), bytes.data(), size / 2, &state), fmi3OK);
  EXPECT_EQ(fmi3SetFMUState(other.instance(), state), fmi3Error);
  EXPECT_THAT(other.said(), HasSubstr("fmi3SetFMUState: "));
  EXPECT_EQ(fmi3FreeFMUState(other.instance(), &state), fmi3OK);
}

TEST(Unit, RefusesStepsThatAreNoStepsOfTheScene) {
  const UnitFolder folder = packed_unit(kTow);
  Importer unit(linked_functions(), folder.description, folder.resources);
  unit.initialize();
  unit.step(3, 0.02);
  for (const double size : {0.03, 0.0, -0.02, 0.0201, 1e9 * std::nan("")}) {
    EXPECT_EQ(unit.do_step(size), fmi3Error) << size;
    EXPECT_THAT(unit.said(), HasSubstr("is no whole multiple of the step of the scene, 0.02 s"));
  }
  bool flags[3];
  double last = 0;
  EXPECT_EQ(fmi3DoStep(unit.instance(), 0.5, 0.02, true, flags, flags + 1, flags + 2, &last),
            fmi3Error);
  EXPECT_THAT(unit.said(), HasSubstr("found the communication point 0.5 s, expected the time"));
  // It goes on as if nothing had been asked, also by steps with rounded digits.
  unit.step(1, 0.06000000001);
  engine::Simulation simulation = plain_simulation(folder);
  for (int i = 0; i < 6; ++i) simulation.step();
  expect_same(unit, simulation);
}

TEST(Unit, TellsOfAWrongCallAndGoesOn) {
  const UnitFolder folder = packed_unit(kTow);
  Importer unit(linked_functions(), folder.description, folder.resources);
  const fmi3Instance it = unit.instance();
  const fmi3ValueReference unknown = 100000, output = unit.reference("tug.x"),
                           force = unit.reference("tug.force_x");
  double value = 1;
  const auto fault = [&](fmi3Status status) {
    EXPECT_EQ(status, fmi3Error);
    return unit.said();
  };
  EXPECT_THAT(fault(fmi3GetFloat64(it, &output, 1, &value, 1)),
              HasSubstr("fmi3GetFloat64: the unit is instantiated, expected one in step mode"));
  EXPECT_THAT(fault(unit.do_step(0.02)), HasSubstr("fmi3DoStep: the unit is instantiated"));
  EXPECT_THAT(fault(fmi3EnterInitializationMode(it, false, 0, 5, false, 0)),
              HasSubstr("found the start time 5 s, expected 0"));
  unit.initialize();
  EXPECT_THAT(fault(fmi3EnterInitializationMode(it, false, 0, 0, false, 0)),
              HasSubstr("the unit is in step mode, expected one instantiated"));
  EXPECT_THAT(fault(fmi3GetFloat64(it, &unknown, 1, &value, 1)),
              HasSubstr("there is no variable of value reference 100000"));
  EXPECT_THAT(fault(fmi3SetFloat64(it, &output, 1, &value, 1)), HasSubstr("is no input"));
  EXPECT_THAT(fault(fmi3SetFloat64(it, &unknown, 1, &value, 1)), HasSubstr("is no input"));
  EXPECT_THAT(fault(fmi3GetFloat64(it, &output, 1, &value, 2)),
              HasSubstr("found an array of 2 values, expected one for each of 1 variables"));
  value = std::numeric_limits<double>::infinity();
  EXPECT_THAT(fault(fmi3SetFloat64(it, &force, 1, &value, 1)),
              HasSubstr("the value of 'tug.force_x' is not finite"));
  EXPECT_EQ(unit.get("tug.force_x"), 0);
  EXPECT_EQ(fmi3GetFloat64(nullptr, &output, 1, &value, 1), fmi3Error);
  unit.step(2, 0.02);
  EXPECT_EQ(fmi3Terminate(it), fmi3OK);
  EXPECT_THAT(fault(unit.do_step(0.02)), HasSubstr("fmi3DoStep: the unit is terminated"));
  EXPECT_NE(unit.get("tug.x"), 0);
}

TEST(Unit, TellsWhySimulationStopsAndCanBeReset) {
  const UnitFolder folder = packed_unit(kTow);
  Importer unit(linked_functions(), folder.description, folder.resources);
  unit.initialize();
  unit.step(2, 0.02);
  unit.set("tug.force_x", 1e300);
  EXPECT_EQ(unit.do_step(0.4), fmi3Error);
  EXPECT_THAT(unit.said(),
              testing::AllOf(HasSubstr("error logStatusError: fmi3DoStep: "), HasSubstr("tug")));
  EXPECT_EQ(unit.do_step(0.02), fmi3Error);
  EXPECT_THAT(unit.said(), HasSubstr("the unit is stopped by an error"));
  unit.reset();
  unit.initialize();
  unit.step(2, 0.02);
}

TEST(Unit, NeedsItsTokenAndItsResources) {
  const UnitFolder folder = packed_unit(kTow);
  const auto refused = [](const std::string& token, const std::filesystem::path& resources,
                          bool events) {
    std::string said;
    const auto keep = [](fmi3InstanceEnvironment environment, fmi3Status, fmi3String,
                         fmi3String message) {
      *static_cast<std::string*>(environment) += message;
    };
    EXPECT_EQ(fmi3InstantiateCoSimulation("unit", token.c_str(), resources.c_str(), false, false,
                                          events, false, nullptr, 0, &said, keep, nullptr),
              nullptr);
    return said;
  };
  EXPECT_THAT(refused("another", folder.resources, false),
              HasSubstr("fmi3InstantiateCoSimulation: found the instantiation token 'another'"));
  EXPECT_THAT(refused(folder.description.token, folder.folder / "nowhere", false),
              HasSubstr("the resources of the unit are missing there"));
  EXPECT_THAT(refused(folder.description.token, folder.resources, true),
              HasSubstr("has no event mode"));
  std::filesystem::remove(folder.resources / "scene.yaml");
  EXPECT_THAT(refused(folder.description.token, folder.resources, false), HasSubstr("scene.yaml"));
  // Without a callback it stays silent.
  EXPECT_EQ(fmi3InstantiateCoSimulation("unit", "another", folder.resources.c_str(), false, false,
                                        false, false, nullptr, 0, nullptr, nullptr, nullptr),
            nullptr);
}

TEST(Unit, SaysWhatItDoesNotHave) {
  const UnitFolder folder = packed_unit(kTow);
  Importer unit(linked_functions(), folder.description, folder.resources);
  const fmi3Instance it = unit.instance();
  const auto expect_absent = [&](fmi3Status status, const std::string& function) {
    EXPECT_EQ(status, fmi3Error) << function;
    EXPECT_THAT(unit.said(), HasSubstr("error logStatusError: " + function + ": "));
  };
  fmi3Int32 number = 0;
  fmi3Clock clock = false;
  const fmi3ValueReference variable = 1;
  expect_absent(fmi3GetInt32(it, &variable, 1, &number, 1), "fmi3GetInt32");
  expect_absent(fmi3SetInt32(it, &variable, 1, &number, 1), "fmi3SetInt32");
  expect_absent(fmi3GetClock(it, &variable, 1, &clock), "fmi3GetClock");
  expect_absent(fmi3EnterEventMode(it), "fmi3EnterEventMode");
  expect_absent(fmi3EnterStepMode(it), "fmi3EnterStepMode");
  expect_absent(fmi3EnterConfigurationMode(it), "fmi3EnterConfigurationMode");
  expect_absent(fmi3SetTime(it, 1), "fmi3SetTime");
  expect_absent(fmi3ActivateModelPartition(it, 1, 0), "fmi3ActivateModelPartition");
  expect_absent(fmi3GetDirectionalDerivative(it, nullptr, 0, nullptr, 0, nullptr, 0, nullptr, 0),
                "fmi3GetDirectionalDerivative");
  EXPECT_EQ(fmi3InstantiateModelExchange("unit", "", "", false, false, nullptr, nullptr), nullptr);
  EXPECT_STREQ(fmi3GetVersion(), "3.0");
}

TEST(Unit, GivesNotesWhereLoggingIsOn) {
  // A wave that would break, of which checks of scenes warn.
  std::string scene = kTow;
  const std::string wave = "amplitude: 0.2";
  scene.replace(scene.find(wave), wave.size(), "amplitude: 2");
  const UnitFolder folder = packed_unit(scene);
  Importer quiet(linked_functions(), folder.description, folder.resources);
  EXPECT_THAT(quiet.said(), IsEmpty());
  Importer loud(linked_functions(), folder.description, folder.resources, true);
  EXPECT_THAT(loud.said(), HasSubstr("warning logStatusWarning: "));
  const char* const categories[] = {"logStatusError", "logNothing"};
  EXPECT_EQ(fmi3SetDebugLogging(loud.instance(), false, 2, categories), fmi3Error);
  EXPECT_THAT(loud.said(), HasSubstr("there is no category 'logNothing'"));
  EXPECT_EQ(fmi3SetDebugLogging(loud.instance(), true, 0, nullptr), fmi3OK);
}

TEST(Unit, MayBeSteppedByAnotherThreadThanItsMaker) {
  const UnitFolder folder = packed_unit(R"(plimsoll: 1
duration: 1
step: 0.01
ground: {z: 0}
bodies:
  - {name: ball, icosphere: {radius: 0.5, subdivisions: 1}, density: 500, position: [0, 0, 0.6]}
  - {name: crate, box: {size: [1, 1, 1]}, density: 500, position: [0.2, 0, 1.8]}
)");
  Importer one(linked_functions(), folder.description, folder.resources);
  Importer other(linked_functions(), folder.description, folder.resources);
  one.initialize();
  one.step(100, 0.01);
  std::thread([&] {
    other.initialize();
    other.step(100, 0.01);
  }).join();
  EXPECT_THAT(other.outputs(), testing::ContainerEq(one.outputs()));
  EXPECT_LT(one.get("crate.z"), 1.7);
}

TEST(Unit, InstancesRunInThreadsOfTheirOwn) {
  const UnitFolder folder = packed_unit(kTow);
  std::vector<double> seen[2];
  const auto run = [&](std::vector<double>& outputs) {
    Importer unit(linked_functions(), folder.description, folder.resources);
    unit.initialize();
    unit.step(30, 0.02);
    outputs = unit.outputs();
  };
  std::thread first(run, std::ref(seen[0])), second(run, std::ref(seen[1]));
  first.join();
  second.join();
  EXPECT_FALSE(seen[0].empty());
  EXPECT_THAT(seen[0], testing::ContainerEq(seen[1]));
}

}  // namespace

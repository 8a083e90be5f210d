#include "app/fmu/model_description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/app/fmu/units.h"
#include "tests/app/fmu/xml_elements.h"

namespace {

using support::described;
using support::kTow;
using support::packed_unit;
using support::UnitFolder;
using support::XmlElement;

std::vector<XmlElement> elements_of(const std::string& xml, const std::string& name) {
  std::vector<XmlElement> found;
  for (const XmlElement& element : support::xml_elements(xml))
    if (element.name == name) found.push_back(element);
  return found;
}

TEST(ModelDescription, HasEachVariableOnceWithItsUnit) {
  const UnitFolder unit = packed_unit(kTow);
  std::set<std::string> units, used;
  for (const XmlElement& element : elements_of(unit.xml, "Unit"))
    units.insert(element.attributes.at("name"));
  std::set<fmi3ValueReference> references, outputs;
  for (const auto& [name, variable] : unit.description.variables) {
    EXPECT_TRUE(references.insert(variable.reference).second) << name;
    used.insert(variable.unit);
    if (variable.causality == "output") outputs.insert(variable.reference);
    EXPECT_EQ(variable.causality == "input", !variable.start.empty()) << name;
  }
  EXPECT_EQ(units, used);
  for (const char* list : {"Output", "InitialUnknown"}) {
    std::set<fmi3ValueReference> listed;
    for (const XmlElement& element : elements_of(unit.xml, list))
      listed.insert(
          static_cast<fmi3ValueReference>(std::stoul(element.attributes.at("valueReference"))));
    EXPECT_EQ(listed, outputs) << list;
  }
}

TEST(ModelDescription, NamesWhatIsSetAndRead) {
  const UnitFolder unit = packed_unit(kTow);
  const auto& all = unit.description.variables;
  const auto expect = [&](const std::string& name, const std::string& causality,
                          const std::string& units, const std::string& start) {
    ASSERT_TRUE(all.contains(name)) << name;
    EXPECT_EQ(all.at(name).causality, causality) << name;
    EXPECT_EQ(all.at(name).unit, units) << name;
    EXPECT_EQ(all.at(name).start, start) << name;
  };
  expect("time", "independent", "s", "");
  expect("propellers[main].speed_rps", "input", "1/s", "2");
  expect("rudders[rudder].angle_deg", "input", "deg", "NaN");
  expect("rudders[rudder].angle_deg.reading", "output", "deg", "");
  expect("ropes[tow].rate", "input", "m/s", "0");
  expect("tug.force_x", "input", "N", "0");
  expect("barge.torque_z", "input", "N m", "0");
  expect("tug.heading_deg", "output", "deg", "");
  expect("tug.turn_rate_deg", "output", "deg/s", "");
  expect("barge.vx", "output", "m/s", "");
  expect("barge.wz", "output", "rad/s", "");
  expect("barge.qw", "output", "1", "");
  expect("ropes[tow].tension", "output", "N", "");
  expect("probes[imu].specific_z", "output", "m/s^2", "");
  expect("probes[gauge].elevation", "output", "m", "");
  EXPECT_FALSE(all.contains("pier.force_x"));  // Nothing moves it.
  EXPECT_NEAR(std::stod(all.at("rudders[skeg].angle_deg").start), 20, 1e-12);
}

TEST(ModelDescription, NamesTheFlowOfAPumpInItsUnit) {
  const UnitFolder unit = packed_unit(
      "plimsoll: 1\nduration: 1\nwater: {}\nhydro: {added_mass: none, radiation: none}\n"
      "bodies:\n  - {name: bucket, mesh: {file: " PLIMSOLL_SOURCE_DIR
      "/scenes/meshes/bucket.obj}, mass: 12, pumps: [{name: p, from: [0, 0, 0.1], rate: 0.25}]}\n");
  const auto& pump = unit.description.variables.at("pumps[p].rate");
  EXPECT_EQ(pump.causality, "input");
  EXPECT_EQ(pump.unit, "m^3/s");
  EXPECT_EQ(pump.start, "0.25");
}

TEST(ModelDescription, TellsTheStepAndTheDuration) {
  const UnitFolder unit = packed_unit(kTow);
  const XmlElement root = support::xml_elements(unit.xml).front();
  EXPECT_EQ(root.attributes.at("fmiVersion"), "3.0");
  EXPECT_EQ(root.attributes.at("modelName"), "tow");
  EXPECT_EQ(root.attributes.at("description"), "A tug & \"her\" <barge>");
  const XmlElement experiment = elements_of(unit.xml, "DefaultExperiment").at(0);
  EXPECT_EQ(experiment.attributes.at("stopTime"), "2");
  EXPECT_EQ(experiment.attributes.at("stepSize"), "0.02");
  const XmlElement co_simulation = elements_of(unit.xml, "CoSimulation").at(0);
  EXPECT_EQ(co_simulation.attributes.at("modelIdentifier"), "tow");
  EXPECT_EQ(co_simulation.attributes.at("fixedInternalStepSize"), "0.02");
  EXPECT_EQ(co_simulation.attributes.at("canHandleVariableCommunicationStepSize"), "false");
}

TEST(ModelDescription, KnowsTheUnitsOfJointsByTheirKind) {
  const UnitFolder unit = packed_unit(R"(plimsoll: 1
duration: 0
water: {}
hydro: {added_mass: none, radiation: none}
bodies:
  - {name: arm, box: {size: [1, 1, 1]}, density: 500}
  - {name: sled, box: {size: [1, 1, 1]}, density: 500, position: [5, 0, 0]}
joints:
  - {name: hinge, type: hinge, bodies: [world, arm], anchor: [1, 0, 0], axis: [0, 1, 0],
     motor: {speed: 0.5, max_torque: 100}}
  - {name: rail, type: slider, bodies: [world, sled], axis: [1, 0, 0],
     motor: {position: 0.5, max_force: 1000}}
)",
                                      "2 odd-names.yaml");
  const auto& all = unit.description.variables;
  EXPECT_EQ(unit.description.identifier, "_2_odd_names");
  EXPECT_EQ(all.at("joints[hinge].angle_deg").unit, "deg");
  EXPECT_EQ(all.at("joints[hinge].coordinate").unit, "rad");
  EXPECT_EQ(all.at("joints[hinge].effort").unit, "N m");
  EXPECT_EQ(all.at("joints[hinge].motor.speed").unit, "rad/s");
  EXPECT_EQ(all.at("joints[rail].position").unit, "m");
  EXPECT_EQ(all.at("joints[rail].speed").unit, "m/s");
  EXPECT_EQ(all.at("joints[rail].effort").unit, "N");
  EXPECT_EQ(all.at("joints[rail].motor.position").unit, "m");
  EXPECT_EQ(all.at("joints[rail].motor.position").start, "0.5");
  // A scene without a duration has no end.
  EXPECT_FALSE(elements_of(unit.xml, "DefaultExperiment").at(0).attributes.contains("stopTime"));
}

}  // namespace

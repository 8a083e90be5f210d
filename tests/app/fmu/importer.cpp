#include "tests/app/fmu/importer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "tests/app/fmu/xml_elements.h"

namespace support {
namespace {

void keep_message(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                  fmi3String message) {
  auto& said = *static_cast<std::string*>(environment);
  said += std::string(status >= fmi3Error ? "error" : "warning") + " " + category + ": " + message;
  said += '\n';
}

}  // namespace

UnitFunctions linked_functions() {
  return {.instantiate = fmi3InstantiateCoSimulation,
          .free_instance = fmi3FreeInstance,
          .enter_initialization = fmi3EnterInitializationMode,
          .exit_initialization = fmi3ExitInitializationMode,
          .set = fmi3SetFloat64,
          .get = fmi3GetFloat64,
          .do_step = fmi3DoStep,
          .terminate = fmi3Terminate,
          .reset = fmi3Reset};
}

Description described(const std::string& xml) {
  Description description;
  for (const XmlElement& element : xml_elements(xml)) {
    const auto value = [&](const std::string& key) {
      const auto found = element.attributes.find(key);
      return found == element.attributes.end() ? "" : found->second;
    };
    if (element.name == "fmiModelDescription") description.token = value("instantiationToken");
    if (element.name == "CoSimulation") {
      description.identifier = value("modelIdentifier");
      description.step = std::stod(value("fixedInternalStepSize"));
    }
    if (element.name != "Float64") continue;
    const DescribedVariable variable{
        .reference = static_cast<fmi3ValueReference>(std::stoul(value("valueReference"))),
        .causality = value("causality"),
        .unit = value("unit"),
        .start = value("start")};
    if (!description.variables.emplace(value("name"), variable).second)
      throw std::runtime_error(value("name") + " is there twice");
  }
  return description;
}

Importer::Importer(UnitFunctions functions, Description description,
                   const std::filesystem::path& resources, bool logging)
    : functions_(functions),
      description_(std::move(description)),
      instance_(functions_.instantiate("unit", description_.token.c_str(),
                                       (resources.string() + "/").c_str(), false, logging, false,
                                       false, nullptr, 0, &said_, keep_message, nullptr)) {
  EXPECT_NE(instance_, nullptr) << said_;
}

Importer::~Importer() { functions_.free_instance(instance_); }

std::string Importer::said() { return std::exchange(said_, ""); }

void Importer::initialize(bool with_start_values) {
  EXPECT_EQ(functions_.enter_initialization(instance_, false, 0, 0, false, 0), fmi3OK) << said_;
  if (with_start_values)
    for (const auto& [name, variable] : description_.variables)
      if (variable.causality == "input") set(name, std::strtod(variable.start.c_str(), nullptr));
  EXPECT_EQ(functions_.exit_initialization(instance_), fmi3OK) << said_;
  time_ = 0;
}

void Importer::set(const std::string& name, double value) {
  const fmi3ValueReference variable = reference(name);
  EXPECT_EQ(functions_.set(instance_, &variable, 1, &value, 1), fmi3OK) << name << said_;
}

double Importer::get(const std::string& name) const {
  const fmi3ValueReference variable = reference(name);
  double value = 0;
  EXPECT_EQ(functions_.get(instance_, &variable, 1, &value, 1), fmi3OK) << name << said_;
  return value;
}

std::vector<double> Importer::outputs() const {
  std::vector<double> values;
  for (const auto& [name, variable] : description_.variables)
    if (variable.causality == "output") values.push_back(get(name));
  return values;
}

fmi3Status Importer::do_step(double size) {
  bool event = true, terminate = true, early = true;
  double last = -1;
  const fmi3Status status =
      functions_.do_step(instance_, time_, size, true, &event, &terminate, &early, &last);
  EXPECT_FALSE(event || terminate || early);
  if (status != fmi3OK) return status;
  time_ += size;
  EXPECT_NEAR(last, time_, 1e-9);
  return status;
}

void Importer::step(int count, double size) {
  for (int i = 0; i < count; ++i) ASSERT_EQ(do_step(size), fmi3OK) << said_;
}

void Importer::reset() {
  EXPECT_EQ(functions_.reset(instance_), fmi3OK) << said_;
  time_ = 0;
}

}  // namespace support

#include "app/fmu/model_description.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string_view>

#include "app/base/quoting.h"
#include "app/fmu/instance.h"

namespace fmu {
namespace {

/// A unit of measurement by its base units.
struct Measure {
  std::string_view name;
  std::string_view base;  ///< Exponents of base units, as attributes.
  double factor = 1;      ///< Size in base units.
};

constexpr std::array<Measure, 13> kMeasures = {
    {{"1", ""},
     {"s", R"(s="1")"},
     {"1/s", R"(s="-1")"},
     {"m", R"(m="1")"},
     {"m/s", R"(m="1" s="-1")"},
     {"m/s^2", R"(m="1" s="-2")"},
     {"m^3/s", R"(m="3" s="-1")"},
     {"rad", R"(rad="1")"},
     {"rad/s", R"(rad="1" s="-1")"},
     {"deg", R"(rad="1")", std::numbers::pi / 180},
     {"deg/s", R"(rad="1" s="-1")", std::numbers::pi / 180},
     {"N", R"(kg="1" m="1" s="-2")"},
     {"N m", R"(kg="1" m="2" s="-2")"}}};

/// Returns a number that reads back to the same bits, as XML Schema writes it.
std::string number(double value) { return std::isnan(value) ? "NaN" : fmt::format("{}", value); }

std::string unit_definitions(const Interface& interface) {
  std::set<std::string_view> used = {"s"};
  for (const auto* variables : {&interface.inputs(), &interface.outputs()})
    for (const Variable& variable : *variables) used.insert(variable.units);
  std::string text = "  <UnitDefinitions>\n";
  for (const std::string_view name : used) {
    const auto measure = std::ranges::find(kMeasures, name, &Measure::name);
    if (measure == kMeasures.end())
      throw std::logic_error("no base units are known of the unit " + std::string(name));
    std::string base(measure->base);
    if (measure->factor != 1) base += fmt::format(" factor=\"{}\"", number(measure->factor));
    text += fmt::format("    <Unit name=\"{}\"><BaseUnit{}{}/></Unit>\n", name,
                        base.empty() ? "" : " ", base);
  }
  return text + "  </UnitDefinitions>\n";
}

std::string variable_text(const Variable& variable, ValueReference reference, bool input) {
  std::string more;
  if (input) more += fmt::format(" start=\"{}\"", number(variable.start));
  if (!variable.description.empty())
    more += fmt::format(" description=\"{}\"", app::xml_text(variable.description));
  return fmt::format(
      "    <Float64 name=\"{}\" valueReference=\"{}\" causality=\"{}\" unit=\"{}\"{}/>\n",
      app::xml_text(variable.name), reference, input ? "input" : "output", variable.units, more);
}

std::string model_variables(const Interface& interface) {
  std::string text = fmt::format(
      "  <ModelVariables>\n"
      "    <Float64 name=\"time\" valueReference=\"{}\" causality=\"independent\" unit=\"s\"/>\n",
      kTime);
  ValueReference reference = interface.first_input();
  for (const Variable& input : interface.inputs()) text += variable_text(input, reference++, true);
  for (const Variable& output : interface.outputs())
    text += variable_text(output, reference++, false);
  return text + "  </ModelVariables>\n";
}

/// Lists the outputs, all of which are known after the initialization and may depend on all inputs.
std::string model_structure(const Interface& interface) {
  std::string text = "  <ModelStructure>\n";
  for (const char* element : {"Output", "InitialUnknown"})
    for (std::size_t i = 0; i < interface.outputs().size(); ++i)
      text +=
          fmt::format("    <{} valueReference=\"{}\"/>\n", element, interface.first_output() + i);
  return text + "  </ModelStructure>\n";
}

std::string co_simulation(const scene::Scene& scene) {
  return fmt::format(
      "  <CoSimulation modelIdentifier=\"{}\" canHandleVariableCommunicationStepSize=\"false\" "
      "fixedInternalStepSize=\"{}\" canGetAndSetFMUState=\"true\" "
      "canSerializeFMUState=\"true\"/>\n",
      model_identifier(scene), number(scene.step));
}

std::string log_categories() {
  return fmt::format(
      "  <LogCategories>\n"
      "    <Category name=\"{}\" description=\"calls that failed\"/>\n"
      "    <Category name=\"{}\" description=\"notes and warnings on the scene\"/>\n"
      "  </LogCategories>\n",
      kErrors, kWarnings);
}

std::string default_experiment(const scene::Scene& scene) {
  const std::string stop =
      scene.duration > 0 ? fmt::format(" stopTime=\"{}\"", number(scene.duration)) : "";
  return fmt::format("  <DefaultExperiment startTime=\"0\"{} stepSize=\"{}\"/>\n", stop,
                     number(scene.step));
}

}  // namespace

std::string model_identifier(const scene::Scene& scene) {
  std::string name = scene.file.stem().string();
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 ||
        static_cast<unsigned char>(letter) > 127)
      letter = '_';
  const bool begins = !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0;
  return begins ? name : "_" + name;
}

std::string model_description(const scene::Scene& scene, const Interface& interface,
                              const std::string& token) {
  const std::string description =
      scene.title.empty() ? "" : fmt::format(" description=\"{}\"", app::xml_text(scene.title));
  return fmt::format(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\" instantiationToken=\"{}\"{} "
             "generationTool=\"Plimsoll {}\" variableNamingConvention=\"flat\">\n",
             app::xml_text(scene.file.stem().string()), app::xml_text(token), description,
             PLIMSOLL_VERSION) +
         co_simulation(scene) + unit_definitions(interface) + log_categories() +
         default_experiment(scene) + model_variables(interface) + model_structure(interface) +
         "</fmiModelDescription>\n";
}

}  // namespace fmu

#include "app/fmu/unit.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "app/assembly/build.h"
#include "app/base/checked_file.h"
#include "app/fmu/unit_files.h"
#include "app/scene/reader.h"

namespace fmu {
namespace {

// The first bytes of a saved state, which change with its layout: the mode and the number of inputs
// follow, then their values, then the state of the simulation.
constexpr std::string_view kHead = "plimsoll unit 1\n";

/// Parts of a step by which a communication step may miss whole steps, as by its decimals; a larger
/// one would let times drift apart.
constexpr double kSizeSlack = 1e-6;
/// Parts of a step by which the importer's time may differ from the unit's, by the sum of what
/// kSizeSlack allows.
constexpr double kTimeSlack = 0.01;

constexpr const char* kModes[] = {"instantiated", "in initialization mode", "in step mode",
                                  "terminated", "stopped by an error"};

engine::SimulationSpec spec_of(const LoadedScene& loaded) {
  engine::SimulationSpec spec = loaded.built.spec;
  spec.record_work = false;
  return spec;
}

std::vector<double> start_values(const Interface& interface) {
  std::vector<double> values;
  for (const Variable& input : interface.inputs()) values.push_back(input.start);
  return values;
}

}  // namespace

LoadedScene load_scene(const std::filesystem::path& resources, app::Reporter& reporter) {
  // Whoever exported the scene has chosen the formats of its meshes.
  scene::Scene scene = scene::read(resources / kSceneFile, {}, scene::MeshFormats::any);
  assembly::AddedMassStore store(resources / kSolutions);
  assembly::BuiltScene built = assembly::build_on_threads(1, scene, store, reporter);
  for (const std::string& warning : built.warnings) reporter.warning(warning);
  return {std::move(scene), std::move(built)};
}

std::string token_of(const std::filesystem::path& resources) {
  std::ifstream file(resources / kTokenFile);
  std::string token;
  if (!std::getline(file, token))
    throw std::runtime_error((resources / kTokenFile).string() +
                             ": the resources of the unit are missing there");
  return token;
}

Unit::Unit(LoadedScene loaded)
    : loaded_(std::move(loaded)),
      motions_(1, loaded_.scene.bodies.size()),
      simulation_(spec_of(loaded_), motions_.all(),
                  {loaded_.scene.probes, loaded_.built.centers_of_mass}),
      interface_(loaded_.scene, simulation_),
      inputs_(start_values(interface_)) {}

void Unit::expect(Mode mode) const {
  if (mode_ != mode)
    throw std::logic_error(fmt::format("the unit is {}, expected one {}",
                                       kModes[static_cast<int>(mode_)],
                                       kModes[static_cast<int>(mode)]));
}

void Unit::enter_initialization(double start) {
  expect(Mode::instantiated);
  if (start != 0)
    throw std::invalid_argument(
        fmt::format("found the start time {} s, expected 0, where every scene starts", start));
  mode_ = Mode::initialization;
}

void Unit::exit_initialization() {
  expect(Mode::initialization);
  mode_ = Mode::step;
}

void Unit::terminate() {
  expect(Mode::step);
  mode_ = Mode::terminated;
}

void Unit::reset() {
  simulation_.reset();
  inputs_ = start_values(interface_);
  outputs_.reset();
  mode_ = Mode::instantiated;
}

void Unit::set(ValueReference variable, double value) {
  if (mode_ == Mode::terminated || mode_ == Mode::failed) expect(Mode::step);
  const ValueReference first = interface_.first_input();
  if (variable < first || variable >= interface_.first_output())
    throw std::invalid_argument(
        fmt::format("the variable of value reference {} is no input", variable));
  const std::size_t input = variable - first;
  const double before = std::exchange(inputs_[input], value);
  try {
    interface_.apply(input, inputs_, simulation_);
  } catch (...) {
    inputs_[input] = before;
    throw;
  }
  outputs_.reset();
}

double Unit::get(ValueReference variable) const {
  if (mode_ == Mode::instantiated) expect(Mode::step);
  if (variable == kTime) return time();
  if (variable < interface_.first_output()) return inputs_[variable - interface_.first_input()];
  const std::size_t output = variable - interface_.first_output();
  if (output >= interface_.outputs().size())
    throw std::invalid_argument(
        fmt::format("there is no variable of value reference {}", variable));
  if (!outputs_) outputs_ = interface_.read(simulation_);
  return (*outputs_)[output];
}

void Unit::do_step(double point, double size) {
  expect(Mode::step);
  const double step = loaded_.scene.step;
  if (!(std::abs(point - time()) <= kTimeSlack * step))
    throw std::invalid_argument(fmt::format(
        "found the communication point {} s, expected the time of the unit, {} s", point, time()));
  const double count = std::round(size / step);
  if (!(count >= 1 && std::abs(size - count * step) <= kSizeSlack * step))
    throw std::invalid_argument(fmt::format(
        "the communication step {0} s is no whole multiple of the step of the scene, {1} s; a unit "
        "that is exported with --set step={0} has it",
        size, step));
  outputs_.reset();
  try {
    for (double n = 0; n < count; ++n) simulation_.step();
  } catch (...) {
    mode_ = Mode::failed;
    throw;
  }
}

std::string Unit::save() const {
  std::string bytes(kHead);
  app::append(bytes, static_cast<std::uint64_t>(mode_));
  app::append(bytes, static_cast<std::uint64_t>(inputs_.size()));
  app::append(bytes, inputs_.data(), inputs_.size());
  return bytes + simulation_.save();
}

void Unit::restore(std::string_view bytes) {
  if (!bytes.starts_with(kHead))
    throw std::invalid_argument("these are not the bytes of a state of this version");
  bytes.remove_prefix(kHead.size());
  const auto mode = app::take<std::uint64_t>(bytes);
  if (mode > static_cast<std::uint64_t>(Mode::failed) ||
      app::take<std::uint64_t>(bytes) != inputs_.size())
    throw std::invalid_argument("the state is that of another scene");
  std::vector<double> inputs;
  for (std::size_t i = 0; i < inputs_.size(); ++i) inputs.push_back(app::take<double>(bytes));
  simulation_.load(bytes);
  inputs_ = std::move(inputs);
  mode_ = static_cast<Mode>(mode);
  outputs_.reset();
}

}  // namespace fmu

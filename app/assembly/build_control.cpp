#include "app/assembly/build_control.h"

#include <fmt/format.h>

#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "app/assembly/signals.h"

namespace assembly {
namespace {

using Quantity = engine::Measurement::Quantity;

/// A quantity of a body or joint, and SI units per unit of its name.
struct QuantityUnit {
  Quantity quantity;
  double unit = 1;
};

QuantityUnit quantity_of(const scene::Measurable& found) {
  constexpr double degree = std::numbers::pi / 180;
  if (found.of == scene::Measurable::Of::joint) {
    if (found.quantity == "speed") return {Quantity::joint_speed};
    return {Quantity::joint, found.quantity == "angle_deg" ? degree : 1};
  }
  if (found.of != scene::Measurable::Of::body)
    return {found.quantity == "tension" ? Quantity::tension : Quantity::line_length};
  static const std::map<std::string, QuantityUnit> kOfBody = {
      {"x", {Quantity::x}},
      {"y", {Quantity::y}},
      {"z", {Quantity::z}},
      {"depth", {Quantity::depth}},
      {"speed", {Quantity::speed}},
      {"sway", {Quantity::sway}},
      {"heading_deg", {Quantity::heading, degree}},
      {"pitch_deg", {Quantity::pitch, degree}},
      {"roll_deg", {Quantity::roll, degree}},
      {"turn_rate_deg", {Quantity::turn_rate, degree}}};
  return kOfBody.at(found.quantity);
}

/// Index of a line in the specification, which has springs before ropes before moorings.
std::size_t index_in_spec(const scene::Scene& scene, const scene::Measurable& found) {
  switch (found.of) {
    case scene::Measurable::Of::rope:
      return scene.springs.size() + found.index;
    case scene::Measurable::Of::mooring:
      return scene.springs.size() + scene.ropes.size() + found.index;
    default:
      return found.index;
  }
}

/// Adds controls to one specification.
class ControlBuilder {
 public:
  ControlBuilder(engine::SimulationSpec& spec, BuildLog& log)
      : spec_(spec), log_(log), quantities_(scene::measurable(log.scene)) {}

  void all() {
    for (std::size_t i = 0; i < log_.scene.controls.size(); ++i)
      add(log_.scene.controls[i], fmt::format("controls[{}]", i));
    for (std::size_t i = 0; i < log_.scene.bodies.size(); ++i)
      for (std::size_t k = 0; k < log_.scene.bodies[i].forces.size(); ++k)
        add_load(log_.scene.bodies[i].forces[k], i, k);
  }

 private:
  engine::SetPointId id_of(const std::string& name) const {
    std::size_t i = 0;
    while (i < spec_.set_points.size() && spec_.set_points[i].name != name) ++i;
    return static_cast<engine::SetPointId>(i);
  }

  std::shared_ptr<const engine::Signal> signal_in(const scene::CommandFile& file,
                                                  const std::string& path) {
    try {
      return read_signal(file);
    } catch (const scene::InputError& error) {
      for (const scene::Fault& fault : error.faults())
        log_.faults.add(
            fault.place.line > 0
                ? fault
                : scene::Fault{scene::place_of(log_.scene.places, path), path,
                               fmt::format("{} {}", file.file.filename().string(), fault.message)});
      return table_signal({0}, {0}, scene::Interpolation::linear);
    }
  }

  /// Sets the measurement and unit of a controller.
  template <class Controller>
  void measure(const std::string& name, Controller& controller) const {
    const NamedMeasurement found =
        measurement_of(log_.scene, *scene::find_named(quantities_, name));
    controller.of = found.of;
    controller.unit = found.unit;
  }

  engine::Pid built(const scene::PidControl& control) const {
    engine::Pid pid{.target = formula_signal(control.target),
                    .kp = control.kp,
                    .ki = control.ki,
                    .kd = control.kd};
    measure(control.of, pid);
    if (control.limits) {
      pid.least = (*control.limits)[0];
      pid.greatest = (*control.limits)[1];
    }
    return pid;
  }

  engine::Relay built(const scene::RelayControl& control) const {
    engine::Relay relay{.low = control.low, .high = control.high, .values = control.values};
    measure(control.of, relay);
    return relay;
  }

  void add(const scene::Control& control, const std::string& path) {
    engine::ControlSpec spec{
        .set = id_of(control.set), .start = control.start, .rate = control.rate};
    if (const auto* file = std::get_if<scene::CommandFile>(&control.source))
      spec.source = signal_in(*file, path + ".file");
    if (const auto* formula = std::get_if<std::string>(&control.source))
      spec.source = formula_signal(*formula);
    if (const auto* pid = std::get_if<scene::PidControl>(&control.source))
      spec.source = built(*pid);
    if (const auto* relay = std::get_if<scene::RelayControl>(&control.source))
      spec.source = built(*relay);
    spec_.controls.push_back(std::move(spec));
  }

  void add_load(const scene::AppliedLoad& load, std::size_t body, std::size_t index) {
    if (!load.formula && !load.file) return;
    const std::string path = fmt::format("bodies[{}].forces[{}].file", body, index);
    spec_.controls.push_back(
        {.set = *spec_.bodies[body].loads[index].factor,
         .source = load.formula ? formula_signal(*load.formula) : signal_in(*load.file, path)});
  }

  engine::SimulationSpec& spec_;
  BuildLog& log_;
  const std::vector<scene::Measurable> quantities_;
};

}  // namespace

NamedMeasurement measurement_of(const scene::Scene& scene, const scene::Measurable& quantity) {
  const QuantityUnit found = quantity_of(quantity);
  return {.of = {.quantity = found.quantity, .index = index_in_spec(scene, quantity)},
          .unit = found.unit};
}

void add_controls(engine::SimulationSpec& spec, BuildLog& log) { ControlBuilder(spec, log).all(); }

}  // namespace assembly

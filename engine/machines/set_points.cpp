#include "engine/machines/set_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace engine {
namespace {

StepValue constant(double value) { return {value, value, value}; }

/// A signal over a step. A jump at the start of the step belongs to it in spite of round-off.
StepValue over_step(const Signal& signal, double time, double h) {
  if (signal.jumps()) return constant(signal.at(time + 1e-12 * (std::abs(time) + h)));
  return {signal.at(time), signal.at(time + h / 2), signal.at(time + h)};
}

bool is_angle(Measurement::Quantity quantity) {
  return quantity == Measurement::Quantity::heading || quantity == Measurement::Quantity::pitch ||
         quantity == Measurement::Quantity::roll;
}

/// The measured quantity, an angle as the one nearest to the last one.
double measured(const Measurement& of, SetPointState& state, const SetPoints::Measure& measure) {
  double now = measure(of);
  if (is_angle(of.quantity) && state.measured) {
    const double turns = std::round((*state.measured - now) / (2 * std::numbers::pi));
    now += turns * 2 * std::numbers::pi;
  }
  return now;
}

double output(const Pid& pid, SetPointState& state, double time, double h,
              const SetPoints::Measure& measure) {
  const double before = state.measured.value_or(std::nan(""));
  const double now = measured(pid.of, state, measure);
  state.measured = now;
  const double error = pid.target->at(time) - now / pid.unit;
  const double target_rate = (pid.target->at(time + h) - pid.target->at(time)) / h;
  const double rate = std::isnan(before) ? 0 : target_rate - (now - before) / (pid.unit * h);
  const double integral = state.integral + h * error;
  const double wanted = pid.kp * error + pid.ki * integral + pid.kd * rate;
  const double given = std::clamp(wanted, pid.least, pid.greatest);
  // The integral grows only while it can act, or shrinks the excess.
  if (given == wanted || (wanted - given) * pid.ki * error < 0) state.integral = integral;
  return given;
}

double output(const Relay& relay, SetPointState& state, const SetPoints::Measure& measure) {
  state.measured = measured(relay.of, state, measure);
  const double now = *state.measured / relay.unit;
  if (now > relay.high) state.beyond = true;
  if (now < relay.low) state.beyond = false;
  return relay.values[state.beyond ? 1 : 0];
}

/// The value kept within `limit` of the one before.
StepValue limited(const StepValue& value, double before, double limit) {
  if (std::abs(value.end - before) <= limit && std::abs(value.start - before) <= limit)
    return value;
  const double end = std::clamp(value.end, before - limit, before + limit);
  return {before, (before + end) / 2, end};
}

}  // namespace

SetPoints::SetPoints(const SimulationSpec& spec)
    : spec_(&spec), states_(spec.set_points.size()), control_of_(spec.set_points.size()) {
  for (std::size_t i = 0; i < states_.size(); ++i)
    states_[i].value = constant(spec.set_points[i].initial / spec.set_points[i].unit);
  for (std::size_t i = 0; i < spec.controls.size(); ++i) {
    const ControlSpec& control = spec.controls[i];
    control_of_.at(control.set) = i;
    const auto* signal = std::get_if<std::shared_ptr<const Signal>>(&control.source);
    if (signal && control.start <= 0) states_[control.set].value = constant((*signal)->at(0));
  }
}

StepValue SetPoints::controlled(const ControlSpec& control, SetPointState& state, double time,
                                double h, const Measure& measure) const {
  if (const auto* pid = std::get_if<Pid>(&control.source))
    return constant(output(*pid, state, time, h, measure));
  if (const auto* relay = std::get_if<Relay>(&control.source))
    return constant(output(*relay, state, measure));
  return over_step(*std::get<std::shared_ptr<const Signal>>(control.source), time, h);
}

void SetPoints::begin_step(double time, double h, const Measure& measure) {
  set_time(time, h);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    SetPointState& state = states_[i];
    const SetPointSpec& spec = spec_->set_points[i];
    const double before = state.value.end;
    const ControlSpec* control = control_of_[i] ? &spec_->controls[*control_of_[i]] : nullptr;
    StepValue value = constant(before);
    if (state.outside)
      value = constant(*state.outside);
    else if (control && time >= control->start - 1e-12 * (time + h))
      value = limited(controlled(*control, state, time, h, measure), before, control->rate * h);
    else if (!control)
      value = constant(spec.initial / spec.unit);
    const double least = spec.least / spec.unit, greatest = spec.greatest / spec.unit;
    for (double* v : {&value.start, &value.middle, &value.end})
      *v = std::clamp(*v, least, greatest);
    state.value = value;
  }
}

double SetPoints::fraction(double time) const { return std::clamp((time - start_) / h_, 0.0, 1.0); }

double SetPoints::value(SetPointId id, double time) const {
  return unit(id) * states_[id].value.at(fraction(time));
}

double SetPoints::rate(SetPointId id, double time) const {
  return unit(id) * states_[id].value.slope(fraction(time)) / h_;
}

double SetPoints::mean_within(SetPointId id, double limit) const {
  const StepValue& value = states_[id].value;
  const auto within = [&](double v) { return std::clamp(v * unit(id), -limit, limit); };
  return (within(value.start) + 4 * within(value.middle) + within(value.end)) / 6;
}

std::vector<double> SetPoints::readings() const {
  std::vector<double> values;
  for (const SetPointState& state : states_) values.push_back(state.value.end);
  return values;
}

SetPointId SetPoints::find(const std::string& name) const {
  const auto& known = spec_->set_points;
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.name == name; });
  if (found == known.end())
    throw std::invalid_argument(fmt::format("there is no set point '{}'", name));
  return static_cast<SetPointId>(found - known.begin());
}

}  // namespace engine

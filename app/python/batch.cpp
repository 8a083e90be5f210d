#include "app/python/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "app/python/threads.h"
#include "hydro/parallel.h"

namespace python {
namespace {

constexpr double kLeftToScene = std::numeric_limits<double>::quiet_NaN();

std::size_t bodies_of_first(const std::vector<BatchMember>& members) {
  if (members.empty()) throw std::invalid_argument("a batch needs at least one simulation");
  return members.front().spec.bodies.size();
}

template <class Named>
bool same_names(const std::vector<Named>& a, const std::vector<Named>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Named& x, const Named& y) { return x.name == y.name; });
}

/// Fills the part of an array that belongs to one simulation.
void fill_part(std::vector<double>& array, std::size_t part, std::size_t parts, double value) {
  const std::size_t length = array.size() / parts;
  std::fill_n(array.begin() + static_cast<std::ptrdiff_t>(part * length), length, value);
}

}  // namespace

Batch::Batch(std::vector<BatchMember> members, int threads, std::vector<std::string> observed)
    : motions_(members.size(), bodies_of_first(members)),
      simulations_(members.size()),
      observed_(std::move(observed)),
      observers_(members.size()),
      forces_(3 * members.size() * members.front().spec.bodies.size()),
      torques_(forces_.size()),
      controls_(members.size() * members.front().spec.set_points.size(), kLeftToScene),
      observations_(members.size() * observed_.size()),
      errors_(members.size()),
      threads_(shared_threads(threads)) {
  for (std::size_t i = 0; i < members.size(); ++i) accept(i, make(i, std::move(members[i])));
}

Batch::Made Batch::make(std::size_t place, BatchMember member) {
  if (simulations_.front() && (!same_names(member.spec.bodies, spec().bodies) ||
                               !same_names(member.spec.set_points, spec().set_points)))
    throw std::invalid_argument(
        fmt::format("simulation {} has other bodies or set points than simulation 0", place));
  // Simulations are stepped at once, so each needs but one thread.
  member.spec.threads = 1;
  Made made{.simulation = std::make_unique<app::HeldSimulation>(
                std::move(member.spec), motions_.rows(place), member.sensors)};
  if (!observed_.empty())
    made.observer = app::Observer(app::Observables(*member.scene, *made.simulation), observed_);
  return made;
}

void Batch::accept(std::size_t place, Made made) {
  simulations_[place] = std::move(made.simulation);
  observers_[place] = std::move(made.observer);
  simulations_[place]->show();
  observe(place);
}

void Batch::observe(std::size_t simulation) {
  const std::size_t count = observed_.size();
  if (count > 0)
    observers_[simulation].read(*simulations_[simulation], &observations_[simulation * count]);
}

void Batch::step(long count, const std::vector<std::size_t>& which) {
  for (std::size_t i = 0; i < forces_.size(); ++i)
    if (!std::isfinite(forces_[i]) || !std::isfinite(torques_[i]))
      throw std::invalid_argument(
          fmt::format("the load on body '{}' of simulation {} is not finite",
                      spec().bodies[i / 3 % bodies()].name, i / 3 / bodies()));
  for (std::size_t i = 0; i < controls_.size(); ++i)
    if (std::isinf(controls_[i]))
      throw std::invalid_argument(fmt::format("the value of '{}' of simulation {} is not finite",
                                              spec().set_points[i % spec().set_points.size()].name,
                                              i / spec().set_points.size()));
  threads_.execute([&] {
    if (which.empty())
      hydro::parallel_for(size(), [&](std::size_t i) { take_steps(i, count); });
    else
      hydro::parallel_for(which.size(), [&](std::size_t i) { take_steps(which[i], count); });
  });
}

void Batch::take_steps(std::size_t simulation, long count) {
  if (!errors_[simulation].empty()) return;
  app::HeldSimulation& one = *simulations_[simulation];
  try {
    hand_over_inputs(simulation);
    for (long n = 0; n < count; ++n) one.step();
  } catch (const std::exception& error) {
    errors_[simulation] = error.what();
  }
  one.show();
  observe(simulation);
}

void Batch::hand_over_inputs(std::size_t simulation) {
  app::HeldSimulation& one = *simulations_[simulation];
  for (std::size_t b = 0; b < bodies(); ++b) {
    const std::size_t row = 3 * (simulation * bodies() + b);
    using Row = Eigen::Map<const Eigen::Vector3d>;
    const hydro::Wrench wrench{.force = Row(&forces_[row]), .moment = Row(&torques_[row])};
    const auto body = static_cast<engine::BodyId>(b);
    if (wrench.force.isZero(0) && wrench.moment.isZero(0))
      one.let_go(body);
    else
      one.hold(body, {.wrench = wrench});
  }
  const std::size_t count = spec().set_points.size();
  for (std::size_t p = 0; p < count; ++p) {
    const double value = controls_[simulation * count + p];
    const auto set_point = static_cast<engine::SetPointId>(p);
    if (std::isnan(value))
      one.release(set_point);
    else
      one.set(set_point, value);
  }
}

void Batch::reset(std::size_t simulation) {
  simulations_.at(simulation)->reset();
  clear_inputs(simulation);
  observe(simulation);
}

void Batch::replace(const std::vector<std::size_t>& which, std::vector<BatchMember> members) {
  std::vector<Made> made;
  for (std::size_t i = 0; i < which.size(); ++i)
    made.push_back(make(which[i], std::move(members[i])));
  for (std::size_t i = 0; i < which.size(); ++i) {
    accept(which[i], std::move(made[i]));
    clear_inputs(which[i]);
  }
}

void Batch::clear_inputs(std::size_t simulation) {
  fill_part(forces_, simulation, size(), 0);
  fill_part(torques_, simulation, size(), 0);
  fill_part(controls_, simulation, size(), kLeftToScene);
  errors_[simulation].clear();
}

void Batch::set_motion(std::size_t simulation, engine::BodyId body, const hydro::BodyState& state) {
  simulations_.at(simulation)->set_motion(body, state);
  observe(simulation);
}

std::string Batch::save(std::size_t simulation) {
  app::HeldSimulation& one = *simulations_.at(simulation);
  hand_over_inputs(simulation);
  return one.save();
}

void Batch::load(std::size_t simulation, std::string_view bytes) {
  app::HeldSimulation& one = *simulations_.at(simulation);
  for (const auto& [body, load] : one.loads_in(bytes))
    if (load.frame != engine::Frame::world || !load.at_B.isZero(0))
      throw std::invalid_argument(
          "the state holds a load that is not one at the centre of mass "
          "in world axes: a batch has no other ones");
  one.load(bytes);
  errors_[simulation].clear();
  fill_part(forces_, simulation, size(), 0);
  fill_part(torques_, simulation, size(), 0);
  for (const auto& [body, load] : one.loads()) {
    const std::size_t row = 3 * (simulation * bodies() + static_cast<std::size_t>(body));
    std::copy_n(load.wrench.force.data(), 3, &forces_[row]);
    std::copy_n(load.wrench.moment.data(), 3, &torques_[row]);
  }
  const std::size_t count = spec().set_points.size();
  for (std::size_t p = 0; p < count; ++p)
    controls_[simulation * count + p] =
        one.engine().set_value(static_cast<engine::SetPointId>(p)).value_or(kLeftToScene);
  observe(simulation);
}

}  // namespace python

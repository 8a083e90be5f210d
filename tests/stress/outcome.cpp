#include "tests/stress/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <ctime>
#include <exception>
#include <sstream>

namespace stress {
namespace {

/// FNV-1a of the bytes of all states.
std::uint64_t digest_of(const std::vector<hydro::BodyState>& states) {
  std::uint64_t digest = 14695981039346656037U;
  const auto add = [&](const auto& numbers) {
    for (const double number : numbers)
      for (const auto byte : std::bit_cast<std::array<unsigned char, sizeof(double)>>(number))
        digest = (digest ^ byte) * 1099511628211U;
  };
  for (const hydro::BodyState& state : states) {
    add(state.position);
    add(state.orientation.coeffs());
    add(state.linear_velocity);
    add(state.angular_velocity);
  }
  return digest;
}

void simulate(const Scenario& scenario, const Listener& listener, Outcome& outcome) {
  outcome.inside = scenario.inside;
  outcome.judged = scenario.inside && scenario.passive;
  Watch watch(scenario);
  engine::Simulation simulation(scenario.spec);
  while (outcome.steps < scenario.steps && outcome.fault.empty()) {
    simulation.step();
    ++outcome.steps;
    if (const auto fault = watch.look(simulation))
      outcome.fault = fmt::format("step {}: {}", outcome.steps, *fault);
    outcome.rise = watch.worst_rise();
    outcome.substeps = watch.most_substeps();
    outcome.sweeps = watch.most_sweeps();
    outcome.digest = digest_of(simulation.states());
    if (listener) listener(simulation, watch);
  }
  for (const engine::Counts& counts : simulation.counts()) {
    outcome.unconverged += counts.unconverged;
    outcome.clamped += counts.clamped;
  }
}

/// Takes a run to its end, with what `begin` makes.
template <class Begin>
Outcome guarded(const Listener& listener, const Begin& begin) {
  Outcome outcome;
  const std::clock_t start = std::clock();
  try {
    simulate(begin(), listener, outcome);
  } catch (const engine::SimulationError& error) {
    outcome.stopped = !outcome.inside && !error.body().empty();
    if (!outcome.stopped)
      outcome.fault = fmt::format("step {}: {}", outcome.steps + 1, error.what());
  } catch (const std::exception& error) {
    outcome.fault = fmt::format("step {}: {}", outcome.steps + 1, error.what());
  }
  outcome.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return outcome;
}

}  // namespace

Outcome run_through(const RunName& run, const Listener& listener) {
  return guarded(listener, [&] { return make_scenario(run); });
}

Outcome run_through(const Scenario& scenario, const Listener& listener) {
  return guarded(listener, [&]() -> const Scenario& { return scenario; });
}

std::string to_csv(const Outcome& o) {
  std::string fault = o.fault;
  std::replace(fault.begin(), fault.end(), ',', ';');
  std::replace(fault.begin(), fault.end(), '\n', ' ');
  return fmt::format("{},{:d},{:d},{:d},{},{},{},{},{},{:.3f},{},{}", o.steps, o.inside, o.judged,
                     o.stopped, o.rise, o.substeps, o.sweeps, o.unconverged, o.clamped, o.seconds,
                     o.digest, fault);
}

Outcome outcome_from_csv(const std::string& line) {
  Outcome o;
  std::istringstream in(line);
  char comma = 0;
  in >> o.steps >> comma >> o.inside >> comma >> o.judged >> comma >> o.stopped >> comma >>
      o.rise >> comma >> o.substeps >> comma >> o.sweeps >> comma >> o.unconverged >> comma >>
      o.clamped >> comma >> o.seconds >> comma >> o.digest >> comma;
  std::getline(in, o.fault);
  return o;
}

}  // namespace stress

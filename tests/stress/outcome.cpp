#include "tests/stress/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <sstream>

namespace stress {
namespace {

void simulate(const Scenario& scenario, const Listener& listener, Outcome& outcome) {
  Watch watch(scenario);
  engine::Simulation simulation(scenario.spec);
  outcome.judged = scenario.passive;
  while (outcome.steps < scenario.steps && outcome.fault.empty()) {
    simulation.step();
    ++outcome.steps;
    if (const auto fault = watch.look(simulation))
      outcome.fault = fmt::format("step {}: {}", outcome.steps, *fault);
    outcome.rise = watch.worst_rise();
    outcome.substeps = watch.most_substeps();
    outcome.sweeps = watch.most_sweeps();
    if (listener) listener(simulation, watch);
  }
  for (const engine::Counts& counts : simulation.counts()) {
    outcome.unconverged += counts.unconverged;
    outcome.clamped += counts.clamped;
  }
}

}  // namespace

Outcome run_through(const RunName& run, const Listener& listener) {
  Outcome outcome;
  const std::clock_t start = std::clock();
  try {
    simulate(make_scenario(run), listener, outcome);
  } catch (const std::exception& error) {
    outcome.fault = fmt::format("step {}: {}", outcome.steps + 1, error.what());
  }
  outcome.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return outcome;
}

std::string to_csv(const Outcome& o) {
  std::string fault = o.fault;
  std::replace(fault.begin(), fault.end(), ',', ';');
  std::replace(fault.begin(), fault.end(), '\n', ' ');
  return fmt::format("{},{:d},{},{},{},{},{},{:.3f},{}", o.steps, o.judged, o.rise, o.substeps,
                     o.sweeps, o.unconverged, o.clamped, o.seconds, fault);
}

Outcome outcome_from_csv(const std::string& line) {
  Outcome o;
  std::istringstream in(line);
  char comma = 0;
  in >> o.steps >> comma >> o.judged >> comma >> o.rise >> comma >> o.substeps >> comma >>
      o.sweeps >> comma >> o.unconverged >> comma >> o.clamped >> comma >> o.seconds >> comma;
  std::getline(in, o.fault);
  return o;
}

}  // namespace stress

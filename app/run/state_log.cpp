#include "app/run/state_log.h"

#include <algorithm>
#include <utility>

#include "app/base/wall_clock.h"
#include "app/run/log_subject.h"
#include "hydro/water/simulated_water.h"

namespace app {
namespace {

/// Returns the largest number of times that may wait to be logged. A row with its forces takes less
/// than a kilobyte, so they need at most a megabyte unless there are very many bodies.
std::size_t most_waiting(std::size_t bodies) {
  constexpr std::size_t kRows = 1024;
  return std::max<std::size_t>(2, kRows / std::max<std::size_t>(1, bodies));
}

}  // namespace

StateLog::StateLog(const scene::Scene& scene, const assembly::BuiltScene& built, LogFormat format,
                   const std::filesystem::path& folder, int threads,
                   const std::optional<LogPosition>& resumed)
    : forces_(scene.log_forces),
      interiors_(may_be_hollow(built.spec)),
      probed_(!scene.probes.empty()),
      log_(make_log(format, log_subject(scene, built), folder, resumed)),
      due_(scene.log_every.value_or(0)),
      probes_(scene.probes, built.spec, built.centers_of_mass),
      rig_(built.spec, scene.log_forces),
      logging_(threads, most_waiting(built.spec.bodies.size())) {}

void StateLog::keep(const engine::Simulation& simulation, RigTotals& totals) {
  const bool logs = due_.due(simulation.time());
  const bool sums_up = RigTotals::sums_up(simulation.spec());
  engine::RigReadings rig;
  if (sums_up || (logs && !rig_.empty())) rig = simulation.rig();
  if (sums_up) totals.add(simulation.time(), simulation.spec(), rig);
  if (!logs) return;
  const WallClock clock;
  add(simulation, rig);
  seconds_ += clock.seconds();
}

/// Queues the rows of the present state.
void StateLog::add(const engine::Simulation& simulation, const engine::RigReadings& rig) {
  std::vector<engine::BodyForces> forces;
  if (forces_) forces = simulation.forces();
  std::vector<engine::InteriorState> interiors;
  if (interiors_) interiors = simulation.interiors();
  logging_.put([this, time = simulation.time(), states = simulation.states(),
                forces = std::move(forces), interiors = std::move(interiors),
                tables = table_numbers(simulation, rig)] {
    log_->add({.time = time,
               .states = states,
               .forces = forces,
               .interiors = interiors,
               .tables = tables});
  });
}

/// Returns the numbers of all tables, in the order of log_subject.
std::vector<std::vector<double>> StateLog::table_numbers(const engine::Simulation& simulation,
                                                         const engine::RigReadings& rig) const {
  const std::vector<hydro::BodyState>& states = simulation.states();
  std::vector<std::vector<double>> tables = rig_.numbers(rig, states);
  if (!probed_) return tables;
  tables.emplace_back();
  const double time = simulation.time();
  const hydro::SimulatedWater* water = simulation.water();
  const auto waves = water ? water->patch(time) : std::nullopt;
  for (const ProbeReading& reading : probes_.read(time, states, waves))
    tables.back().insert(tables.back().end(), reading.begin(), reading.end());
  return tables;
}

LogPosition StateLog::save() {
  LogPosition position;
  logging_.put([&] { position = log_->save(); });
  logging_.finish();
  return position;
}

void StateLog::finish() {
  const WallClock clock;
  logging_.put([this] { log_->finish(); });
  logging_.finish();
  seconds_ += clock.seconds();
}

}  // namespace app

#include "app/held/held_simulation.h"

#include <array>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "app/base/checked_file.h"

namespace app {
namespace {

// The first bytes of a saved state, which change with its layout: the number of held loads follows,
// then the loads; the number of velocities of probes before the last step, then these; then the
// state of the engine.
constexpr std::string_view kHead = "plimsoll held 2\n";

/// A held load as it is saved.
struct SavedLoad {
  std::int64_t body, frame;
  double numbers[9];
};

SavedLoad saved(engine::BodyId body, const HeldLoad& load) {
  SavedLoad bytes{.body = body, .frame = static_cast<std::int64_t>(load.frame), .numbers = {}};
  std::memcpy(bytes.numbers, load.wrench.force.data(), 3 * sizeof(double));
  std::memcpy(bytes.numbers + 3, load.wrench.moment.data(), 3 * sizeof(double));
  std::memcpy(bytes.numbers + 6, load.at_B.data(), 3 * sizeof(double));
  return bytes;
}

HeldLoad restored(const SavedLoad& bytes) {
  using Vector = Eigen::Map<const Eigen::Vector3d>;
  return {.wrench = {.force = Vector(bytes.numbers), .moment = Vector(bytes.numbers + 3)},
          .frame = bytes.frame == 0 ? engine::Frame::world : engine::Frame::body,
          .at_B = Vector(bytes.numbers + 6)};
}

/// Returns a number of entries. @throws std::invalid_argument above the number that fits the scene
std::size_t take_count(std::string_view& bytes, std::size_t most) {
  const auto count = take<std::uint64_t>(bytes);
  if (count > most) throw std::invalid_argument("the state is that of another scene");
  return static_cast<std::size_t>(count);
}

}  // namespace

HeldSimulation::HeldSimulation(engine::SimulationSpec spec, const MotionRows& rows,
                               const SensorSpec& sensors)
    : engine_(std::move(spec)), rows_(rows) {
  if (!sensors.probes.empty()) sensors_.emplace(sensors, engine_.spec());
}

void HeldSimulation::hold(engine::BodyId body, const HeldLoad& load) {
  if (!load.wrench.force.allFinite() || !load.wrench.moment.allFinite() || !load.at_B.allFinite())
    throw std::invalid_argument("the load on body '" + engine_.spec().bodies.at(body).name +
                                "' is not finite");
  loads_[body] = load;
}

void HeldSimulation::set_motion(engine::BodyId body, const hydro::BodyState& state) {
  engine_.set_motion(body, state);
  if (sensors_) sensors_->restart();
  show();
}

void HeldSimulation::step() {
  for (const auto& [body, load] : loads_) engine_.apply(body, load.wrench, load.frame, load.at_B);
  if (!sensors_) return engine_.step();
  const std::vector<Eigen::Vector3d> before = sensors_->readings().velocities_before();
  sensors_->before_step(engine_.states());
  try {
    engine_.step();
  } catch (...) {
    sensors_->readings().set_velocities_before(before);
    throw;
  }
}

std::string HeldSimulation::save() const {
  std::string bytes(kHead);
  append(bytes, static_cast<std::uint64_t>(loads_.size()));
  for (const auto& [body, load] : loads_) append(bytes, saved(body, load));
  const auto velocities =
      sensors_ ? sensors_->readings().velocities_before() : std::vector<Eigen::Vector3d>();
  append(bytes, static_cast<std::uint64_t>(velocities.size()));
  for (const Eigen::Vector3d& velocity : velocities) append(bytes, velocity);
  return bytes + engine_.state().to_bytes();
}

std::map<engine::BodyId, HeldLoad> HeldSimulation::take_loads(std::string_view& bytes) const {
  if (!bytes.starts_with(kHead))
    throw std::invalid_argument("these are not the bytes of a state of this version");
  bytes.remove_prefix(kHead.size());
  std::map<engine::BodyId, HeldLoad> loads;
  const std::size_t count = take_count(bytes, engine_.spec().bodies.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto load = take<SavedLoad>(bytes);
    if (load.body < 0 || load.body >= static_cast<std::int64_t>(engine_.spec().bodies.size()))
      throw std::invalid_argument("the state is that of another scene");
    loads[static_cast<engine::BodyId>(load.body)] = restored(load);
  }
  return loads;
}

std::map<engine::BodyId, HeldLoad> HeldSimulation::loads_in(std::string_view bytes) const {
  return take_loads(bytes);
}

void HeldSimulation::load(std::string_view bytes) {
  std::map<engine::BodyId, HeldLoad> loads = take_loads(bytes);
  const std::size_t probes = sensors_ ? sensors_->size() : 0;
  std::vector<Eigen::Vector3d> velocities(take_count(bytes, probes));
  if (!velocities.empty() && velocities.size() != probes)
    throw std::invalid_argument("the state is that of another scene");
  for (Eigen::Vector3d& velocity : velocities)
    velocity = Eigen::Map<const Eigen::Vector3d>(take<std::array<double, 3>>(bytes).data());
  engine_.restore(engine::SimulationState::from_bytes(bytes));
  if (sensors_) sensors_->readings().set_velocities_before(std::move(velocities));
  loads_ = std::move(loads);
  show();
}

void HeldSimulation::reset() {
  engine_.reset();
  if (sensors_) sensors_->restart();
  loads_.clear();
  show();
}

}  // namespace app

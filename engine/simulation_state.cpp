#include "engine/simulation_state.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "engine/state_data.h"

namespace engine {
namespace {

// Begins the bytes of a state; the last digit counts the changes of their layout.
constexpr std::string_view kMagic = "plimsoll state 17";

template <class T>
concept Number = std::is_arithmetic_v<T>;

/// FNV-1a: tells bytes of which one has changed.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return sum;
}

class Writer {
 public:
  void bytes(void* data, std::size_t size) { out.append(static_cast<const char*>(data), size); }
  std::uint64_t count(std::size_t size) {
    std::uint64_t n = size;
    bytes(&n, sizeof n);
    return n;
  }

  std::string out;
};

class Reader {
 public:
  explicit Reader(std::string_view in) : in_(in) {}
  void bytes(void* data, std::size_t size) {
    if (size > in_.size()) throw std::invalid_argument("the state of a simulation is cut short");
    std::memcpy(data, in_.data(), size);
    in_.remove_prefix(size);
  }
  std::uint64_t count(std::size_t) {
    std::uint64_t n = 0;
    bytes(&n, sizeof n);
    // Every element takes a byte at least, which bounds what is allocated.
    if (n > in_.size()) throw std::invalid_argument("the state of a simulation is cut short");
    return n;
  }
  bool at_end() const { return in_.empty(); }

 private:
  std::string_view in_;
};

// visit() names every part of a value once, for both directions.

template <class Archive, Number T>
void visit(Archive& a, T& number) {
  a.bytes(&number, sizeof number);
}
template <class Archive, class Derived>
void visit(Archive& a, Eigen::PlainObjectBase<Derived>& matrix) {
  a.bytes(matrix.data(), sizeof(double) * static_cast<std::size_t>(matrix.size()));
}
void visit(auto& a, Eigen::Quaterniond& q) { visit(a, q.coeffs()); }
template <class Archive, class T>
void visit(Archive& a, std::optional<T>& value) {
  bool present = value.has_value();
  visit(a, present);
  if (present && !value) value.emplace();
  if (!present) value.reset();
  if (value) visit(a, *value);
}
void visit(auto& a, std::string& text) {
  text.resize(a.count(text.size()));
  a.bytes(text.data(), text.size());
}
template <class Archive, class T>
void visit(Archive& a, std::vector<T>& values) {
  values.resize(a.count(values.size()));
  for (T& value : values) visit(a, value);
}
template <class Archive, class Key, class Value>
void visit(Archive& a, std::map<Key, Value>& map) {
  std::vector<std::pair<Key, Value>> entries(map.begin(), map.end());
  entries.resize(a.count(entries.size()));
  for (auto& [key, value] : entries) {
    visit(a, key);
    visit(a, value);
  }
  map = std::map<Key, Value>(entries.begin(), entries.end());
}
template <class Archive, class... T>
void visit_all(Archive& a, T&... parts) {
  (visit(a, parts), ...);
}

void visit(auto& a, Pair& pair) { visit_all(a, pair.first, pair.second); }
void visit(auto& a, ContactForce& f) { visit_all(a, f.pair, f.place_B, f.force_B); }
void visit(auto& a, hydro::BodyState& s) {
  visit_all(a, s.position, s.orientation, s.linear_velocity, s.angular_velocity);
}
void visit(auto& a, AccelerationHistory& history) {
  history.visit_parts([&a](auto&... parts) { visit_all(a, parts...); });
}
template <class Archive, Number T, std::size_t N>
void visit(Archive& a, std::array<T, N>& numbers) {
  for (T& number : numbers) visit(a, number);
}
void visit(auto& a, WorkRecord& w) {
  Works& works = w.works;
  visit_all(a, works.buoyancy, works.pressure_drag, works.viscous_drag, works.lift,
            works.wave_inertia, works.diffraction, works.radiation, works.wind, works.interior,
            works.added_mass, works.applied, works.weight, works.constraint, works.brake,
            w.added_energy_at_start, w.added_impulse, w.constraint_impulse, works.lines,
            works.machines, works.hull_lift, w.row_impulse, works.resistance);
}
void visit(auto& a, Eigen::VectorXd& vector) {
  vector.resize(static_cast<Eigen::Index>(a.count(static_cast<std::size_t>(vector.size()))));
  a.bytes(vector.data(), sizeof(double) * static_cast<std::size_t>(vector.size()));
}
void visit(auto& a, Eigen::Matrix3Xd& points) {
  points.resize(3, static_cast<Eigen::Index>(a.count(static_cast<std::size_t>(points.cols()))));
  a.bytes(points.data(), sizeof(double) * static_cast<std::size_t>(points.size()));
}
void visit(auto& a, WaveMemory& memory) { visit_all(a, memory.q, memory.p); }
void visit(auto& a, WaterMemory& water) {
  visit_all(a, water.displacement, water.load, water.momentum);
}
void visit(auto& a, PocketContent& p) {
  visit_all(a, p.id, p.volume, p.inflow, p.flooded, p.air, p.surface.level, p.surface.area,
            p.centre_B, p.up_B);
}
/// The interior follows from the rest (`completed`).
void visit(auto& a, CarriedWater& water) {
  visit_all(a, water.found_up_B, water.known_up_B, water.pockets, water.openings, water.pumps,
            water.inertia_B, water.next_id, water.has_all);
}
void visit(auto& a, std::shared_ptr<const CarriedWater>& carried) {
  std::optional<CarriedWater> water;
  if (carried) water = *carried;
  visit(a, water);
  carried = water ? std::make_shared<const CarriedWater>(*std::move(water)) : nullptr;
}
void visit(auto& a, Suction& s) { visit_all(a, s.bond, s.force, s.place_B, s.into_bed_B); }
void visit(auto& a, Motion& m) {
  visit_all(a, m.state, m.wake, m.rotors_B, m.added_B, m.memory, m.water, m.carried_water,
            m.suction, m.accelerations, m.constrained, m.load_acceleration_W, m.acceleration_W,
            m.longest_after_impact, m.work);
}
void visit(auto& a, Pull& p) { visit_all(a, p.at_B, p.to_W, p.rate); }
void visit(auto& a, Sine& sine) { visit_all(a, sine.frequency, sine.phase); }
void visit(auto& a, AppliedLoad& l) {
  visit_all(a, l.force, l.torque, l.in_body_frame, l.at_B, l.start, l.end, l.sine, l.factor);
}
void visit(auto& a, Counts& c) {
  visit_all(a, c.free, c.constrained, c.substeps, c.implicit, c.iterations, c.unconverged,
            c.clamped, c.dry, c.resting);
}
void visit(auto& a, BodyRecord& body) {
  visit_all(a, body.motion, body.inputs.pull, body.inputs.loads, body.counts, body.water_state);
}
void visit(auto& a, EnergyRange& r) { visit_all(a, r.lowest, r.highest, r.lowest_potential); }
void visit(auto& a, StepValue& v) { visit_all(a, v.start, v.middle, v.end); }
void visit(auto& a, SetPointState& s) {
  visit_all(a, s.value, s.outside, s.integral, s.measured, s.beyond);
}
void visit(auto& a, LineState& l) {
  visit_all(a, l.length, l.broken, l.impulse, l.tension, l.pull);
}
void visit(auto& a, JointState& j) { visit_all(a, j.force, j.moment, j.effort, j.motor); }
void visit(auto& a, hydro::LumpedState& l) {
  visit_all(a, l.places, l.places_before, l.velocities, l.velocities_before, l.forces);
}
void visit(auto& a, RigState& rig) {
  visit_all(a, rig.lines, rig.joints, rig.turns, rig.set_points, rig.dynamic_lines);
}
void visit(auto& a, Peak& peak) { visit_all(a, peak.value, peak.time); }
void visit(auto& a, JointError& joint) { visit_all(a, joint.separation, joint.turn); }
void visit(auto& a, SimulationState::Data& data) {
  visit_all(a, data.steps, data.bodies, data.stepper.contacts.touching,
            data.stepper.contacts.forces, data.stepper.ranges, data.rig, data.errors.overlaps,
            data.errors.joints, data.water);
}

}  // namespace

long SimulationState::steps() const { return data_->steps; }

std::string SimulationState::to_bytes() const {
  Writer writer{.out = std::string(kMagic)};
  Data copy = *data_;
  visit(writer, copy);
  std::uint64_t sum = checksum(writer.out);
  visit(writer, sum);
  return writer.out;
}

SimulationState SimulationState::from_bytes(std::string_view bytes) {
  if (!bytes.starts_with(kMagic))
    throw std::invalid_argument("this is no state of a simulation, or one of another version");
  if (bytes.size() < kMagic.size() + sizeof(std::uint64_t))
    throw std::invalid_argument("the state of a simulation is cut short");
  const std::string_view content = bytes.substr(0, bytes.size() - sizeof(std::uint64_t));
  Reader end(bytes.substr(content.size()));
  std::uint64_t sum = 0;
  visit(end, sum);
  if (sum != checksum(content))
    throw std::invalid_argument("the state of a simulation is cut short or has changed");
  Reader reader(content.substr(kMagic.size()));
  auto data = std::make_shared<Data>();
  visit(reader, *data);
  if (!reader.at_end())
    throw std::invalid_argument("the state of a simulation has bytes beyond its end");
  return SimulationState(std::move(data));
}

}  // namespace engine

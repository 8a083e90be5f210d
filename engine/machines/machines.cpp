#include "engine/machines/machines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "hydro/airy_waves.h"
#include "hydro/machines/foil.h"

namespace engine {
namespace {

using Eigen::Vector3d;

Vector3d velocity_of(const Vector3d& r_W, const hydro::BodyState& state) {
  return state.linear_velocity + state.angular_velocity.cross(r_W);
}

Vector3d turned(const Vector3d& v, double angle, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis) * v;
}

/// Angular momentum about its axis of a screw that turns `rate` times a second.
double spun(const PropellerSpec& spec, double rate) {
  return (spec.right_handed ? 1 : -1) * 2 * std::numbers::pi * spec.inertia * rate;
}

/// Part of a vertical extent about the height z that is below a level.
double part_below(double z, double extent, double level) {
  if (extent <= 0) return z < level ? 1 : 0;
  return std::clamp((level - z) / extent + 0.5, 0.0, 1.0);
}

}  // namespace

class Machines::Water {
 public:
  Water(const SimulationSpec& spec, double time) : time_(time) {
    if (spec.sea) sea_ = &*spec.sea;
    if (sea_) waves_.emplace(*sea_, time);
  }
  double density() const { return sea_ ? sea_->density : 0; }
  /// Height of the surface [m]; without water there is none.
  double surface(const Vector3d& p_W) const {
    if (!sea_) return -std::numeric_limits<double>::infinity();
    return hydro::surface_height(*sea_, p_W.x(), p_W.y(), time_);
  }
  Vector3d velocity(const Vector3d& p_W, double surface) const {
    return waves_->at(p_W, surface - p_W.z()).velocity;
  }
  Vector3d wind(const Vector3d& p_W, double surface) const {
    const hydro::Wind& wind = sea_->air->wind;
    return wind.factor(std::max(0.0, p_W.z() - surface)) * wind.velocity;
  }
  double air_density() const { return sea_ && sea_->air ? sea_->air->density : 0; }

 private:
  const hydro::Sea* sea_ = nullptr;
  std::optional<hydro::AiryWaves> waves_;
  double time_;
};

struct Machines::Screw {
  Vector3d at_W;    ///< From the centre of mass.
  Vector3d axis_W;  ///< Unit.
  double speed = 0;
  double azimuth = 0;
  double wetted = 0;
  hydro::PropellerLoad load;
};

Machines::Machines(const SimulationSpec& spec, const SetPoints& set_points)
    : spec_(spec), set_points_(set_points), of_body_(spec.bodies.size()) {
  for (std::size_t i = 0; i < spec.propellers.size(); ++i) {
    curves_.emplace_back(spec.propellers[i].screw);
    of_body_.at(spec.propellers[i].body).propellers.push_back(i);
  }
  for (std::size_t i = 0; i < spec.foils.size(); ++i) {
    hydro::check_foil(spec.foils[i].foil);
    of_body_.at(spec.foils[i].body).foils.push_back(i);
  }
}

Machines::Screw Machines::screw(std::size_t index, const hydro::BodyState& state, double time,
                                const Water& water) const {
  const PropellerSpec& spec = spec_.propellers[index];
  Screw screw;
  screw.speed = set_points_.value(spec.speed, time);
  screw.azimuth = set_points_.value(spec.azimuth, time);
  screw.at_W = state.orientation * spec.at_B;
  screw.axis_W = state.orientation * turned(spec.axis_B, screw.azimuth, spec.pivot_B);
  const Vector3d center = state.position + screw.at_W;
  const double surface = water.surface(center);
  screw.wetted = hydro::wetted_share(center, screw.axis_W, spec.screw.diameter, surface);
  if (screw.wetted == 0) return screw;
  const Vector3d through = velocity_of(screw.at_W, state) - water.velocity(center, surface);
  screw.load =
      curves_[index].load(screw.speed, screw.axis_W.dot(through), water.density(), screw.wetted);
  return screw;
}

hydro::Wrench Machines::load(const Screw& screw, std::size_t index, double time) const {
  const PropellerSpec& spec = spec_.propellers[index];
  const Vector3d force = screw.load.thrust * screw.axis_W;
  const double hand = spec.right_handed ? 1 : -1;
  Vector3d moment = screw.at_W.cross(force) - hand * screw.load.torque * screw.axis_W;
  if (spec.inertia > 0) moment -= spun(spec, set_points_.rate(spec.speed, time)) * screw.axis_W;
  return {.force = force, .moment = moment};
}

Vector3d Machines::rotors_B(BodyId body, double time) const {
  Vector3d sum = Vector3d::Zero();
  for (const std::size_t i : of_body_[body].propellers) {
    const PropellerSpec& spec = spec_.propellers[i];
    if (!(spec.inertia > 0)) continue;
    const double azimuth = set_points_.value(spec.azimuth, time);
    sum += spun(spec, set_points_.value(spec.speed, time)) *
           turned(spec.axis_B, azimuth, spec.pivot_B);
  }
  return sum;
}

FoilReading Machines::foil(std::size_t index, const hydro::BodyState& state, double time,
                           const Water& water) const {
  const FoilSpec& spec = spec_.foils[index];
  FoilReading reading{.angle = set_points_.value(spec.angle, time)};
  const Vector3d r_W = state.orientation * spec.at_B;
  const Vector3d p_W = state.position + r_W;
  const Vector3d span = state.orientation * spec.span_B;
  const Vector3d chord = state.orientation * turned(spec.chord_B, -reading.angle, spec.span_B);
  const double surface = water.surface(p_W);
  const double below = part_below(p_W.z(), std::abs(span.z()) * spec.foil.span, surface);
  const bool sail = spec.fluid == FoilSpec::Fluid::air;
  const double density = sail ? water.air_density() : water.density();
  const double share = sail ? 1 - below : below;
  if (share <= 0 || density <= 0) return reading;
  const Vector3d fluid = sail ? water.wind(p_W, surface) : water.velocity(p_W, surface);
  const Vector3d flow = fluid - velocity_of(r_W, state);
  Vector3d raced = flow;
  double covered = 0;
  if (spec.behind) {
    const Screw screw = this->screw(*spec.behind, state, time, water);
    const PropellerSpec& propeller = spec_.propellers[*spec.behind];
    const double distance = std::abs(screw.axis_W.dot(r_W - screw.at_W));
    const hydro::Race race = hydro::propeller_race(screw.load.inflow, screw.load.open_thrust,
                                                   propeller.screw.diameter, distance, density);
    covered = screw.wetted * std::min(1.0, race.diameter / spec.foil.span);
    raced -= (screw.axis_W.dot(flow) + race.speed) * screw.axis_W;
  }
  const auto force_in = [&](const Vector3d& f) {
    return hydro::foil_force(spec.foil, f, chord, span, density);
  };
  reading.force_W = share * (1 - covered) * force_in(flow);
  if (covered > 0) reading.force_W += share * covered * force_in(raced);
  const Vector3d seen = (1 - covered) * flow + covered * raced;
  const Vector3d across = seen - span.dot(seen) * span;
  reading.speed = across.norm();
  reading.attack = std::atan2(span.cross(chord).dot(across), -chord.dot(across));
  return reading;
}

hydro::Wrench Machines::load(BodyId body, const hydro::BodyState& state, double time) const {
  const Water water(spec_, time);
  hydro::Wrench sum;
  for (const std::size_t i : of_body_[body].propellers)
    sum += load(screw(i, state, time, water), i, time);
  for (const std::size_t i : of_body_[body].foils) {
    const Vector3d force = foil(i, state, time, water).force_W;
    sum += {.force = force, .moment = (state.orientation * spec_.foils[i].at_B).cross(force)};
  }
  return sum;
}

PropellerReading Machines::propeller(std::size_t index, const hydro::BodyState& state,
                                     double time) const {
  const Screw s = screw(index, state, time, Water(spec_, time));
  return {.speed = s.speed,
          .azimuth = s.azimuth,
          .thrust = s.load.thrust,
          .torque = s.load.torque,
          .advance = s.load.advance_ratio,
          .wetted = s.wetted};
}

FoilReading Machines::foil(std::size_t index, const hydro::BodyState& state, double time) const {
  return foil(index, state, time, Water(spec_, time));
}

}  // namespace engine

#include "hydro/water/simulated_water.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "hydro/airy_waves.h"
#include "hydro/water/moving_surface.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Longest step of the water over 1/ω of the shortest waves of the grid [-], and longest way of a
/// body in a step over a cell [-]. No wave that the filter leaves is mistaken for another one from
/// step to step: both are below π.
constexpr double kLongestStep = 2, kLongestWay = 1.5;

/// The same for hulls that feel the water [-]: the load of a step is then within a hundredth.
constexpr double kLongestFeltStep = 1;

/// Distance between two hulls within which they feel each other's sources, over the radius of the
/// larger one [-].
constexpr double kNearInRadii = 4;

/// Distance of two hulls below which they do not, over the mean radius of the larger waterplane
/// [-]: the strengths of the step before, by which hulls act on each other, would not converge.
constexpr double kApart = 0.25;

/// Height of the water that counts as still, over a cell [-].
constexpr double kStill = 1e-6;

/// Energy over density of the square with that height in the mean [m^5/s^2].
double energy_of_still_water(const PeriodicSquare& square) {
  return square.gravity / 2 * std::pow(square.side() * kStill * square.cell, 2);
}

/// Damping of the surface inside a waterplane, over the frequency √(g/R) of its radius [-], and the
/// Froude number by R up to which it is damped: at speed the damping would be drag.
constexpr double kInnerDamping = 0.1, kSlow = 0.1;

/// Smallest distance of two places, one of either [m].
double smallest_distance(const Eigen::Matrix3Xd& some, const Eigen::Matrix3Xd& others) {
  double smallest = HUGE_VAL;
  for (const Vector3d place : some.colwise())
    smallest = std::min(smallest, (others.colwise() - place).colwise().squaredNorm().minCoeff());
  return std::sqrt(smallest);
}

}  // namespace

PeriodicSquare square_about(const std::vector<WaterBody>& bodies,
                            const std::vector<BodyState>& states, const Sea& sea) {
  double largest = 0;
  Vector2d low = Vector2d::Constant(HUGE_VAL), high = -low;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].mesh_B == nullptr) continue;
    const double radius = bodies[i].radius;
    largest = std::max(largest, radius);
    low = low.cwiseMin(Vector2d(states[i].position.head<2>().array() - radius));
    high = high.cwiseMax(Vector2d(states[i].position.head<2>().array() + radius));
  }
  const double side = (high - low).maxCoeff() + 22 * largest;
  PeriodicSquare square{
      .cells = 256, .deepest = largest, .gravity = sea.gravity, .depth = sea.depth};
  if (side / square.cells > largest / 8) square.cells = 512;
  square.cell = side / square.cells;
  return square;
}

double smallest_cell(double step, double gravity) {
  return gravity * M_PI * std::pow(step / kLongestStep, 2);
}

SimulatedWater::SimulatedWater(const Sea& sea, std::vector<WaterBody> bodies,
                               const PeriodicSquare& square, double edge)
    : sea_(sea),
      bodies_(std::move(bodies)),
      waves_(square),
      window_(square, sea, edge),
      passages_(bodies_.size()) {
  felt_ = std::ranges::any_of(bodies_, [](const auto& body) { return body.hull != nullptr; });
  longest_ =
      (felt_ ? kLongestFeltStep : kLongestStep) / std::sqrt(sea.gravity * M_PI / square.cell);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (const HullSources* hull = bodies_[i].hull.get())
      passages_[i] = HullPassage(*hull, time_of_mean_speed(sea, hull->length()));
}

/// Takes the window to the middle of the bodies.
void SimulatedWater::follow_bodies(const std::vector<BodyState>& states) {
  Vector2d low = Vector2d::Constant(HUGE_VAL), high = -low;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].mesh_B == nullptr) continue;
    const Vector2d place = window_.in_square(states[i].position.head<2>(), now_.time);
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  window_.follow((low + high) / 2);
}

/// Finds where a hull is halfway through the step, from where the water is at `now_`.
void SimulatedWater::find_passage(const WaterBody& body, const BodyState& start,
                                  HullPassage& passage) const {
  BodyState half = start;
  half.position += now_.length / 2 * start.linear_velocity;
  const Vector3d turned = now_.length / 2 * start.angular_velocity;
  if (const double angle = turned.norm(); angle > 0)
    half.orientation = Eigen::AngleAxisd(angle, turned / angle) * start.orientation;
  const WaveFrame frame = body.floating->frame(half.orientation);
  passage.place = window_.in_square((half.position + frame.origin).head<2>(), now_.time);
  passage.heading = frame.heading();
  passage.presence = std::sqrt(body.floating->presence(start, sea_, now_.time));
  passage.set_course(*body.hull);
}

/// The sources of hulls near by, halfway through the step, in the square's axes. Hulls that touch
/// or overlap have none: there is no flow between them, and the strengths of the step before would
/// not converge.
std::vector<NearSources> SimulatedWater::neighbours_of(std::size_t hull) const {
  const double cell = waves_.square().cell;
  const auto places_of = [&](const HullSources& of, const HullPassage& passage) {
    Eigen::Matrix3Xd places(3, of.places.cols());
    for (Index i = 0; i < places.cols(); ++i)
      places.col(i) << cell * passage.at(of.places.col(i), cell), of.places(2, i);
    return places;
  };
  const HullPassage& own = passages_[hull];
  Eigen::Matrix3Xd own_places;  // Found for the first neighbour.
  std::vector<NearSources> near;
  for (std::size_t j = 0; j < bodies_.size(); ++j) {
    const HullPassage& other = passages_[j];
    if (j == hull || !bodies_[j].hull || other.presence == 0) continue;
    const double apart =
        cell * (own.place - other.place).norm() - bodies_[hull].radius - bodies_[j].radius;
    if (apart > kNearInRadii * std::max(bodies_[hull].radius, bodies_[j].radius)) continue;
    NearSources sources;
    sources.places = places_of(*bodies_[j].hull, other);
    if (own_places.cols() == 0) own_places = places_of(*bodies_[hull].hull, own);
    if (smallest_distance(own_places, sources.places) <
        kApart * std::max(bodies_[hull].hull->radius(), bodies_[j].hull->radius()))
      continue;
    sources.rates = 2 * other.rates - other.before;
    sources.changes = (other.rates - other.before) / now_.length;
    near.push_back(std::move(sources));
  }
  return near;
}

/// The waves at a hull; near it are other hulls.
FlowAtHull SimulatedWater::flow_at(std::size_t body) const {
  const HullSources& hull = *bodies_[body].hull;
  const HullPassage& passage = passages_[body];
  const double cell = waves_.square().cell, g = sea_.gravity;
  const Eigen::Rotation2Dd to_H(-passage.heading);
  const std::vector<NearSources> neighbours = neighbours_of(body);
  const std::optional<AiryWaves> sea =
      has_airy_waves(sea_) ? std::optional<AiryWaves>(std::in_place, sea_, now_.time)
                           : std::nullopt;
  const auto in_H = [&](const Vector3d& v) {
    Vector3d turned;
    turned << to_H * v.head<2>(), v.z();
    return turned;
  };
  FlowAtHull flow(hull.places.cols());
  for (Index i = 0; i < hull.places.cols(); ++i) {
    const Vector2d at = passage.at(hull.places.col(i), cell);
    Vector3d place;
    place << cell * at, hull.places(2, i);
    const FieldBelow::Sample waves =
        now_.still ? FieldBelow::Sample() : field_.at(at.x(), at.y(), place.z());
    NearFlow near;
    for (const NearSources& neighbour : neighbours) near += near_flow(neighbour, place);
    // The neighbours' −1/g ∂φ/∂t loads a hull as η does.
    flow.raise[i] = waves.value.real() - near.change / g;
    flow.slope.col(i) = in_H(waves.slope.real() - near.acceleration / g);
    flow.potential[i] = waves.value.imag();
    flow.velocity.col(i) = in_H(waves.slope.imag());
    Vector3d water = waves.slope.imag() + near.velocity;
    if (sea) {
      Vector3d p_W;
      p_W << place.head<2>() + now_.time * sea_.current.head<2>(), sea_.level + place.z();
      water += sea->at(p_W, -place.z()).velocity - current_at(sea_, p_W.z());
    }
    flow.inward[i] = -in_H(water).dot(hull.fluxes.col(i));
  }
  return flow;
}

void SimulatedWater::add_hull(std::size_t body, const Vector6d& way) {
  const HullSources& hull = *bodies_[body].hull;
  HullPassage& passage = passages_[body];
  const Eigen::VectorXd volumes = passage.give(hull, way, now_.length);
  for (Index i = 0; i < volumes.size(); ++i) {
    const Vector2d at = passage.at(hull.places.col(i), waves_.square().cell);
    if (!window_.has(at)) continue;
    waves_.add_source(at.x(), at.y(), hull.places(2, i), volumes[i]);
    largest_ = std::max(largest_, std::abs(volumes[i]));
  }
}

void SimulatedWater::add_surface(const WaterBody& body, const BodyState& state) {
  const PeriodicSquare& square = waves_.square();
  const double time = now_.time + now_.length / 2;
  find_sources(*body.mesh_B, body.radius, state, sea_, time, square.cell, square.side() / 2,
               [&](const WaterSource& source) {
                 const Vector2d at = window_.in_square(source.place, time);
                 if (!window_.has(at)) return;
                 const double volume = source.rate * now_.length;
                 waves_.add_source(at.x(), at.y(), source.height, volume);
                 largest_ = std::max(largest_, std::abs(volume));
               });
}

std::vector<WavesOnHull> SimulatedWater::begin(double time, double length,
                                               const std::vector<BodyState>& states) {
  now_.started = true;
  now_.length = length;
  now_.time = time + length / 2;
  follow_bodies(states);
  if (!now_.still) waves_.advance(length / 2);
  std::vector<WavesOnHull> loads(bodies_.size());
  if (!felt_) return loads;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].hull) find_passage(bodies_[i], states[i], passages_[i]);
  std::optional<Vector2d> read;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].hull) continue;
    HullPassage& passage = passages_[i];
    if (passage.presence == 0) {
      passage.flow.setZero();
      continue;
    }
    const Vector2d velocity = passage.velocity();
    if (!now_.still && read != velocity) waves_.read(field_, velocity);
    read = velocity;
    loads[i] = passage.meet(*bodies_[i].hull, flow_at(i), length);
  }
  return loads;
}

void SimulatedWater::end(const std::vector<BodyState>& states, const std::vector<Vector6d>& ways) {
  largest_ = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].hull)
      add_hull(i, ways[i]);
    else if (bodies_[i].mesh_B != nullptr)
      add_surface(bodies_[i], states[i]);
  }
  const double length = std::exchange(now_.length, 0), cell = waves_.square().cell;
  now_.time += length / 2;
  const bool nothing_given = largest_ < kStill * cell * cell * cell;
  if (now_.still && nothing_given) {
    waves_.drop_sources();
    return;
  }
  now_.still = false;
  waves_.take_sources();
  waves_.advance(length / 2);
  now_.undamped += length;
  if (now_.undamped <= 4 * longest_) return;
  const double left = damp(states);
  if (!nothing_given || left > energy_of_still_water(waves_.square())) return;
  now_.absorbed += left;
  waves_.calm();
  now_.still = true;
}

void SimulatedWater::follow(double time, const std::vector<BodyState>& states) {
  if (!now_.started) now_ = {.time = time, .started = true};
  double fastest = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].mesh_B != nullptr)
      fastest = std::max(fastest, states[i].linear_velocity.norm() +
                                      bodies_[i].radius * states[i].angular_velocity.norm());
  const double cell = waves_.square().cell, elapsed = time - now_.time;
  if (elapsed < longest_ * (1 - 1e-9) && elapsed * fastest < kLongestWay * cell) return;
  std::vector<BodyState> starts = states;
  for (BodyState& start : starts) start.position -= elapsed * start.linear_velocity;
  begin(now_.time, elapsed, starts);
  std::vector<Vector6d> ways(bodies_.size(), Vector6d::Zero());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].hull) continue;
    Vector6d u;
    u << states[i].linear_velocity - sea_.current, states[i].angular_velocity;
    ways[i] = elapsed * passages_[i].presence *
              bodies_[i].floating->frame(states[i].orientation).velocity_in(u);
  }
  end(states, ways);
  now_.time = time;
}

/// Damps the window's edges and what sloshes inside slow hulls. @return the energy that is left
/// over density [m^5/s^2]
double SimulatedWater::damp(const std::vector<BodyState>& states) {
  const PeriodicSquare& square = waves_.square();
  Eigen::MatrixXf factor =
      window_.damping(1, now_.undamped) * window_.damping(0, now_.undamped).transpose();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].hull || bodies_[i].hull->inside.cols() == 0) continue;
    const HullSources& hull = *bodies_[i].hull;
    const double radius = hull.radius();
    const double speed = (states[i].linear_velocity - sea_.current).head<2>().norm();
    if (speed > kSlow * std::sqrt(square.gravity * radius)) continue;
    const double rate = kInnerDamping * std::sqrt(square.gravity / radius);
    const auto part = static_cast<float>(std::exp(-rate * now_.undamped));
    for (const Vector2d point : hull.inside.colwise()) {
      const Vector2d at = passages_[i].at({point.x(), point.y(), 0}, square.cell).array().round();
      float& here = factor(static_cast<Index>(at.y()) & (square.cells - 1),
                           static_cast<Index>(at.x()) & (square.cells - 1));
      here = std::min(here, part);
    }
  }
  now_.absorbed += waves_.energy();
  waves_.damp(factor);
  const double left = waves_.energy();
  now_.absorbed -= left;
  now_.undamped = 0;
  return left;
}

std::optional<SurfacePatch> SimulatedWater::patch(double time) const {
  if (now_.still) return std::nullopt;
  return window_.patch(waves_.elevation(time - now_.time), time);
}

std::string SimulatedWater::state() const {
  std::string bytes;
  const auto put = [&](const double* numbers, Index count) {
    bytes.append(reinterpret_cast<const char*>(numbers),
                 sizeof *numbers * static_cast<std::size_t>(count));
  };
  const double numbers[] = {now_.time,
                            now_.undamped,
                            now_.length,
                            now_.started ? 1.0 : 0.0,
                            now_.still ? 1.0 : 0.0,
                            now_.absorbed,
                            window_.middle().x(),
                            window_.middle().y()};
  put(numbers, std::size(numbers));
  for (HullPassage passage : passages_)
    for (const std::span<double> part : passage.numbers())
      put(part.data(), static_cast<Index>(part.size()));
  put(reinterpret_cast<const double*>(waves_.state().data()), 2 * waves_.state().size());
  return bytes;
}

void SimulatedWater::restore(const std::string& state) {
  std::size_t place = 0;
  const auto take = [&](double* numbers, Index count) {
    const std::size_t size = sizeof *numbers * static_cast<std::size_t>(count);
    if (state.size() - place < size)
      throw std::invalid_argument("the state of the simulated water is that of another scene");
    std::copy_n(state.data() + place, size, reinterpret_cast<char*>(numbers));  // No number: null.
    place += size;
  };
  double numbers[8];
  take(numbers, std::size(numbers));
  std::vector<HullPassage> passages = passages_;
  for (HullPassage& passage : passages)
    for (const std::span<double> part : passage.numbers())
      take(part.data(), static_cast<Index>(part.size()));
  Eigen::MatrixXcd zeta(waves_.square().cells, waves_.square().cells);
  take(reinterpret_cast<double*>(zeta.data()), 2 * zeta.size());
  if (place != state.size())
    throw std::invalid_argument("the state of the simulated water is that of another scene");
  now_ = {.time = numbers[0],
          .undamped = numbers[1],
          .length = numbers[2],
          .started = numbers[3] != 0,
          .still = numbers[4] != 0,
          .absorbed = numbers[5]};
  window_.restore({numbers[6], numbers[7]});
  passages_ = std::move(passages);
  waves_.restore(std::move(zeta));
}

}  // namespace hydro

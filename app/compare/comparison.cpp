#include "app/compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/logs/interpolation.h"

namespace app {
namespace {

using Eigen::Quaterniond;
using hydro::BodyState;

constexpr double kSameTime = 1e-9;  ///< Round-off of logged times, relative, or [s] below 1 s.

/// Returns the angle of the rotation between two attitudes [deg].
double angle_between(const BodyState& a, const BodyState& b) {
  const Quaterniond d = a.orientation.conjugate() * b.orientation;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w())) * 180 / std::numbers::pi;
}

bool same_time(double a, double b) {
  return std::abs(a - b) <= kSameTime * std::max(1.0, std::abs(a));
}

/// Counts the rows of a track outside the times of another.
std::size_t rows_beyond(const BodyTrack& track, const BodyTrack& other) {
  return static_cast<std::size_t>(
      std::count_if(track.times.begin(), track.times.end(), [&](double time) {
        const bool before = time < other.times.front() && !same_time(time, other.times.front());
        const bool after = time > other.times.back() && !same_time(time, other.times.back());
        return before || after;
      }));
}

bool has_row(const BodyTrack& track, double time) {
  const auto next = std::lower_bound(track.times.begin(), track.times.end(), time);
  return (next != track.times.end() && same_time(*next, time)) ||
         (next != track.times.begin() && same_time(*(next - 1), time));
}

void note(BodyComparison& body, double time, const BodyState& a, const BodyState& b) {
  body.times.push_back(time);
  for (std::size_t k = 0; k < kComparedQuantities.size(); ++k) {
    const double difference = kComparedQuantities[k].difference(a, b);
    Difference& d = body.differences[k];
    body.difference_over[k].push_back(difference);
    if (difference > d.largest) {
      d.largest = difference;
      d.when_largest = time;
    }
    if (difference > d.tolerance) d.first_beyond = std::min(d.first_beyond, time);
  }
}

BodyComparison compare_body(const std::string& name, const BodyTrack& a, const BodyTrack& b,
                            const Tolerances& tolerances) {
  BodyComparison body{.name = name};
  for (std::size_t k = 0; k < kComparedQuantities.size(); ++k)
    body.differences[k].tolerance = tolerances.of(name, kComparedQuantities[k].name);
  body.only_a = rows_beyond(a, b);
  body.only_b = rows_beyond(b, a);
  const bool a_is_coarser = a.times.size() - body.only_a <= b.times.size() - body.only_b;
  const BodyTrack& coarser = a_is_coarser ? a : b;
  const BodyTrack& finer = a_is_coarser ? b : a;
  for (std::size_t i = 0; i < coarser.times.size(); ++i) {
    const double time = coarser.times[i];
    const bool met = has_row(finer, time);
    if (!met && (time < finer.times.front() || time > finer.times.back())) continue;
    body.interpolated += !met;
    const BodyState other = state_at(finer, time);
    note(body, time, a_is_coarser ? coarser.states[i] : other,
         a_is_coarser ? other : coarser.states[i]);
  }
  return body;
}

}  // namespace

const std::array<ComparedQuantity, 4> kComparedQuantities = {{
    {"position", "m",
     [](const BodyState& a, const BodyState& b) { return (a.position - b.position).norm(); }},
    {"orientation_deg", "deg", angle_between},
    {"linear_velocity", "m/s",
     [](const BodyState& a, const BodyState& b) {
       return (a.linear_velocity - b.linear_velocity).norm();
     }},
    {"angular_velocity", "rad/s",
     [](const BodyState& a, const BodyState& b) {
       return (a.angular_velocity - b.angular_velocity).norm();
     }},
}};

double Tolerances::of(const std::string& body, const std::string& quantity) const {
  if (all.empty() && bodies.empty()) return kDefault;
  if (const auto own = bodies.find(body); own != bodies.end())
    if (const auto found = own->second.find(quantity); found != own->second.end())
      return found->second;
  const auto found = all.find(quantity);
  return found == all.end() ? kNotJudged : found->second;
}

bool BodyComparison::same() const {
  return in == In::both && only_a + only_b == 0 && !times.empty() &&
         std::all_of(differences.begin(), differences.end(),
                     [](const Difference& d) { return d.within(); });
}

bool Comparison::same() const {
  return std::all_of(bodies.begin(), bodies.end(),
                     [](const BodyComparison& body) { return body.same(); });
}

Comparison compare_trajectories(const Trajectory& a, const Trajectory& b,
                                const Tolerances& tolerances) {
  Comparison comparison;
  for (const std::string& name : a.names) {
    if (b.tracks.contains(name))
      comparison.bodies.push_back(
          compare_body(name, a.tracks.at(name), b.tracks.at(name), tolerances));
    else
      comparison.bodies.push_back({.name = name, .in = BodyComparison::In::only_a});
  }
  for (const std::string& name : b.names)
    if (!a.tracks.contains(name))
      comparison.bodies.push_back({.name = name, .in = BodyComparison::In::only_b});
  return comparison;
}

BodyState state_at(const BodyTrack& track, double time) {
  const auto next = std::lower_bound(track.times.begin(), track.times.end(), time);
  const auto row = static_cast<std::size_t>(next - track.times.begin());
  if (row < track.times.size() && same_time(track.times[row], time)) return track.states[row];
  if (row == 0) return track.states.front();
  if (row == track.times.size() || same_time(track.times[row - 1], time))
    return track.states[row - 1];
  const double h = track.times[row] - track.times[row - 1];
  return between(track.states[row - 1], track.states[row], h, (time - track.times[row - 1]) / h);
}

}  // namespace app

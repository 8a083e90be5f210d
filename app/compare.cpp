#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "app/commands.h"
#include "app/faults.h"
#include "app/trajectory.h"

namespace app {
namespace {

using hydro::BodyState;

constexpr double kDefaultTolerance = 1e-9;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Angle of the rotation between two attitudes [deg].
double angle_between(const BodyState& a, const BodyState& b) {
  const Eigen::Quaterniond d = a.orientation.conjugate() * b.orientation;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w())) * 180 / M_PI;
}

struct ComparedQuantity {
  const char* name;
  const char* unit;
  double (*difference)(const BodyState&, const BodyState&);
};

constexpr std::array<ComparedQuantity, 4> kQuantities = {{
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

/// How far one quantity of one body differs.
struct Difference {
  double largest = 0;
  double when_largest = 0;       ///< [s]
  double first_beyond = kNever;  ///< [s]
};

/// The rows of two tracks at the times that both have, and how many each has alone.
struct Matched {
  std::vector<std::pair<std::size_t, std::size_t>> rows;
  std::size_t only_a = 0;
  std::size_t only_b = 0;
};

Matched match(const BodyTrack& a, const BodyTrack& b) {
  Matched matched;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.times.size() && j < b.times.size()) {
    const double slack = 1e-9 * std::max(1.0, std::abs(a.times[i]));
    if (std::abs(a.times[i] - b.times[j]) <= slack)
      matched.rows.emplace_back(i++, j++);
    else
      ++(a.times[i] < b.times[j] ? i : j);
  }
  matched.only_a = a.times.size() - matched.rows.size();
  matched.only_b = b.times.size() - matched.rows.size();
  return matched;
}

Difference compare_quantity(const ComparedQuantity& quantity, const BodyTrack& a,
                            const BodyTrack& b, const Matched& matched, double tolerance) {
  Difference d;
  for (const auto& [i, j] : matched.rows) {
    const double difference = quantity.difference(a.states[i], b.states[j]);
    if (difference > d.largest) {
      d.largest = difference;
      d.when_largest = a.times[i];
    }
    if (difference > tolerance && d.first_beyond == kNever) d.first_beyond = a.times[i];
  }
  return d;
}

/// Tolerance of a quantity; infinite if it is only shown, not judged.
double tolerance_of(const std::map<std::string, double>& tolerances, const char* quantity) {
  if (tolerances.empty()) return kDefaultTolerance;
  const auto found = tolerances.find(quantity);
  return found == tolerances.end() ? kNever : found->second;
}

void check_quantities(const std::map<std::string, double>& tolerances) {
  std::string known;
  for (const ComparedQuantity& q : kQuantities)
    known += fmt::format("{}{}", known.empty() ? "" : ", ", q.name);
  for (const auto& [name, value] : tolerances) {
    bool is_known = false;
    for (const ComparedQuantity& q : kQuantities) is_known |= name == q.name;
    if (!is_known)
      throw InputError("--tol", fmt::format("unknown quantity {}; there are {}", name, known));
    if (!(value >= 0))
      throw InputError("--tol", fmt::format("{}={}: expected a number not below 0", name, value));
  }
}

std::string verdict(const Difference& d, double tolerance) {
  if (tolerance == kNever) return "not judged";
  if (d.first_beyond == kNever) return "ok";
  return fmt::format("exceeds it from {:g} s", d.first_beyond);
}

/// Prints a body's part of the table; true if all is within tolerance.
bool compare_body(const std::string& name, const BodyTrack& a, const BodyTrack& b,
                  const CompareOptions& options) {
  const Matched matched = match(a, b);
  bool same = true;
  if (matched.only_a + matched.only_b > 0) {
    fmt::print("{:<16} {} times in both, {} only in {}, {} only in {}\n", name, matched.rows.size(),
               matched.only_a, options.a.string(), matched.only_b, options.b.string());
    same = false;
  }
  for (const ComparedQuantity& quantity : kQuantities) {
    const double tolerance = tolerance_of(options.tolerances, quantity.name);
    const Difference d = compare_quantity(quantity, a, b, matched, tolerance);
    fmt::print("{:<16} {:<17} {:>12.4g} {:<6} {:>8.3f} {:>11}  {}\n", name, quantity.name,
               d.largest, quantity.unit, d.when_largest,
               tolerance == kNever ? "-" : fmt::format("{:g}", tolerance), verdict(d, tolerance));
    same = same && d.first_beyond == kNever;
  }
  return same;
}

}  // namespace

int compare(const CompareOptions& options) {
  check_quantities(options.tolerances);
  const Trajectory a = read_trajectory(options.a);
  const Trajectory b = read_trajectory(options.b);
  fmt::print("{:<16} {:<17} {:>12} {:<6} {:>8} {:>11}\n", "body", "quantity", "largest", "unit",
             "at [s]", "tolerance");
  bool same = true;
  for (const std::string& name : a.names) {
    if (b.tracks.contains(name)) {
      same = compare_body(name, a.tracks.at(name), b.tracks.at(name), options) && same;
    } else {
      fmt::print("{:<16} only in {}\n", name, options.a.string());
      same = false;
    }
  }
  for (const std::string& name : b.names) {
    if (a.tracks.contains(name)) continue;
    fmt::print("{:<16} only in {}\n", name, options.b.string());
    same = false;
  }
  fmt::print("{}\n", same ? "the same within tolerance" : "different");
  return same ? kDone : kDiffers;
}

}  // namespace app

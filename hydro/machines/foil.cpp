#include "hydro/machines/foil.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hydro/require.h"

namespace hydro {
namespace {

/// Normal force coefficient of a plate across the flow, of moderate aspect ratio.
constexpr double kStalledNormalForce = 1.2;

/// Range of angles over which the flow separates [rad].
constexpr double kSeparating = 0.2;

/// Share of the induced drag above that of an elliptic distribution of lift.
constexpr double kInduced = 1.1;

double aspect_ratio(const Foil& foil) {
  return foil.aspect_ratio > 0 ? foil.aspect_ratio : foil.span / foil.chord;
}

/// 0 before x = 0, 1 after x = 1, with level ends.
double smooth_step(double x) {
  const double s = std::clamp(x, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

FoilCoefficients mixed(const FoilCoefficients& a, const FoilCoefficients& b, double weight_b) {
  return {a.lift + weight_b * (b.lift - a.lift), a.drag + weight_b * (b.drag - a.drag)};
}

/// (2), for any angle.
FoilCoefficients separated(const Foil& foil, double angle) {
  const double s = std::sin(angle);
  const double normal = kStalledNormalForce * (4 + M_PI) * s / (4 + M_PI * std::abs(s));
  return {normal * std::cos(angle), foil.drag_zero + normal * s};
}

/// Between the rows of a table; its ends beyond them.
FoilCoefficients interpolated(const Foil::Table& table, double angle) {
  const double a = std::clamp(angle, table.angle.front(), table.angle.back());
  const auto after = std::upper_bound(table.angle.begin() + 1, table.angle.end() - 1, a);
  const auto i = static_cast<std::size_t>(after - table.angle.begin());
  const double t = (a - table.angle[i - 1]) / (table.angle[i] - table.angle[i - 1]);
  return mixed({table.lift[i - 1], table.drag[i - 1]}, {table.lift[i], table.drag[i]}, t);
}

bool is_symmetric(const Foil::Table& table) { return table.angle.front() == 0; }

FoilCoefficients of_table(const Foil& foil, double angle) {
  const Foil::Table& table = foil.table;
  const bool mirrored = is_symmetric(table) && angle < 0;
  const double a = mirrored ? -angle : angle;
  FoilCoefficients inside = interpolated(table, a);
  if (mirrored) inside.lift = -inside.lift;
  const double outside = std::max(table.angle.front() - a, a - table.angle.back());
  return mixed(inside, separated(foil, angle), smooth_step(outside / kSeparating));
}

/// Flow from ahead or from behind: a foil turned round has the lift of the opposite angle.
FoilCoefficients of_law(const Foil& foil, double angle) {
  const double lift = lift_slope(foil) * std::sin(angle) * (std::cos(angle) < 0 ? -1 : 1);
  const FoilCoefficients attached{
      lift, foil.drag_zero + kInduced * lift * lift / (M_PI * aspect_ratio(foil))};
  const double incidence = std::atan2(std::abs(std::sin(angle)), std::abs(std::cos(angle)));
  return mixed(attached, separated(foil, angle),
               smooth_step((incidence - foil.stall) / kSeparating));
}

bool within(double value, double least, double most) { return value >= least && value <= most; }

void check_foil_table(const Foil::Table& table) {
  const std::size_t rows = table.angle.size();
  require(rows >= 2, "number of table rows of a foil", static_cast<double>(rows), "2 or more");
  for (const std::vector<double>* column : {&table.lift, &table.drag})
    require(column->size() == rows, "length of a table column of a foil",
            static_cast<double>(column->size()), "that of the first column");
  for (std::size_t i = 0; i < rows; ++i) {
    require(within(table.angle[i], -M_PI, M_PI), "table angle of a foil", table.angle[i],
            "one in -pi to pi");
    require(std::isfinite(table.lift[i]), "lift coefficient of a foil", table.lift[i],
            "a finite number");
    require(within(table.drag[i], 0, std::numeric_limits<double>::max()),
            "drag coefficient of a foil", table.drag[i], "0 or more");
    require(i == 0 || table.angle[i] > table.angle[i - 1], "table angle of a foil", table.angle[i],
            "more than in the row before");
  }
}

}  // namespace

void check_foil(const Foil& foil) {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::min();
  require(within(foil.span, least, most), "span of a foil", foil.span, "a positive number");
  require(within(foil.chord, least, most), "chord of a foil", foil.chord, "a positive number");
  require(within(foil.aspect_ratio, 0, most), "aspect ratio of a foil", foil.aspect_ratio,
          "0 or more");
  require(within(foil.drag_zero, 0, most), "drag coefficient of a foil", foil.drag_zero,
          "0 or more");
  require(within(foil.stall, 0, 1.3), "stall angle of a foil", foil.stall, "0 to 1.3 rad");
  if (foil.law == Foil::Law::table) check_foil_table(foil.table);
}

double lift_slope(const Foil& foil) {
  const double ratio = aspect_ratio(foil);
  switch (foil.law) {
    case Foil::Law::soding:
      return 2 * M_PI * ratio * (ratio + 1) / ((ratio + 2) * (ratio + 2));
    case Foil::Law::fujii:
      return 6.13 * ratio / (ratio + 2.25);
    case Foil::Law::whicker_fehlner:
      return 1.8 * M_PI * ratio / (std::sqrt(ratio * ratio + 4) + 1.8);
    case Foil::Law::table:
      break;
  }
  constexpr double kStep = 1e-6;
  return (of_table(foil, kStep).lift - of_table(foil, -kStep).lift) / (2 * kStep);
}

FoilCoefficients foil_coefficients(const Foil& foil, double angle_of_attack) {
  return foil.law == Foil::Law::table ? of_table(foil, angle_of_attack)
                                      : of_law(foil, angle_of_attack);
}

Eigen::Vector3d foil_force(const Foil& foil, const Eigen::Vector3d& flow,
                           const Eigen::Vector3d& chord_axis, const Eigen::Vector3d& span_axis,
                           double density) {
  const Eigen::Vector3d across = flow - flow.dot(span_axis) * span_axis;
  const double angle = std::atan2(across.dot(span_axis.cross(chord_axis)), -across.dot(chord_axis));
  const FoilCoefficients c = foil_coefficients(foil, angle);
  const double scale = 0.5 * density * foil.span * foil.chord * across.norm();
  return scale * (c.drag * across + c.lift * across.cross(span_axis));
}

Race propeller_race(double inflow, double thrust, double diameter, double distance,
                    double density) {
  if (thrust <= 0) return {inflow, diameter};
  const double disc = 0.25 * M_PI * diameter * diameter;
  const double ahead = std::max(inflow, 0.0);
  const double far = std::sqrt(ahead * ahead + 2 * thrust / (density * disc));
  const double length = std::abs(distance);
  const double share = 0.5 + 0.5 * length / (length + 0.15 * diameter);
  const double speed = ahead + share * (far - ahead);
  return {speed + std::min(inflow, 0.0), diameter * std::sqrt(0.5 * (ahead + far) / speed)};
}

}  // namespace hydro

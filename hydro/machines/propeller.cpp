#include "hydro/machines/propeller.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hydro/require.h"

namespace hydro {
namespace {

/// 0.7π: at 0.7 of the radius the blades move at this times nD.
constexpr double kBladeSpeed = 0.7 * M_PI;

/// C* over K at β = 0.
constexpr double kToStar = 8 / (0.49 * M_PI * M_PI * M_PI);

/// Arm of the torque, 0.7 of the radius, over D [-].
constexpr double kTorqueArm = 0.35;

/// Normal force coefficient of a plate across the flow.
constexpr double kBladeNormalForce = 1.2;

bool is_positive(double value) { return value > 0 && value <= std::numeric_limits<double>::max(); }

/// Columns of one length, two rows or more, finite, the first increasing.
void check_propeller_table(const std::vector<double>& key, const std::vector<double>& thrust,
                           const std::vector<double>& torque, const char* name) {
  const auto rows = static_cast<double>(key.size());
  require(key.size() >= 2, "number of table rows of a propeller", rows, "2 or more");
  for (const std::vector<double>* column : {&thrust, &torque})
    require(column->size() == key.size(), "length of a table column of a propeller",
            static_cast<double>(column->size()), "that of the first column");
  for (std::size_t i = 0; i < key.size(); ++i) {
    for (const double value : {key[i], thrust[i], torque[i]})
      require(std::isfinite(value), "table value of a propeller", value, "a finite number");
    require(i == 0 || key[i] > key[i - 1], name, key[i],
            "more than in the row before of a propeller");
  }
}

double cubic_at(const std::array<double, 4>& k, double j) {
  return k[0] + j * (k[1] + j * (k[2] + j * k[3]));
}

double cubic_slope_at(const std::array<double, 4>& k, double j) {
  return k[1] + j * (2 * k[2] + 3 * j * k[3]);
}

/// The line through (j0, k0) and (j1, k1).
std::array<double, 4> line_through(double j0, double k0, double j1, double k1) {
  const double slope = (k1 - k0) / (j1 - j0);
  return {k0 - slope * j0, slope, 0, 0};
}

/// The least J > 0 at which the thrust of a screw of the series vanishes. It is above 0.4 and below
/// 1.7 in all of the series, and K_T falls from J = 0 to there.
double zero_thrust(const std::array<double, 4>& thrust) {
  double low = 0, high = 0.1;
  while (cubic_at(thrust, high) > 0) {
    low = high;
    high += 0.1;
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (cubic_at(thrust, middle) > 0 ? low : high) = middle;
  }
  return low;
}

/// A table that is linear between the rows and repeats itself after 2π.
QuadrantCoefficients from_quadrant_table(const FourQuadrantTable& table, double beta) {
  const std::size_t rows = table.beta.size();
  const auto after = std::upper_bound(table.beta.begin(), table.beta.end(), beta);
  const auto next = static_cast<std::size_t>(after - table.beta.begin()) % rows;
  const std::size_t last = (next + rows - 1) % rows;
  double from = table.beta[last], to = table.beta[next];
  if (next == 0) (beta < to ? from : to) += beta < to ? -2 * M_PI : 2 * M_PI;
  const double t = to > from ? (beta - from) / (to - from) : 0;
  return {table.thrust[last] + t * (table.thrust[next] - table.thrust[last]),
          table.torque[last] + t * (table.torque[next] - table.torque[last])};
}

}  // namespace

PropellerCurves::PropellerCurves(const Propeller& propeller) : propeller_(propeller) {
  const Propeller& p = propeller_;
  require(is_positive(p.diameter), "diameter of a propeller", p.diameter, "a positive number");
  require(p.wake < 1 && std::isfinite(p.wake), "wake fraction of a propeller", p.wake,
          "a number below 1");
  require(p.deduction < 1 && std::isfinite(p.deduction), "thrust deduction of a propeller",
          p.deduction, "a number below 1");
  require(is_positive(p.rotative_efficiency), "rotative efficiency of a propeller",
          p.rotative_efficiency, "a positive number");
  require(is_positive(p.reverse), "thrust astern over that ahead of a propeller", p.reverse,
          "a positive number");
  std::visit([this](const auto& model) { prepare(model); }, p.model);
}

void PropellerCurves::prepare(const WageningenB& screw) {
  const OpenWaterCubics cubics = open_water_cubics(screw);
  pieces_ = {{0, cubics.thrust, cubics.torque}};
  last_ = zero_thrust(cubics.thrust);
  prepare_ends(last_, screw.area_ratio);
}

void PropellerCurves::prepare(const OpenWaterTable& table) {
  const std::vector<double>& j = table.advance_ratio;
  const std::vector<double>& thrust = table.thrust_coefficient;
  const std::vector<double>& torque = table.torque_coefficient;
  check_propeller_table(j, thrust, torque, "advance ratio of a propeller");
  require(j.front() <= 0, "first advance ratio of a propeller", j.front(), "0 or less");
  require(j.back() > 0, "last advance ratio of a propeller", j.back(), "a positive number");
  require(is_positive(table.area_ratio), "area ratio of a propeller", table.area_ratio,
          "a positive number");
  for (std::size_t i = 0; i + 1 < j.size(); ++i)
    pieces_.push_back({j[i], line_through(j[i], thrust[i], j[i + 1], thrust[i + 1]),
                       line_through(j[i], torque[i], j[i + 1], torque[i + 1])});
  const double bollard = cubic_at(piece_at(0).thrust, 0);
  require(bollard > 0, "thrust coefficient at J = 0 of a propeller", bollard, "a positive number");
  std::size_t row = 0;  // The first without thrust ahead.
  while (row < j.size() && (j[row] <= 0 || thrust[row] > 0)) ++row;
  const Piece& falling = pieces_[std::min(row, j.size() - 1) - 1];
  require(falling.thrust[1] < 0, "last slope of the thrust coefficient of a propeller",
          falling.thrust[1], "a negative number");
  const double zero = -falling.thrust[0] / falling.thrust[1];
  last_ = std::max(j.back(), zero);
  prepare_ends(zero, table.area_ratio);
}

void PropellerCurves::prepare(const FourQuadrantTable& table) {
  check_propeller_table(table.beta, table.thrust, table.torque, "angle beta of a propeller");
  for (const double beta : {table.beta.front(), table.beta.back()})
    require(std::abs(beta) <= M_PI, "angle beta of a propeller", beta, "one within -pi and pi");
  if (table.beta.back() - table.beta.front() < 2 * M_PI) return;
  require(table.thrust.back() == table.thrust.front(), "last thrust coefficient of a propeller",
          table.thrust.back(), "the first one, as the table is a whole turn");
  require(table.torque.back() == table.torque.front(), "last torque coefficient of a propeller",
          table.torque.back(), "the first one, as the table is a whole turn");
}

void PropellerCurves::prepare_ends(double zero_thrust, double area_ratio) {
  pitch_angle_ = std::atan(zero_thrust / kBladeSpeed);
  plate_ = kBladeNormalForce * area_ratio;
  lower_ = end_at(pieces_.front().from);
  upper_ = end_at(last_);
}

const PropellerCurves::Piece& PropellerCurves::piece_at(double advance_ratio) const {
  const auto after = std::upper_bound(pieces_.begin() + 1, pieces_.end(), advance_ratio,
                                      [](double j, const Piece& piece) { return j < piece.from; });
  return *(after - 1);
}

PropellerCurves::End PropellerCurves::end_at(double advance_ratio) const {
  const Piece& piece = piece_at(advance_ratio);
  End end;
  end.beta = std::atan(advance_ratio / kBladeSpeed);
  const double c = std::cos(end.beta), s = std::sin(end.beta);
  const double thrust = cubic_at(piece.thrust, advance_ratio);
  const double torque = cubic_at(piece.torque, advance_ratio);
  end.value = {kToStar * c * c * thrust, kToStar * c * c * torque};
  end.slope = {
      kToStar * (kBladeSpeed * cubic_slope_at(piece.thrust, advance_ratio) - 2 * c * s * thrust),
      kToStar * (kBladeSpeed * cubic_slope_at(piece.torque, advance_ratio) - 2 * c * s * torque)};
  return end;
}

/// Between an end of the measured range and β = ±π/2, the border.
QuadrantCoefficients PropellerCurves::beyond(const End& end, double border, double beta) const {
  const double past = beta - end.beta;
  const double s = past / (border - end.beta);
  const double weight = s * s * (3 - 2 * s);
  const double plate = plate_ * std::sin(pitch_angle_ - beta) * std::cos(pitch_angle_);
  const double thrust =
      (1 - weight) * (end.value.thrust + end.slope.thrust * past) + weight * plate;
  const double torque = (1 - weight) * (end.value.torque + end.slope.torque * past) +
                        weight * plate * kTorqueArm * std::tan(pitch_angle_);
  // Inequality (2). At the border itself the plate fulfils it, whatever tan β is in double
  // precision.
  return {thrust, std::max(torque, kTorqueArm * thrust * std::tan(beta))};
}

QuadrantCoefficients PropellerCurves::ahead(double beta) const {
  if (beta < lower_.beta) return beyond(lower_, -M_PI / 2, beta);
  if (beta > upper_.beta) return beyond(upper_, M_PI / 2, beta);
  const double c = std::cos(beta);
  const double j = kBladeSpeed * std::tan(beta);
  const Piece& piece = piece_at(j);
  return {kToStar * c * c * cubic_at(piece.thrust, j), kToStar * c * c * cubic_at(piece.torque, j)};
}

QuadrantCoefficients PropellerCurves::coefficients(double beta) const {
  if (const auto* table = std::get_if<FourQuadrantTable>(&propeller_.model))
    return from_quadrant_table(*table, beta);
  if (std::abs(beta) <= M_PI / 2) return ahead(beta);
  const QuadrantCoefficients turned = ahead(beta - std::copysign(M_PI, beta));
  const double s = std::sin(beta);
  const double factor = -(propeller_.reverse + (1 - propeller_.reverse) * s * s);
  return {factor * turned.thrust, factor * turned.torque};
}

PropellerLoad PropellerCurves::load(double rps, double speed, double density,
                                    double wetted_share) const {
  const double diameter = propeller_.diameter;
  PropellerLoad out;
  out.inflow = (1 - propeller_.wake) * speed;
  if (rps != 0) out.advance_ratio = out.inflow / (rps * diameter);
  const double turning = kBladeSpeed * rps * diameter;
  const QuadrantCoefficients c = coefficients(std::atan2(out.inflow, turning));
  const double disc = 0.25 * M_PI * diameter * diameter;
  const double scale =
      0.5 * density * (out.inflow * out.inflow + turning * turning) * disc * wetted_share;
  out.open_thrust = scale * c.thrust;
  out.thrust = (1 - propeller_.deduction) * out.open_thrust;
  out.torque = scale * diameter * c.torque / propeller_.rotative_efficiency;
  return out;
}

double wetted_share(const Eigen::Vector3d& center_W, const Eigen::Vector3d& axis_W, double diameter,
                    double surface_height) {
  const double upright = std::sqrt(std::max(0.0, 1 - axis_W.z() * axis_W.z()));
  const double reach = 0.5 * diameter * std::max(upright, 0.05);
  const double q = std::clamp((surface_height - center_W.z()) / reach, -1.0, 1.0);
  return std::clamp(0.5 + (q * std::sqrt(1 - q * q) + std::asin(q)) / M_PI, 0.0, 1.0);
}

}  // namespace hydro

#include "hydro/statics/intact_stability.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hydro {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kLast = 60;             ///< End of the curve [deg].
constexpr double kAngleError = 1e-6;  ///< Error of the angle of downflooding [rad].

Eigen::Quaterniond orientation_of(const RightingArm& arm) {
  return Eigen::AngleAxisd(arm.trim, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(arm.heel, Eigen::Vector3d::UnitX());
}

std::vector<RightingArm> curve(const IntactBody& body, const std::vector<double>& heels) {
  return righting_arms(body.mesh, body.volume, heels, body.tanks);
}

/// The heel between two at which the flooding points meet the water, by bisection.
double downflooding_between(const IntactBody& body, double dry, double wet) {
  while (wet - dry > kAngleError) {
    const double middle = (dry + wet) / 2;
    const RightingArm arm = curve(body, {middle}).front();
    (*flooding_freeboard(body, arm) > 0 ? dry : wet) = middle;
  }
  return (dry + wet) / 2;
}

std::optional<double> downflooding(const IntactBody& body, const std::vector<RightingArm>& arms) {
  if (body.flooding_points_B.empty()) return std::nullopt;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    if (*flooding_freeboard(body, arms[i]) > 0) continue;
    return i == 0 ? 0 : downflooding_between(body, arms[i - 1].heel, arms[i].heel);
  }
  return std::nullopt;
}

/// Lever at a heel, linear between those of the curve.
double lever_at(const std::vector<RightingArm>& arms, double heel) {
  const auto i = std::min(static_cast<std::size_t>(heel / kDegree), arms.size() - 2);
  const double part = (heel - arms[i].heel) / (arms[i + 1].heel - arms[i].heel);
  return arms[i].lever + part * (arms[i + 1].lever - arms[i].lever);
}

/// ∫ GZ dheel [m rad]
double area(const std::vector<RightingArm>& arms, double from, double to) {
  double sum = 0;
  for (double heel = from; heel < to;) {
    const double next = std::min(to, (std::floor(heel / kDegree + 1e-9) + 1) * kDegree);
    sum += (next - heel) * (lever_at(arms, heel) + lever_at(arms, next)) / 2;
    heel = next;
  }
  return sum;
}

}  // namespace

std::optional<double> flooding_freeboard(const IntactBody& body, const RightingArm& arm) {
  if (body.flooding_points_B.empty()) return std::nullopt;
  const Eigen::Matrix3d R_WB = orientation_of(arm).toRotationMatrix();
  double lowest = HUGE_VAL;
  for (const Eigen::Vector3d& point : body.flooding_points_B)
    lowest = std::min(lowest, R_WB.row(2).dot(point));
  return lowest - body.mesh.lowest(R_WB) - arm.draught;
}

IntactStability intact_stability(const IntactBody& body, double gm) {
  std::vector<double> heels;
  for (int i = 0; i <= kLast; ++i) heels.push_back(i * kDegree);
  const std::vector<RightingArm> arms = curve(body, heels);
  IntactStability result{.downflooding = downflooding(body, arms)};
  const double end = std::min(40 * kDegree, result.downflooding.value_or(HUGE_VAL));
  const double first = std::min(30 * kDegree, end);
  const auto larger = [](const RightingArm& a, const RightingArm& b) { return a.lever < b.lever; };
  const auto peak = std::max_element(arms.begin(), arms.end(), larger);
  const auto late = std::max_element(arms.begin() + 30, arms.end(), larger);
  result.criteria = {{"area under GZ to 30 deg", area(arms, 0, first), 0.055, "m rad"},
                     {"area under GZ to 40 deg or downflooding", area(arms, 0, end), 0.09, "m rad"},
                     {"area under GZ from 30 deg on", area(arms, first, end), 0.03, "m rad"},
                     {"largest GZ at 30 deg or more", late->lever, 0.2, "m"},
                     {"heel of the largest GZ", peak->heel / kDegree, 25, "deg"},
                     {"initial GM", gm, 0.15, "m"}};
  return result;
}

}  // namespace hydro

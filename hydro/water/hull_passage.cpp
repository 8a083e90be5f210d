#include "hydro/water/hull_passage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Froude numbers by the length between which the mean motion comes to count.
constexpr double kAtRest = 0.05, kUnderWay = 0.15;

/// Part of the course that has the sources (1) [-].
double thin_part(const HullSources& hull, const HullPassage& passage) {
  return hull.pierces_surface() ? passage.under_way : 0;
}

/// (3), about the centre of mass.
Vector6d pull_on_sources(const HullSources& hull, const HullPassage& passage,
                         const Eigen::Matrix3Xd& velocity) {
  Vector6d pull = Vector6d::Zero();
  if (passage.under_way == 0) return pull;
  const VectorXd rates =
      hull.pierces_surface() ? VectorXd(hull.motions * passage.course) : passage.rates;
  for (Index i = 0; i < rates.size(); ++i) {
    const Vector3d force = -passage.under_way * rates[i] * velocity.col(i);
    const Vector3d arm = hull.places.col(i) - Vector3d(0, 0, hull.pose.height);
    pull.head<3>() += force;
    pull.tail<3>() += arm.cross(force);
  }
  return pull;
}

}  // namespace

FlowAtHull::FlowAtHull(Index patches)
    : raise(patches),
      slope(3, patches),
      potential(patches),
      velocity(3, patches),
      inward(patches) {}

HullPassage::HullPassage(const HullSources& hull, double mean_time) : mean_time_(mean_time) {
  flow = steady = rates = before = VectorXd::Zero(hull.places.cols());
}

Vector2d HullPassage::at(const Vector3d& place_H, double cell) const {
  return place + Eigen::Rotation2Dd(heading) * place_H.head<2>() / cell;
}

Vector2d HullPassage::velocity() const {
  return under_way * (Eigen::Rotation2Dd(heading) * course.head<2>());
}

void HullPassage::set_course(const HullSources& hull) {
  const double froude = course.head<2>().norm() / std::sqrt(hull.water.gravity * hull.length());
  const double s = std::clamp((froude - kAtRest) / (kUnderWay - kAtRest), 0.0, 1.0);
  under_way = s * s * (3 - 2 * s);
}

double HullPassage::part_of_mean(double length) const { return 1 - std::exp(-length / mean_time_); }

WavesOnHull HullPassage::meet(const HullSources& hull, const FlowAtHull& water, double length) {
  const VectorXd whole = presence * water.inward;
  const double thin = thin_part(hull, *this);
  flow = whole - thin * steady;
  steady += part_of_mean(length) * (whole - steady);
  const Vector6d late = hull.reply * flow - thin * (hull.spring - hull.thin_spring) * course;
  return {
      .load = -hull.water.gravity * (hull.load_of(water.raise, water.slope) + length / 2 * late) +
              pull_on_sources(hull, *this, water.velocity),
      .momentum = -hull.load_of(water.potential, water.velocity)};
}

VectorXd HullPassage::give(const HullSources& hull, const Vector6d& way, double length) {
  const Vector6d mean = length * thin_part(hull, *this) * course;
  const VectorXd volumes =
      hull.volumes * (hull.motions * (way - mean) + length * flow) + hull.motions * mean;
  before = std::exchange(rates, volumes / length);
  course += part_of_mean(length) * (way / length - course);
  return volumes;
}

std::vector<std::span<double>> HullPassage::numbers() {
  const auto all = [](auto& of) {
    return std::span<double>(of.data(), static_cast<std::size_t>(of.size()));
  };
  return {all(place), {&heading, 1}, {&presence, 1}, {&under_way, 1}, all(course),
          all(flow),  all(steady),   all(rates),     all(before)};
}

}  // namespace hydro

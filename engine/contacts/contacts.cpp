#include "engine/contacts/contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "engine/base/constants.h"

namespace engine {
namespace {

// Extent of coinciding points [m]; its square is still no zero.
constexpr double kLeastExtent = 1e-100;

/// Square of the distance of two points, in position over the extent of all, and in direction.
double distance(const ContactPoint& a, const ContactPoint& b, double extent) {
  return (a.position_W - b.position_W).squaredNorm() / (extent * extent) +
         (a.normal_W - b.normal_W).squaredNorm();
}

/// True if `deep` lies in the overlap of the far shallower contact `shallow`, in another direction.
bool explains(const ContactPoint& shallow, const ContactPoint& deep) {
  return shallow.depth < 0.2 * deep.depth && shallow.normal_W.dot(deep.normal_W) < 0.7 &&
         std::abs((deep.position_W - shallow.position_W).dot(shallow.normal_W)) <
             1.5 * shallow.depth;
}

}  // namespace

std::vector<ContactPoint> without_artefacts(const std::vector<ContactPoint>& points, double reach,
                                            double boxes) {
  std::vector<ContactPoint> touching;
  std::copy_if(points.begin(), points.end(), std::back_inserter(touching),
               [](const ContactPoint& point) { return point.depth > 0; });
  const auto artefact = [&](const ContactPoint& point) {
    if (point.depth <= reach) return false;
    return point.depth > 2 * boxes ||
           std::any_of(touching.begin(), touching.end(),
                       [&](const ContactPoint& other) { return explains(other, point); });
  };
  std::vector<ContactPoint> contacts;
  std::remove_copy_if(touching.begin(), touching.end(), std::back_inserter(contacts), artefact);
  return contacts;
}

std::vector<ContactPoint> supporting_a_sphere(std::vector<ContactPoint> points) {
  const auto deeper = [](const auto& a, const auto& b) { return a.depth > b.depth; };
  std::stable_sort(points.begin(), points.end(), deeper);
  std::vector<ContactPoint> kept;
  for (const ContactPoint& point : points) {
    const bool remains = std::all_of(kept.begin(), kept.end(), [&](const ContactPoint& other) {
      return point.depth > other.depth * other.normal_W.dot(point.normal_W);
    });
    if (remains) kept.push_back(point);
  }
  return kept;
}

std::vector<std::size_t> representative(const std::vector<ContactPoint>& points,
                                        std::size_t limit) {
  if (points.empty()) return {};
  const auto shallower = [](const auto& a, const auto& b) { return a.depth < b.depth; };
  const auto deepest = std::max_element(points.begin(), points.end(), shallower);
  auto next = static_cast<std::size_t>(deepest - points.begin());
  Eigen::AlignedBox3d box;
  for (const ContactPoint& point : points) box.extend(point.position_W);
  const double extent = std::max(box.diagonal().norm(), kLeastExtent);

  std::vector<std::size_t> taken;
  std::vector<double> gap(points.size(), std::numeric_limits<double>::infinity());
  while (taken.size() < limit) {
    taken.push_back(next);
    for (std::size_t i = 0; i < points.size(); ++i)
      gap[i] = std::min(gap[i], distance(points[i], points[next], extent));
    const auto farthest = std::max_element(gap.begin(), gap.end());
    if (*farthest == 0) break;  // every other point coincides with one taken
    next = static_cast<std::size_t>(farthest - gap.begin());
  }
  return taken;
}

double impact_speed(double gravity) { return kShortestContact * std::max(gravity, kLeastGravity); }

ContactRow contact_row(double depth, const ContactLaw& law, double step) {
  const double compliance = kSlip * step * static_cast<double>(law.points) / law.mass;
  const double over = depth - law.rest;
  const double speed = over / (kContactRecovery * std::max(step, kShortestContact));
  const double fall = law.fall * std::max(law.gravity, kLeastGravity);
  return {.speed = std::min(speed, std::sqrt(std::max(0.0, fall * over / 2))),
          .compliance = compliance};
}

}  // namespace engine
